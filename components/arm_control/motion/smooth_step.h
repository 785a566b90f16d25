#pragma once
// This is the minimum-jerk blend between rest and rest.

#include <algorithm>

namespace robots {

/// Rises from 0 at s <= 0 to 1 at s >= 1 with zero velocity and acceleration at both ends, as
/// 10 s^3 - 15 s^4 + 6 s^5 (Flash and Hogan, "The coordination of arm movements", J. Neuroscience
/// 5(7), 1985).
inline double smoothStep(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10 + s * (6 * s - 15));
}

/// smoothStep has its greatest slope at s = 1/2.
constexpr double kSmoothStepPeakSlope = 1.875;

/// The second derivative of smoothStep is 10 / sqrt(3) at most.
constexpr double kSmoothStepPeakCurvature = 5.7735026918962577;

}  // namespace robots
