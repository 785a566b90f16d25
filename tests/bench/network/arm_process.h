#pragma once
// An arm with the complete CRTK interface in a process of its own, which counts what it allocates.

#include <suture/component/periodic_task.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "support/allocations.h"

namespace bench {

/// Of both ends.
inline constexpr suture::PeriodicOptions kCycle{.period = std::chrono::milliseconds(1)};

/// Allocations of a task's thread in steady state: after its first connected cycles.
class AllocationCount {
 public:
  /// The task's thread, once a cycle.
  void cycle(bool connected) {
    if (!connected) return;
    const std::uint64_t total = suture::allocations();
    const std::uint64_t cycles = cycles_.load(std::memory_order_relaxed) + 1;
    if (cycles <= kWarmUp) before_ = total;
    found_.store(total - before_, std::memory_order_relaxed);
    cycles_.store(cycles, std::memory_order_release);
  }

  /// Any thread.
  std::uint64_t cycles() const {
    const std::uint64_t cycles = cycles_.load(std::memory_order_acquire);
    return cycles < kWarmUp ? 0 : cycles - kWarmUp;
  }
  std::uint64_t found() const { return found_.load(std::memory_order_relaxed); }

 private:
  static constexpr std::uint64_t kWarmUp = 50;

  std::uint64_t before_ = 0;
  std::atomic<std::uint64_t> cycles_{0}, found_{0};
};

/// Adds the hidden subcommand: serves "arm:Arm/Crtk" at 1 kHz until it is told to end, then writes
/// the cycles and the allocations of its AllocationCount, two std::uint64_t.
void addArmProcess(CLI::App& program);
/// How this program is called to be that process.
std::vector<std::string> armProcessArguments(const std::string& managerAddress);

}  // namespace bench
