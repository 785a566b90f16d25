#pragma once
// The provided interface "component" that a manager gives each of its components.

#include <suture/component/component.h>
#include <suture/standard/lifecycle.suture.h>

namespace suture {

/// Tells a component's changes of state as events, and takes requests to suspend and resume it.
/// Its commands run in the component's thread, as those of any provided interface.
class LifecycleFace final : public Lifecycle, public StateListener {
 public:
  static constexpr const char* kName = "component";

  /// Before the component starts, in the manager's thread. Throws SetupError if the component has
  /// another interface of that name.
  explicit LifecycleFace(Component& component);

  bool suspend() override { return request(Transition::Suspend); }
  bool resume() override { return request(Transition::Resume); }
  ComponentState component_state() const override { return component_.state(); }

  void stateChanged(ComponentState state) override;

 private:
  bool request(Transition transition);

  Component& component_;
  Provided<Lifecycle> provided_;
};

}  // namespace suture
