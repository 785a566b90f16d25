#include "guidance/knot_guide.h"

#include <suture/base/errors.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "parameters/valid_age.h"
#include "parameters/valid_time.h"
#include "registration/surgeon_view.h"
#include "teleop/valid_scale.h"
#include "timing/seconds.h"

namespace robots {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// The capstan's friction is not known better than this share of it, nor are the strand's ends
// straight.
constexpr double kHolding = 0.8;
// A tip is behind its hand by no more than it goes in this time.
constexpr double kCatchUp = 0.1;  // s

/// Returns the parameters. Throws suture::SetupError for those with which nothing can be guided.
const GuideParameters& checked(const GuideParameters& parameters) {
  requireValidScale(parameters.scale);
  requireAge("max_age", parameters.max_age);
  requireAge("sighting_age", parameters.sighting_age);
  requireAge("registration_age", parameters.registration_age);
  requireAge("operator_age", parameters.operator_age);
  requireTimeOrZero("preparation_limit", parameters.preparation_limit);
  return parameters;
}

FixtureModel model(const GuideParameters& parameters) {
  if (parameters.approach.norm() == 0) {
    throw suture::SetupError("guiding a knot along \"approach\" [0, 0, 0]",
                             "that has no direction, so it is no line",
                             "Set \"approach\" to the direction in which the knot shall come");
  }
  return {.target = parameters.target,
          .approach = parameters.approach,
          .radius = parameters.radius,
          .slope = parameters.slope,
          .speed = parameters.speed,
          .separation = parameters.separation,
          .holding = std::exp(kHolding * parameters.friction * parameters.wrap)};
}

GuidedSide::Settings settings(const GuideParameters& parameters) {
  return {.scale = parameters.scale,
          .master_damping = parameters.master_damping,
          .period = inSeconds(parameters.period)};
}

bool haveSameBases(const SceneFrames& one, const SceneFrames& other) {
  return one.left_base.isApprox(other.left_base, 1e-12) &&
         one.right_base.isApprox(other.right_base, 1e-12);
}

}  // namespace

