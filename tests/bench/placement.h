#pragma once
// Where the threads of a measurement run.

#include <sched.h>

#include <optional>
#include <string>

namespace bench {

/// Pins the calling thread, and every thread that it starts, until the end of the scope.
class Pinned {
 public:
  /// Nothing is pinned without a processor. Throws SetupError if this process may not use it.
  explicit Pinned(std::optional<int> cpu);
  ~Pinned();
  Pinned(const Pinned&) = delete;
  Pinned& operator=(const Pinned&) = delete;

 private:
  cpu_set_t before_;
};

/// The last of the processors that this process may use: the first serves most interrupts.
int preferredCpu();
/// The last of them that is not `cpu`; `cpu` if it is the only one.
int cpuBeside(int cpu);

/// Why a thread cannot have SCHED_FIFO at `priority`; "" if it can.
std::string whyNotFifo(int priority);

}  // namespace bench
