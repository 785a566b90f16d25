#pragma once
// How the kernel schedules a thread, and what of a wish it grants.

#include <suture/base/time.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace suture::rt {

/// Which of the kernel's rules decides when a thread has a processor.
enum class Policy : std::uint8_t {
  Default,     ///< that of the thread which starts it, as a rule SCHED_OTHER
  Fifo,        ///< SCHED_FIFO: until it sleeps, before all of a lower priority
  RoundRobin,  ///< SCHED_RR: the same, by turns with those of its own priority
};

struct Scheduling {
  Policy policy = Policy::Default;
  /// 1 to 99, the most urgent; without meaning under the default policy.
  int priority = 0;
  /// The processor that the thread is pinned to, counted from 0; without, the kernel chooses.
  std::optional<int> processor = std::nullopt;

  bool operator==(const Scheduling&) const = default;
};

/// "fifo 80 on processor 1", "default".
std::string toString(const Scheduling& scheduling);

/// The slice of a task under the default policy, and that of a thread that serves tasks. A thread
/// that wakes up takes the processor from one of a longer slice: so a task runs as soon as there is
/// something to do, and has answered before the thread that woke it goes to sleep.
inline constexpr Duration kTaskSlice = std::chrono::microseconds(100);
inline constexpr Duration kServiceSlice = std::chrono::milliseconds(1);

/// Asks the kernel to let the calling thread run for `slice` at a time, if it is under the default
/// policy. Linux before 6.12 does not know such a wish; then nothing changes.
void askForSlice(Duration slice);

/// Schedules the calling thread so, and the threads that it starts. `name`: whose thread it is, for
/// the error. Throws SetupError if the kernel refuses, e.g. without the right to real-time
/// priorities.
void schedule(const std::string& name, const Scheduling& scheduling);

/// Applies the name (at most 15 characters are kept) and the scheduling to the calling thread, and
/// has its timed sleeps end when they are due. Throws as schedule() does.
void configureThisThread(const std::string& name, const Scheduling& scheduling);

/// It tells what the kernel grants of a wish, and why not the rest.
struct Granted {
  Scheduling scheduling;
  std::vector<std::string> refusals;  ///< what was asked, what was found, what to do; one each
};

/// Tries what schedule() would do, in a thread that ends with it.
Granted grantedOf(const std::string& name, const Scheduling& wanted);

}  // namespace suture::rt
