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

PositionPositionModel feedbackOf(const OperatorParameters& parameters) {
  return {.gains = {parameters.stiffness, parameters.damping},
          .passive = parameters.passive,
          .mass = handOf(parameters, 0).mass};
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
  const bool leftTook = left_.follow(now, seconds, intended_);
  const bool rightTook = right_.follow(now, seconds, intended_);
  if (!leftTook || !rightTook) holds_ = false;
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
      slaveRate(kRateFilter) {
  if (shared.force_feedback == ForceFeedback::None) slave.makeOptional();
}

bool Operator::Side::begin() {
  const auto pose = master.setpoint_cp();
  if (!pose || !pose->valid) return false;
  start = pose->pose;
  hand.restAt(Vector3d::Zero());
  slaveStart.reset();
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

/// Makes the master go where the hand goes. Returns false if it did not take its goal.
bool Operator::Side::follow(suture::Time now, double seconds, const Vector3d& intended) {
  hand.advance(seconds, intended, feedbackForce(seconds));
  const Eigen::Translation3d moved(fromMaster.transpose() * hand.position());
  return master.servo_cp({moved * start, now, true}).has_value();
}

Vector3d Operator::Side::feedbackForce(double seconds) {
  if (parameters.force_feedback == ForceFeedback::None || !(seconds > 0)) return Vector3d::Zero();
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
