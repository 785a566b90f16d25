#include "bench/compiler/handwritten/arm_client.h"

#include "bench/compiler/handwritten/parts.h"

namespace handwritten {
namespace {

/// Fills what travels with every command: the sender's clock, and that the answer shall come when
/// the command has been executed.
void fill(suture::wire::Sent::Builder sent) {
  sent.setStamp(suture::toNanoseconds(suture::now()));
  sent.setAnswer(true);
}

class Subscriber final : public wire::ArmEvents::Server {
 public:
  Subscriber(ArmHandlers& handlers, ArmState& state) : handlers_(handlers), state_(state) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto row = context.getParams().getRow();
    state_.stamp = suture::fromNanoseconds(row.getStamp());
    state_.evaluated = row.getEvaluated();
    if (row.getEvaluated() >> 0 & 1) read(row.getConfigurationJs(), state_.configuration_js);
    if (row.getEvaluated() >> 1 & 1) read(row.getOperatingState(), state_.operating_state);
    if (row.getEvaluated() >> 2 & 1) read(row.getPeriodStatistics(), state_.period_statistics);
    if (row.getEvaluated() >> 3 & 1) read(row.getMeasuredJs(), state_.measured_js);
    if (row.getEvaluated() >> 4 & 1) read(row.getSetpointJs(), state_.setpoint_js);
    if (row.getEvaluated() >> 5 & 1) read(row.getGoalJs(), state_.goal_js);
    if (row.getEvaluated() >> 6 & 1) read(row.getMeasuredCp(), state_.measured_cp);
    if (row.getEvaluated() >> 7 & 1) read(row.getSetpointCp(), state_.setpoint_cp);
    if (row.getEvaluated() >> 8 & 1) read(row.getGoalCp(), state_.goal_cp);
    if (row.getEvaluated() >> 9 & 1) read(row.getLocalMeasuredCp(), state_.local_measured_cp);
    if (row.getEvaluated() >> 10 & 1) read(row.getLocalSetpointCp(), state_.local_setpoint_cp);
    if (row.getEvaluated() >> 11 & 1) read(row.getMeasuredCv(), state_.measured_cv);
    if (row.getEvaluated() >> 12 & 1) read(row.getSetpointCv(), state_.setpoint_cv);
    if (row.getEvaluated() >> 13 & 1) read(row.getBodyMeasuredCf(), state_.body_measured_cf);
    if (row.getEvaluated() >> 14 & 1) read(row.getSpatialMeasuredCf(), state_.spatial_measured_cf);
    if (row.getEvaluated() >> 15 & 1) read(row.getMeasuredCs(), state_.measured_cs);
    if (row.getEvaluated() >> 16 & 1) read(row.getBodyJacobian(), state_.body_jacobian);
    if (row.getEvaluated() >> 17 & 1) read(row.getSpatialJacobian(), state_.spatial_jacobian);
    if (row.getEvaluated() >> 18 & 1) read(row.getBaseFrame(), state_.base_frame);
    if (row.getEvaluated() >> 19 & 1) state_.trajectory_j_ratio = row.getTrajectoryJRatio();
    if (row.getEvaluated() >> 20 & 1) state_.trajectory_j_ratio_v = row.getTrajectoryJRatioV();
    if (row.getEvaluated() >> 21 & 1) state_.trajectory_j_ratio_a = row.getTrajectoryJRatioA();
    return kj::READY_NOW;
  }

  kj::Promise<void> operatingState(OperatingStateContext context) override {
    if (handlers_.operating_state)
      handlers_.operating_state(as<robots::OperatingState>(context.getParams().getValue()));
    return kj::READY_NOW;
  }

  kj::Promise<void> desiredState(DesiredStateContext context) override {
    if (handlers_.desired_state) handlers_.desired_state(read(context.getParams().getValue()));
    return kj::READY_NOW;
  }

  kj::Promise<void> goalReached(GoalReachedContext context) override {
    if (handlers_.goal_reached) handlers_.goal_reached(context.getParams().getValue());
    return kj::READY_NOW;
  }

  kj::Promise<void> gravityCompensation(GravityCompensationContext context) override {
    if (handlers_.gravity_compensation)
      handlers_.gravity_compensation(context.getParams().getValue());
    return kj::READY_NOW;
  }

  kj::Promise<void> trajectoryJRatio(TrajectoryJRatioContext context) override {
    if (handlers_.trajectory_j_ratio) handlers_.trajectory_j_ratio(context.getParams().getValue());
    return kj::READY_NOW;
  }

  kj::Promise<void> trajectoryJRatioV(TrajectoryJRatioVContext context) override {
    if (handlers_.trajectory_j_ratio_v)
      handlers_.trajectory_j_ratio_v(context.getParams().getValue());
    return kj::READY_NOW;
  }

  kj::Promise<void> trajectoryJRatioA(TrajectoryJRatioAContext context) override {
    if (handlers_.trajectory_j_ratio_a)
      handlers_.trajectory_j_ratio_a(context.getParams().getValue());
    return kj::READY_NOW;
  }

