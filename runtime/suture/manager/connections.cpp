#include <suture/base/errors.h>
#include <suture/component/channel/channel.h>
#include <suture/lane/delay/delay_thread.h>
#include <suture/manager/connections.h>
#include <suture/session/network.h>
#include <suture/wiring/connect.h>

#include <utility>

namespace suture {
namespace {

std::shared_ptr<ConnectionWatch> watchOf(ConnectionContract contract,
                                         const RequiredBase& required) {
  if (contract.maxAge == Duration{0}) contract.maxAge = required.maxAge();
  if (contract == ConnectionContract{}) return nullptr;
  return std::make_shared<ConnectionWatch>(contract);
}

// Refuses a silence that is too short for the ten heartbeats that must fit into it.
void requireSilenceThatCanBeTold(const ConnectionContract& contract,
                                 const std::string& connection) {
  constexpr Duration kShortest = ConnectionContract::kShortestSilence;
  if (contract.silence == Duration{0} || contract.silence >= kShortest) return;
  throw SetupError(
      "connecting " + connection,
      "a longest silence of " + std::to_string(contract.silence.count()) + " ns",
      "Allow at least " + std::to_string(kShortest / std::chrono::milliseconds(1)) + " ms");
}

// Zero has a meaning of its own for each of these.
void requireNoNegativeTime(const ConnectOptions& options, const RequiredBase& required,
                           const std::string& connection) {
  const std::pair<const char*, Duration> times[] = {{"a max_age", options.contract.maxAge},
                                                    {"a max_age", required.maxAge()},
                                                    {"a deadline", options.contract.deadline},
                                                    {"a patience", options.patience},
                                                    {"a delay of commands", options.delay.commands},
                                                    {"a delay of answers", options.delay.answers}};
  for (const auto& [time, length] : times) {
    if (length >= Duration{0}) continue;
    throw SetupError("connecting " + connection,
                     time + (" of " + std::to_string(length.count())) + " ns",
                     "Give a time that is not negative; 0 stands for none");
  }
}

void requirePossible(const ConnectOptions& options, const RequiredBase& required,
                     const std::string& connection) {
  requireNoNegativeTime(options, required, connection);
  requireSilenceThatCanBeTold(options.contract, connection);
  if (options.delay.any()) DelayThread::requireBounded(required.info());
  if (options.laneRequired && options.lane == Lane::Auto) {
    throw SetupError("connecting " + connection, "it requires a lane and names none",
                     "Name the lane, or let it have any");
  }
}

}  // namespace

void Connections::connect(RequiredBase& required, const Endpoint& from,
                          std::string_view providedName, const ConnectOptions& options) {
  const Endpoint to = Endpoint::parse(providedName);
  const std::string& process = directory_.process();
  const bool sameProcess = to.process.empty() || to.process == process;
  const std::string connection =
      connectionName({process, from.component, from.interface},
                     {sameProcess ? process : to.process, to.component, to.interface});
  requireFree(from, connection);
  requirePossible(options, required, connection);
  if (sameProcess && options.lane == Lane::Auto) {
    local_[from.toString()] = connectHere(required, directory_.provided(to), connection, options);
    return;
  }
  if (network_ == nullptr) {
    throw SetupError("connecting " + connection, "this process has no global manager",
                     "Give the manager's address when constructing suture::Manager");
  }
  network_->connect({.required = required,
                     .from = from,
                     .to = to,
                     .options = options,
                     .delays = threads_.delaysFor(options.delay),
                     .watch = watchOf(options.contract, required)});
}

void Connections::requireFree(const Endpoint& required, const std::string& connection) const {
  const auto existing = of(required.toString());
  if (existing == nullptr) return;
  throw SetupError("connecting " + connection, "it is already connected: " + existing->name(),
                   "A required interface has one provider; disconnect() it first, or add another "
                   "required interface");
}

std::shared_ptr<Channel> Connections::connectHere(RequiredBase& required, ProvidedBase& provided,
                                                  const std::string& connection,
                                                  const ConnectOptions& options) {
  auto watch = watchOf(options.contract, required);
  DelayThread* const delays = threads_.delaysFor(options.delay);
  if (delays == nullptr) return connectLocally(required, provided, connection, std::move(watch));
  auto far = offerLocally(required, provided, {.name = connection, .watch = std::move(watch)},
                          {.client = delays->sharedDoorbell(),
                           .provider = threads_.serverOf(provided),
                           .components = ConnectionEnd::Provider});
  std::erase_if(offered_, [](const auto& one) { return one->status == ChannelStatus::Closed; });
  offered_.push_back(far);
  auto near = delays->interpose(required, std::move(far), options.delay);
  required.attach(near);
  return near;
}

void Connections::disconnect(std::string_view requiredName) {
  const Endpoint from = Endpoint::parse(requiredName);
  RequiredBase& required = directory_.required(from);
  const std::string name = from.toString();
  const auto channel = of(name);
  if (channel == nullptr) {
    throw SetupError("disconnecting '" + name + "'", "it is not connected",
                     "Connect it with connect() first");
  }
  drop(name);
  required.attach(nullptr);
  if (!required.owner().hasCycles()) channel->client.close();  // nobody else would soon
}

void Connections::drop(const std::string& required) {
  if (local_.erase(required) == 0 && network_ != nullptr) network_->disconnect(required);
}

void Connections::resume(std::string_view requiredName) {
  const std::string asked = "resuming connection '" + std::string(requiredName) + "'";
  const auto channel = of(Endpoint::parse(requiredName).toString());
  if (channel == nullptr) throw SetupError(asked, "it is not connected", "Connect it first");
  switch (channel->client.resume()) {
    case ResumeOutcome::NotAwaiting:
      throw SetupError(asked, "it does not await an operator", "Nothing has to be done");
    case ResumeOutcome::ProviderLost:
      throw SetupError(asked, toString(errorOf(channel->status.load(std::memory_order_acquire))),
                       "Have its provider run again, and look at it, first");
    default: return;
  }
}

std::shared_ptr<Channel> Connections::of(const std::string& required) const {
  if (const auto found = local_.find(required); found != local_.end()) return found->second;
  return network_ == nullptr ? nullptr : network_->news().connected(required);
}

std::vector<std::shared_ptr<Channel>> Connections::all() const {
  std::vector<std::shared_ptr<Channel>> all;
  for (const auto& [name, channel] : local_) all.push_back(channel);
  all.insert(all.end(), offered_.begin(), offered_.end());
  if (network_ == nullptr) return all;
  for (auto& [name, channel] : network_->news().connected()) all.push_back(std::move(channel));
  for (auto& channel : network_->served()) all.push_back(std::move(channel));
  return all;
}

}  // namespace suture
