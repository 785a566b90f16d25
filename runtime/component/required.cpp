#include <suture/component/channel.h>
#include <suture/component/required.h>

#include <algorithm>
#include <cstring>

namespace suture {

RequiredBase::RequiredBase(Component& owner, std::string_view name, const InterfaceInfo& info)
    : name_(name),
      owner_(owner),
      info_(info),
      calls_(Channel::kMaxCalls),
      handlers_(info.events.size()) {
  std::uint32_t largest = 0;
  for (const CommandInfo& command : info.commands) largest = std::max(largest, command.resultSize);
  for (PendingCall& call : calls_) call.result.resize(largest);
  owner.required_.push_back(this);
}

RequiredBase::~RequiredBase() {
  delete incoming_.load(std::memory_order_acquire);
  if (channel_ != nullptr) channel_->status = ChannelStatus::Closed;
}

void RequiredBase::attach(std::shared_ptr<Channel> channel) {
  auto* arriving = new std::shared_ptr<Channel>(std::move(channel));
  delete incoming_.exchange(arriving, std::memory_order_acq_rel);
  owner_.doorbell().ring();
}

void RequiredBase::adopt() {
  if (!rewired()) return;
  const std::unique_ptr<std::shared_ptr<Channel>> arrived(
      incoming_.exchange(nullptr, std::memory_order_acq_rel));
  // What was under way went to the old connection; nobody will answer it here.
  for (PendingCall& call : calls_) {
    if (call.number == 0) continue;
    call.error = Errc::OutcomeUnknown;
    call.done = true;
    if (call.abandoned) call.number = 0;
  }
  if (channel_ != nullptr) channel_->status = ChannelStatus::Closed;
  channel_ = std::move(*arrived);
}

Errc RequiredBase::unusable() {
  if (!owner_.ownedByThisThread()) return Errc::WrongThread;
  if (!owner_.ownsThread()) adopt();  // a device has no cycle in which to do it
  if (channel_ == nullptr) return Errc::NotConnected;
  return errorOf(channel_->status.load(std::memory_order_acquire));
}

Errc RequiredBase::unusable(std::uint16_t command) {
  const Errc error = unusable();
  if (error != Errc{} || command < channel_->offered) return error;
  return Errc::NotImplemented;
}

ProvidedBase* RequiredBase::device() const { return channel_->ends.device; }

Errc RequiredBase::claim(std::uint16_t command, std::uint32_t call, std::byte*& arguments) {
  const Result<std::byte*> claimed = channel_->commands.claim(command, now(), call);
  if (!claimed) return claimed.error();
  arguments = *claimed;
  return Errc{};
}

Errc RequiredBase::commit(bool fits) {
  if (!fits) {
    channel_->commands.counters.tooLarge.fetch_add(1, std::memory_order_relaxed);
    return Errc::TooLarge;
  }
  channel_->commands.commit();
  owner_.ringLater(*channel_->ends.provider);
  return Errc{};
}

Sample<void> RequiredBase::read(std::uint16_t command, std::byte* slot, bool& device) {
  if (const Errc error = unusable(command); error != Errc{}) return error;
  device = channel_->ends.device != nullptr;
  if (device) return Errc{};
  const auto column = static_cast<unsigned>(info_.commands[command].column);
  if (channel_->state->ask(column)) owner_.ringLater(*channel_->ends.provider);
  const Result<Time> stamp = channel_->state->read(column, slot);
  if (!stamp) return stamp.error();
  channel_->noteRead(*stamp);
  return Sample<void>(*stamp);
}

void RequiredBase::handleEvents() {
  adopt();
  if (channel_ == nullptr) return;
  while (const rt::EventRecord* record = channel_->events.next()) {
    // Released even if the handler throws: it must not meet the same event again.
    struct Release {
      rt::EventQueue& events;
      ~Release() { events.pop(); }
    } release{channel_->events};
    handlers_[record->event](record->payload());
  }
}

bool RequiredBase::pending() const {
  return rewired() || (channel_ != nullptr && channel_->events.pending());
}

RequiredBase::PendingCall* RequiredBase::openCall() {
  collectReplies();
  const auto free = std::find_if(calls_.begin(), calls_.end(),
                                 [](const PendingCall& call) { return call.number == 0; });
  if (free == calls_.end()) return nullptr;
  const auto index = static_cast<std::uint32_t>(free - calls_.begin());
  ++callsOpened_;
  free->number = callsOpened_ % (1u << 27) * Channel::kMaxCalls + index + Channel::kMaxCalls;
  free->done = free->abandoned = false;
  free->error = Errc{};
  return &*free;
}

void RequiredBase::closeCall(PendingCall& call) {
  // The answer may still come; until then the place is taken.
  if (call.done || channel_ == nullptr) {
    call.number = 0;
  } else {
    call.abandoned = true;
  }
}

void RequiredBase::collectReplies() {
  if (channel_ == nullptr) return;
  while (const std::byte* memory = channel_->replies.front()) {
    const auto* reply = reinterpret_cast<const ReplyRecord*>(memory);
    PendingCall& call = calls_[reply->call % Channel::kMaxCalls];
    if (call.number == reply->call) {
      call.done = true;
      call.error = reply->error;
      call.stamp = reply->stamp;
      const std::size_t size = channel_->replies.frontSize() - sizeof(ReplyRecord);
      std::memcpy(call.result.data(), reply->result(), std::min(size, call.result.size()));
      if (call.abandoned) call.number = 0;
    }
    channel_->replies.pop();
  }
}

bool RequiredBase::isDone(PendingCall& call) {
  collectReplies();
  if (call.done) return true;
  const ChannelStatus status = channel_ == nullptr
                                   ? ChannelStatus::Closed
                                   : channel_->status.load(std::memory_order_acquire);
  // A suspended provider answers what has been sent: with Errc::Suspended.
  if (errorOf(status) == Errc{} || status == ChannelStatus::Suspended) return false;
  collectReplies();  // an answer may have come just before the end
  if (call.done) return true;
  call.done = true;
  call.error = status == ChannelStatus::Faulted ? Errc::Faulted : Errc::OutcomeUnknown;
  return true;
}

void RequiredBase::waitFor(PendingCall& call, Time deadline) {
  owner_.ringNow();
  while (!isDone(call) && now() < deadline) owner_.doorbell().waitUntil(deadline);
}

}  // namespace suture
