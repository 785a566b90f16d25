#pragma once
// This says which turn of an angle a joint takes, and which differences the closed forms accept as
// rounding errors.

#include <cmath>
#include <numbers>

namespace robots::kinematics {

/// A value this little (rad or m) beyond a limit is a rounding error of a closed form.
constexpr double kLimitSlack = 1e-10;

/// A vector no longer than this, in m, has no direction.
constexpr double kOpenLength = 1e-10;

/// Returns `angle` plus whole turns (rad): of those within the limits the one nearest to `near`; if
/// there is none, the one that lies the least beyond a limit.
inline double nearestTurn(double angle, double near, double lower, double upper) {
  constexpr double kTurn = 2 * std::numbers::pi;
  double turned = angle + kTurn * std::round((near - angle) / kTurn);
  if (turned > upper + kLimitSlack) {
    turned -= kTurn * std::ceil((turned - upper - kLimitSlack) / kTurn);
  }
  if (turned < lower - kLimitSlack) {
    turned += kTurn * std::ceil((lower - kLimitSlack - turned) / kTurn);
  }
  const bool liesBeyond = turned > upper + kLimitSlack;
  return liesBeyond && turned - upper > lower - (turned - kTurn) ? turned - kTurn : turned;
}

}  // namespace robots::kinematics
