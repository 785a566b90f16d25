#pragma once
// A user may choose these for `suture-bench network`.

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace bench {

struct NetworkOptions {
  int cpu;       ///< both ends run on it
  int otherCpu;  ///< the writer beside a reader runs on it; the same one if there is no other
  bool quick = false;
  std::string lane;  ///< round trips use it: a name as in its figure; "" = all

  NetworkOptions();
  void addTo(CLI::App& options);
  nlohmann::json toJson() const;

  std::size_t skipped() const { return quick ? 10 : 1000; }
  std::size_t kept() const { return quick ? 100 : 10000; }
  /// A profiler, for which one lane alone is measured, wants seconds of it.
  std::size_t keptOfLane() const { return kept() * (lane.empty() ? 1 : 30); }
  std::uint64_t steadyCycles() const { return quick ? 100 : 5000; }
  std::size_t fanOutRounds() const { return quick ? 100 : 3000; }
  std::size_t goals() const { return quick ? 100 : 5000; }
  std::size_t links() const { return quick ? 2 : 20; }
  std::size_t survivorRounds() const { return quick ? 1 : 3; }
  /// Returns the least length; it ends with the fault under way.
  std::chrono::milliseconds survivorWindow() const {
    return std::chrono::milliseconds(quick ? 1 : 1700);
  }
  std::chrono::milliseconds idleWindow() const {
    return std::chrono::milliseconds(quick ? 100 : 10'000);
  }
  std::size_t streamBlock() const { return quick ? 5'000 : 200'000; }
  std::size_t streamBlocks() const { return quick ? 2 : 5; }
  std::size_t readLoops() const { return quick ? 2 : 200; }
};

}  // namespace bench
