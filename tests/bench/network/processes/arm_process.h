#pragma once
// This is an arm with the complete CRTK interface in a process of its own, which counts what it
// allocates.

#include <suture/component/task/periodic_task.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/network/lane_threads.h"
#include "support/allocations.h"

namespace bench {

/// Both ends have this cycle.
inline constexpr suture::PeriodicOptions kCycle{.period = std::chrono::milliseconds(1)};

/// Counts allocations of a task's thread and of the lane threads of its process in steady state:
/// after its first connected cycles.
class AllocationCount {
 public:
  /// The task's thread calls this once a cycle.
  void cycle(bool connected) {
    if (!connected) return;
    const std::uint64_t total = suture::allocations();
    const std::uint64_t cycles = cycles_.load(std::memory_order_relaxed) + 1;
    if (cycles <= kWarmUp) {
      before_ = total;
      laneBefore_ = lane_.count();
    }
    found_.store(total - before_, std::memory_order_relaxed);
    foundInLane_.store(lane_.count() - laneBefore_, std::memory_order_relaxed);
    cycles_.store(cycles, std::memory_order_release);
  }

  /// Any thread: returns how many cycles were counted.
  std::uint64_t cycles() const {
    const std::uint64_t cycles = cycles_.load(std::memory_order_acquire);
    return cycles < kWarmUp ? 0 : cycles - kWarmUp;
  }
  std::uint64_t found() const { return found_.load(std::memory_order_relaxed); }
  std::uint64_t foundInLane() const { return foundInLane_.load(std::memory_order_relaxed); }

 private:
  static constexpr std::uint64_t kWarmUp = 50;

  const suture::NamedThreadAllocations lane_{kLaneThread};
  std::uint64_t before_ = 0, laneBefore_ = 0;
  std::atomic<std::uint64_t> cycles_{0}, found_{0}, foundInLane_{0};
};

/// An ArmResult is what an arm process says of itself.
struct ArmResult {
  std::uint64_t cycles, allocations, laneAllocations;  ///< as its AllocationCount has them
  std::uint64_t laneThreads;
};

/// Adds the hidden subcommand: serves "arm:Arm/Arm" at 1 kHz until it is told to end, then writes
/// an ArmResult.
void addArmProcess(CLI::App& program);
/// Says how this program is called to be that process.
std::vector<std::string> armProcessArguments(const std::string& managerAddress);

}  // namespace bench
