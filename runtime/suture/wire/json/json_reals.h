#pragma once
// These are real numbers in JSON, which has no words for some of them.

#include <suture/wire/json/json.h>

#include <cmath>
#include <limits>
#include <optional>

namespace suture {

/// Returns a number, or "nan", "inf", "-inf".
inline Json realToJson(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

/// Does the reverse; returns none if it is neither.
inline std::optional<double> realOf(const Json& json) {
  if (json.is_number()) return json.get<double>();
  if (json == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (json == "inf") return std::numeric_limits<double>::infinity();
  if (json == "-inf") return -std::numeric_limits<double>::infinity();
  return std::nullopt;
}

}  // namespace suture
