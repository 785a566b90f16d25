#include <suture/component/channel/call_limit.h>
#include <suture/component/channel/channel.h>
#include <suture/component/required.h>
#include <suture/component/required_tables.h>

#include <algorithm>
#include <string>
#include <utility>

namespace suture {

RequiredBase::Tables::Tables(const InterfaceInfo& info)
    : calls(callLimitOf(info).calls), events(info.events.size()) {
  const std::size_t words = (callLimitOf(info).largestResult + 7) / 8;
  results.resize(words * calls.size());
  for (std::size_t i = 0; i < calls.size(); ++i) {
    calls[i].result = std::as_writable_bytes(std::span(results).subspan(i * words, words));
  }
}

RequiredBase::RequiredBase(Component& owner, std::string_view name, const InterfaceInfo& info)
    : name_(name), owner_(owner), info_(info), tables_(std::make_shared<Tables>(info)) {
  refuseUnbounded(info, owner.ownsThread());
  owner.required_.push_back(this);
}

RequiredBase::~RequiredBase() {
  const std::unique_ptr<std::shared_ptr<Channel>> unadopted(
      incoming_.load(std::memory_order_acquire));
  if (unadopted != nullptr) close(*unadopted);
  for (PendingCall& call : tables_->calls) discard(call);
  close(channel_);
  awaitDirectHandlers();
}

void RequiredBase::awaitDirectHandlers() const {
  if (channel_ != nullptr) channel_->direct.awaitCalls();
}

// The provider lets go in its own time, and may be gone: ring only a bell that is shared.
void RequiredBase::close(const std::shared_ptr<Channel>& channel) {
  if (channel == nullptr) return;
  channel->cut();
  channel->status = ChannelStatus::Closed;
  channel->direct.clear();
  if (channel->providersBell != nullptr) channel->providersBell->ring();
}

void RequiredBase::attach(std::shared_ptr<Channel> channel) {
  expectConnection();
  // Close only what the owner has not taken over: the rest is its own to close.
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
  // Calls under way went to the old connection; nobody will answer them here.
  for (PendingCall& call : tables_->calls) {
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
  owner_.ringNow();  // a bell that is due may go with its channel
  channel_ = std::move(*arrived);
  for (std::uint16_t event = 0; event < tables_->events.size(); ++event) lendHandler(event);
  // Pass on what has been subscribed to since the channel was made.
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
    owner_.park("connection '" + channel_->name + "' is lost, and its on_loss is fault",
                FaultCause::Connection);
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
  const std::vector<std::uint16_t>& lacking = channel_->lacking;
  if (std::binary_search(lacking.begin(), lacking.end(), command)) return Errc::NotImplemented;
  return awaitsOperator(command) ? Errc::AwaitingOperator : Errc{};
}

// Reads and qualified reads await no operator, since questions move nothing.
bool RequiredBase::awaitsOperator(std::uint16_t command) const {
  if (channel_->watch == nullptr || !channel_->watch->awaitsOperator) return false;
  const CommandKind kind = info_.commands[command].kind;
  return kind != CommandKind::Read && kind != CommandKind::QualifiedRead;
}

void RequiredBase::watch(ProvidedBase& own) {
  std::erase(owner_.required_, this);
  rt::Doorbell& bell = owner_.doorbell();
  channel_ = std::make_shared<Channel>(info_, owner_.name() + "/" + name_, "own",
                                       Channel::Ends{.client = &bell, .provider = &bell},
                                       own.state(), EventSet{0});
}

std::pair<const void*, std::uint64_t> RequiredBase::losses() const {
  const ConnectionWatch* const watch = channel_ == nullptr ? nullptr : channel_->watch.get();
  return {watch, watch == nullptr ? 0 : watch->losses.load(std::memory_order_relaxed)};
}

// Only asks a device, whose required interfaces belong to another thread than its commands. Whoever
// resumes a connection has not seen what is lost since, so that awaits its operator.
ResumeOutcome RequiredBase::resume() {
  if (!owner_.ownsThread()) {
    resumeAsked_ = true;
    return ResumeOutcome::Asked;
  }
  const auto seen = losses();
  lookAtConnection();
  if (channel_ == nullptr) return ResumeOutcome::NotConnected;
  return seen == losses() ? channel_->resume() : ResumeOutcome::ProviderLost;
}

void RequiredBase::lookAtConnection() {
  const bool asked = resumeAsked_.load(std::memory_order_relaxed) && resumeAsked_.exchange(false);
  const auto seen = losses();
  adopt();
  noticeLoss();
  if (asked && channel_ != nullptr && seen == losses()) channel_->resume();
}

void RequiredBase::handleEvents() {
  const bool atItsEnd = owner_.ending();
  handleQueuedEvents();
  if (!atItsEnd && owner_.ending()) return;
  offerNews();
  finishFollowed();
}

bool RequiredBase::pending() const {
  return rewired() || followedMayBeDone() || (channel_ != nullptr && channel_->events.pending());
}

}  // namespace suture
