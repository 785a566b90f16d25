#include <suture/component/channel.h>
#include <suture/component/required.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <utility>

namespace suture {

RequiredBase::RequiredBase(Component& owner, std::string_view name, const InterfaceInfo& info)
    : name_(name),
      owner_(owner),
      info_(info),
      calls_(Channel::kMaxCalls),
      events_(info.events.size()) {
  refuseUnbounded(info, owner.ownsThread());
  std::uint32_t largest = 0;
  for (const CommandInfo& command : info.commands) largest = std::max(largest, command.resultSize);
  for (PendingCall& call : calls_) call.result.resize(largest);
  owner.required_.push_back(this);
}

RequiredBase::~RequiredBase() {
  const std::unique_ptr<std::shared_ptr<Channel>> unadopted(
      incoming_.load(std::memory_order_acquire));
  if (unadopted != nullptr) close(*unadopted);
  for (PendingCall& call : calls_) discard(call);
  close(channel_);
  awaitDirectHandlers();
}

void RequiredBase::awaitDirectHandlers() const {
  if (channel_ != nullptr) channel_->direct.awaitCalls();
}

// The provider lets go of it in its own time.
void RequiredBase::close(const std::shared_ptr<Channel>& channel) {
  if (channel == nullptr) return;
  channel->status = ChannelStatus::Closed;
  channel->direct.clear();
}

void RequiredBase::attach(std::shared_ptr<Channel> channel) {
  // What has arrived is the owner's.
  const std::unique_ptr<std::shared_ptr<Channel>> unadopted(
      incoming_.exchange(new std::shared_ptr<Channel>(channel), std::memory_order_acq_rel));
  if (unadopted != nullptr && *unadopted != channel) close(*unadopted);
  owner_.doorbell().ring();
}

void RequiredBase::adopt() {
  if (!rewired()) return;
  const std::unique_ptr<std::shared_ptr<Channel>> arrived(
      incoming_.exchange(nullptr, std::memory_order_acq_rel));
  collectReplies();
  // What was under way went to the old connection; nobody will answer it here.
  for (PendingCall& call : calls_) {
    if (call.number == 0 || call.done) continue;
    call.error = Errc::OutcomeUnknown;
    call.done = true;
    if (call.abandoned) discard(call);
  }
  const bool madeAnew =
      channel_ != nullptr && *arrived != nullptr && channel_->watch == (*arrived)->watch;
  if (madeAnew) noticeLoss();
  if (channel_ != nullptr) loseAwaited();
  close(channel_);
  channel_ = std::move(*arrived);
  for (std::uint16_t event = 0; event < events_.size(); ++event) lendHandler(event);
  // What has been subscribed to since the channel was made.
  if (channel_ != nullptr) passSubscriptionsOn(subscribed() & ~channel_->subscribed());
  lossNoticed_ = false;
  faultsNoticed_ = 0;
}

void RequiredBase::noticeLoss() {
  if (channel_ == nullptr || channel_->watch == nullptr) return;
  const ChannelStatus status = channel_->status.load(std::memory_order_acquire);
  const std::uint32_t faults = channel_->faults.load(std::memory_order_acquire);
  const bool lost = status == ChannelStatus::Lost || status == ChannelStatus::Faulted;
  const bool news = (lost && !lossNoticed_) || faults != faultsNoticed_;
  lossNoticed_ = lost;
  faultsNoticed_ = faults;
  if (!news) return;
  ConnectionWatch& watch = *channel_->watch;
  watch.losses.fetch_add(1, std::memory_order_relaxed);
  if (watch.contract.resume == Resume::Operator) watch.awaitsOperator = true;
  if (watch.contract.onLoss == Fallback::Fault) {
    owner_.park("connection '" + channel_->name + "' is lost, and its on_loss is fault");
  }
}

Errc RequiredBase::unusable() {
  if (!owner_.ownedByThisThread()) return Errc::WrongThread;
  if (!owner_.ownsThread()) lookAtConnection();  // a device has no cycle in which to do it
  if (channel_ == nullptr) return Errc::NotConnected;
  return errorOf(channel_->status.load(std::memory_order_acquire));
}

Errc RequiredBase::unusable(std::uint16_t command) {
  const Errc error = unusable();
  if (error != Errc{}) return error;
  if (command >= channel_->offered) return Errc::NotImplemented;
  return awaitsOperator(command) ? Errc::AwaitingOperator : Errc{};
}

// Questions move nothing.
bool RequiredBase::awaitsOperator(std::uint16_t command) const {
  if (channel_->watch == nullptr || !channel_->watch->awaitsOperator) return false;
  const CommandKind kind = info_.commands[command].kind;
  return kind != CommandKind::Read && kind != CommandKind::QualifiedRead;
}

Duration RequiredBase::deadlineOf(std::uint16_t command) const {
  const ConnectionWatch* const watch = channel_->watch.get();
  const bool agreed = watch != nullptr && watch->contract.deadline > Duration{0};
  return agreed ? watch->contract.deadline : info_.commands[command].deadline;
}

Sample<void> RequiredBase::judgeAge(Time stamp) {
  ConnectionWatch* const watch = channel_->watch.get();
  if (watch == nullptr || watch->contract.maxAge == Duration{0}) return Sample<void>(stamp);
  if (now() - stamp <= watch->contract.maxAge) return Sample<void>(stamp);
  watch->staleReads.fetch_add(1, std::memory_order_relaxed);
  if (watch->contract.resume == Resume::Operator) watch->awaitsOperator = true;
  return fallBack(watch->contract.onStale, Errc::Stale, stamp);
}

Sample<void> RequiredBase::judgeLoss(Errc error, std::uint16_t command, std::byte* slot) {
  if ((error != Errc::Lost && error != Errc::Faulted) || channel_->watch == nullptr) return error;
  const auto column = static_cast<unsigned>(info_.commands[command].column);
  const Result<Time> stamp = channel_->state->read(column, slot);
  if (!stamp) return error;
  return fallBack(channel_->watch->contract.onLoss, error, *stamp);
}

Sample<void> RequiredBase::fallBack(Fallback fallback, Errc error, Time stamp) {
  if (fallback == Fallback::Fault && error == Errc::Stale) {
    owner_.park("connection '" + channel_->name + "': a value was " +
                std::to_string((now() - stamp) / std::chrono::milliseconds(1)) +
                " ms old, beyond its max_age, and its on_stale is fault");
  }
  const bool usable = fallback == Fallback::Zero || fallback == Fallback::Last;
  return {error, stamp, usable};
}

bool RequiredBase::zeroes(const Sample<void>& answer) const {
  if (!answer || answer.error() == Errc{}) return false;
  const ConnectionContract& contract = channel_->watch->contract;
  return (answer.error() == Errc::Stale ? contract.onStale : contract.onLoss) == Fallback::Zero;
}

ProvidedBase* RequiredBase::callee(std::uint16_t command) const {
  const Channel::Ends& ends = channel_->ends;
  return info_.commands[command].inCallersThread ? ends.here : ends.device;
}

Errc RequiredBase::claim(std::uint16_t command, std::uint32_t call, std::byte*& arguments) {
  const Result<std::byte*> claimed = channel_->commands.claim(command, now(), call);
  if (!claimed) return claimed.error();
  arguments = *claimed;
  return Errc{};
}

Errc RequiredBase::commit(bool fits) {
  if (!fits) {
    channel_->commands.abandon();
    channel_->commands.counters.tooLarge.fetch_add(1, std::memory_order_relaxed);
    return Errc::TooLarge;
  }
  channel_->commands.commit();
  owner_.ringLater(*channel_->ends.provider);
  return Errc{};
}

Errc RequiredBase::ask(std::uint16_t command, bool& device) {
  if (const Errc error = unusable(command); error != Errc{}) return error;
  device = channel_->ends.device != nullptr;
  if (device) return Errc{};
  const auto column = static_cast<unsigned>(info_.commands[command].column);
  if (channel_->state->ask(column)) owner_.ringLater(*channel_->ends.provider);
  return Errc{};
}

Sample<void> RequiredBase::read(std::uint16_t command, std::byte* slot, bool& device) {
  const Errc error = ask(command, device);
  if (device) return error;
  if (error != Errc{}) return judgeLoss(error, command, slot);
  const auto column = static_cast<unsigned>(info_.commands[command].column);
  const Result<Time> stamp = channel_->state->read(column, slot);
  if (!stamp) return stamp.error();
  channel_->noteRead(*stamp);
  return judgeAge(*stamp);
}

Sample<void> RequiredBase::readAt(Time at, std::uint16_t command, std::byte* slot, bool& device) {
  if (const Errc error = ask(command, device); error != Errc{} || device) return error;
  const auto column = static_cast<unsigned>(info_.commands[command].column);
  const Result<Time> stamp = channel_->state->readAt(at, column, slot);
  if (!stamp) return stamp.error();
  return Sample<void>(*stamp);
}

Sample<void> RequiredBase::readRow(const Time* at, std::span<const std::uint16_t> commands,
                                   std::span<std::byte* const> slots, bool& device) {
  std::array<std::byte*, 64> byColumn{};  // a contract has no more reads
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (const Errc error = ask(commands[i], device); error != Errc{} || device) return error;
    byColumn[static_cast<std::size_t>(info_.commands[commands[i]].column)] = slots[i];
  }
  const rt::StateTable& state = *channel_->state;
  const std::span<std::byte* const> wanted = std::span(byColumn).first(state.columns());
  const rt::StateTable::Row row =
      at == nullptr ? state.readRow(wanted) : state.readRowAt(*at, wanted);
  for (const std::uint16_t command : commands) {
    const auto column = static_cast<unsigned>(info_.commands[command].column);
    if (const Errc error = row.missing(column); error != Errc{}) return error;
  }
  if (at != nullptr) return Sample<void>(row.stamp);
  channel_->noteRead(row.stamp);
  return judgeAge(row.stamp);
}

