#include "guidance/knot_guide.h"

#include <suture/base/errors.h>

#include <algorithm>

namespace robots {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

FixtureModel model(const GuideParameters& parameters) {
  if (parameters.approach.norm() == 0) {
    throw suture::SetupError("guiding a knot along \"approach\" [0, 0, 0]",
                             "that has no direction, so it is no line",
                             "set \"approach\" to the direction in which the knot shall come");
  }
  return {.target = parameters.target,
          .approach = parameters.approach,
          .radius = parameters.radius,
          .slope = parameters.slope,
          .speed = parameters.speed,
          .separation = parameters.separation,
          .floor = parameters.floor};
}

}  // namespace

KnotGuide::KnotGuide(const GuideParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      parameters_(parameters),
      fixtures_(model(parameters)) {}

void KnotGuide::run() {
  for (Side* side : {&left_, &right_}) {
    side->masterWatch.prepare();
    side->slaveWatch.prepare();
  }
  if (!readArms()) {
    estimate_.forget();
    progress_.valid = false;
    return leave(GuidanceState::Preparing);
  }
  lookForKnot();
  if (parameters_.fixtures && !progress_.valid) return leave(GuidanceState::Blind);
  const bool leftBroke = left_.slaveWatch.hasBrokenOff();
  const bool rightBroke = right_.slaveWatch.hasBrokenOff();
  if (leftBroke || rightBroke || !left_.law) begin();
  if (!move()) leave(GuidanceState::Preparing);
}

/// False unless all four arms and the registration may be acted on. Until following begins, the
/// tips are where the slaves' set-points are.
bool KnotGuide::readArms() {
  const auto frames = registration_.frames();
  if (!frames || !read(left_) || !read(right_)) return false;
  frames_ = *frames;
  if (!left_.law) {
    tips_.left = frames_.left_base * left_.slavePose.pose.translation();
    tips_.right = frames_.right_base * right_.slavePose.pose.translation();
  }
  estimate_.tipsAt(suture::now(), tips_.mean());
  return true;
}

bool KnotGuide::read(Side& side) {
  const auto masterSample = side.master.measured_cp();
  const auto slaveSample = side.slave.setpoint_cp();
  const PoseStamped* const master = usable(masterSample);
  const PoseStamped* const slave = usable(slaveSample);
  if (master == nullptr || slave == nullptr || !side.ready()) return false;
  if (suture::now() - master->stamp > parameters_.max_age) return false;
  side.masterPose = *master;
  side.slavePose = *slave;
  return true;
}

const PoseStamped* KnotGuide::usable(const suture::Sample<PoseStamped>& sample) const {
  return sample && sample.age() <= parameters_.max_age && sample->valid ? &*sample : nullptr;
}

void KnotGuide::lookForKnot() {
  const suture::Time now = suture::now();
  const auto sighting = vision_.sighting();
  if (sighting && sighting->valid) {
    estimate_.seenAt(sighting->stamp, frames_.camera * sighting->knot);
  }
  const auto knot = estimate_.knot(now, parameters_.sighting_age);
  progress_.valid = knot.has_value();
  if (!knot) return;
  progress_.knot = *knot;
  progress_.to_go = fixtures_.toGo(*knot);
  progress_.aside = fixtures_.aside(*knot);
  progress_.stamp = now;
}

void KnotGuide::begin() {
  for (Side* side : {&left_, &right_}) {
    side->law.emplace(side->masterPose.pose, side->slavePose.pose, parameters_.scale);
  }
  tips_.left = frames_.left_base * left_.slavePose.pose.translation();
  tips_.right = frames_.right_base * right_.slavePose.pose.translation();
  enter(GuidanceState::Guiding);
}

bool KnotGuide::move() {
  const TipPair step = permitted(wish());
  tips_.left += step.left;
  tips_.right += step.right;
  const bool leftTook = send(left_, frames_.left_base, tips_.left);
  return send(right_, frames_.right_base, tips_.right) && leftTook;
}

/// From where the tips are to where their masters want them.
TipPair KnotGuide::wish() const {
  const auto wanted = [](const Side& side, const Isometry3d& base) -> Vector3d {
    return base * side.law->follow(side.masterPose.pose).translation();
  };
  return {wanted(left_, frames_.left_base) - tips_.left,
          wanted(right_, frames_.right_base) - tips_.right};
}

TipPair KnotGuide::permitted(const TipPair& wish) {
  const double seconds = std::chrono::duration<double>(parameters_.period).count();
  if (parameters_.fixtures) return fixtures_.permit(tips_, progress_.knot, wish, seconds);
  const double most = parameters_.speed * seconds;
  return {wish.left.cwiseMin(most).cwiseMax(-most), wish.right.cwiseMin(most).cwiseMax(-most)};
}

/// The goal keeps the stamp of the master's data, so its age is known wherever it arrives.
bool KnotGuide::send(Side& side, const Isometry3d& base, const Vector3d& tip) {
  Isometry3d goal = side.law->follow(side.masterPose.pose);
  goal.translation() = base.inverse() * tip;
  return side.slave.servo_cp({goal, side.masterPose.stamp, true}).has_value();
}

void KnotGuide::leave(GuidanceState state) {
  left_.law.reset();
  right_.law.reset();
  enter(state);
}

void KnotGuide::enter(GuidanceState state) {
  if (state_ == state) return;
  state_ = state;
  guidance_.emit().guidance_state(state);
}

}  // namespace robots
