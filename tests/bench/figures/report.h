#pragma once
// These are the figures that a subcommand has measured, by name.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/figures/statistics.h"

namespace bench {

/// This is one value with its unit.
struct Value {
  double value;
  std::string unit;
};

/// Holds figures in the order in which they were added. A figure is a distribution, a single value,
/// or the reason why it could not be had: none is left out silently. Names are dotted:
/// "event.csc.network".
class Report {
 public:
  void add(const std::string& figure, const std::string& unit, const Statistics& statistics);
  void add(const std::string& figure, const std::string& unit, double value);
  void addUnavailable(const std::string& figure, const std::string& reason);
  /// Notes anything else worth keeping beside the figures: options, machine.
  void note(const std::string& key, const nlohmann::json& value);

  /// Returns a single value by its name, one of a distribution as "event.csc.network.p50"; nothing
  /// if it was not measured.
  std::optional<Value> find(const std::string& name) const;
  /// Says why figure `name`, or the one that `name` is a part of, is not available; "" if it was
  /// not even tried.
  std::string whyUnavailable(const std::string& name) const;

  nlohmann::ordered_json toJson() const;

 private:
  nlohmann::ordered_json notes_;
  nlohmann::ordered_json figures_;
};

}  // namespace bench
