#include <suture/base/slots/used_parts.h>
#include <suture/base/words.h>
#include <suture/component/channel/call_limit.h>
#include <suture/component/channel/channel.h>
#include <suture/component/required/calls.h>
#include <suture/component/sleep.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace suture {

Calls::Calls(Attachment& attachment)
    : attachment_(attachment), calls_(callLimitOf(attachment.info()).calls) {
  const std::size_t words = wordsFor(callLimitOf(attachment.info()).largestResult);
  results_.resize(words * calls_.size());
  for (std::size_t i = 0; i < calls_.size(); ++i) {
    calls_[i].result = std::as_writable_bytes(std::span(results_).subspan(i * words, words));
  }
  attachment.inform(*this);
}

Calls::~Calls() {
  for (PendingCall& call : calls_) discard(call);
}

PendingCall* Calls::open(std::uint16_t command) {
  collectReplies();
  const auto free = std::find_if(calls_.begin(), calls_.end(),
                                 [](const PendingCall& call) { return call.number == 0; });
  if (free == calls_.end()) return nullptr;
  const auto index = static_cast<std::uint32_t>(free - calls_.begin());
  ++opened_;
  free->number = opened_ % (1u << 27) * Channel::kMaxCalls + index + Channel::kMaxCalls;
  free->command = command;
  free->done = free->abandoned = false;
  free->error = Errc{};
  return &*free;
}

void Calls::close(PendingCall& call) {
  // The answer may still come, so the place stays taken until then.
  if (call.done || attachment_.channel() == nullptr) {
    discard(call);
  } else {
    call.abandoned = true;
  }
}

// Ends calls under way, which went to the old connection: the next one will not answer them.
void Calls::leave() {
  collectReplies();
  for (PendingCall& call : calls_) {
    if (call.number == 0 || call.done) continue;
    call.error = Errc::OutcomeUnknown;
    call.done = true;
    if (call.abandoned) discard(call);
  }
}

void Calls::collectReplies() {
  Channel* const channel = attachment_.channel().get();
  if (channel == nullptr) return;
  channel->client.lowerUntaken();
  // Take no more than there may be calls, because a foreign provider may write without end.
  for (std::size_t i = 0; i < calls_.size(); ++i) {
    ReplyRecord* const reply = channel->client.nextReply();
    if (reply == nullptr) return;
    collect(*reply, channel->replies.frontSize() - sizeof(ReplyRecord));
    channel->client.popReply();
  }
}

void Calls::collect(ReplyRecord& reply, std::size_t size) {
  Channel& channel = *attachment_.channel();
  channel.countReceived(rt::SpscRing::recordSize(sizeof(reply) + size));
  const std::size_t index = reply.call % Channel::kMaxCalls;
  if (index >= calls_.size()) return;  // no call of ours: the provider invented it
  PendingCall& call = calls_[index];
  if (call.number != reply.call) return;
  call.done = true;
  if (!std::exchange(call.fresh, true)) ++fresh_;
  call.error = toldErrc(static_cast<std::uint8_t>(reply.error));  // any process may have written it
  call.stamp = reply.stamp;
  const CommandInfo& command = attachment_.info().commands[call.command];
  copyUsed(call.result.data(), reply.result(), std::min(size, call.result.size()),
           size == command.resultSize ? command.resultLevels : BoundedLevels{});
  call.shared = reply.shared;
  if (reply.shared) putSharedSlot(reply.result(), nullptr);  // the call owns it now
  if (call.error == Errc{} && !channel.admitsCopy(command, call.result.data())) {
    call.error = Errc::Invalid;
  }
  if (call.abandoned) discard(call);
}

void Calls::discard(PendingCall& call) {
  if (std::exchange(call.fresh, false)) --fresh_;
  if (call.shared) releaseSharedSlot(call.result.data());
  call.shared = false;
  call.number = 0;
  call.follower = nullptr;
}

bool Calls::isDone(PendingCall& call) {
  collectReplies();
  if (call.done) return true;
  const Errc reason = end();
  if (reason == Errc{}) return false;
  collectReplies();  // an answer may have come just before the end
  if (call.done) return true;
  call.done = true;
  call.error = reason;
  return true;
}

Errc Calls::end() const {
  const Channel* const channel = attachment_.channel().get();
  if (channel == nullptr) return Errc::OutcomeUnknown;
  return endOfCalls(channel->status.load(std::memory_order_acquire));
}

bool Calls::cancel(PendingCall& call) {
  return !isDone(call) && attachment_.channel()->client.cancel(call.number);
}

void Calls::waitFor(PendingCall& call, Duration limit) {
  sleepUntil(attachment_.owner(), fromNow(limit), [&] { return isDone(call); });
}

bool Calls::mayWait() const { return attachment_.owner().mayWait(); }

void Calls::noteTimeout() const {
  Channel* const channel = attachment_.channel().get();
  if (channel == nullptr) return;
  if (attachment_.owner().holdsUp(Channel::componentOf(channel->providerName()))) {
    channel->mutualWaits.fetch_add(1, std::memory_order_relaxed);
  }
}

void Calls::follow(PendingCall& call, PendingCall::Follower follower) {
  call.follower = follower;
  ++followed_;
}

bool Calls::followedMayBeDone() const {
  if (followed_ == 0) return false;
  return end() != Errc{} || attachment_.channel()->client.nextReply() != nullptr ||
         std::any_of(calls_.begin(), calls_.end(),
                     [](const PendingCall& call) { return call.follower != nullptr && call.done; });
}

void Calls::finishFollowed() {
  if (followed_ == 0) return;
  for (PendingCall& call : calls_) {
    if (call.follower == nullptr || !isDone(call)) continue;
    --followed_;
    std::exchange(call.follower, nullptr)(*this, call);
  }
}

bool Calls::unseen() {
  collectReplies();
  return fresh_ != 0;
}

void Calls::markSeen() {
  if (!unseen()) return;
  for (PendingCall& call : calls_) call.fresh = false;
  fresh_ = 0;
}

}  // namespace suture
