#pragma once
// The thread of its event loop uses this, and the implementation runs there as well. It is a server
// of the complete arm interface, written by hand on Cap'n Proto: it calls an implementation of the
// contract, and tells subscribers events and rows.

#include <kj/async.h>

#include <string>
#include <vector>

#include "arm/arm.h"
#include "bench/compiler/handwritten/conversions.h"

namespace handwritten {

class ArmServer final : public wire::Arm::Server, private kj::TaskSet::ErrorHandler {
 public:
  explicit ArmServer(robots::Arm& arm) : arm_(arm), sending_(*this) {}

  /// Evaluates the reads that each subscriber asked for and sends them as a row.
  void sendRows();

  // These emit to all who asked for the event.
  void emitOperatingState(const robots::OperatingState& value);
  void emitDesiredState(robots::ArmState value);
  void emitGoalReached(bool value);
  void emitGravityCompensation(bool value);
  void emitTrajectoryJRatio(double value);
  void emitTrajectoryJRatioV(double value);
  void emitTrajectoryJRatioA(double value);
  void emitStatus(const suture::Message& value);
  void emitWarning(const suture::Message& value);
  void emitError(const suture::Message& value);

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override;
  kj::Promise<void> configurationJs(ConfigurationJsContext context) override;
  kj::Promise<void> operatingState(OperatingStateContext context) override;
  kj::Promise<void> periodStatistics(PeriodStatisticsContext context) override;
  kj::Promise<void> measuredJs(MeasuredJsContext context) override;
  kj::Promise<void> setpointJs(SetpointJsContext context) override;
  kj::Promise<void> goalJs(GoalJsContext context) override;
  kj::Promise<void> measuredCp(MeasuredCpContext context) override;
  kj::Promise<void> setpointCp(SetpointCpContext context) override;
  kj::Promise<void> goalCp(GoalCpContext context) override;
  kj::Promise<void> localMeasuredCp(LocalMeasuredCpContext context) override;
  kj::Promise<void> localSetpointCp(LocalSetpointCpContext context) override;
  kj::Promise<void> measuredCv(MeasuredCvContext context) override;
  kj::Promise<void> setpointCv(SetpointCvContext context) override;
  kj::Promise<void> bodyMeasuredCf(BodyMeasuredCfContext context) override;
  kj::Promise<void> spatialMeasuredCf(SpatialMeasuredCfContext context) override;
  kj::Promise<void> measuredCs(MeasuredCsContext context) override;
  kj::Promise<void> bodyJacobian(BodyJacobianContext context) override;
  kj::Promise<void> spatialJacobian(SpatialJacobianContext context) override;
  kj::Promise<void> baseFrame(BaseFrameContext context) override;
  kj::Promise<void> trajectoryJRatio(TrajectoryJRatioContext context) override;
  kj::Promise<void> trajectoryJRatioV(TrajectoryJRatioVContext context) override;
  kj::Promise<void> trajectoryJRatioA(TrajectoryJRatioAContext context) override;
  kj::Promise<void> enable(EnableContext context) override;
  kj::Promise<void> disable(DisableContext context) override;
  kj::Promise<void> pause(PauseContext context) override;
  kj::Promise<void> resume(ResumeContext context) override;
  kj::Promise<void> home(HomeContext context) override;
  kj::Promise<void> unhome(UnhomeContext context) override;
  kj::Promise<void> hold(HoldContext context) override;
  kj::Promise<void> free(FreeContext context) override;
  kj::Promise<void> stateCommand(StateCommandContext context) override;
  kj::Promise<void> setBaseFrame(SetBaseFrameContext context) override;
  kj::Promise<void> useGravityCompensation(UseGravityCompensationContext context) override;
  kj::Promise<void> servoJp(ServoJpContext context) override;
  kj::Promise<void> servoJr(ServoJrContext context) override;
  kj::Promise<void> servoJv(ServoJvContext context) override;
  kj::Promise<void> servoJf(ServoJfContext context) override;
  kj::Promise<void> servoCp(ServoCpContext context) override;
  kj::Promise<void> servoCr(ServoCrContext context) override;
  kj::Promise<void> servoCv(ServoCvContext context) override;
  kj::Promise<void> bodyServoCf(BodyServoCfContext context) override;
  kj::Promise<void> spatialServoCf(SpatialServoCfContext context) override;
  kj::Promise<void> interpolateJp(InterpolateJpContext context) override;
  kj::Promise<void> interpolateJr(InterpolateJrContext context) override;
  kj::Promise<void> interpolateCp(InterpolateCpContext context) override;
  kj::Promise<void> interpolateCr(InterpolateCrContext context) override;
  kj::Promise<void> moveJp(MoveJpContext context) override;
  kj::Promise<void> moveJr(MoveJrContext context) override;
  kj::Promise<void> moveCp(MoveCpContext context) override;
  kj::Promise<void> moveCr(MoveCrContext context) override;
  kj::Promise<void> trajectoryJSetRatio(TrajectoryJSetRatioContext context) override;
  kj::Promise<void> trajectoryJSetRatioV(TrajectoryJSetRatioVContext context) override;
  kj::Promise<void> trajectoryJSetRatioA(TrajectoryJSetRatioAContext context) override;
  kj::Promise<void> forwardKinematics(ForwardKinematicsContext context) override;
  kj::Promise<void> inverseKinematics(InverseKinematicsContext context) override;
  kj::Promise<void> queryCp(QueryCpContext context) override;
  kj::Promise<void> localQueryCp(LocalQueryCpContext context) override;

 private:
  struct Subscriber {
    wire::ArmEvents::Client events;
    std::uint64_t eventMask, stateMask;
  };

  template <class Send>
  void toSubscribers(unsigned event, const Send& send);
  void taskFailed(kj::Exception&& exception) override;

  robots::Arm& arm_;
  std::vector<Subscriber> subscribers_;
  kj::TaskSet sending_;
};

}  // namespace handwritten
