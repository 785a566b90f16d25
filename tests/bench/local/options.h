#pragma once
// A user may choose these for `suture-bench local`.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace bench {

struct LocalOptions {
  int cpu;       ///< the processor of everything that runs on one
  int otherCpu;  ///< the processor of what runs beside it; the same one if there is no other
  bool quick = false;

  LocalOptions();
  void addTo(CLI::App& options);
  nlohmann::json toJson() const;

  bool twoProcessors() const { return cpu != otherCpu; }
  /// Returns `full`, or the hundredth part of it.
  std::size_t count(std::size_t full) const { return quick ? (full + 99) / 100 : full; }
};

}  // namespace bench
