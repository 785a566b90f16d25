#pragma once
// These threads serve the connections of a process beside those of its tasks.

#include <suture/component/provided.h>
#include <suture/rt/scheduling.h>

#include <memory>
#include <mutex>

namespace suture {

class DelayThread;
class DeviceExecutor;
class Task;
struct ConnectionDelay;

/// Each thread exists only in a process that needs it. The manager's thread uses it except where
/// noted.
class ServiceThreads {
 public:
  ServiceThreads();
  ~ServiceThreads();
  ServiceThreads(const ServiceThreads&) = delete;
  ServiceThreads& operator=(const ServiceThreads&) = delete;

  /// Sets the scheduling of those that do not run yet.
  void schedule(const rt::Scheduling& scheduling);

  /// Any thread. Returns the doorbell of the thread that serves an interface for clients that do
  /// not call it themselves: the task's, or an executor's.
  std::shared_ptr<rt::Doorbell> serverOf(ProvidedBase& provided);
  /// Any thread. Returns the task whose thread that is; nullptr: a device that no remote client has
  /// used yet.
  const Task* taskOf(const Component& component) const;
  /// Returns the thread that delays connections; nullptr: `delay` is none.
  DelayThread* delaysFor(const ConnectionDelay& delay);

  /// Throws SetupError in a handler of a device, which runs in a cycle of the executor.
  void refuseToStopInCycle() const;
  /// Ends them. Nothing may ask for one any more, and what they ring must still exist.
  void stop();

 private:
  mutable std::mutex mutex_;  // never taken by a task thread
  rt::Scheduling scheduling_;
  std::unique_ptr<DeviceExecutor> executor_;
  std::unique_ptr<DelayThread> delays_;
};

}  // namespace suture
