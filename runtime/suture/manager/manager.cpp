#include <suture/base/errors.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/component/task/task.h>
#include <suture/lane/delay/delay_thread.h>
#include <suture/lane/lane_kind.h>
#include <suture/manager/handle.h>
#include <suture/manager/lifecycle_interface.h>
#include <suture/manager/manager.h>
#include <suture/rt/standard_error.h>
#include <suture/session/network.h>
#include <suture/standard/collecting.suture.h>
#include <suture/wiring/connect.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

// A change of a component's state rings; this is how often those who wait look for what does not: a
// lost provider that is back, or that a faulted task stays so.
constexpr Duration kLookAgain = std::chrono::milliseconds(10);

Task* taskOf(Component& component) {
  return component.ownsThread() ? static_cast<Task*>(&component) : nullptr;
}

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

// Compares hashes, since a shared library has its own tables.
bool collects(const Component& component) {
  const std::string_view collecting = interfaceInfo<Collecting>().hash;
  const auto& all = component.provided();
  return std::any_of(all.begin(), all.end(),
                     [&](const ProvidedBase* one) { return one->info().hash == collecting; });
}

void startOne(Component& component) {
  if (Task* const task = taskOf(component); task != nullptr) {
    task->start();
  } else {
    static_cast<Device&>(component).start();
  }
}

}  // namespace

Manager::Manager(std::string process) : directory_(std::move(process)) {}

Manager::Manager(std::string process, const std::string& address, Duration patience)
    : Manager(std::move(process), address, Security{}, patience) {}

Manager::Manager(std::string process, const std::string& address, const Security& security,
                 Duration patience, std::uint16_t port)
    : directory_(std::move(process)) {
  network_ = std::make_unique<Network>(directory_, address, threads_, patience, security, port);
}

Manager::~Manager() {
  refuseToStopInCycle();
  if (const std::string why = stopAll(); !why.empty()) rt::printUnlessFull(why);
  for (HandleBase* handle : handles_) handle->manager_ = nullptr;
}

void Manager::add(const std::string& name, Component& component) {
  directory_.add(name, component, [&] {
    if (const auto other = component.process_.lock()) {
      throw SetupError("adding a component '" + name + "' to process '" + process() + "'",
                       "it is '" + component.name() + "' of process '" + *other + "'",
                       "Create a second object, or destroy the manager of that process before");
    }
    component.name_ = name;
    component.process_ = name_;
    if (!component.hasStateListener())
      component.setStateListener(std::make_shared<LifecycleInterface>(component, changed_));
  });
}

void Manager::scheduleService(const rt::Scheduling& scheduling) {
  const rt::Granted granted = rt::grantedOf("the connections of " + process(), scheduling);
  if (!granted.refusals.empty()) throw SetupError(granted.refusals.front());
  if (network_ != nullptr) network_->schedule(scheduling);
  threads_.schedule(scheduling);
}

void Manager::addLane(std::unique_ptr<LaneKind> lane) {
  if (network_ == nullptr) {
    throw SetupError("adding a lane", "process '" + process() + "' has no global manager",
                     "Give the manager's address when constructing suture::Manager");
  }
  network_->addLane(std::move(lane));
}

std::vector<std::string> Manager::lanes() const {
  return network_ == nullptr ? std::vector<std::string>{} : network_->lanes();
}

void Manager::configure() {
  for (Component* component : directory_.components()) {
    if (after(component->state(), Transition::Configure)) component->configure();
  }
}

void Manager::start() {
  started_ = true;
  configure();
  for (Component* component : directory_.components()) {
    const ComponentState state = component->state();
    const bool started = state == ComponentState::Running || state == ComponentState::Suspended;
    if (!started) startOne(*component);
  }
  if (network_ != nullptr) network_->publish();
}

void Manager::awaitStart(Duration patience) const {
  const Time begin = now();
  const auto faulted = [this] {
    const std::vector<Component*> all = directory_.components();
    return std::any_of(all.begin(), all.end(), [](const Component* component) {
      return component->state() == ComponentState::Faulted;
    });
  };
  const Time deadline = fromNow(patience);
  while (!missing().empty() && now() < deadline && !faulted()) {
    changed_->waitUntil(std::min(deadline, now() + kLookAgain));
  }
  const std::vector<std::string> lines = missing();
  if (lines.empty()) return;
  const auto waited = std::chrono::duration_cast<std::chrono::milliseconds>(now() - begin);
  std::string found = "after " + std::to_string(waited.count()) + " ms this is missing:";
  for (const std::string& line : lines) found += "\n    " + line;
  throw SetupError("waiting until process '" + process() + "' has started", found + "\n  ",
                   "Mend that, or call makeOptional() of what a component can do without");
}

