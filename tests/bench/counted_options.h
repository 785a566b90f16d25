#pragma once
// A user may choose these for a subcommand that measures very many calls, one at a time.

#include <CLI/CLI.hpp>
#include <cstddef>
#include <nlohmann/json.hpp>

#include "bench/placement.h"

namespace bench {

struct CountedOptions {
  int cpu = preferredCpu();
  std::size_t calls = 1'000'000;  ///< how many each part makes
  bool quick = false;

  void addTo(CLI::App& options) {
    options.add_option("--cpu", cpu, "processor to measure on")->capture_default_str();
    options.add_option("--calls", calls, "calls of each part")->capture_default_str();
    options.add_flag("--quick", quick, "a hundredth: shows that it works, not how well");
  }
  nlohmann::json toJson() const { return {{"cpu", cpu}, {"calls", calls}, {"quick", quick}}; }

  std::size_t count() const { return quick ? (calls + 99) / 100 : calls; }
};

}  // namespace bench
