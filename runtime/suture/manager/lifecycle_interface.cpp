#include <suture/base/errors.h>
#include <suture/base/plain.h>
#include <suture/component/required.h>
#include <suture/manager/lifecycle_interface.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

/// Returns `component`. Throws SetupError if it has such an interface already.
Component& withoutLifecycle(Component& component) {
  const auto& all = component.provided();
  const bool taken = std::any_of(all.begin(), all.end(), [](const ProvidedBase* one) {
    return one->name() == LifecycleInterface::kName;
  });
  if (!taken) return component;
  throw SetupError(
      "adding component '" + component.name() + "'",
      "it provides an interface '" + std::string(LifecycleInterface::kName) + "' of its own",
      "Rename it: every component has one of that name, which tells of its life");
}

constexpr std::size_t kLongestFault = 255;  // as StateChange declares

}  // namespace

LifecycleInterface::LifecycleInterface(Component& component,
                                       std::shared_ptr<std::atomic<ComponentState>> kept,
                                       std::shared_ptr<rt::Doorbell> changed,
                                       std::shared_ptr<const Telling> telling)
    : component_(withoutLifecycle(component)),
      provided_(component, kName, *this),
      kept_(std::move(kept)),
      changed_(std::move(changed)),
      telling_(std::move(telling)) {
  provided_.serveInEveryState();
  stateChanged(component.state());
}

void LifecycleInterface::stateChanged(ComponentState state) {
  StateChange change{.state = state, .fault = {}, .stamp = now()};
  if (state == ComponentState::Faulted) assignCut(change.fault, component_.fault(), kLongestFault);
  (void)provided_.emit().state_changed(change);  // it fits
  *kept_ = state;
  changed_->ring();
  tellPeople(state);
}

void LifecycleInterface::tellPeople(ComponentState state) {
  const auto tell = [&](const std::string& what) {
    telling_->tell("component '" + component_.name() + "' " + what);
  };
  if (state == ComponentState::Faulted) {
    faulted_ = true;
    tell("has faulted, " + component_.whyFaulted());
  } else if (state == ComponentState::Running && faulted_.exchange(false)) {
    tell("runs again after its fault");
  }
}

ResumeOutcome LifecycleInterface::resume_connection(const std::string& required) {
  const auto& all = component_.required();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const RequiredBase* one) { return one->name() == required; });
  return found == all.end() ? ResumeOutcome::NoSuchInterface : (*found)->resume();
}

bool LifecycleInterface::request(Transition transition) {
  if (!after(component_.state(), transition)) return false;
  try {
    component_.request(transition);
    return true;
  } catch (const SetupError&) {  // a device that another thread has changed meanwhile
    return false;
  }
}

}  // namespace suture