std::vector<std::string> Manager::missing() const {
  std::vector<std::string> lines;
  for (const Component* component : directory_.components()) {
    const ComponentState state = component->state();
    if (state != ComponentState::Running) {
      lines.push_back("component '" + component->name() + "' is " + toString(state) +
                      (state == ComponentState::Faulted ? ", " + component->whyFaulted() : ""));
    }
    for (const RequiredBase* required : component->required()) {
      if (required->isOptional()) continue;
      if (std::string line = missingFor(*required); !line.empty()) lines.push_back(std::move(line));
    }
  }
  return lines;
}

std::string Manager::missingFor(const RequiredBase& required) const {
  const std::string name = required.owner().name() + "/" + required.name();
  const std::string what =
      "required interface '" + name + "' (" + required.info().name + ") is not connected: ";
  const auto channel = connectionOf(name);
  if (channel == nullptr) return what + "nobody has called connect() for it";
  const Errc error = errorOf(channel->status.load(std::memory_order_acquire));
  return error == Errc{} ? "" : what + channel->name() + ": " + toString(error);
}

void Manager::suspend(const std::string& component, Duration patience) {
  change(component, Transition::Suspend, patience);
}

void Manager::resume(const std::string& component, Duration patience) {
  change(component, Transition::Resume, patience);
}

void Manager::change(const std::string& name, Transition transition, Duration patience) {
  Component& component = directory_.component(name);
  const ComponentState before = component.state();
  component.request(transition);
  const Time deadline = fromNow(patience);
  const auto undecided = [&component, before, task = taskOf(component)] {
    const ComponentState state = component.state();
    // A task that is restarted after a fault does what it was asked.
    const bool mayGoOn = task != nullptr && !task->staysFaulted();
    return state == before || (state == ComponentState::Faulted && mayGoOn);
  };
  while (undecided() && now() < deadline) {
    changed_->waitUntil(std::min(deadline, now() + kLookAgain));
  }
  const ComponentState reached = component.state();
  const ComponentState* const meant = after(before, transition);
  if (meant != nullptr && reached == *meant) return;
  const std::string asked = "component '" + name + "' was asked to " + toString(transition);
  if (reached == ComponentState::Faulted) {
    throw SetupError(asked, component.whyFaulted(), "Correct the cause");
  }
  throw SetupError(asked, std::string("it is still ") + toString(reached),
                   "It changes between two cycles: its run() has to return, the period of a "
                   "PeriodicTask to pass, and the callback of a CallbackTask to come");
}

void Manager::giveUp() {
  if (network_ != nullptr) network_->giveUp();
}

void Manager::stop() {
  refuseToStopInCycle();
  if (const std::string why = stopAll(); !why.empty()) throw SetupError(why);
}

// Returns why one of the parts has failed to stop, in words; "" if none has.
std::string Manager::stopAll() {
  // Once stopped, components may be gone before the manager is.
  if (std::exchange(started_, false)) stopComponents();
  // The threads ring the doorbell of the network, which may still ask for one. So both stop before
  // the network is destroyed.
  std::string why = network_ == nullptr ? "" : network_->leave();
  threads_.stop();
  network_.reset();
  return why;
}

void Manager::refuseToStopInCycle() {
  if (started_) {
    for (Component* component : directory_.components()) {
      if (Task* const task = taskOf(*component); task != nullptr) task->refuseToStopInCycle();
    }
  }
  threads_.refuseToStopInCycle();
}

// Stops tasks before the devices that they use, and collectors last, because they record the
// others.
void Manager::stopComponents() {
  const std::vector<Component*> all = directory_.components();
  const auto stopTasks = [&](bool collectors) {
    for (Component* component : all) {
      Task* const task = taskOf(*component);
      if (task != nullptr && collects(*component) == collectors) task->stop();
    }
  };
  stopTasks(false);
  for (Component* component : all) {
    if (taskOf(*component) == nullptr) static_cast<Device*>(component)->stop();
  }
  stopTasks(true);
}

void Manager::connect(std::string_view requiredName, std::string_view providedName,
                      const ConnectOptions& options) {
  const Endpoint from = Endpoint::parse(requiredName);
  connect(directory_.required(from), from, providedName, options);
}

void Manager::connect(HandleBase& handle, RequiredBase& required, std::string_view provided,
                      const ConnectOptions& options) {
  handle.device_.name_ = handle.name_.component;
  connect(required, handle.name_, provided, options);
  handles_.push_back(&handle);
}

