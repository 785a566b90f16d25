#include <suture/base/errors.h>
#include <suture/lane/lane_kind.h>
#include <suture/manager/handle.h>
#include <suture/manager/lifecycle_interface.h>
#include <suture/manager/manager.h>
#include <suture/rt/standard_error.h>
#include <suture/session/network.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

/// Returns what the network says; nothing in a process that is on its own.
template <class Answer>
Answer ask(const Network* network, Answer (Network::*question)() const) {
  return network == nullptr ? Answer{} : (network->*question)();
}

}  // namespace

Manager::Manager(std::string process) : directory_(std::move(process)) {}

Manager::Manager(std::string process, const std::string& address, Duration patience)
    : Manager(std::move(process), address, Security{}, patience) {}

Manager::Manager(std::string process, const std::string& address, const Security& security,
                 Duration patience, std::uint16_t port)
    : directory_(std::move(process)) {
  network_ =
      std::make_unique<Network>(directory_, address, threads_, *telling_, patience, security, port);
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
    // An earlier manager has left its listener, which would go on to tell that one's program.
    component.setStateListener(nullptr);
    component.setStateListener(std::make_shared<LifecycleInterface>(component, lives_.stateOf(name),
                                                                    lives_.changed(), telling_));
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

std::vector<std::string> Manager::lanes() const { return ask(network_.get(), &Network::lanes); }

void Manager::configure() { lives_.configure(); }

void Manager::start() {
  lives_.start();
  if (network_ != nullptr) network_->publish();
}

void Manager::awaitStart(Duration patience) const { lives_.await(patience); }

void Manager::suspend(const std::string& component, Duration patience) {
  lives_.change(component, Transition::Suspend, patience);
}

void Manager::resume(const std::string& component, Duration patience) {
  lives_.change(component, Transition::Resume, patience);
}

void Manager::giveUp() {
  if (network_ != nullptr) network_->giveUp();
}

void Manager::stop() {
  refuseToStopInCycle();
  if (const std::string why = stopAll(); !why.empty()) throw SetupError(why);
}

void Manager::refuseToStopInCycle() const {
  lives_.refuseToStopInCycle();
  threads_.refuseToStopInCycle();
}

// Returns why one of the parts has failed to stop, in words; "" if none has.
std::string Manager::stopAll() {
  lives_.stop();
  // The threads ring the doorbell of the network, which may still ask for one. So both stop before
  // the network is destroyed.
  std::string why = network_ == nullptr ? "" : network_->leave();
  threads_.stop();
  network_.reset();
  return why;
}

void Manager::connect(std::string_view required, std::string_view provided,
                      const ConnectOptions& options) {
  const Endpoint from = Endpoint::parse(required);
  connections_.connect(directory_.required(from), from, provided, options);
}

void Manager::connect(HandleBase& handle, RequiredBase& required, std::string_view provided,
                      const ConnectOptions& options) {
  handle.device_.name_ = handle.name_.component;
  connections_.connect(required, handle.name_, provided, options);
  handles_.push_back(&handle);
}

void Manager::disconnect(HandleBase& handle) {
  connections_.drop(handle.name_.toString());
  std::erase(handles_, &handle);
}

void Manager::disconnect(std::string_view required) { connections_.disconnect(required); }

void Manager::resumeConnection(std::string_view required) { connections_.resume(required); }

std::string Manager::placeOf(const Component& component, const std::string& interface) const {
  std::string place = component.name() + "/" + interface;
  const std::vector<Component*> all = directory_.components();
  if (std::find(all.begin(), all.end(), &component) != all.end()) return place;
  throw SetupError("connecting '" + place + "'",
                   "its component does not belong to process '" + process() + "'",
                   "Add it with add() first");
}

std::string Manager::missingGlobalManager() const {
  return ask(network_.get(), &Network::missingManager);
}

std::map<std::string, std::string> Manager::whyNoGlobalManager() const {
  return ask(network_.get(), &Network::managerTroubles);
}

std::map<std::string, std::string> Manager::whyLost() const {
  if (network_ == nullptr) return {};
  return network_->news().whyLost();
}

std::map<std::string, std::string> Manager::whyNotBack() const {
  if (network_ == nullptr) return {};
  return network_->news().whyNotBack();
}

std::uint64_t Manager::incarnation() const { return ask(network_.get(), &Network::incarnation); }

net::Refusals::Summary Manager::refusals() const { return ask(network_.get(), &Network::refusals); }

std::vector<std::shared_ptr<Channel>> Manager::channels() const { return connections_.all(); }

}  // namespace suture
