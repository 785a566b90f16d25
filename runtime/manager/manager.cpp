#include <suture/base/errors.h>
#include <suture/component/channel.h>
#include <suture/component/task.h>
#include <suture/manager/device_executor.h>
#include <suture/manager/manager.h>
#include <suture/manager/network.h>
#include <suture/transport/delay/delay_thread.h>
#include <suture/wiring/connect.h>

namespace suture {

Manager::Manager(std::string process) : directory_(std::move(process)) {}

Manager::Manager(std::string process, const std::string& address, Duration patience)
    : directory_(std::move(process)) {
  network_ = std::make_unique<Network>(
      directory_, address,
      [this](ProvidedBase& provided) -> rt::Doorbell& { return serverOf(provided); }, patience);
}

// Who serves an interface for those that cannot call it directly: its task, or an executor. Any
// thread.
rt::Doorbell& Manager::serverOf(ProvidedBase& provided) {
  if (provided.owner().ownsThread()) return provided.owner().doorbell();
  const std::lock_guard lock(executorMutex_);
  if (executor_ == nullptr) executor_ = std::make_unique<DeviceExecutor>();
  executor_->serve(provided);
  return executor_->doorbell();
}

DelayThread* Manager::delaysFor(const ConnectionDelay& delay) {
  if (delay.any() && delays_ == nullptr) delays_ = std::make_unique<DelayThread>();
  return delay.any() ? delays_.get() : nullptr;
}

Manager::~Manager() { stop(); }

void Manager::add(const std::string& name, Component& component) {
  directory_.add(name, component);
  component.name_ = name;
}

std::vector<Task*> Manager::tasks() const {
  std::vector<Task*> all;
  for (Component* component : directory_.components()) {
    if (auto* task = dynamic_cast<Task*>(component); task != nullptr) all.push_back(task);
  }
  return all;
}

void Manager::start() {
  for (Task* task : tasks()) task->start();
  if (network_ != nullptr) network_->publish();
}

void Manager::stop() {
  for (Task* task : tasks()) task->stop();
  // The executor rings the doorbells of the network and of delays, and those ring each other's; and
  // the network may yet ask for an executor. So all stop before any of them goes.
  if (network_ != nullptr) network_->leave();
  if (executor_ != nullptr) executor_->stop();
  delays_.reset();
  executor_.reset();
  network_.reset();
}

void Manager::connect(std::string_view requiredName, std::string_view providedName, Lane lane,
                      Duration patience, const ConnectionDelay& delay) {
  const Endpoint from = Endpoint::parse(requiredName), to = Endpoint::parse(providedName);
  RequiredBase& required = directory_.required(from);
  const std::string connection = process() + ":" + from.component + "/" + from.interface + " -> " +
                                 (to.process.empty() ? process() + ":" : "") + to.toString();
  if (const auto existing = connectionOf(from.toString()); existing != nullptr) {
    throw SetupError("connecting " + connection, "it is already connected: " + existing->name,
                     "A required interface has one provider; add another required interface");
  }
  const bool sameProcess = to.process.empty() || to.process == process();
  if (sameProcess && lane == Lane::Auto) {
    local_[from.toString()] = connectHere(required, directory_.provided(to), connection, delay);
    return;
  }
  if (network_ == nullptr) {
    throw SetupError("connecting " + connection, "this process has no global manager",
                     "Give the manager's address when constructing suture::Manager");
  }
  network_->connect(required, from, to, patience, {delaysFor(delay), delay});
}

std::shared_ptr<Channel> Manager::connectHere(RequiredBase& required, ProvidedBase& provided,
                                              const std::string& connection,
                                              const ConnectionDelay& delay) {
  DelayThread* const delays = delaysFor(delay);
  if (delays == nullptr) return connectLocally(required, provided, connection);
  auto far = offerLocally(required, provided, connection, delays->doorbell(), serverOf(provided));
  std::erase_if(offered_, [](const auto& one) { return one->status == ChannelStatus::Closed; });
  offered_.push_back(far);
  return delays->interpose(required, std::move(far), delay);
}

std::shared_ptr<Channel> Manager::connectionOf(const std::string& required) const {
  if (const auto found = local_.find(required); found != local_.end()) return found->second;
  if (network_ == nullptr) return nullptr;
  const auto remote = network_->connected();
  const auto found = remote.find(required);
  return found == remote.end() ? nullptr : found->second;
}

std::string Manager::missingGlobalManager() const {
  return network_ == nullptr ? "" : network_->missingManager();
}

std::vector<std::shared_ptr<Channel>> Manager::channels() const {
  std::vector<std::shared_ptr<Channel>> all;
  for (const auto& [name, channel] : local_) all.push_back(channel);
  all.insert(all.end(), offered_.begin(), offered_.end());
  if (network_ == nullptr) return all;
  for (auto& [name, channel] : network_->connected()) all.push_back(std::move(channel));
  for (auto& channel : network_->served()) all.push_back(std::move(channel));
  return all;
}

}  // namespace suture
