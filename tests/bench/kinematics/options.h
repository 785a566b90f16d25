#pragma once
// What a user may choose of `suture-bench kinematics`.

#include <CLI/CLI.hpp>
#include <cstddef>
#include <nlohmann/json.hpp>

#include "bench/placement.h"

namespace bench {

struct KinematicsOptions {
  int cpu = preferredCpu();
  std::size_t poses = 1'000'000;  ///< of each arm
  bool quick = false;

  void addTo(CLI::App& options) {
    options.add_option("--cpu", cpu, "processor to measure on")->capture_default_str();
    options.add_option("--poses", poses, "poses of each arm")->capture_default_str();
    options.add_flag("--quick", quick, "a hundredth: shows that it works, not how well");
  }
  nlohmann::json toJson() const { return {{"cpu", cpu}, {"poses", poses}, {"quick", quick}}; }

  std::size_t count() const { return quick ? (poses + 99) / 100 : poses; }
};

}  // namespace bench
