#include "force_feedback/passivity.h"

#include <algorithm>
#include <cmath>

namespace robots {
namespace {

// m/s: a slower hand rests. What a force gives it is below all that is accounted for, and a
// quotient by its velocity is no damping that has a meaning.
constexpr double kRest = 1e-9;

}  // namespace

Eigen::Vector3d damped(const Eigen::Vector3d& force, const Eigen::Vector3d& velocity,
                       const Eigen::Vector3d& energy, double most, double dt) {
  Eigen::Vector3d result = force;
  for (int i = 0; i < 3; ++i) {
    const double left = energy[i] - force[i] * velocity[i] * dt;  // J, after this cycle
    if (left >= 0 || std::abs(velocity[i]) < kRest) continue;
    const double lacking = -left / (velocity[i] * velocity[i] * dt);
    // Damping that only takes away what the feedback pushes is safe, however strong it is.
    const double pushing = std::max(force[i] / velocity[i], 0.0);
    result[i] -= std::min(lacking, pushing + most) * velocity[i];
  }
  return result;
}

}  // namespace robots
