#include "force_feedback/passive_port.h"

#include "parameters/parameter_check.h"

namespace robots {
namespace {

// The damping of a cycle takes away no more than this share of the momentum, because its force is
// held for the whole cycle, and would throw the hand back if it took more than all.
constexpr double kShare = 0.5;

}  // namespace

PassivePort::PassivePort(const Model& model) : model_(model) {
  ParameterCheck("force feedback")
      .isNotNegative("greatest force in N", model.most_force)
      .isFinite("greatest force in N", model.most_force)
      .isNotNegative("mass in kg", model.mass)
      .isFinite("mass in kg", model.mass);
}

Eigen::Vector3d PassivePort::push(const TipMotion& hand, const Eigen::Vector3d& wanted,
                                  const Eigen::Vector3d& stored, double dt) {
  observer_.movedTo(hand.position);
  Eigen::Vector3d force = wanted.cwiseMin(model_.most_force).cwiseMax(-model_.most_force);
  if (model_.passive) {
    observer_.keepAtMost(stored);
    force = damped(force, hand.velocity, observer_.energy(), kShare * model_.mass / dt, dt);
  }
  observer_.pushes(force);
  return force;
}

}  // namespace robots
