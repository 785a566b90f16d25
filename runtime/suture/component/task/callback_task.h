#pragma once

#include <suture/component/task/task.h>

#include <atomic>

namespace suture {

/// A CallbackTask has no thread: another one, say that of a driver or a window system, calls
/// trigger() and runs the cycle. Commands, events, and requests to suspend or resume wait for the
/// next call.
class CallbackTask : public Task {
 public:
  void start() final;
  /// Waits for the cycle under way. Later calls of trigger() do nothing.
  void stop() final;

  /// Any thread. Runs one cycle, here and now. Returns false, and counts a skipped cycle, if one is
  /// under way in another thread or further up in this one. Returns false also if run() was not
  /// called, because the task is not started, suspended or parked.
  bool trigger();

 private:
  void restUntilTriggered();
  void endCycle();

  std::atomic<bool> running_{false};
  std::atomic_flag cycling_ = ATOMIC_FLAG_INIT;
  rt::Doorbell cycleEnded_;  // rung if stop() may wait for it
};

}  // namespace suture
