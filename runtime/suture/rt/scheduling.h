#pragma once
// This tells the kernel how to schedule a thread, and finds out which part of that it grants.

#include <suture/base/time.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace suture::rt {

/// Says by which of the kernel's rules a thread gets a processor.
enum class Policy : std::uint8_t {
  Default,     ///< that of the thread which starts it, as a rule SCHED_OTHER
  Fifo,        ///< SCHED_FIFO: until it sleeps, before all of a lower priority
  RoundRobin,  ///< SCHED_RR: the same, by turns with those of its own priority
};

struct Scheduling {
  Policy policy = Policy::Default;
  /// It is 1 to 99, of which 99 is the most urgent; it has no meaning under the default policy.
  int priority = 0;
  /// The thread is pinned to this processor, counted from 0; without it the kernel chooses.
  std::optional<int> processor = std::nullopt;

  bool operator==(const Scheduling&) const = default;
};

/// Returns for example "fifo 80 on processor 1", or "default".
std::string toString(const Scheduling& scheduling);

/// These are the slices, under the default policy, of a task and of a thread that serves tasks. A
/// thread that wakes up takes the processor from one of a longer slice: so a task runs as soon as
/// there is something to do, and has answered before the thread that woke it goes to sleep.
inline constexpr Duration kTaskSlice = std::chrono::microseconds(100);
inline constexpr Duration kServiceSlice = std::chrono::milliseconds(1);

/// Asks the kernel to let the calling thread run for `slice` at a time, if it is under the default
/// policy. Linux before 6.12 does not know such a wish; then nothing changes.
void askForSlice(Duration slice);

/// Schedules the calling thread, and the threads that it starts from then on. `name` says in the
/// error which thread it is. Throws SetupError if the kernel refuses, e.g. without the right to
/// real-time priorities.
void schedule(const std::string& name, const Scheduling& scheduling);

/// Applies the name (at most 15 characters are kept) and the scheduling to the calling thread, and
/// makes its timed sleeps end when they are due. Throws as schedule() does.
void configureThisThread(const std::string& name, const Scheduling& scheduling);

/// Says which part of a wish the kernel grants, and why it refuses the rest.
struct Granted {
  Scheduling scheduling;
  std::vector<std::string> refusals;  ///< what was asked, what was found, what to do; one each
};

/// Any thread. Tries what schedule() would do, in a thread of its own that ends with this call.
Granted grantedOf(const std::string& name, const Scheduling& wanted);

}  // namespace suture::rt
