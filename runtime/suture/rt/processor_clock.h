#pragma once
// This measures how much processor time a thread has used.

#include <suture/base/time.h>

#include <atomic>
#include <ctime>
#include <optional>

namespace suture::rt {

/// Any thread. Returns the processor time of all threads of this process together.
Duration processorTimeOfProcess();

/// Counts for one thread at a time, and adds up over the threads that begin one after the other. It
/// is the kernel's count, even if the clock is stepped. Never allocates or locks.
class ProcessorClock {
 public:
  /// The thread that is measured calls begin() first and end() last.
  void begin();
  void end();

  /// Any thread, at any time. Makes a system call in the caller's thread; the measured thread is
  /// not disturbed.
  Duration used() const;

 private:
  std::atomic<std::optional<clockid_t>> clock_{std::nullopt};  // none while no thread runs
  std::atomic<Duration::rep> before_{0};                       // ns, of threads that have ended
};

}  // namespace suture::rt