Result<void> RequiredBase::handle(std::uint16_t event,
                                  std::function<void(const std::byte*, Time)> handler) {
  return subscribe(event, [handler = std::move(handler)](const std::byte* payload) {
    handler(payload, rt::EventRecord::of(payload).stamp);
  });
}

Result<void> RequiredBase::subscribe(std::uint16_t event, EventHandler handler, bool direct) {
  if (owner_.ownedByAnotherThread()) return tl::unexpected(Errc::WrongThread);
  if (handler == nullptr) return unsubscribe(event);
  HeardEvent& heard = events_[event];
  const bool joins = heard.handler == nullptr;
  if (joins) heard.since = now();
  heard.handler = std::make_shared<const EventHandler>(std::move(handler));
  heard.direct = direct;
  lendHandler(event);
  const EventSet bit = EventSet{1} << event;
  subscribed_.fetch_or(bit, std::memory_order_relaxed);
  passSubscriptionsOn(joins ? bit : 0);
  return {};
}

Result<void> RequiredBase::unsubscribe(std::uint16_t event) {
  if (owner_.ownedByAnotherThread()) return tl::unexpected(Errc::WrongThread);
  events_[event].handler = nullptr;
  events_[event].direct = false;
  lendHandler(event);
  if (!isAwaited(event)) {
    subscribed_.fetch_and(~(EventSet{1} << event), std::memory_order_relaxed);
  }
  passSubscriptionsOn(0);
  return {};
}

