#pragma once
// A user may choose these for `suture-bench table2`.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "bench/table2/setup.h"

namespace bench {

struct Table2Options {
  std::size_t samples = 10000;
  std::size_t skip = 1000;
  double rateHz = 1000;
  int cpu;  ///< the event-driven loops and the ping-pong run on it
  int fifoPriority = 80;
  std::string lane = "rpc";
  bool tcp = false;
  bool namespaces = false;
  bool quick = false;
  bool eventDrivenOnly = false;

  Table2Options();
  void addTo(CLI::App& options);
  nlohmann::json toJson() const;

  Between between() const;
  /// Returns "rpc over TCP".
  std::string betweenInWords() const;
  std::size_t kept() const { return quick ? 100 : samples; }
  std::size_t skipped() const { return quick ? 10 : skip; }
  std::size_t codecLoops() const { return quick ? 10 : 100; }
  LoopSetup periodic(Loop loop, bool fifo) const;
  LoopSetup eventDriven(Loop loop) const;
};

}  // namespace bench
