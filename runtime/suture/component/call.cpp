#include <suture/component/call.h>
#include <suture/component/channel/channel.h>
#include <suture/component/required.h>
#include <suture/component/required_tables.h>
#include <suture/component/sleep.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace suture {

CallBase::CallBase(CallBase&& other) noexcept
    : required_(other.required_),
      pending_(std::exchange(other.pending_, nullptr)),
      limit_(other.limit_) {}

CallBase& CallBase::operator=(CallBase&& other) noexcept {
  if (this == &other) return *this;
  close();
  required_ = other.required_;
  pending_ = std::exchange(other.pending_, nullptr);
  limit_ = other.limit_;
  return *this;
}

bool CallBase::done() { return pending_ != nullptr && required_->isDone(*pending_); }

void CallBase::close() {
  if (pending_ != nullptr) required_->closeCall(*std::exchange(pending_, nullptr));
}

bool CallBase::takeBack() {
  if (!required_->cancel(*pending_)) return false;
  close();
  return true;
}

void CallBase::passOnTo(RequiredBase::Follower follower) {
  required_->follow(*std::exchange(pending_, nullptr), follower);
}

// --- what RequiredBase does for the calls under way on it

RequiredBase::PendingCall* RequiredBase::openCall(std::uint16_t command) {
  collectReplies();
  const auto free = std::find_if(tables_->calls.begin(), tables_->calls.end(),
                                 [](const PendingCall& call) { return call.number == 0; });
  if (free == tables_->calls.end()) return nullptr;
  const auto index = static_cast<std::uint32_t>(free - tables_->calls.begin());
  ++callsOpened_;
  free->number = callsOpened_ % (1u << 27) * Channel::kMaxCalls + index + Channel::kMaxCalls;
  free->command = command;
  free->done = free->abandoned = false;
  free->error = Errc{};
  return &*free;
}

void RequiredBase::closeCall(PendingCall& call) {
  // The answer may still come; until then the place is taken.
  if (call.done || channel_ == nullptr) {
    discard(call);
  } else {
    call.abandoned = true;
  }
}

void RequiredBase::collectReplies() {
  if (channel_ == nullptr) return;
  noteTaking();
  // Take no more than there may be calls: a foreign provider may write without end.
  for (std::size_t i = 0; i < tables_->calls.size(); ++i) {
    ReplyRecord* const reply = channel_->nextReply();
    if (reply == nullptr) return;
    collect(*reply, channel_->replies.frontSize() - sizeof(ReplyRecord));
    channel_->popReply();
  }
}

// Lowers the flag before anybody looks, so that what comes later is rung for.
void RequiredBase::noteTaking() {
  if (!channel_->untaken.isUp(std::memory_order_relaxed)) return;
  channel_->untaken.take(std::memory_order_acq_rel);
}

void RequiredBase::collect(ReplyRecord& reply, std::size_t size) {
  channel_->countReceived(rt::SpscRing::recordSize(sizeof(reply) + size));
  const std::size_t index = reply.call % Channel::kMaxCalls;
  if (index >= tables_->calls.size()) return;  // no call of ours: the provider made it up
  PendingCall& call = tables_->calls[index];
  if (call.number != reply.call) return;
  call.done = true;
  if (!std::exchange(call.fresh, true)) ++fresh_;
  call.error = reply.error;
  call.stamp = reply.stamp;
  std::memcpy(call.result.data(), reply.result(), std::min(size, call.result.size()));
  call.shared = reply.shared;
  if (reply.shared) putSharedSlot(reply.result(), nullptr);  // it is the call's now
  if (call.error == Errc{} && !admitsCopy(call.command, call.result.data())) {
    call.error = Errc::Invalid;
  }
  if (call.abandoned) discard(call);
}

void RequiredBase::discard(PendingCall& call) {
  if (std::exchange(call.fresh, false)) --fresh_;
  if (call.shared) releaseSharedSlot(call.result.data());
  call.shared = false;
  call.number = 0;
  call.follower = nullptr;
}

bool RequiredBase::isDone(PendingCall& call) {
  collectReplies();
  if (call.done) return true;
  const Errc end = endOfCalls();
  if (end == Errc{}) return false;
  collectReplies();  // an answer may have come just before the end
  if (call.done) return true;
  call.done = true;
  call.error = end;
  return true;
}

Errc RequiredBase::endOfCalls() const {
  if (channel_ == nullptr) return Errc::OutcomeUnknown;
  return suture::endOfCalls(channel_->status.load(std::memory_order_acquire));
}

bool RequiredBase::cancel(PendingCall& call) {
  return !isDone(call) && channel_->claimCall(call.number);
}

void RequiredBase::follow(PendingCall& call, Follower follower) {
  call.follower = follower;
  ++followed_;
}

bool RequiredBase::followedMayBeDone() const {
  if (followed_ == 0) return false;
  return endOfCalls() != Errc{} || channel_->nextReply() != nullptr ||
         std::any_of(tables_->calls.begin(), tables_->calls.end(),
                     [](const PendingCall& call) { return call.follower != nullptr && call.done; });
}

void RequiredBase::finishFollowed() {
  if (followed_ == 0) return;
  for (PendingCall& call : tables_->calls) {
    if (call.follower == nullptr || !isDone(call)) continue;
    --followed_;
    std::exchange(call.follower, nullptr)(*this, call);
  }
}

void RequiredBase::waitFor(PendingCall& call, Duration limit) {
  sleepUntil(owner_, now() + limit, [&] { return isDone(call); });
}

bool RequiredBase::unseen() {
  collectReplies();
  return fresh_ != 0 || handledInWait_;
}

void RequiredBase::offerNews() {
  collectReplies();
  handledInWait_ = false;
  if (fresh_ == 0) return;
  for (PendingCall& call : tables_->calls) call.fresh = false;
  fresh_ = 0;
}

}  // namespace suture
