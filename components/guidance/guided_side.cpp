#include "guidance/guided_side.h"

#include <cstddef>
#include <utility>

namespace robots {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Returns the axis that leads from one orientation to another, times the angle in rad.
Vector3d turnBetween(const Matrix3d& from, const Matrix3d& to) {
  const Eigen::AngleAxisd turn(to * from.transpose());
  return turn.angle() * turn.axis();
}

/// Returns the orientation that is at such a share of the way from one to another.
Matrix3d between(const Matrix3d& from, const Matrix3d& to, double share) {
  const Eigen::AngleAxisd turn(to * from.transpose());
  return Eigen::AngleAxisd(share * turn.angle(), turn.axis()) * from;
}

}  // namespace

GuidedSide::GuidedSide(suture::Component& guide, const char* masterName, const char* slaveName,
                       const Settings& settings)
    : settings_(settings),
      master_(guide, masterName),
      slave_(guide, slaveName),
      resistance_({.damping = settings.master_damping}) {
  slave_.configuration_js.reserve(configuration_);
  slave_.setpoint_js.reserve(setpointJs_);
  slave_.spatial_jacobian.reserve(jacobian_);
}

bool GuidedSide::readArms(suture::Duration maxAge, bool withJoints) {
  const auto poses = arms_.poses(maxAge);
  if (!poses || !arms_.ready()) return false;
  if (withJoints) readJoints(maxAge);
  poses_ = *poses;
  if (poses->rebased) forgetAnchor();
  return true;
}

/// An arm that does not say where its joints are minds their limits alone.
void GuidedSide::readJoints(suture::Duration maxAge) {
  const auto isFresh = [&](const suture::Sample<void>& sample) {
    return sample && sample.age() <= maxAge;
  };
  const bool setpoint = isFresh(slave_.setpoint_js(setpointJs_)) && setpointJs_.valid;
  const bool moves = isFresh(slave_.spatial_jacobian(jacobian_)) && jacobian_.valid;
  const auto base = slave_.base_frame();
  const bool stands = base && base.age() <= maxAge && base->valid;
  if (stands) mount_ = base->transform.linear();
  knowsJoints_ = stands && setpoint && setpointJs_.position.size() == std::size_t{kTipJoints} &&
                 moves && jacobian_.coefficients.size() == std::size_t{6 * kTipJoints};
  if (bounds_ || !slave_.configuration_js(configuration_) || !configuration_.valid) return;
  bounds_ = jointBounds(configuration_);
}

void GuidedSide::look(const Matrix3d& view) {
  if (view.isApprox(view_, 1e-12)) return;
  view_ = view;
  if (law_) anchor(law_->follow(poses_.master.pose));
}

void GuidedSide::begin() {
  anchor(poses_.slave.pose);
  turned_ = poses_.slave.pose.linear();
}

void GuidedSide::end() {
  law_.reset();
  bounds_.reset();
  presses_ = false;
}

void GuidedSide::anchor(const Isometry3d& slaveSetpoint) {
  law_.emplace(poses_.master.pose, slaveSetpoint,
               FollowSettings{.scale = settings_.scale, .view = view_});
}

/// An arm that is asked to turn its tool beyond a joint's limit would slide along the limit, and
/// its tip with it, where no fixture has looked.
Isometry3d GuidedSide::goal(const Isometry3d& base, const Vector3d& tip) const {
  Isometry3d goal = law_->follow(poses_.master.pose);
  if (!bounds_ || !knowsJoints_) return goal;
  const double share =
      turnShare(*bounds_, setpointJs_, jacobian_, ahead(goal, base, tip), settings_.period);
  if (share < 1) goal.linear() = between(turned_, goal.linear(), share);
  return goal;
}

JointRoom GuidedSide::room(const Isometry3d& goal, const Isometry3d& base,
                           const Vector3d& tip) const {
  if (!bounds_ || !knowsJoints_) return {};
  return jointRoom(*bounds_, setpointJs_, jacobian_, ahead(goal, base, tip), base.linear() * mount_,
                   settings_.period);
}

/// Poses are in the reference frame of the arm, and its joints are about its base, which
/// set_base_frame() may have turned in that.
TipAhead GuidedSide::ahead(const Isometry3d& goal, const Isometry3d& base,
                           const Vector3d& tip) const {
  const Matrix3d toBase = mount_.transpose();
  return {.moved = toBase * (base.inverse() * tip - poses_.slave.pose.translation()),
          .turned = toBase * turnBetween(poses_.slave.pose.linear(), goal.linear()),
          .turns = toBase * turnBetween(turned_, goal.linear())};
}

bool GuidedSide::send(const Isometry3d& goal, const Isometry3d& base, const Vector3d& tip) {
  PoseStamped sent{goal, poses_.master.stamp, true};
  sent.pose.translation() = base.inverse() * tip;
  turned_ = goal.linear();
  return slave_.servo_cp(sent).has_value();
}

void GuidedSide::forget(const Vector3d& wish, const Isometry3d& base) {
  law_->shift(-(base.linear().transpose() * wish));
}

void GuidedSide::resist(const Vector3d& forbidden, const Isometry3d& base) {
  if (settings_.master_damping <= 0) return;
  const auto rate = master_.measured_cv();
  const TipMotion hand{.position = poses_.master.pose.translation(),
                       .velocity = rate && rate->valid ? rate->linear : Vector3d::Zero()};
  if (!std::exchange(presses_, true)) resistance_.beginAt(hand.position);
  const Vector3d felt = view_.transpose() * base.linear().transpose() * forbidden / settings_.scale;
  press(resistance_.force(hand, felt, settings_.period));
}

void GuidedSide::release() {
  if (settings_.master_damping > 0) press(Vector3d::Zero());
}

/// A wrench that the master does not take ends with its stream: the master holds.
void GuidedSide::press(const Vector3d& force) {
  WrenchGoal wrench;
  wrench.force = poses_.master.pose.linear().transpose() * force;  // in the tip's own directions
  wrench.stamp = poses_.master.stamp;
  master_.body_servo_cf(wrench);
}

}  // namespace robots
