#pragma once
// How much time of the processors a thread has had.

#include <suture/base/time.h>

#include <atomic>
#include <ctime>
#include <optional>

namespace suture::rt {

/// That of all threads of this process. Any thread.
Duration processorTimeOfProcess();

/// Counts for one thread at a time, and for those that come after it, too. It is the kernel's
/// count, also on a stepped clock. No allocation, no locks.
class ProcessorClock {
 public:
  /// The thread's first and last words here.
  void begin();
  void end();

  /// Any thread, at any time. A system call of the caller; the thread that is asked about does not
  /// notice.
  Duration used() const;

 private:
  std::atomic<std::optional<clockid_t>> clock_{std::nullopt};  // none while no thread runs
  std::atomic<Duration::rep> before_{0};                       // ns, of threads that have ended
};

}  // namespace suture::rt