void RequiredBase::lendHandler(std::uint16_t event) {
  if (channel_ == nullptr || channel_->ends.here == nullptr) return;
  const HeardEvent& heard = events_[event];
  if (!heard.direct && (channel_->direct.events() >> event & 1) == 0) return;
  channel_->direct.set(event, owner_, heard.direct ? heard.handler : nullptr);
  if (heard.direct) refuseAwaited(event);
}

void RequiredBase::passSubscriptionsOn(EventSet joining) {
  if (channel_ == nullptr) return;
  if (joining == 0 && channel_->subscribed() == subscribed()) return;
  channel_->subscribe(subscribed(), joining);
  // Past its end, what is at the far end may be gone.
  const ChannelStatus status = channel_->status.load(std::memory_order_acquire);
  if (status == ChannelStatus::Lost || status == ChannelStatus::Closed) return;
  const Channel::Ends& ends = channel_->ends;
  owner_.ringLater(*ends.provider);
  if (ends.device != nullptr) ends.device->greetLocal(*channel_);
}

void RequiredBase::watch(ProvidedBase& own) {
  std::erase(owner_.required_, this);
  rt::Doorbell& bell = owner_.doorbell();
  channel_ = std::make_shared<Channel>(info_, owner_.name() + "/" + name_, "own",
                                       Channel::Ends{.client = &bell, .provider = &bell},
                                       own.state(), EventSet{0});
}

