#pragma once
// A task shows here if it hangs.

#include <suture/base/time.h>

#include <atomic>
#include <cstdint>

namespace suture {

enum class Activity : std::uint8_t {
  Running,    ///< in a cycle
  Asleep,     ///< until something arrives, or until it is due
  Suspended,  ///< it has no cycles to run
};

/// The thread that runs the task writes it, and any may read it. It is one word, so that neither
/// waits and both halves are of one moment.
class TaskActivity {
 public:
  struct Reading {
    Activity activity = Activity::Suspended;
    /// Running: when the cycle began. Asleep: the latest time of the next; unset: there is none.
    Time due{};

    /// Returns for how long the end of a cycle, or the beginning of one, has been overdue.
    Duration overdue(Time present) const {
      return due == Time{} || present < due ? Duration{0} : present - due;
    }
  };

  void run(Time begin) { write(Activity::Running, begin); }
  void sleep(Time due = {}) { write(Activity::Asleep, due); }
  void suspend() { write(Activity::Suspended, {}); }

  Reading read() const {
    const std::int64_t word = word_.load(std::memory_order_relaxed);
    return {static_cast<Activity>(word & kActivity), fromNanoseconds(word & ~kActivity)};
  }

 private:
  static constexpr std::int64_t kActivity = 3;  // the lowest bits of the time, in ns

  void write(Activity activity, Time due) {
    word_.store((toNanoseconds(due) & ~kActivity) | static_cast<std::int64_t>(activity),
                std::memory_order_relaxed);
  }

  std::atomic<std::int64_t> word_{static_cast<std::int64_t>(Activity::Suspended)};
};

}  // namespace suture
