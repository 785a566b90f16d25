#pragma once
// The threads of the runtime, and how those of tasks are scheduled.

#include <suture/base/time.h>
#include <suture/rt/doorbell.h>

#include <functional>
#include <optional>
#include <string>
#include <thread>

namespace suture::rt {

struct Scheduling {
  /// 1..99: SCHED_FIFO; absent: the default policy.
  std::optional<int> fifoPriority = std::nullopt;
  /// Pins the thread to this processor.
  std::optional<int> cpu = std::nullopt;
};

/// The slice of a task under the default policy, and that of a thread that serves tasks. A thread
/// that wakes up takes the processor from one of a longer slice: so a task runs as soon as there is
/// something to do, and has answered before the thread that woke it goes to sleep.
inline constexpr Duration kTaskSlice = std::chrono::microseconds(100);
inline constexpr Duration kServiceSlice = std::chrono::milliseconds(1);

/// Asks the kernel to let the calling thread run for `slice` at a time, if it is under the default
/// policy. Linux before 6.12 does not know such a wish; then nothing changes.
void askForSlice(Duration slice);

/// Applies the name (at most 15 characters are kept) and the scheduling to the calling thread, and
/// has its timed sleeps end when they are due.
/// Throws SetupError if the kernel refuses, e.g. without the right to real-time priorities.
void configureThisThread(const std::string& name, const Scheduling& scheduling);

/// A thread that a stepped clock knows from its beginning to its end. Whoever starts it joins it.
class Thread {
 public:
  /// Which signals may interrupt it.
  enum class Signals : std::uint8_t { AsTheStarter, None };

  Thread() = default;
  /// Ends the program if the thread has not been joined, as std::thread does.
  ~Thread() = default;
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;

  /// Runs `body`, which throws nothing. `name` is for a stepped clock alone. Throws
  /// std::system_error if the kernel refuses.
  void start(const std::string& name, std::function<void()> body,
             Signals signals = Signals::AsTheStarter);
  bool joinable() const { return thread_.joinable(); }
  /// Waits for its end, in any other thread.
  void join();
  /// True in the thread itself.
  bool isCurrent() const { return std::this_thread::get_id() == thread_.get_id(); }

 private:
  Doorbell ended_;
  std::thread thread_;
};

}  // namespace suture::rt
