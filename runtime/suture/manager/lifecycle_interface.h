#pragma once
// A manager gives each of its components this provided interface "component".

#include <suture/component/component.h>
#include <suture/rt/doorbell.h>
#include <suture/session/telling.h>
#include <suture/standard/lifecycle.suture.h>

#include <atomic>
#include <memory>

namespace suture {

/// Reports a component's changes of state as events, and takes requests to suspend and resume it.
/// Its commands run in the component's thread, as those of any provided interface.
class LifecycleInterface final : public Lifecycle, public StateListener {
 public:
  static constexpr const char* kName = "component";

  /// Before the component starts, in the manager's thread. At each change `kept` gets the state,
  /// and `changed` is rung. Throws SetupError if the component has another interface of that name.
  LifecycleInterface(Component& component, std::shared_ptr<std::atomic<ComponentState>> kept,
                     std::shared_ptr<rt::Doorbell> changed, std::shared_ptr<const Telling> telling);

  bool suspend() override { return request(Transition::Suspend); }
  bool resume() override { return request(Transition::Resume); }
  ComponentState component_state() const override { return component_.state(); }
  ResumeOutcome resume_connection(const std::string& required) override;

  void stateChanged(ComponentState state) override;

 private:
  bool request(Transition transition);
  void tellPeople(ComponentState state);

  Component& component_;
  Provided<Lifecycle> provided_;
  const std::shared_ptr<std::atomic<ComponentState>> kept_;
  const std::shared_ptr<rt::Doorbell> changed_;
  const std::shared_ptr<const Telling> telling_;
  std::atomic<bool> faulted_{false};
};

}  // namespace suture
