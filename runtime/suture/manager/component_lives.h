#pragma once
// This leads the components of one process through their lives.

#include <suture/component/component.h>
#include <suture/manager/connections.h>
#include <suture/rt/doorbell.h>
#include <suture/wiring/directory.h>

#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace suture {

/// The manager's thread uses it.
class ComponentLives {
 public:
  /// Both outlive it.
  ComponentLives(const Directory& directory, const Connections& connections)
      : directory_(directory), connections_(connections) {}

  /// A component rings it when its state has changed, even one that outlives this.
  std::shared_ptr<rt::Doorbell> changed() const { return changed_; }
  /// The component of that name keeps its state there, even when this is gone, or the component.
  std::shared_ptr<std::atomic<ComponentState>> stateOf(const std::string& name);

  /// Configures the components that are not configured.
  void configure();
  /// Configures, and starts all that do not run.
  void start();
  /// Waits until each runs and its required interfaces can reach their providers. Throws SetupError
  /// that names each that does not, and why, after `patience`, or as soon as one has faulted.
  void await(Duration patience) const;
  /// Suspends or resumes the component of that name. Throws SetupError if it does not get there
  /// within `patience`.
  void change(const std::string& component, Transition transition, Duration patience);

  /// Throws SetupError in the thread of a task that stop() would wait for.
  void refuseToStopInCycle() const;
  /// Once start() has been called: stops what runs, and tells what was added later and never
  /// started. It touches nothing else, since components may be gone that were never started, or
  /// have been stopped.
  void stop();

 private:
  using ByName = std::map<std::string, Component*>;

  bool anyFaulted() const;
  std::vector<std::string> missing() const;
  std::string missingFor(const RequiredBase& required) const;
  bool isLate(const Component& component) const;
  ByName addedLater() const;

  const Directory& directory_;
  const Connections& connections_;
  const std::shared_ptr<rt::Doorbell> changed_ = std::make_shared<rt::Doorbell>();
  ByName started_;  // by start(), until stop()
  std::map<std::string, std::shared_ptr<std::atomic<ComponentState>>> states_;
};

}  // namespace suture
