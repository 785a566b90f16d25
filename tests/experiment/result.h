#pragma once
// This says what became of a trial.

#include <suture/base/time.h>

#include <Eigen/Core>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace experiment {

enum class Outcome : std::uint8_t {
  Placed,  ///< the knot came within kPlaced of its target, stayed there, and is there at the end
  Oscillates,  ///< it swings about its target by more than twice that at the end
  Diverges,    ///< its swings about the target grow
  Misses,      ///< it rests elsewhere, or has not arrived yet
  Unguided,    ///< the guide never began, or does not guide at the end
};
const char* toString(Outcome outcome);

struct Result {
  Outcome outcome = Outcome::Unguided;
  double error = 0;            ///< m: of the knot from its target, the mean of the last half second
  std::optional<double> time;  ///< s, from the guide's beginning until the knot was placed
  double swing = 0;            ///< m: of the knot in the last quarter, along its widest axis
  double guided = 0;           ///< share of the time
  /// A slave's tip is this far from where its master asks it to be at the same instant, m, while it
  /// is guided; what fixtures forbid is in it as well.
  double tracking50 = 0, tracking99 = 0;

  bool operator==(const Result&) const = default;
};

/// A Moment is an instant of a trial, by the truth.
struct Moment {
  Eigen::Vector3d error;  ///< m: of the knot from its target
  bool guided = false;
  double left = 0, right = 0;  ///< m: the tracking error of each slave, while it is guided
};

constexpr double kPlaced = 0.001;       ///< m
constexpr double kStaysPlaced = 2;      ///< s
constexpr double kMomentLength = 1e-3;  ///< s between two moments
constexpr suture::Duration kMomentPeriod = std::chrono::milliseconds(1);

/// Returns how many moments `seconds` have.
inline std::size_t momentsIn(double seconds) {
  return static_cast<std::size_t>(std::lround(seconds / kMomentLength));
}

/// Judges from the moment at which the guide began.
Result judge(const std::vector<Moment>& moments);

}  // namespace experiment
