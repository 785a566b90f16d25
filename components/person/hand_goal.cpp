#include "person/hand_goal.h"

namespace robots {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Quaterniond turnBy(const Vector3d& rotation) {
  const double angle = rotation.norm();
  if (angle <= 0) return Quaterniond::Identity();
  return Quaterniond(Eigen::AngleAxisd(angle, rotation / angle));
}

Vector3d near(const Vector3d& position, const Vector3d& setpoint) {
  const Vector3d lead = position - setpoint;
  const double distance = lead.norm();
  if (distance <= kFurthestLead) return position;
  return setpoint + kFurthestLead / distance * lead;
}

Quaterniond near(const Quaterniond& orientation, const Quaterniond& setpoint) {
  const double angle = orientation.angularDistance(setpoint);
  if (angle <= kWidestLead) return orientation;
  return setpoint.slerp(kWidestLead / angle, orientation);
}

}  // namespace

Eigen::Isometry3d movedGoal(const Eigen::Isometry3d& goal, const Eigen::Isometry3d& setpoint,
                            const HandInput& input, double dt) {
  const Quaterniond turned =
      (turnBy(dt * input.angular_velocity) * Quaterniond(goal.linear())).normalized();
  Eigen::Isometry3d next = Eigen::Isometry3d::Identity();
  next.translation() = near(goal.translation() + dt * input.velocity, setpoint.translation());
  next.linear() = near(turned, Quaterniond(setpoint.linear())).toRotationMatrix();
  return next;
}

}  // namespace robots
