#pragma once
// A passive component.

#include <suture/base/errors.h>
#include <suture/component/component.h>

#include <mutex>

namespace suture {

/// Has no thread: its commands run at once in the thread of a local caller, and in one executor
/// thread of the process for remote ones. If it serves both, its methods must be safe to call from
/// several threads. Its required interfaces belong to the first thread that uses one. While it is
/// suspended, commands are answered Errc::Suspended, and who handles its events decides about that.
class Device : public Component {
 public:
  /// `remoteReadPeriod`: how often the reads that remote clients ask for are evaluated.
  explicit Device(Duration remoteReadPeriod = std::chrono::milliseconds(10))
      : Component(false), remoteReadPeriod_(remoteReadPeriod) {}

  /// The manager's: configures it if that has not been done; then it runs. Throws SetupError if it
  /// runs already.
  void start();
  /// The manager's: clients are told that they have lost it. Calls under way are not waited for.
  void stop();

  Duration remoteReadPeriod() const final { return remoteReadPeriod_; }

  /// Runs the handlers of the events that have arrived, in the calling thread, which must be the
  /// one that uses the required interfaces: Errc::WrongThread.
  Result<void> processEvents();
  /// The same, after sleeping until something arrives or until `deadline`. True if something
  /// arrived; false at once in another thread.
  bool waitForEvents(Time deadline);

 private:
  void take(Transition transition) final;

  const Duration remoteReadPeriod_;
  std::mutex changing_;  // no control loop waits here: changes are rare, and asked for by people
};

}  // namespace suture
