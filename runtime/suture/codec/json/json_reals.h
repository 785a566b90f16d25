#pragma once
// These are real numbers in JSON, which has no words for some of them.

#include <suture/codec/json/json.h>

#include <cmath>
#include <limits>
#include <optional>

namespace suture::codec {

/// Returns a number, or "nan", "inf", "-inf".
inline Json realToJson(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

/// Does the reverse; returns none if it is neither, or is finite and larger than any Real.
template <class Real>
std::optional<Real> realOf(const Json& json) {
  using Limits = std::numeric_limits<Real>;
  if (json == "nan") return Limits::quiet_NaN();
  if (json == "inf") return Limits::infinity();
  if (json == "-inf") return -Limits::infinity();
  if (!json.is_number()) return std::nullopt;
  const auto value = json.get<double>();
  if (std::isfinite(value) && std::abs(value) > Limits::max()) return std::nullopt;
  return static_cast<Real>(value);
}

}  // namespace suture::codec
