#pragma once
// This is a component without a thread.

#include <suture/base/errors.h>
#include <suture/component/component.h>
#include <suture/rt/period.h>

#include <mutex>

namespace suture {

/// A Device has no thread: its commands run at once in the thread of a local caller, and in one
/// executor thread of the process for remote ones. If it serves both, its methods must be safe to
/// call from several threads. Its required interfaces belong to the first thread that uses one.
/// While it is suspended, commands are answered Errc::Suspended; the code that calls
/// processEvents() decides about events.
class Device : public Component {
 public:
  /// `remoteReadPeriod` says how often the reads that remote clients ask for are evaluated. Throws
  /// SetupError if it is not positive.
  explicit Device(Duration remoteReadPeriod = std::chrono::milliseconds(10))
      : Component(false),
        remoteReadPeriod_(rt::positivePeriod("the reads of a device", remoteReadPeriod)) {}

  /// The manager calls this: configures it if that has not been done, and lets it run. Throws
  /// SetupError if it runs already.
  void start();
  /// The manager calls this: tells clients that they have lost it. Does not wait for calls under
  /// way.
  void stop();

  Duration remoteReadPeriod() const final { return remoteReadPeriod_; }

  /// Runs the handlers of the events that have arrived, in the calling thread. Answers
  /// Errc::WrongThread unless that thread uses the required interfaces, and Errc::CannotWait in
  /// such a handler.
  Result<void> processEvents();
  /// Sleeps until something arrives or until `deadline`, and does the same. Returns true if
  /// something arrived, and false at once in another thread or in such a handler.
  bool waitForEvents(Time deadline);

 private:
  void take(Transition transition) final;
  /// Returns why events cannot be handled here, or 0 if they can.
  Errc cannotHandle();

  const Duration remoteReadPeriod_;
  std::mutex changing_;  // no control loop waits for it, because only people ask for changes, and
                         // rarely
};

}  // namespace suture
