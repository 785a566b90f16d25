#include "force_feedback/passivity.h"

#include <algorithm>

namespace robots {

Eigen::Vector3d damped(const Eigen::Vector3d& force, const Eigen::Vector3d& velocity,
                       const Eigen::Vector3d& energy, double most, double dt) {
  Eigen::Vector3d result = force;
  for (int i = 0; i < 3; ++i) {
    const double left = energy[i] - force[i] * velocity[i] * dt;  // J, after this cycle
    if (left >= 0 || velocity[i] == 0) continue;
    const double lacking = -left / (velocity[i] * velocity[i] * dt);
    // Damping that only takes away what the feedback pushes is safe, however strong it is.
    const double pushing = std::max(force[i] / velocity[i], 0.0);
    result[i] -= std::min(lacking, pushing + most) * velocity[i];
  }
  return result;
}

}  // namespace robots