  kj::Promise<void> status(StatusContext context) override {
    if (handlers_.status) handlers_.status(as<suture::Message>(context.getParams().getValue()));
    return kj::READY_NOW;
  }

  kj::Promise<void> warning(WarningContext context) override {
    if (handlers_.warning) handlers_.warning(as<suture::Message>(context.getParams().getValue()));
    return kj::READY_NOW;
  }

  kj::Promise<void> error(ErrorContext context) override {
    if (handlers_.error) handlers_.error(as<suture::Message>(context.getParams().getValue()));
    return kj::READY_NOW;
  }

 private:
  ArmHandlers& handlers_;
  ArmState& state_;
};

}  // namespace

kj::Promise<void> ArmClient::subscribe(ArmHandlers& handlers, ArmState& state,
                                       std::uint64_t columns) {
  auto request = arm_.subscribeRequest();
  request.setEvents(kj::heap<Subscriber>(handlers, state));
  request.setEventMask(~std::uint64_t{0});
  request.setStateMask(columns);
  return request.send().ignoreResult();
}

kj::Promise<Stamped<robots::JointConfiguration>> ArmClient::configuration_js() {
  auto request = arm_.configurationJsRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::JointConfiguration>{as<robots::JointConfiguration>(response.getValue()),
                                               suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::OperatingState>> ArmClient::operating_state() {
  auto request = arm_.operatingStateRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::OperatingState>{as<robots::OperatingState>(response.getValue()),
                                           suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::IntervalStatistics>> ArmClient::period_statistics() {
  auto request = arm_.periodStatisticsRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::IntervalStatistics>{as<robots::IntervalStatistics>(response.getValue()),
                                               suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::JointState>> ArmClient::measured_js() {
  auto request = arm_.measuredJsRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::JointState>{as<robots::JointState>(response.getValue()),
                                       suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::JointState>> ArmClient::setpoint_js() {
  auto request = arm_.setpointJsRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::JointState>{as<robots::JointState>(response.getValue()),
                                       suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::JointState>> ArmClient::goal_js() {
  auto request = arm_.goalJsRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::JointState>{as<robots::JointState>(response.getValue()),
                                       suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::PoseStamped>> ArmClient::measured_cp() {
  auto request = arm_.measuredCpRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::PoseStamped>{as<robots::PoseStamped>(response.getValue()),
                                        suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::PoseStamped>> ArmClient::setpoint_cp() {
  auto request = arm_.setpointCpRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::PoseStamped>{as<robots::PoseStamped>(response.getValue()),
                                        suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::PoseStamped>> ArmClient::goal_cp() {
  auto request = arm_.goalCpRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::PoseStamped>{as<robots::PoseStamped>(response.getValue()),
                                        suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::PoseStamped>> ArmClient::local_measured_cp() {
  auto request = arm_.localMeasuredCpRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::PoseStamped>{as<robots::PoseStamped>(response.getValue()),
                                        suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::PoseStamped>> ArmClient::local_setpoint_cp() {
  auto request = arm_.localSetpointCpRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::PoseStamped>{as<robots::PoseStamped>(response.getValue()),
                                        suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::Twist>> ArmClient::measured_cv() {
  auto request = arm_.measuredCvRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::Twist>{as<robots::Twist>(response.getValue()),
                                  suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::Twist>> ArmClient::setpoint_cv() {
  auto request = arm_.setpointCvRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::Twist>{as<robots::Twist>(response.getValue()),
                                  suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::Wrench>> ArmClient::body_measured_cf() {
  auto request = arm_.bodyMeasuredCfRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::Wrench>{as<robots::Wrench>(response.getValue()),
                                   suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::Wrench>> ArmClient::spatial_measured_cf() {
  auto request = arm_.spatialMeasuredCfRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::Wrench>{as<robots::Wrench>(response.getValue()),
                                   suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::CartesianState>> ArmClient::measured_cs() {
  auto request = arm_.measuredCsRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::CartesianState>{as<robots::CartesianState>(response.getValue()),
                                           suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::Jacobian>> ArmClient::body_jacobian() {
  auto request = arm_.bodyJacobianRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::Jacobian>{as<robots::Jacobian>(response.getValue()),
                                     suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::Jacobian>> ArmClient::spatial_jacobian() {
  auto request = arm_.spatialJacobianRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::Jacobian>{as<robots::Jacobian>(response.getValue()),
                                     suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<robots::TransformStamped>> ArmClient::base_frame() {
  auto request = arm_.baseFrameRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<robots::TransformStamped>{as<robots::TransformStamped>(response.getValue()),
                                             suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<double>> ArmClient::trajectory_j_ratio() {
  auto request = arm_.trajectoryJRatioRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<double>{response.getValue(), suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<double>> ArmClient::trajectory_j_ratio_v() {
  auto request = arm_.trajectoryJRatioVRequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<double>{response.getValue(), suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<Stamped<double>> ArmClient::trajectory_j_ratio_a() {
  auto request = arm_.trajectoryJRatioARequest();
  fill(request.initSent());
  return request.send().then([](auto&& response) {
    return Stamped<double>{response.getValue(), suture::fromNanoseconds(response.getStamp())};
  });
}

kj::Promise<void> ArmClient::enable() {
  auto request = arm_.enableRequest();
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::disable() {
  auto request = arm_.disableRequest();
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::pause() {
  auto request = arm_.pauseRequest();
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::resume() {
  auto request = arm_.resumeRequest();
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::home() {
  auto request = arm_.homeRequest();
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::unhome() {
  auto request = arm_.unhomeRequest();
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::hold() {
  auto request = arm_.holdRequest();
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::free() {
  auto request = arm_.freeRequest();
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::state_command(const std::string& name) {
  auto request = arm_.stateCommandRequest();
  request.setName(textOf(name));
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::set_base_frame(const robots::TransformStamped& base) {
  auto request = arm_.setBaseFrameRequest();
  write(base, request.initBase());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::use_gravity_compensation(bool use) {
  auto request = arm_.useGravityCompensationRequest();
  request.setUse(use);
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::servo_jp(const robots::JointGoal& goal) {
  auto request = arm_.servoJpRequest();
  write(goal, request.initGoal());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::servo_jr(const robots::JointGoal& step) {
  auto request = arm_.servoJrRequest();
  write(step, request.initStep());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::servo_jv(const robots::JointVelocityGoal& goal) {
  auto request = arm_.servoJvRequest();
  write(goal, request.initGoal());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::servo_jf(const robots::JointEffortGoal& goal) {
  auto request = arm_.servoJfRequest();
  write(goal, request.initGoal());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::servo_cp(const robots::PoseStamped& goal) {
  auto request = arm_.servoCpRequest();
  write(goal, request.initGoal());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::servo_cr(const robots::PoseStamped& step) {
  auto request = arm_.servoCrRequest();
  write(step, request.initStep());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::servo_cv(const robots::TwistGoal& goal) {
  auto request = arm_.servoCvRequest();
  write(goal, request.initGoal());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::body_servo_cf(const robots::WrenchGoal& goal) {
  auto request = arm_.bodyServoCfRequest();
  write(goal, request.initGoal());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::spatial_servo_cf(const robots::WrenchGoal& goal) {
  auto request = arm_.spatialServoCfRequest();
  write(goal, request.initGoal());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::interpolate_jp(const robots::JointGoal& goal) {
  auto request = arm_.interpolateJpRequest();
  write(goal, request.initGoal());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::interpolate_jr(const robots::JointGoal& step) {
  auto request = arm_.interpolateJrRequest();
  write(step, request.initStep());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::interpolate_cp(const robots::PoseStamped& goal) {
  auto request = arm_.interpolateCpRequest();
  write(goal, request.initGoal());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::interpolate_cr(const robots::PoseStamped& step) {
  auto request = arm_.interpolateCrRequest();
  write(step, request.initStep());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::move_jp(const robots::JointGoal& goal) {
  auto request = arm_.moveJpRequest();
  write(goal, request.initGoal());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::move_jr(const robots::JointGoal& step) {
  auto request = arm_.moveJrRequest();
  write(step, request.initStep());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::move_cp(const robots::PoseStamped& goal) {
  auto request = arm_.moveCpRequest();
  write(goal, request.initGoal());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::move_cr(const robots::PoseStamped& step) {
  auto request = arm_.moveCrRequest();
  write(step, request.initStep());
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::trajectory_j_set_ratio(double ratio) {
  auto request = arm_.trajectoryJSetRatioRequest();
  request.setRatio(ratio);
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::trajectory_j_set_ratio_v(double ratio) {
  auto request = arm_.trajectoryJSetRatioVRequest();
  request.setRatio(ratio);
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<void> ArmClient::trajectory_j_set_ratio_a(double ratio) {
  auto request = arm_.trajectoryJSetRatioARequest();
  request.setRatio(ratio);
  fill(request.initSent());
  return request.send().ignoreResult();
}

kj::Promise<robots::PoseStamped> ArmClient::forward_kinematics(const robots::JointGoal& q) {
  auto request = arm_.forwardKinematicsRequest();
  write(q, request.initQ());
  fill(request.initSent());
  return request.send().then(
      [](auto&& response) { return as<robots::PoseStamped>(response.getValue()); });
}

kj::Promise<robots::JointSolution> ArmClient::inverse_kinematics(const robots::PoseStamped& goal) {
  auto request = arm_.inverseKinematicsRequest();
  write(goal, request.initGoal());
  fill(request.initSent());
  return request.send().then(
      [](auto&& response) { return as<robots::JointSolution>(response.getValue()); });
}

kj::Promise<robots::PoseStamped> ArmClient::query_cp(const robots::JointGoal& q) {
  auto request = arm_.queryCpRequest();
  write(q, request.initQ());
  fill(request.initSent());
  return request.send().then(
      [](auto&& response) { return as<robots::PoseStamped>(response.getValue()); });
}

kj::Promise<robots::PoseStamped> ArmClient::local_query_cp(const robots::JointGoal& q) {
  auto request = arm_.localQueryCpRequest();
  write(q, request.initQ());
  fill(request.initSent());
  return request.send().then(
      [](auto&& response) { return as<robots::PoseStamped>(response.getValue()); });
}

}  // namespace handwritten
