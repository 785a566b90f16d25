#pragma once
// This is what a user may choose of `suture-bench stop`.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace bench {

struct StopOptions {
  bool quick = false;

  void addTo(CLI::App& options) {
    options.add_flag("--quick", quick, "a hundredth of the presses: the figures mean nothing");
  }
  nlohmann::json toJson() const { return {{"quick", quick}}; }

  int presses() const { return quick ? 10 : 1000; }
  int cuts() const { return quick ? 1 : 100; }
};

}  // namespace bench
