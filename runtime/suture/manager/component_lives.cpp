#include <suture/base/errors.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/component/task/task.h>
#include <suture/manager/component_lives.h>
#include <suture/rt/standard_error.h>
#include <suture/standard/collecting.suture.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

// A change of a component's state rings; this is how often those who wait look for what does not: a
// lost provider that is back, or that a faulted task stays so.
constexpr Duration kLookAgain = std::chrono::milliseconds(10);

constexpr const char* kLate = "it was added after start(), which has to be called again";

Task* taskOf(Component& component) {
  return component.ownsThread() ? static_cast<Task*>(&component) : nullptr;
}

// Compares hashes, since a shared library has its own tables.
bool collects(const Component& component) {
  const std::string_view collecting = interfaceInfo<Collecting>().hash;
  const auto& all = component.provided();
  return std::any_of(all.begin(), all.end(),
                     [&](const ProvidedBase* one) { return one->info().hash == collecting; });
}

void stopTasks(const std::map<std::string, Component*>& components, bool collectors) {
  for (const auto& [name, component] : components) {
    Task* const task = taskOf(*component);
    if (task != nullptr && collects(*component) == collectors) task->stop();
  }
}

void startOne(Component& component) {
  if (Task* const task = taskOf(component); task != nullptr) {
    task->start();
  } else {
    static_cast<Device&>(component).start();
  }
}

}  // namespace

std::shared_ptr<std::atomic<ComponentState>> ComponentLives::stateOf(const std::string& name) {
  auto& state = states_[name];
  if (state == nullptr) state = std::make_shared<std::atomic<ComponentState>>();
  return state;
}

void ComponentLives::configure() {
  for (Component* component : directory_.components()) {
    if (after(component->state(), Transition::Configure)) component->configure();
  }
}

void ComponentLives::start() {
  configure();
  started_ = directory_.componentsByName();
  for (const auto& [name, component] : started_) {
    const ComponentState state = component->state();
    const bool started = state == ComponentState::Running || state == ComponentState::Suspended;
    if (!started) startOne(*component);
  }
}

void ComponentLives::await(Duration patience) const {
  const Time begin = now();
  const Time deadline = fromNow(patience);
  while (!missing().empty() && now() < deadline && !anyFaulted()) {
    changed_->waitUntil(std::min(deadline, now() + kLookAgain));
  }
  const std::vector<std::string> lines = missing();
  if (lines.empty()) return;
  const auto waited = std::chrono::duration_cast<std::chrono::milliseconds>(now() - begin);
  std::string found = "after " + std::to_string(waited.count()) + " ms this is missing:";
  for (const std::string& line : lines) found += "\n    " + line;
  throw SetupError("waiting until process '" + directory_.process() + "' has started",
                   found + "\n  ",
                   "Mend that, or call makeOptional() of what a component can do without");
}

bool ComponentLives::anyFaulted() const {
  const std::vector<Component*> all = directory_.components();
  return std::any_of(all.begin(), all.end(), [](const Component* component) {
    return component->state() == ComponentState::Faulted;
  });
}

std::vector<std::string> ComponentLives::missing() const {
  std::vector<std::string> lines;
  for (const Component* component : directory_.components()) {
    const ComponentState state = component->state();
    if (state != ComponentState::Running) {
      lines.push_back("component '" + component->name() + "' is " + toString(state) +
                      (state == ComponentState::Faulted ? ", " + component->whyFaulted() : "") +
                      (isLate(*component) ? std::string(": ") + kLate : ""));
    }
    for (const RequiredBase* required : component->required()) {
      if (required->isOptional()) continue;
      if (std::string line = missingFor(*required); !line.empty()) lines.push_back(std::move(line));
    }
  }
  return lines;
}

bool ComponentLives::isLate(const Component& component) const {
  return !started_.empty() && !started_.contains(component.name()) &&
         component.state() == ComponentState::Constructed;
}

std::string ComponentLives::missingFor(const RequiredBase& required) const {
  const std::string name = required.owner().name() + "/" + required.name();
  const std::string what =
      "required interface '" + name + "' (" + required.info().name + ") is not connected: ";
  const auto channel = connections_.of(name);
  if (channel == nullptr) return what + "nobody has called connect() for it";
  const Errc error = errorOf(channel->status.load(std::memory_order_acquire));
  return error == Errc{} ? "" : what + channel->name() + ": " + toString(error);
}

void ComponentLives::change(const std::string& name, Transition transition, Duration patience) {
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

void ComponentLives::refuseToStopInCycle() const {
  for (const auto& [name, component] : started_) {
    if (Task* const task = taskOf(*component); task != nullptr) task->refuseToStopInCycle();
  }
}

ComponentLives::ByName ComponentLives::addedLater() const {
  ByName later = directory_.componentsByName();
  std::erase_if(later, [this](const auto& one) { return started_.contains(one.first); });
  return later;
}

// Stops tasks before the devices that they use, and collectors last, because they record the
// others. A component that was never started, or has been stopped, may be gone, so only what is
// known of its state is looked at.
void ComponentLives::stop() {
  if (started_.empty()) return;
  const ByName later = addedLater();
  ByName all = std::exchange(started_, {});
  for (const auto& [name, component] : later) {
    const ComponentState state = states_.at(name)->load();
    const bool hasRun = state != ComponentState::Constructed && state != ComponentState::Configured;
    if (!hasRun) {
      rt::printUnlessFull(directory_.process() + ": component '" + name +
                          "' has never run: " + kLate);
    } else if (state != ComponentState::Stopped) {
      all.emplace(name, component);
    }
  }
  stopTasks(all, false);
  for (const auto& [name, component] : all) {
    if (taskOf(*component) == nullptr) static_cast<Device*>(component)->stop();
  }
  stopTasks(all, true);
}

}  // namespace suture
