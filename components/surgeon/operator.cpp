#include "surgeon/operator.h"

#include <utility>

#include "arm/fresh_pose.h"
#include "parameters/valid_age.h"
#include "registration/surgeon_view.h"
#include "surgeon/pause.h"
#include "timing/seconds.h"

namespace robots {
namespace {

using Eigen::Vector3d;

constexpr double kRateFilter = 0.005;  // s

HandModel handOf(const OperatorParameters& parameters, std::uint32_t number) {
  return {.tremor = {.amplitude = parameters.tremor, .seed = parameters.seed + number}};
}

CrossoverParameters crossoverOf(const OperatorParameters& parameters) {
  return {.frequency = parameters.crossover_frequency,
          .delay = parameters.delay,
          .remnant = parameters.remnant,
          .seed = parameters.seed};
}

PassivePort::Model portOf(const OperatorParameters& parameters) {
  return {.passive = parameters.passive, .mass = handOf(parameters, 0).mass};
}

PositionPositionModel feedbackOf(const OperatorParameters& parameters) {
  return {.gains = {parameters.stiffness, parameters.damping}, .port = portOf(parameters)};
}

FixtureResistanceModel resistanceOf(const OperatorParameters& parameters) {
  return {.damping = parameters.feel_fixtures ? parameters.resistance : 0,
          .port = portOf(parameters)};
}

}  // namespace

Operator::Operator(const OperatorParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      parameters_(parameters),
      left_(*this, "Left", "LeftSlave", parameters_, 0),
      right_(*this, "Right", "RightSlave", parameters_, 1),
      model_(crossoverOf(parameters), parameters.period) {
  requireAge("picture_age", parameters.picture_age);
  requireAge("slave_age", parameters.slave_age);
  guidance_.on().guidance_state(
      [this](const GuidanceState& state) { guided_ = state == GuidanceState::Guiding; });
}

void Operator::run() {
  const suture::Time now = suture::now();
  const double seconds = secondsBetween(std::exchange(last_, now), now);
  // The operator looks even while it holds, so that it knows the error when it begins.
  const Vector3d error = seenError(now);
  const bool missed = cycles_.missed(kLongestPause);
  const bool leftBrokeOff = left_.watch.hasBrokenOff();  // both must be asked
  const bool brokeOff = right_.watch.hasBrokenOff() || leftBrokeOff;
  const bool ready =
      guided_ && guidance_.connected() && left_.watch.ready() && right_.watch.ready();
  if (!ready || missed || brokeOff) holds_ = false;
  if (holds_) return lead(now, seconds, error);
  if (ready) begin();
}

void Operator::begin() {
  model_.forget();
  intended_.setZero();
  holds_ = orient() && left_.begin() && right_.begin();
}

/// Returns false if it is not known where things stand.
bool Operator::orient() {
  const auto frames = registration_.frames();
  if (!frames) return false;
  const Eigen::Matrix3d atConsole = sceneAtConsole(*frames);
  left_.orient(frames->left_master.linear(), atConsole * frames->left_base.linear());
  right_.orient(frames->right_master.linear(), atConsole * frames->right_base.linear());
  return true;
}

void Operator::lead(suture::Time now, double seconds, const Vector3d& error) {
  Vector3d rate = model_.rate(now, error) / parameters_.scale;
  const double speed = rate.norm();
  if (speed > parameters_.speed) rate *= parameters_.speed / speed;
  intended_ += seconds * rate;
  orient();  // the camera may have been moved
  const ForbiddenMotion forbidden = forbiddenAtConsole();
  const bool leftTook = left_.follow(now, seconds, intended_, forbidden.left);
  const bool rightTook = right_.follow(now, seconds, intended_, forbidden.right);
  if (!leftTook || !rightTook) holds_ = false;
}

/// Returns what the fixtures forbid as it looks at the console, to the scale of the masters; zero
/// if that is not known or not felt.
ForbiddenMotion Operator::forbiddenAtConsole() {
  if (!parameters_.feel_fixtures) return {};
  const auto forbidden = guidance_.forbidden_motion();
  const auto frames = registration_.frames();
  if (!forbidden || !forbidden->valid || !frames) return {};
  if (suture::now() - forbidden->stamp > parameters_.slave_age) return {};
  const Eigen::Matrix3d toHands = sceneAtConsole(*frames) / parameters_.scale;
  return {.left = toHands * forbidden->left,
          .right = toHands * forbidden->right,
          .stamp = forbidden->stamp,
          .valid = true};
}

Vector3d Operator::seenError(suture::Time now) {
  const auto sighting = vision_.sighting();
  if (!sighting || !sighting->valid) return Vector3d::Zero();
  if (now - sighting->stamp > parameters_.picture_age) return Vector3d::Zero();
  const auto frames = registration_.frames.at(sighting->stamp);  // the camera may have been moved
  if (!frames || sighting->stamp - frames.stamp() > parameters_.picture_age) {
    return Vector3d::Zero();
  }
  return sceneAtConsole(*frames) * (parameters_.target - frames->camera * sighting->knot);
}

Operator::Side::Side(Operator& self, const char* masterName, const char* slaveName,
                     const OperatorParameters& shared, std::uint32_t number)
    : parameters(shared),
      master(self, masterName),
      slave(self, slaveName),
      hand(handOf(shared, number)),
      feedback(feedbackOf(shared)),
      resistance(resistanceOf(shared)),
      slaveRate(kRateFilter) {
  if (shared.force_feedback == ForceFeedback::None) slave.makeOptional();
}

bool Operator::Side::begin() {
  const auto pose = master.setpoint_cp();
  if (!pose || !pose->valid) return false;
  start = pose->pose;
  hand.restAt(Vector3d::Zero());
  slaveStart.reset();
  resistance.beginAt(hand.position());
  return true;
}

/// If the slave is at another place in the picture, what the hand feels begins anew.
void Operator::Side::orient(const Eigen::Matrix3d& newFromMaster,
                            const Eigen::Matrix3d& newFromSlave) {
  fromMaster = newFromMaster;
  if (newFromSlave.isApprox(fromSlave, 1e-12)) return;
  fromSlave = newFromSlave;
  slaveStart.reset();
}

bool Operator::Side::follow(suture::Time now, double seconds, const Vector3d& intended,
                            const Vector3d& forbidden) {
  const Vector3d force =
      seconds > 0
          ? Vector3d(forceOfSlave(seconds) +
                     resistance.force({hand.position(), hand.velocity()}, forbidden, seconds))
          : Vector3d::Zero();
  hand.advance(seconds, intended, force);
  const Eigen::Translation3d moved(fromMaster.transpose() * hand.position());
  return master.servo_cp({moved * start, now, true}).has_value();
}

Vector3d Operator::Side::forceOfSlave(double seconds) {
  if (parameters.force_feedback == ForceFeedback::None) return Vector3d::Zero();
  const auto sample = slave.measured_cp();
  const PoseStamped* const pose = freshMeasurement(sample, parameters.slave_age);
  if (pose == nullptr) {
    slaveStart.reset();
    return Vector3d::Zero();
  }
  const Vector3d place = fromSlave * pose->pose.translation() / parameters.scale;
  if (!slaveStart) {
    slaveStart = place - hand.position();
    slaveRate.reset(place);
    feedback.beginAt(hand.position());
  }
  slaveRate.update(place, seconds);
  return feedback.force({hand.position(), hand.velocity()}, {place - *slaveStart, slaveRate.rate()},
                        seconds);
}

}  // namespace robots
