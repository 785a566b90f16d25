#include "force_feedback/position_position.h"

#include <cmath>
#include <initializer_list>
#include <stdexcept>

namespace robots {
namespace {

// The damping of a cycle takes away no more than this share of the momentum, because its force is
// held for the whole cycle, and would throw the hand back if it took more than all.
constexpr double kShare = 0.5;

}  // namespace

PositionPosition::PositionPosition(const PositionPositionModel& model) : model_(model) {
  for (const double number :
       {model.gains.stiffness, model.gains.damping, model.most_force, model.mass}) {
    if (std::isfinite(number) && number >= 0) continue;
    throw std::invalid_argument(
        "position-position feedback: gains, bounds and mass must be finite, and not negative");
  }
}

Eigen::Vector3d PositionPosition::force(const TipMotion& master, const TipMotion& slave,
                                        double dt) {
  observer_.movedTo(master.position);
  const double most = model_.most_force;
  Eigen::Vector3d force = coupling(model_.gains, master, slave).cwiseMin(most).cwiseMax(-most);
  if (model_.passive) {
    const double mostDamping = kShare * model_.mass / dt;
    force = damped(force, master.velocity, observer_.energy(), mostDamping, dt);
  }
  observer_.pushes(force);
  return force;
}

}  // namespace robots