KnotGuide::KnotGuide(const GuideParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      parameters_(checked(parameters)),
      left_(*this, "LeftMaster", "LeftSlave", settings(parameters)),
      right_(*this, "RightMaster", "RightSlave", settings(parameters)),
      fixtures_(model(parameters)),
      estimate_(parameters.sighting_age, parameters.period),
      enableAtFirstCycle_(parameters.enable_at_start) {}

void KnotGuide::enable() {
  for (GuidedSide* side : {&left_, &right_}) side->arms().permit();
  preparation_.begin();
  if (state_ == GuidanceState::Disabled) enter(GuidanceState::Preparing);
}

void KnotGuide::disable() {
  enableAtFirstCycle_ = false;  // disable() may come before the first cycle
  leave(GuidanceState::Disabled);
}

/// Leaves guiding, because a guide that does not run must not say that it guides.
void KnotGuide::onSuspend() {
  if (state_ == GuidanceState::Disabled) return;
  for (GuidedSide* side : {&left_, &right_}) side->arms().stopPreparing();
  progress_.valid = false;
  leave(GuidanceState::Preparing);
}

/// Restarts the limit, which counts the time that it works and not the time that it was suspended.
void KnotGuide::onResume() { preparation_.begin(); }

/// Stops, and comes back disabled from a restart: whoever finds out why it faulted enables it.
void KnotGuide::onFault() {
  progress_.valid = false;
  disable();
}

void KnotGuide::run() {
  if (std::exchange(enableAtFirstCycle_, false)) enable();
  step();
  if (state_ != GuidanceState::Preparing || !preparation_.isOver()) return;
  giveUp(offers_ ? kGoalsNotTaken : kNotReadyInTime);
}

void KnotGuide::step() {
  const bool disabled = state_ == GuidanceState::Disabled;
  const bool sendsGoals = std::exchange(offers_, false) || state_ == GuidanceState::Guiding;
  for (GuidedSide* side : {&left_, &right_}) {
    if (!disabled) side->arms().prepare();
  }
  if (isRefused() && sendsGoals) return giveUp(kGoalsRefused);
  const bool missed = cycles_.missed(std::max(parameters_.max_age, 3 * period()));
  if (missed) estimate_.forget();  // where the tips have been meanwhile is not known
  if (!readArms()) {
    estimate_.forget();
    progress_.valid = false;
    return leave(disabled ? GuidanceState::Disabled : GuidanceState::Preparing);
  }
  lookForKnot();
  if (disabled) return;
  if (!operator_.teleoperates()) {
    for (GuidedSide* side : {&left_, &right_}) {
      if (operator_.isPresent()) side->release();
    }
    return leave(GuidanceState::Clutched);
  }
  if (parameters_.fixtures && !progress_.valid) return leave(GuidanceState::Blind);
  const bool streams = left_.arms().slave().streams() && right_.arms().slave().streams();
  if ((mustBeginAnew() || missed || !streams) && !begin()) return leave(GuidanceState::Preparing);
  if (!move()) return leave(GuidanceState::Preparing);
  offers_ = !streams;
  enter(streams ? GuidanceState::Guiding : GuidanceState::Preparing);
}

/// Returns false if it is not known where things stand. While the guide guides, a scene that is
/// lost stays as it was.
bool KnotGuide::readScene() {
  const auto frames = registration_.frames();
  sceneIsKnown_ = frames && frames.age() <= parameters_.registration_age;
  if (!sceneIsKnown_) return left_.follows();
  if (!haveSameBases(frames_, *frames)) forgetScene();
  frames_ = *frames;
  fixtures_.setTissue(frames_.tissue);
  left_.look(surgeonView(frames_, Side::Left, Side::Left));
  right_.look(surgeonView(frames_, Side::Right, Side::Right));
  return true;
}

/// Lets guiding begin anew, because tips and knot are elsewhere in a scene whose bases were
/// corrected. No arm has moved, so none must.
void KnotGuide::forgetScene() {
  estimate_.forget();
  for (GuidedSide* side : {&left_, &right_}) side->forgetAnchor();
}

/// Returns false unless the data of all four arms and the registration may be acted on.
bool KnotGuide::readArms() {
  if (!readScene()) return false;
  for (GuidedSide* side : {&left_, &right_}) {
    if (!side->readArms(parameters_.max_age, parameters_.fixtures)) return false;
  }
  setpoints_ = {frames_.left_base * left_.poses().slave.pose.translation(),
                frames_.right_base * right_.poses().slave.pose.translation()};
  estimate_.tipsAt(suture::now(), setpoints_.mean());
  return true;
}

void KnotGuide::lookForKnot() {
  const suture::Time now = suture::now();
  const auto sighting = vision_.sighting();
  if (sighting && sighting->valid) {
    // This needs where the camera stood at that time, because it may have moved since; without that
    // the sighting does not count.
    const auto then = registration_.frames.at(sighting->stamp);
    if (then && sighting->stamp - then.stamp() <= parameters_.registration_age) {
      estimate_.seenAt(sighting->stamp, then->camera * sighting->knot);
    }
  }
  const auto knot = estimate_.knot(now);
  progress_.valid = knot.has_value();
  if (!knot) return;
  progress_.knot = *knot;
  progress_.distance_to_target = fixtures_.distanceToTarget(*knot);
  progress_.lateral_error = fixtures_.lateralError(*knot);
  progress_.stamp = now;
}

bool KnotGuide::isRefused() {
  const bool left = left_.arms().slave().refuses();  // both must be asked
  return right_.arms().slave().refuses() || left;
}

void KnotGuide::giveUp(const char* why) {
  leave(GuidanceState::Disabled);
  messages_.error(why);
}

/// Returns true if a slave is not where it was sent, because it refuses goals or slides along a
/// joint limit.
bool KnotGuide::mustBeginAnew() {
  const bool leftBroke = left_.arms().slave().hasBrokenOff();
  const bool rightBroke = right_.arms().slave().hasBrokenOff();
  const bool leftIsSilent = left_.arms().slave().hasFallenSilent();
  const bool rightIsSilent = right_.arms().slave().hasFallenSilent();
  if (leftBroke || rightBroke || leftIsSilent || rightIsSilent) return true;
  if (!left_.follows() || !right_.follows()) return true;
  // A set-point may come back as late as max_age, and it is looked at a cycle or two later.
  const double most =
      std::numbers::sqrt3 * parameters_.speed * inSeconds(parameters_.max_age + 2 * period());
  return (setpoints_.left - tips_.left).norm() > most ||
         (setpoints_.right - tips_.right).norm() > most;
}

/// Returns false if it is not known where things stand now.
bool KnotGuide::begin() {
  if (!sceneIsKnown_) return false;
  for (GuidedSide* side : {&left_, &right_}) side->begin();
  tips_ = setpoints_;
  return true;
}

bool KnotGuide::move() {
  const Isometry3d left = left_.goal(frames_.left_base, tips_.left);
  const Isometry3d right = right_.goal(frames_.right_base, tips_.right);
  const TipPair wish{frames_.left_base * left.translation() - tips_.left,
                     frames_.right_base * right.translation() - tips_.right};
  const TipPair step = permitted(wish, {left_.room(left, frames_.left_base, tips_.left),
                                        right_.room(right, frames_.right_base, tips_.right)});
  forbid({wish.left - step.left - kept(wish.left, step.left),
          wish.right - step.right - kept(wish.right, step.right)});
  tips_.left += step.left;
  tips_.right += step.right;
  const bool leftTook = left_.send(left, frames_.left_base, tips_.left);
  return right_.send(right, frames_.right_base, tips_.right) && leftTook;
}

/// Returns where the knot is when the tips are where they have been sent. It is estimated from
/// where the slaves say that their tips are, which comes back late.
Vector3d KnotGuide::knotOfTips() const { return progress_.knot + tips_.mean() - setpoints_.mean(); }

TipPair KnotGuide::permitted(const TipPair& wish, const RoomPair& rooms) {
  if (!parameters_.fixtures) return {withoutHaste(wish.left), withoutHaste(wish.right)};
  return fixtures_.constrain(tips_, knotOfTips(), wish, inSeconds(parameters_.period), rooms);
}

/// Returns the part of a wish that a tip may fulfil in one cycle if nothing but its speed bounds
/// it.
Vector3d KnotGuide::withoutHaste(const Vector3d& wish) const {
  const double most = parameters_.speed * inSeconds(parameters_.period);
  return wish.cwiseMin(most).cwiseMax(-most);
}

/// What the fixtures forbid is made up for later only on the way to the target. So a tip whose hand
/// rests is not moved aside when they give way.
void KnotGuide::forbid(const TipPair& forbidden) {
  left_.forget(forbidden.left, frames_.left_base);
  right_.forget(forbidden.right, frames_.right_base);
  const double seconds = inSeconds(parameters_.period);
  forbidden_ = {.left = forbidden.left / seconds,
                .right = forbidden.right / seconds,
                .stamp = suture::now(),
                .valid = true};
  left_.resist(forbidden_.left, frames_.left_base);
  right_.resist(forbidden_.right, frames_.right_base);
}

/// Returns what later cycles shall fulfil of a wish of which this one fulfils `step`: what is only
/// delayed, by the bound of the speed, or before the target by a fixture, since one slows the knot
/// there and another leads it aside while hands go on. It is no more than a tip goes in kCatchUp,
/// nor does it lead beyond the target.
Vector3d KnotGuide::kept(const Vector3d& wish, const Vector3d& step) const {
  Vector3d delayed = wish - withoutHaste(wish);
  if (parameters_.fixtures) {
    const Vector3d approach = parameters_.approach.normalized();
    delayed += std::max(0.0, (wish - delayed - step).dot(approach)) * approach;
    const double beyond = delayed.dot(approach) - std::max(0.0, progress_.distance_to_target);
    delayed -= std::max(0.0, beyond) * approach;
  }
  const double most = parameters_.speed * kCatchUp;
  return delayed * (most / std::max(delayed.norm(), most));
}

void KnotGuide::leave(GuidanceState state) {
  for (GuidedSide* side : {&left_, &right_}) {
    if (state_ == GuidanceState::Guiding) side->arms().holdSlave();
    if (state == GuidanceState::Disabled) side->arms().stopPreparing();
    side->end();
  }
  forbidden_ = {};
  enter(state);
}

void KnotGuide::enter(GuidanceState state) {
  if (state_ == state) return;
  if (state == GuidanceState::Preparing) preparation_.begin();
  state_ = state;
  guidance_.emit().guidance_state(state);
}

}  // namespace robots
