#pragma once
// This finds what a thread does that a task thread in steady state must not do.

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace proof {

/// Says what a thread may ask of the kernel in one cycle.
struct Allowance {
  unsigned sleeps = 0;  ///< waits for its doorbell, beside those that a late wake ends
  unsigned wakes = 0;   ///< sleeping peers that it rings, each once
};

/// Watches one thread for a number of its cycles, after some in which it warms up: every use of
/// the allocator, every lock, page faults beyond those of the kernel itself, and every system call
/// beyond the allowance. Under the sanitizers (unwatched.cpp) it only counts cycles.
class Watch {
 public:
  /// `thread` says which thread it is, for the findings.
  Watch(std::string thread, std::uint64_t warmUp, std::uint64_t cycles, Allowance allowance = {});
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// The watched thread calls this once in each cycle, always at the same place of the cycle. From
  /// the end of the warm-up on, the thread must not start others.
  void cycle();

  /// Any thread: returns true when all cycles have been seen.
  bool done() const { return done_.load(std::memory_order_acquire); }
  /// Returns, once done(), a line for each thing found: in which thread, what, how often, and where
  /// it was seen first.
  std::vector<std::string> findings() const;

  // --- for what stands in for the C library and the kernel: the calling thread, if it is watched

  /// ...has called this function of the C library.
  static void noteCall(const char* function);
  /// ...is making a system call, with its first two arguments.
  static void noteSystemCall(long number, long first, long second);
  /// ...has made it, and got `result`.
  static void noteResult(long number, long second, long result);

 private:
  static constexpr int kMaxFrames = 24;
  static constexpr std::size_t kMaxWoken = 8;

  struct Finding {
    std::string what;
    std::uint64_t count = 0;
    void* frames[kMaxFrames];
    int frameCount = 0;
  };

  void begin();
  void end();
  bool allowed(long number, long address, long operation);
  bool allowedSleep();
  bool allowedWake(long address);
  void record(const char* what, long number = -1);
  std::string describe(const Finding& finding) const;

  const std::string thread_;
  const std::uint64_t warmUp_, cycles_;
  const Allowance allowance_;
  std::uint64_t cycle_ = 0;
  std::uint64_t faultsBefore_ = 0, movedBefore_ = 0;
  unsigned sleeps_ = 0, wakes_ = 0;  // how many this cycle has had
  unsigned lateWakes_ = 0;           // wakes that may still come
  long woken_[kMaxWoken] = {};
  std::vector<Finding> findings_;
  std::atomic<bool> done_{false};
};

}  // namespace proof