void RequiredBase::lookAtConnection() {
  adopt();
  noticeLoss();
}

void RequiredBase::handleEvents() {
  handleQueuedEvents();
  finishFollowed();
}

void RequiredBase::handleQueuedEvents() {
  const std::shared_ptr<Channel> channel = channel_;  // a handler of a device may take over another
  if (channel == nullptr) return;
  while (const rt::EventRecord* record = channel->events.next()) {
    // Released even if the handler throws: it must not meet the same event again.
    struct Release {
      rt::EventQueue& events;
      bool& handling;
      ~Release() {
        handling = false;
        events.pop();
      }
    } release{channel->events, handling_};
    handling_ = true;
    deliver(*record);
  }
}

void RequiredBase::deliver(const rt::EventRecord& record) {
  satisfyAwaited(record);
  const HeardEvent& heard = events_[record.event];
  // Of a latched event the value may be older than its subscription: a replay.
  if (record.stamp < heard.since && !info_.events[record.event].latched) return;
  const auto handler = heard.handler;  // lives on if it ends its own subscription
  if (handler != nullptr) (*handler)(record.payload());
}

bool RequiredBase::pending() const {
  return rewired() || followedMayBeDone() || (channel_ != nullptr && channel_->events.pending());
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
    discard(call);
  } else {
    call.abandoned = true;
  }
}

void RequiredBase::collectReplies() {
  if (channel_ == nullptr) return;
  while (ReplyRecord* const reply = channel_->nextReply()) {
    collect(*reply, channel_->replies.frontSize() - sizeof(ReplyRecord));
    channel_->popReply();
  }
}

void RequiredBase::collect(ReplyRecord& reply, std::size_t size) {
  PendingCall& call = calls_[reply.call % Channel::kMaxCalls];
  if (call.number != reply.call) return;
  ++answers_;
  call.done = true;
  call.error = reply.error;
  call.stamp = reply.stamp;
  std::memcpy(call.result.data(), reply.result(), std::min(size, call.result.size()));
  call.shared = reply.shared;
  if (reply.shared) putSharedSlot(reply.result(), nullptr);  // it is the call's now
  if (call.abandoned) discard(call);
}

void RequiredBase::discard(PendingCall& call) {
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
  switch (channel_->status.load(std::memory_order_acquire)) {
    case ChannelStatus::Connected: return Errc{};
    // It answers what has been sent: with Errc::Suspended.
    case ChannelStatus::Suspended: return Errc{};
    case ChannelStatus::Faulted: return Errc::Faulted;
    default: return Errc::OutcomeUnknown;
  }
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
         std::any_of(calls_.begin(), calls_.end(),
                     [](const PendingCall& call) { return call.follower != nullptr && call.done; });
}

void RequiredBase::finishFollowed() {
  if (followed_ == 0) return;
  for (PendingCall& call : calls_) {
    if (call.follower == nullptr || !isDone(call)) continue;
    --followed_;
    std::exchange(call.follower, nullptr)(*this, call);
  }
}

void RequiredBase::waitFor(PendingCall& call, Time deadline) {
  owner_.ringNow();
  const std::uint32_t before = answers_;
  bool forOthers = false;
  while (!isDone(call) && now() < deadline) {
    const bool rung = owner_.doorbell().waitUntil(deadline);
    forOthers = forOthers || (rung && !isDone(call));
  }
  // The ring of what is for the next cycle has been taken notice of here.
  if (forOthers || answers_ - before > 1) owner_.doorbell().ring();
}

}  // namespace suture
