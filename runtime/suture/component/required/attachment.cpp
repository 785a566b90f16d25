#include <suture/component/channel/channel.h>
#include <suture/component/component.h>
#include <suture/component/provided.h>
#include <suture/component/required/attachment.h>

#include <algorithm>

namespace suture {
namespace {

void giveUp(const std::shared_ptr<Channel>& channel) {
  if (channel == nullptr) return;
  channel->direct.clear();
  channel->client.close();
}

}  // namespace

void Attachment::close() {
  const std::unique_ptr<std::shared_ptr<Channel>> unadopted(
      incoming_.exchange(nullptr, std::memory_order_acq_rel));
  if (unadopted != nullptr) giveUp(*unadopted);
  giveUp(channel_);
  awaitDirectHandlers();
}

void Attachment::awaitDirectHandlers() const {
  if (channel_ != nullptr) channel_->direct.awaitCalls();
}

void Attachment::attach(std::shared_ptr<Channel> channel) {
  // Close only what the owner has not taken over; the owner closes the rest.
  const std::unique_ptr<std::shared_ptr<Channel>> unadopted(
      incoming_.exchange(new std::shared_ptr<Channel>(channel), std::memory_order_acq_rel));
  if (unadopted != nullptr && *unadopted != channel) giveUp(*unadopted);
  owner_.doorbell().ring();
}

void Attachment::adopt() {
  if (!rewired()) return;
  const std::unique_ptr<std::shared_ptr<Channel>> arrived(
      incoming_.exchange(nullptr, std::memory_order_acq_rel));
  const bool madeAnew = channel_ != nullptr && *arrived != nullptr &&
                        channel_->terms.watch == (*arrived)->terms.watch;
  if (madeAnew) noticeLoss();
  for (User* const user : users_) user->leave();
  giveUp(channel_);
  owner_.ringNow();  // a bell that is due may go with its channel
  channel_ = std::move(*arrived);
  for (User* const user : users_) user->join();
  lossNoticed_ = false;
  faultsNoticed_ = 0;
}

void Attachment::noticeLoss() {
  if (channel_ == nullptr || channel_->terms.watch == nullptr) return;
  const ChannelStatus status = channel_->status.load(std::memory_order_acquire);
  const std::uint32_t faults = channel_->faults.load(std::memory_order_acquire);
  const bool lost = status == ChannelStatus::Lost || status == ChannelStatus::Faulted;
  const bool news = (lost && !lossNoticed_) || faults != faultsNoticed_;
  lossNoticed_ = lost;
  faultsNoticed_ = faults;
  if (!news) return;
  ConnectionWatch& watch = *channel_->terms.watch;
  watch.losses.fetch_add(1, std::memory_order_relaxed);
  if (watch.contract.resume == Resume::Operator) watch.awaitsOperator = true;
  if (watch.contract.onLoss == Fallback::Fault) {
    owner_.park("connection '" + channel_->name() + "' is lost, and its on_loss is fault",
                FaultCause::Connection);
  }
}

bool Attachment::lossFaults() const {
  return lossNoticed_ && channel_ != nullptr &&
         channel_->terms.watch->contract.onLoss == Fallback::Fault;
}

void Attachment::update() {
  const bool asked = resumeAsked_.load(std::memory_order_relaxed) && resumeAsked_.exchange(false);
  const auto seen = losses();
  adopt();
  noticeLoss();
  if (asked && channel_ != nullptr && seen == losses()) channel_->client.resume();
}

Errc Attachment::unusable() {
  if (!owner_.ownedByThisThread()) return Errc::WrongThread;
  if (!owner_.ownsThread()) update();  // a device has no cycle in which to do it
  if (channel_ == nullptr) return Errc::NotConnected;
  return errorOf(channel_->status.load(std::memory_order_acquire));
}

Errc Attachment::unusable(std::uint16_t command) {
  const Errc error = unusable();
  if (error != Errc{}) return error;
  const std::vector<std::uint16_t>& lacking = channel_->terms.lacking;
  if (std::binary_search(lacking.begin(), lacking.end(), command)) return Errc::NotImplemented;
  return awaitsOperator(command) ? Errc::AwaitingOperator : Errc{};
}

// Reads and qualified reads await no operator, since they move nothing. A provider may have been
// faulted and restarted since noticeLoss() looked, which the next cycle will act on.
bool Attachment::awaitsOperator(std::uint16_t command) const {
  const ConnectionWatch* const watch = channel_->terms.watch.get();
  if (watch == nullptr || watch->contract.resume != Resume::Operator) return false;
  const bool unnoticed = channel_->faults.load(std::memory_order_acquire) != faultsNoticed_;
  if (!unnoticed && !watch->awaitsOperator) return false;
  const CommandKind kind = info_.commands[command].kind;
  return kind != CommandKind::Read && kind != CommandKind::QualifiedRead;
}

// Only asks a device, whose required interfaces belong to another thread than its commands. An
// operator who resumes has not seen a loss that comes later, so that awaits the operator again.
ResumeOutcome Attachment::resume() {
  if (!owner_.ownsThread()) {
    resumeAsked_ = true;
    return ResumeOutcome::Asked;
  }
  const auto seen = losses();
  update();
  if (channel_ == nullptr) return ResumeOutcome::NotConnected;
  return seen == losses() ? channel_->client.resume() : ResumeOutcome::ProviderLost;
}

std::pair<const void*, std::uint64_t> Attachment::losses() const {
  const ConnectionWatch* const watch = channel_ == nullptr ? nullptr : channel_->terms.watch.get();
  return {watch, watch == nullptr ? 0 : watch->losses.load(std::memory_order_relaxed)};
}

void Attachment::watch(ProvidedBase& own) {
  const std::shared_ptr<rt::Doorbell> bell = owner_.sharedDoorbell();
  channel_ = std::make_shared<Channel>(
      info_, Channel::Terms{.name = owner_.name() + "/" + name_}, "own",
      Channel::Ends{.client = bell, .provider = bell, .components = ConnectionEnd::Client},
      own.state(), EventSet{0});
}

}  // namespace suture
