#include "bench/compiler/handwritten/arm_server.h"

#include <kj/debug.h>

#include <cmath>

#include "bench/compiler/handwritten/parts.h"

namespace handwritten {
namespace {

/// Requires the schema's range of a ratio.
double ratioOf(double value) {
  KJ_REQUIRE(value >= 0.01 && value <= 1, "a ratio is out of its range", value);
  return value;
}

std::int64_t stampNow() { return suture::toNanoseconds(suture::now()); }

}  // namespace

template <class Send>
void ArmServer::toSubscribers(unsigned event, const Send& send) {
  for (Subscriber& one : subscribers_) {
    if (one.eventMask >> event & 1) sending_.add(send(one.events));
  }
}

void ArmServer::taskFailed(kj::Exception&& exception) {
  KJ_LOG(WARNING, "a subscriber is gone", exception);
}

kj::Promise<void> ArmServer::subscribe(SubscribeContext context) {
  auto in = context.getParams();
  subscribers_.push_back({in.getEvents(), in.getEventMask(), in.getStateMask()});
  return kj::READY_NOW;
}

void ArmServer::sendRows() {
  for (Subscriber& one : subscribers_) {
    auto request = one.events.stateRequest();
    auto row = request.initRow();
    row.setStamp(stampNow());
    row.setEvaluated(one.stateMask);
    if (one.stateMask >> 0 & 1) write(arm_.configuration_js(), row.initConfigurationJs());
    if (one.stateMask >> 1 & 1) write(arm_.operating_state(), row.initOperatingState());
    if (one.stateMask >> 2 & 1) write(arm_.period_statistics(), row.initPeriodStatistics());
    if (one.stateMask >> 3 & 1) write(arm_.measured_js(), row.initMeasuredJs());
    if (one.stateMask >> 4 & 1) write(arm_.setpoint_js(), row.initSetpointJs());
    if (one.stateMask >> 5 & 1) write(arm_.goal_js(), row.initGoalJs());
    if (one.stateMask >> 6 & 1) write(arm_.measured_cp(), row.initMeasuredCp());
    if (one.stateMask >> 7 & 1) write(arm_.setpoint_cp(), row.initSetpointCp());
    if (one.stateMask >> 8 & 1) write(arm_.goal_cp(), row.initGoalCp());
    if (one.stateMask >> 9 & 1) write(arm_.local_measured_cp(), row.initLocalMeasuredCp());
    if (one.stateMask >> 10 & 1) write(arm_.local_setpoint_cp(), row.initLocalSetpointCp());
    if (one.stateMask >> 11 & 1) write(arm_.measured_cv(), row.initMeasuredCv());
    if (one.stateMask >> 12 & 1) write(arm_.setpoint_cv(), row.initSetpointCv());
    if (one.stateMask >> 13 & 1) write(arm_.body_measured_cf(), row.initBodyMeasuredCf());
    if (one.stateMask >> 14 & 1) write(arm_.spatial_measured_cf(), row.initSpatialMeasuredCf());
    if (one.stateMask >> 15 & 1) write(arm_.measured_cs(), row.initMeasuredCs());
    if (one.stateMask >> 16 & 1) write(arm_.body_jacobian(), row.initBodyJacobian());
    if (one.stateMask >> 17 & 1) write(arm_.spatial_jacobian(), row.initSpatialJacobian());
    if (one.stateMask >> 18 & 1) write(arm_.base_frame(), row.initBaseFrame());
    if (one.stateMask >> 19 & 1) row.setTrajectoryJRatio(arm_.trajectory_j_ratio());
    if (one.stateMask >> 20 & 1) row.setTrajectoryJRatioV(arm_.trajectory_j_ratio_v());
    if (one.stateMask >> 21 & 1) row.setTrajectoryJRatioA(arm_.trajectory_j_ratio_a());
    sending_.add(request.send().ignoreResult());
  }
}

void ArmServer::emitOperatingState(const robots::OperatingState& value) {
  toSubscribers(3, [&](wire::ArmEvents::Client& events) {
    auto request = events.operatingStateRequest();
    write(value, request.initValue());
    return request.send().ignoreResult();
  });
}

void ArmServer::emitDesiredState(robots::ArmState value) {
  toSubscribers(4, [&](wire::ArmEvents::Client& events) {
    auto request = events.desiredStateRequest();
    request.setValue(write(value));
    return request.send().ignoreResult();
  });
}

void ArmServer::emitGoalReached(bool value) {
  toSubscribers(5, [&](wire::ArmEvents::Client& events) {
    auto request = events.goalReachedRequest();
    request.setValue(value);
    return request.send().ignoreResult();
  });
}

void ArmServer::emitGravityCompensation(bool value) {
  toSubscribers(6, [&](wire::ArmEvents::Client& events) {
    auto request = events.gravityCompensationRequest();
    request.setValue(value);
    return request.send().ignoreResult();
  });
}

void ArmServer::emitTrajectoryJRatio(double value) {
  toSubscribers(7, [&](wire::ArmEvents::Client& events) {
    auto request = events.trajectoryJRatioRequest();
    request.setValue(value);
    return request.send().ignoreResult();
  });
}

void ArmServer::emitTrajectoryJRatioV(double value) {
  toSubscribers(8, [&](wire::ArmEvents::Client& events) {
    auto request = events.trajectoryJRatioVRequest();
    request.setValue(value);
    return request.send().ignoreResult();
  });
}

void ArmServer::emitTrajectoryJRatioA(double value) {
  toSubscribers(9, [&](wire::ArmEvents::Client& events) {
    auto request = events.trajectoryJRatioARequest();
    request.setValue(value);
    return request.send().ignoreResult();
  });
}

void ArmServer::emitStatus(const suture::Message& value) {
  toSubscribers(0, [&](wire::ArmEvents::Client& events) {
    auto request = events.statusRequest();
    write(value, request.initValue());
    return request.send().ignoreResult();
  });
}

void ArmServer::emitWarning(const suture::Message& value) {
  toSubscribers(1, [&](wire::ArmEvents::Client& events) {
    auto request = events.warningRequest();
    write(value, request.initValue());
    return request.send().ignoreResult();
  });
}

void ArmServer::emitError(const suture::Message& value) {
  toSubscribers(2, [&](wire::ArmEvents::Client& events) {
    auto request = events.errorRequest();
    write(value, request.initValue());
    return request.send().ignoreResult();
  });
}

kj::Promise<void> ArmServer::configurationJs(ConfigurationJsContext context) {
  auto out = context.getResults();
  write(arm_.configuration_js(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::operatingState(OperatingStateContext context) {
  auto out = context.getResults();
  write(arm_.operating_state(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::periodStatistics(PeriodStatisticsContext context) {
  auto out = context.getResults();
  write(arm_.period_statistics(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::measuredJs(MeasuredJsContext context) {
  auto out = context.getResults();
  write(arm_.measured_js(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::setpointJs(SetpointJsContext context) {
  auto out = context.getResults();
  write(arm_.setpoint_js(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::goalJs(GoalJsContext context) {
  auto out = context.getResults();
  write(arm_.goal_js(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::measuredCp(MeasuredCpContext context) {
  auto out = context.getResults();
  write(arm_.measured_cp(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::setpointCp(SetpointCpContext context) {
  auto out = context.getResults();
  write(arm_.setpoint_cp(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::goalCp(GoalCpContext context) {
  auto out = context.getResults();
  write(arm_.goal_cp(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::localMeasuredCp(LocalMeasuredCpContext context) {
  auto out = context.getResults();
  write(arm_.local_measured_cp(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::localSetpointCp(LocalSetpointCpContext context) {
  auto out = context.getResults();
  write(arm_.local_setpoint_cp(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::measuredCv(MeasuredCvContext context) {
  auto out = context.getResults();
  write(arm_.measured_cv(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::setpointCv(SetpointCvContext context) {
  auto out = context.getResults();
  write(arm_.setpoint_cv(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::bodyMeasuredCf(BodyMeasuredCfContext context) {
  auto out = context.getResults();
  write(arm_.body_measured_cf(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::spatialMeasuredCf(SpatialMeasuredCfContext context) {
  auto out = context.getResults();
  write(arm_.spatial_measured_cf(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::measuredCs(MeasuredCsContext context) {
  auto out = context.getResults();
  write(arm_.measured_cs(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::bodyJacobian(BodyJacobianContext context) {
  auto out = context.getResults();
  write(arm_.body_jacobian(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::spatialJacobian(SpatialJacobianContext context) {
  auto out = context.getResults();
  write(arm_.spatial_jacobian(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::baseFrame(BaseFrameContext context) {
  auto out = context.getResults();
  write(arm_.base_frame(), out.initValue());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::trajectoryJRatio(TrajectoryJRatioContext context) {
  auto out = context.getResults();
  out.setValue(arm_.trajectory_j_ratio());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::trajectoryJRatioV(TrajectoryJRatioVContext context) {
  auto out = context.getResults();
  out.setValue(arm_.trajectory_j_ratio_v());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::trajectoryJRatioA(TrajectoryJRatioAContext context) {
  auto out = context.getResults();
  out.setValue(arm_.trajectory_j_ratio_a());
  out.setStamp(stampNow());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::enable(EnableContext) {
  arm_.enable();
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::disable(DisableContext) {
  arm_.disable();
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::pause(PauseContext) {
  arm_.pause();
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::resume(ResumeContext) {
  arm_.resume();
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::home(HomeContext) {
  arm_.home();
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::unhome(UnhomeContext) {
  arm_.unhome();
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::hold(HoldContext) {
  arm_.hold();
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::free(FreeContext) {
  arm_.free();
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::stateCommand(StateCommandContext context) {
  std::string name;
  read(context.getParams().getName(), name);
  arm_.state_command(name);
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::setBaseFrame(SetBaseFrameContext context) {
  arm_.set_base_frame(as<robots::TransformStamped>(context.getParams().getBase()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::useGravityCompensation(UseGravityCompensationContext context) {
  arm_.use_gravity_compensation(context.getParams().getUse());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::servoJp(ServoJpContext context) {
  arm_.servo_jp(as<robots::JointGoal>(context.getParams().getGoal()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::servoJr(ServoJrContext context) {
  arm_.servo_jr(as<robots::JointGoal>(context.getParams().getStep()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::servoJv(ServoJvContext context) {
  arm_.servo_jv(as<robots::JointVelocityGoal>(context.getParams().getGoal()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::servoJf(ServoJfContext context) {
  arm_.servo_jf(as<robots::JointEffortGoal>(context.getParams().getGoal()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::servoCp(ServoCpContext context) {
  arm_.servo_cp(as<robots::PoseStamped>(context.getParams().getGoal()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::servoCr(ServoCrContext context) {
  arm_.servo_cr(as<robots::PoseStamped>(context.getParams().getStep()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::servoCv(ServoCvContext context) {
  arm_.servo_cv(as<robots::TwistGoal>(context.getParams().getGoal()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::bodyServoCf(BodyServoCfContext context) {
  arm_.body_servo_cf(as<robots::WrenchGoal>(context.getParams().getGoal()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::spatialServoCf(SpatialServoCfContext context) {
  arm_.spatial_servo_cf(as<robots::WrenchGoal>(context.getParams().getGoal()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::interpolateJp(InterpolateJpContext context) {
  arm_.interpolate_jp(as<robots::JointGoal>(context.getParams().getGoal()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::interpolateJr(InterpolateJrContext context) {
  arm_.interpolate_jr(as<robots::JointGoal>(context.getParams().getStep()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::interpolateCp(InterpolateCpContext context) {
  arm_.interpolate_cp(as<robots::PoseStamped>(context.getParams().getGoal()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::interpolateCr(InterpolateCrContext context) {
  arm_.interpolate_cr(as<robots::PoseStamped>(context.getParams().getStep()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::moveJp(MoveJpContext context) {
  arm_.move_jp(as<robots::JointGoal>(context.getParams().getGoal()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::moveJr(MoveJrContext context) {
  arm_.move_jr(as<robots::JointGoal>(context.getParams().getStep()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::moveCp(MoveCpContext context) {
  arm_.move_cp(as<robots::PoseStamped>(context.getParams().getGoal()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::moveCr(MoveCrContext context) {
  arm_.move_cr(as<robots::PoseStamped>(context.getParams().getStep()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::trajectoryJSetRatio(TrajectoryJSetRatioContext context) {
  arm_.trajectory_j_set_ratio(ratioOf(context.getParams().getRatio()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::trajectoryJSetRatioV(TrajectoryJSetRatioVContext context) {
  arm_.trajectory_j_set_ratio_v(ratioOf(context.getParams().getRatio()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::trajectoryJSetRatioA(TrajectoryJSetRatioAContext context) {
  arm_.trajectory_j_set_ratio_a(ratioOf(context.getParams().getRatio()));
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::forwardKinematics(ForwardKinematicsContext context) {
  const auto q = as<robots::JointGoal>(context.getParams().getQ());
  write(arm_.forward_kinematics(q), context.getResults().initValue());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::inverseKinematics(InverseKinematicsContext context) {
  const auto goal = as<robots::PoseStamped>(context.getParams().getGoal());
  write(arm_.inverse_kinematics(goal), context.getResults().initValue());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::queryCp(QueryCpContext context) {
  const auto q = as<robots::JointGoal>(context.getParams().getQ());
  write(arm_.query_cp(q), context.getResults().initValue());
  return kj::READY_NOW;
}

kj::Promise<void> ArmServer::localQueryCp(LocalQueryCpContext context) {
  const auto q = as<robots::JointGoal>(context.getParams().getQ());
  write(arm_.local_query_cp(q), context.getResults().initValue());
  return kj::READY_NOW;
}

}  // namespace handwritten