void Manager::disconnect(HandleBase& handle) {
  const std::string name = handle.name_.toString();
  if (local_.erase(name) == 0 && network_ != nullptr) network_->disconnect(name);
  std::erase(handles_, &handle);
}

void Manager::connect(RequiredBase& required, const Endpoint& from, std::string_view providedName,
                      const ConnectOptions& options) {
  const Endpoint to = Endpoint::parse(providedName);
  const std::string connection =
      connectionName({process(), from.component, from.interface},
                     {to.process.empty() ? process() : to.process, to.component, to.interface});
  if (const auto existing = connectionOf(from.toString()); existing != nullptr) {
    throw SetupError("connecting " + connection, "it is already connected: " + existing->name(),
                     "A required interface has one provider; disconnect() it first, or add another "
                     "required interface");
  }
  requireNoNegativeTime(options, required, connection);
  requireSilenceThatCanBeTold(options.contract, connection);
  if (options.delay.any()) DelayThread::requireBounded(required.info());
  const auto watch = watchOf(options.contract, required);
  const bool sameProcess = to.process.empty() || to.process == process();
  if (options.laneRequired && options.lane == Lane::Auto) {
    throw SetupError("connecting " + connection, "it requires a lane and names none",
                     "Name the lane, or let it have any");
  }
  if (sameProcess && options.lane == Lane::Auto) {
    local_[from.toString()] =
        connectHere(required, directory_.provided(to), connection, options.delay, watch);
    return;
  }
  if (network_ == nullptr) {
    throw SetupError("connecting " + connection, "this process has no global manager",
                     "Give the manager's address when constructing suture::Manager");
  }
  network_->connect(required, from, to, options, threads_.delaysFor(options.delay), watch);
}

void Manager::disconnect(std::string_view requiredName) {
  const Endpoint from = Endpoint::parse(requiredName);
  RequiredBase& required = directory_.required(from);
  const std::string name = from.toString();
  const auto channel = connectionOf(name);
  if (channel == nullptr) {
    throw SetupError("disconnecting '" + name + "'", "it is not connected",
                     "Connect it with connect() first");
  }
  if (local_.erase(name) == 0) network_->disconnect(name);
  required.attach(nullptr);
  if (!required.owner().hasCycles()) channel->client.close();  // nobody else would soon
}

void Manager::resumeConnection(std::string_view requiredName) {
  const std::string asked = "resuming connection '" + std::string(requiredName) + "'";
  const auto channel = connectionOf(Endpoint::parse(requiredName).toString());
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

std::shared_ptr<Channel> Manager::connectHere(RequiredBase& required, ProvidedBase& provided,
                                              const std::string& connection,
                                              const ConnectionDelay& delay,
                                              std::shared_ptr<ConnectionWatch> watch) {
  DelayThread* const delays = threads_.delaysFor(delay);
  if (delays == nullptr) return connectLocally(required, provided, connection, std::move(watch));
  auto far = offerLocally(required, provided, {.name = connection, .watch = std::move(watch)},
                          {.client = delays->sharedDoorbell(),
                           .provider = threads_.serverOf(provided),
                           .components = ConnectionEnd::Provider});
  std::erase_if(offered_, [](const auto& one) { return one->status == ChannelStatus::Closed; });
  offered_.push_back(far);
  auto near = delays->interpose(required, std::move(far), delay);
  required.attach(near);
  return near;
}

std::string Manager::placeOf(const Component& component, const std::string& interface) const {
  std::string place = component.name() + "/" + interface;
  const std::vector<Component*> all = directory_.components();
  if (std::find(all.begin(), all.end(), &component) != all.end()) return place;
  throw SetupError("connecting '" + place + "'",
                   "its component does not belong to process '" + process() + "'",
                   "Add it with add() first");
}

std::shared_ptr<Channel> Manager::connectionOf(const std::string& required) const {
  if (const auto found = local_.find(required); found != local_.end()) return found->second;
  return network_ == nullptr ? nullptr : network_->connected(required);
}

std::string Manager::missingGlobalManager() const {
  return network_ == nullptr ? "" : network_->missingManager();
}

std::map<std::string, std::string> Manager::whyLost() const {
  return network_ == nullptr ? std::map<std::string, std::string>{} : network_->whyLost();
}

std::map<std::string, std::string> Manager::whyNotBack() const {
  return network_ == nullptr ? std::map<std::string, std::string>{} : network_->whyNotBack();
}

std::uint64_t Manager::incarnation() const {
  return network_ == nullptr ? 0 : network_->incarnation();
}

net::Refusals::Summary Manager::refusals() const {
  return network_ == nullptr ? net::Refusals::Summary{} : network_->refusals();
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
