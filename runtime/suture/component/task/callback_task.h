#pragma once

#include <suture/component/task/task.h>

#include <atomic>

namespace suture {

/// Has no thread of its own: another one, say that of a driver or a window system, calls trigger()
/// and runs the cycle. Commands, events, and requests to suspend or resume wait for the next call.
class CallbackTask : public Task {
 public:
  void start() final;
  /// Waits for the cycle under way, so it must not be called from one. Calls that come later do
  /// nothing.
  void stop() final;

  /// Any thread: one cycle, here and now. False, and counted as skipped, if one is under way,
  /// whether in another thread or further up in this one; false also if run() was not called, since
  /// it is not started, suspended or parked.
  bool trigger();

 private:
  void restUntilTriggered();
  void endCycle();

  std::atomic<bool> running_{false};
  std::atomic_flag cycling_ = ATOMIC_FLAG_INIT;
  rt::Doorbell cycleEnded_;  // rung once stop() may wait for it
};

}  // namespace suture
