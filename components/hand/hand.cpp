#include "hand/hand.h"

#include "parameters/parameter_check.h"

namespace robots {
namespace {

using Eigen::Vector3d;

HandModel checked(const HandModel& model) {
  ParameterCheck("a hand")
      .isPositive("mass in kg", model.mass)
      .isNotNegative("damping in N.s/m", model.damping)
      .isNotNegative("stiffness in N/m", model.stiffness)
      .isNotNegative("amplitude of tremor in m", model.tremor.amplitude);
  return model;
}

}  // namespace

Hand::Hand(const HandModel& model) : model_(checked(model)), tremor_(model.tremor) {}

void Hand::restAt(const Vector3d& position) {
  target_ = position_ = position;
  velocity_.setZero();
  muscles_.setZero();
}

void Hand::advance(double dt, const Vector3d& target, const Vector3d& force) {
  if (!(dt > 0)) return;
  const double m = model_.mass, b = model_.damping, k = model_.stiffness;
  const Vector3d wanted = (target_ + target) / 2, wantedRate = (target - target_) / dt;
  const Vector3d shake = shaking(time_ + dt / 2);
  // m (v' - v) / dt = k (wanted - x - dt rate / 2) + b (wantedRate - rate) + shake + force, where
  // rate = (v + v') / 2; solved for the rate.
  const Vector3d push = 2 * m / dt * velocity_ + k * (wanted - position_) + b * wantedRate;
  const Vector3d rate = (push + shake + force) / (2 * m / dt + b + k * dt / 2);
  muscles_ = k * (wanted - position_ - dt / 2 * rate) + b * (wantedRate - rate) + shake;
  position_ += dt * rate;
  velocity_ = 2 * rate - velocity_;
  target_ = target;
  time_ += dt;
}

/// Returns the force that moves the hand as its tremor says, against its own mass, damper and
/// spring.
Vector3d Hand::shaking(double t) const {
  const Tremor::Motion motion = tremor_.at(t);
  return model_.mass * motion.acceleration + model_.damping * motion.velocity +
         model_.stiffness * motion.offset;
}

}  // namespace robots
