#pragma once
// These say where the threads of a measurement run.

#include <sched.h>
#include <suture/rt/scheduling.h>

#include <optional>
#include <string>

namespace bench {

/// Pins the calling thread, and every thread that it starts, until the end of the scope.
class Pinned {
 public:
  /// Pins nothing without a processor. Throws SetupError if this process may not use it.
  explicit Pinned(std::optional<int> cpu);
  ~Pinned();
  Pinned(const Pinned&) = delete;
  Pinned& operator=(const Pinned&) = delete;

 private:
  cpu_set_t before_;
};

/// Runs the calling thread, and every thread and process that it starts, under SCHED_BATCH until
/// the end of the scope. Under the default policy the kernel decides at each wake-up if the woken
/// thread preempts the one that rang, and the same work on one processor takes one of two times, a
/// bare socket's round trip too. A batch thread never preempts, as one of SCHED_FIFO never preempts
/// its equal, and needs no privilege.
class Unpreempted {
 public:
  Unpreempted();
  ~Unpreempted();
  Unpreempted(const Unpreempted&) = delete;
  Unpreempted& operator=(const Unpreempted&) = delete;

 private:
  // The end of the scope gives them back.
  int policy_;
  sched_param parameters_;
};

/// Returns the last of the processors that this process may use: the first serves most interrupts.
int preferredCpu();
/// Returns the last of them that is not `cpu`; `cpu` if it is the only one.
int cpuBeside(int cpu);

/// Returns SCHED_FIFO at `priority` where this process may have it, else the default policy.
suture::rt::Scheduling urgent(int priority, std::optional<int> processor = std::nullopt);

/// Says why a thread cannot have SCHED_FIFO at `priority`; "" if it can.
std::string whyNotFifo(int priority);

}  // namespace bench
