// Written by suturec from arm/arm.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "arm/arm.capnp.h"
#include "arm/arm.suture.h"

// Defined in robot_types/cartesian.wire.cpp.
namespace robots {
void toWire(const CartesianStateSlot& slot, wire::CartesianState::Builder out);
suture::Errc fromWire(wire::CartesianState::Reader in, CartesianStateSlot& slot,
                      suture::Duration shift);
void toWire(const TwistSlot& slot, wire::Twist::Builder out);
suture::Errc fromWire(wire::Twist::Reader in, TwistSlot& slot, suture::Duration shift);
void toWire(const TwistGoalSlot& slot, wire::TwistGoal::Builder out);
suture::Errc fromWire(wire::TwistGoal::Reader in, TwistGoalSlot& slot, suture::Duration shift);
void toWire(const WrenchSlot& slot, wire::Wrench::Builder out);
suture::Errc fromWire(wire::Wrench::Reader in, WrenchSlot& slot, suture::Duration shift);
void toWire(const WrenchGoalSlot& slot, wire::WrenchGoal::Builder out);
suture::Errc fromWire(wire::WrenchGoal::Reader in, WrenchGoalSlot& slot, suture::Duration shift);
}  // namespace robots

// Defined in robot_types/joint_commands.wire.cpp.
namespace robots {
void toWire(const JacobianSlot& slot, wire::Jacobian::Builder out);
suture::Errc fromWire(wire::Jacobian::Reader in, JacobianSlot& slot, suture::Duration shift);
void toWire(const JointConfigurationSlot& slot, wire::JointConfiguration::Builder out);
suture::Errc fromWire(wire::JointConfiguration::Reader in, JointConfigurationSlot& slot,
                      suture::Duration shift);
void toWire(const JointEffortGoalSlot& slot, wire::JointEffortGoal::Builder out);
suture::Errc fromWire(wire::JointEffortGoal::Reader in, JointEffortGoalSlot& slot,
                      suture::Duration shift);
void toWire(const JointVelocityGoalSlot& slot, wire::JointVelocityGoal::Builder out);
suture::Errc fromWire(wire::JointVelocityGoal::Reader in, JointVelocityGoalSlot& slot,
                      suture::Duration shift);
}  // namespace robots

// Defined in robot_types/joints.wire.cpp.
namespace robots {
void toWire(const JointGoalSlot& slot, wire::JointGoal::Builder out);
suture::Errc fromWire(wire::JointGoal::Reader in, JointGoalSlot& slot, suture::Duration shift);
void toWire(const JointSolutionSlot& slot, wire::JointSolution::Builder out);
suture::Errc fromWire(wire::JointSolution::Reader in, JointSolutionSlot& slot,
                      suture::Duration shift);
void toWire(const JointStateSlot& slot, wire::JointState::Builder out);
suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration shift);
}  // namespace robots

// Defined in robot_types/messages.wire.cpp.
namespace robots {
void toWire(const IntervalStatisticsSlot& slot, wire::IntervalStatistics::Builder out);
suture::Errc fromWire(wire::IntervalStatistics::Reader in, IntervalStatisticsSlot& slot,
                      suture::Duration shift);
}  // namespace robots

// Defined in robot_types/operating_state.wire.cpp.
namespace robots {
wire::ArmState wireArmState(std::uint8_t slot);
suture::Errc fromWire(wire::ArmState in, std::uint8_t& slot);
void toWire(const OperatingStateSlot& slot, wire::OperatingState::Builder out);
suture::Errc fromWire(wire::OperatingState::Reader in, OperatingStateSlot& slot,
                      suture::Duration shift);
}  // namespace robots

// Defined in robot_types/pose.wire.cpp.
namespace robots {
void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out);
suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift);
void toWire(const TransformStampedSlot& slot, wire::TransformStamped::Builder out);
suture::Errc fromWire(wire::TransformStamped::Reader in, TransformStampedSlot& slot,
                      suture::Duration shift);
}  // namespace robots

// Defined in suture/standard/messages.wire.cpp.
namespace suture {
void toWire(const MessageSlot& slot, wire::Message::Builder out);
suture::Errc fromWire(wire::Message::Reader in, MessageSlot& slot, suture::Duration shift);
}  // namespace suture

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- Arm as Cap'n Proto

namespace {

void encodeArmServoCp(const ArmServoCpArguments& slot, wire::Arm::ServoCpParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmServoCp(wire::Arm::ServoCpParams::Reader in, ArmServoCpArguments& slot,
                              suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmServoJp(const ArmServoJpArguments& slot, wire::Arm::ServoJpParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmServoJp(wire::Arm::ServoJpParams::Reader in, ArmServoJpArguments& slot,
                              suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmMoveJp(const ArmMoveJpArguments& slot, wire::Arm::MoveJpParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmMoveJp(wire::Arm::MoveJpParams::Reader in, ArmMoveJpArguments& slot,
                             suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmMeasuredJsResult(const JointStateSlot& slot,
                               wire::Arm::MeasuredJsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmMeasuredJsResult(wire::Arm::MeasuredJsResults::Reader in,
                                       JointStateSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmSetpointJsResult(const JointStateSlot& slot,
                               wire::Arm::SetpointJsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmSetpointJsResult(wire::Arm::SetpointJsResults::Reader in,
                                       JointStateSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmMeasuredCpResult(const PoseStampedSlot& slot,
                               wire::Arm::MeasuredCpResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmMeasuredCpResult(wire::Arm::MeasuredCpResults::Reader in,
                                       PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmSetpointCpResult(const PoseStampedSlot& slot,
                               wire::Arm::SetpointCpResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmSetpointCpResult(wire::Arm::SetpointCpResults::Reader in,
                                       PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmOperatingStateResult(const OperatingStateSlot& slot,
                                   wire::Arm::OperatingStateResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmOperatingStateResult(wire::Arm::OperatingStateResults::Reader in,
                                           OperatingStateSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmForwardKinematics(const ArmForwardKinematicsArguments& slot,
                                wire::Arm::ForwardKinematicsParams::Builder out) {
  toWire(slot.q, out.initQ());
}
suture::Errc decodeArmForwardKinematics(wire::Arm::ForwardKinematicsParams::Reader in,
                                        ArmForwardKinematicsArguments& slot,
                                        suture::Duration shift) {
  return in.hasQ() ? fromWire(in.getQ(), slot.q, shift) : suture::Errc::Invalid;
}

void encodeArmForwardKinematicsResult(const PoseStampedSlot& slot,
                                      wire::Arm::ForwardKinematicsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmForwardKinematicsResult(wire::Arm::ForwardKinematicsResults::Reader in,
                                              PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmInverseKinematics(const ArmInverseKinematicsArguments& slot,
                                wire::Arm::InverseKinematicsParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmInverseKinematics(wire::Arm::InverseKinematicsParams::Reader in,
                                        ArmInverseKinematicsArguments& slot,
                                        suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmInverseKinematicsResult(const JointSolutionSlot& slot,
                                      wire::Arm::InverseKinematicsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmInverseKinematicsResult(wire::Arm::InverseKinematicsResults::Reader in,
                                              JointSolutionSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmConfigurationJsResult(const JointConfigurationSlot& slot,
                                    wire::Arm::ConfigurationJsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmConfigurationJsResult(wire::Arm::ConfigurationJsResults::Reader in,
                                            JointConfigurationSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmPeriodStatisticsResult(const IntervalStatisticsSlot& slot,
                                     wire::Arm::PeriodStatisticsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmPeriodStatisticsResult(wire::Arm::PeriodStatisticsResults::Reader in,
                                             IntervalStatisticsSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmStateCommand(const ArmStateCommandArguments& slot,
                           wire::Arm::StateCommandParams::Builder out) {
  toWire(slot.name, out.initName(sizeOf(slot.name)));
}
suture::Errc decodeArmStateCommand(wire::Arm::StateCommandParams::Reader in,
                                   ArmStateCommandArguments& slot, suture::Duration) {
  return fromWire(in.getName(), slot.name);
}

void encodeArmGoalJsResult(const JointStateSlot& slot, wire::Arm::GoalJsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmGoalJsResult(wire::Arm::GoalJsResults::Reader in, JointStateSlot& slot,
                                   suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmGoalCpResult(const PoseStampedSlot& slot, wire::Arm::GoalCpResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmGoalCpResult(wire::Arm::GoalCpResults::Reader in, PoseStampedSlot& slot,
                                   suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmLocalMeasuredCpResult(const PoseStampedSlot& slot,
                                    wire::Arm::LocalMeasuredCpResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmLocalMeasuredCpResult(wire::Arm::LocalMeasuredCpResults::Reader in,
                                            PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmLocalSetpointCpResult(const PoseStampedSlot& slot,
                                    wire::Arm::LocalSetpointCpResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmLocalSetpointCpResult(wire::Arm::LocalSetpointCpResults::Reader in,
                                            PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmMeasuredCvResult(const TwistSlot& slot, wire::Arm::MeasuredCvResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmMeasuredCvResult(wire::Arm::MeasuredCvResults::Reader in, TwistSlot& slot,
                                       suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmSetpointCvResult(const TwistSlot& slot, wire::Arm::SetpointCvResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmSetpointCvResult(wire::Arm::SetpointCvResults::Reader in, TwistSlot& slot,
                                       suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmBodyMeasuredCfResult(const WrenchSlot& slot,
                                   wire::Arm::BodyMeasuredCfResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmBodyMeasuredCfResult(wire::Arm::BodyMeasuredCfResults::Reader in,
                                           WrenchSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmSpatialMeasuredCfResult(const WrenchSlot& slot,
                                      wire::Arm::SpatialMeasuredCfResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmSpatialMeasuredCfResult(wire::Arm::SpatialMeasuredCfResults::Reader in,
                                              WrenchSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmMeasuredCsResult(const CartesianStateSlot& slot,
                               wire::Arm::MeasuredCsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmMeasuredCsResult(wire::Arm::MeasuredCsResults::Reader in,
                                       CartesianStateSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmBodyJacobianResult(const JacobianSlot& slot,
                                 wire::Arm::BodyJacobianResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmBodyJacobianResult(wire::Arm::BodyJacobianResults::Reader in,
                                         JacobianSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmSpatialJacobianResult(const JacobianSlot& slot,
                                    wire::Arm::SpatialJacobianResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmSpatialJacobianResult(wire::Arm::SpatialJacobianResults::Reader in,
                                            JacobianSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmBaseFrameResult(const TransformStampedSlot& slot,
                              wire::Arm::BaseFrameResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmBaseFrameResult(wire::Arm::BaseFrameResults::Reader in,
                                      TransformStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmSetBaseFrame(const ArmSetBaseFrameArguments& slot,
                           wire::Arm::SetBaseFrameParams::Builder out) {
  toWire(slot.base, out.initBase());
}
suture::Errc decodeArmSetBaseFrame(wire::Arm::SetBaseFrameParams::Reader in,
                                   ArmSetBaseFrameArguments& slot, suture::Duration shift) {
  return in.hasBase() ? fromWire(in.getBase(), slot.base, shift) : suture::Errc::Invalid;
}

void encodeArmUseGravityCompensation(const ArmUseGravityCompensationArguments& slot,
                                     wire::Arm::UseGravityCompensationParams::Builder out) {
  out.setUse(slot.use != 0);
}
suture::Errc decodeArmUseGravityCompensation(wire::Arm::UseGravityCompensationParams::Reader in,
                                             ArmUseGravityCompensationArguments& slot,
                                             suture::Duration) {
  slot.use = in.getUse();
  return suture::Errc{};
}

void encodeArmServoJr(const ArmServoJrArguments& slot, wire::Arm::ServoJrParams::Builder out) {
  toWire(slot.step, out.initStep());
}
suture::Errc decodeArmServoJr(wire::Arm::ServoJrParams::Reader in, ArmServoJrArguments& slot,
                              suture::Duration shift) {
  return in.hasStep() ? fromWire(in.getStep(), slot.step, shift) : suture::Errc::Invalid;
}

void encodeArmServoJv(const ArmServoJvArguments& slot, wire::Arm::ServoJvParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmServoJv(wire::Arm::ServoJvParams::Reader in, ArmServoJvArguments& slot,
                              suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmServoJf(const ArmServoJfArguments& slot, wire::Arm::ServoJfParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmServoJf(wire::Arm::ServoJfParams::Reader in, ArmServoJfArguments& slot,
                              suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmServoCr(const ArmServoCrArguments& slot, wire::Arm::ServoCrParams::Builder out) {
  toWire(slot.step, out.initStep());
}
suture::Errc decodeArmServoCr(wire::Arm::ServoCrParams::Reader in, ArmServoCrArguments& slot,
                              suture::Duration shift) {
  return in.hasStep() ? fromWire(in.getStep(), slot.step, shift) : suture::Errc::Invalid;
}

void encodeArmServoCv(const ArmServoCvArguments& slot, wire::Arm::ServoCvParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmServoCv(wire::Arm::ServoCvParams::Reader in, ArmServoCvArguments& slot,
                              suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmBodyServoCf(const ArmBodyServoCfArguments& slot,
                          wire::Arm::BodyServoCfParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmBodyServoCf(wire::Arm::BodyServoCfParams::Reader in,
                                  ArmBodyServoCfArguments& slot, suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmSpatialServoCf(const ArmSpatialServoCfArguments& slot,
                             wire::Arm::SpatialServoCfParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmSpatialServoCf(wire::Arm::SpatialServoCfParams::Reader in,
                                     ArmSpatialServoCfArguments& slot, suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmInterpolateJp(const ArmInterpolateJpArguments& slot,
                            wire::Arm::InterpolateJpParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmInterpolateJp(wire::Arm::InterpolateJpParams::Reader in,
                                    ArmInterpolateJpArguments& slot, suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmInterpolateJr(const ArmInterpolateJrArguments& slot,
                            wire::Arm::InterpolateJrParams::Builder out) {
  toWire(slot.step, out.initStep());
}
suture::Errc decodeArmInterpolateJr(wire::Arm::InterpolateJrParams::Reader in,
                                    ArmInterpolateJrArguments& slot, suture::Duration shift) {
  return in.hasStep() ? fromWire(in.getStep(), slot.step, shift) : suture::Errc::Invalid;
}

void encodeArmInterpolateCp(const ArmInterpolateCpArguments& slot,
                            wire::Arm::InterpolateCpParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmInterpolateCp(wire::Arm::InterpolateCpParams::Reader in,
                                    ArmInterpolateCpArguments& slot, suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmInterpolateCr(const ArmInterpolateCrArguments& slot,
                            wire::Arm::InterpolateCrParams::Builder out) {
  toWire(slot.step, out.initStep());
}
suture::Errc decodeArmInterpolateCr(wire::Arm::InterpolateCrParams::Reader in,
                                    ArmInterpolateCrArguments& slot, suture::Duration shift) {
  return in.hasStep() ? fromWire(in.getStep(), slot.step, shift) : suture::Errc::Invalid;
}

void encodeArmMoveJr(const ArmMoveJrArguments& slot, wire::Arm::MoveJrParams::Builder out) {
  toWire(slot.step, out.initStep());
}
suture::Errc decodeArmMoveJr(wire::Arm::MoveJrParams::Reader in, ArmMoveJrArguments& slot,
                             suture::Duration shift) {
  return in.hasStep() ? fromWire(in.getStep(), slot.step, shift) : suture::Errc::Invalid;
}

void encodeArmMoveCp(const ArmMoveCpArguments& slot, wire::Arm::MoveCpParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmMoveCp(wire::Arm::MoveCpParams::Reader in, ArmMoveCpArguments& slot,
                             suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmMoveCr(const ArmMoveCrArguments& slot, wire::Arm::MoveCrParams::Builder out) {
  toWire(slot.step, out.initStep());
}
suture::Errc decodeArmMoveCr(wire::Arm::MoveCrParams::Reader in, ArmMoveCrArguments& slot,
                             suture::Duration shift) {
  return in.hasStep() ? fromWire(in.getStep(), slot.step, shift) : suture::Errc::Invalid;
}

void encodeArmTrajectoryJSetRatio(const ArmTrajectoryJSetRatioArguments& slot,
                                  wire::Arm::TrajectoryJSetRatioParams::Builder out) {
  out.setRatio(slot.ratio);
}
suture::Errc decodeArmTrajectoryJSetRatio(wire::Arm::TrajectoryJSetRatioParams::Reader in,
                                          ArmTrajectoryJSetRatioArguments& slot, suture::Duration) {
  slot.ratio = in.getRatio();
  return suture::Errc{};
}

void encodeArmTrajectoryJSetRatioV(const ArmTrajectoryJSetRatioVArguments& slot,
                                   wire::Arm::TrajectoryJSetRatioVParams::Builder out) {
  out.setRatio(slot.ratio);
}
suture::Errc decodeArmTrajectoryJSetRatioV(wire::Arm::TrajectoryJSetRatioVParams::Reader in,
                                           ArmTrajectoryJSetRatioVArguments& slot,
                                           suture::Duration) {
  slot.ratio = in.getRatio();
  return suture::Errc{};
}

void encodeArmTrajectoryJSetRatioA(const ArmTrajectoryJSetRatioAArguments& slot,
                                   wire::Arm::TrajectoryJSetRatioAParams::Builder out) {
  out.setRatio(slot.ratio);
}
suture::Errc decodeArmTrajectoryJSetRatioA(wire::Arm::TrajectoryJSetRatioAParams::Reader in,
                                           ArmTrajectoryJSetRatioAArguments& slot,
                                           suture::Duration) {
  slot.ratio = in.getRatio();
  return suture::Errc{};
}

void encodeArmTrajectoryJRatioResult(const double& slot,
                                     wire::Arm::TrajectoryJRatioResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeArmTrajectoryJRatioResult(wire::Arm::TrajectoryJRatioResults::Reader in,
                                             double& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmTrajectoryJRatioVResult(const double& slot,
                                      wire::Arm::TrajectoryJRatioVResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeArmTrajectoryJRatioVResult(wire::Arm::TrajectoryJRatioVResults::Reader in,
                                              double& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmTrajectoryJRatioAResult(const double& slot,
                                      wire::Arm::TrajectoryJRatioAResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeArmTrajectoryJRatioAResult(wire::Arm::TrajectoryJRatioAResults::Reader in,
                                              double& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmQueryCp(const ArmQueryCpArguments& slot, wire::Arm::QueryCpParams::Builder out) {
  toWire(slot.q, out.initQ());
}
suture::Errc decodeArmQueryCp(wire::Arm::QueryCpParams::Reader in, ArmQueryCpArguments& slot,
                              suture::Duration shift) {
  return in.hasQ() ? fromWire(in.getQ(), slot.q, shift) : suture::Errc::Invalid;
}

void encodeArmQueryCpResult(const PoseStampedSlot& slot, wire::Arm::QueryCpResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmQueryCpResult(wire::Arm::QueryCpResults::Reader in, PoseStampedSlot& slot,
                                    suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmLocalQueryCp(const ArmLocalQueryCpArguments& slot,
                           wire::Arm::LocalQueryCpParams::Builder out) {
  toWire(slot.q, out.initQ());
}
suture::Errc decodeArmLocalQueryCp(wire::Arm::LocalQueryCpParams::Reader in,
                                   ArmLocalQueryCpArguments& slot, suture::Duration shift) {
  return in.hasQ() ? fromWire(in.getQ(), slot.q, shift) : suture::Errc::Invalid;
}

void encodeArmLocalQueryCpResult(const PoseStampedSlot& slot,
                                 wire::Arm::LocalQueryCpResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmLocalQueryCpResult(wire::Arm::LocalQueryCpResults::Reader in,
                                         PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmStatusEvent(const suture::MessageSlot& slot,
                          wire::ArmEvents::StatusParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmStatusEvent(wire::ArmEvents::StatusParams::Reader in,
                                  suture::MessageSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmWarningEvent(const suture::MessageSlot& slot,
                           wire::ArmEvents::WarningParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmWarningEvent(wire::ArmEvents::WarningParams::Reader in,
                                   suture::MessageSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmErrorEvent(const suture::MessageSlot& slot,
                         wire::ArmEvents::ErrorParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmErrorEvent(wire::ArmEvents::ErrorParams::Reader in, suture::MessageSlot& slot,
                                 suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmOperatingStateEvent(const OperatingStateSlot& slot,
                                  wire::ArmEvents::OperatingStateParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmOperatingStateEvent(wire::ArmEvents::OperatingStateParams::Reader in,
                                          OperatingStateSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmGoalReachedEvent(const std::uint8_t& slot,
                               wire::ArmEvents::GoalReachedParams::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeArmGoalReachedEvent(wire::ArmEvents::GoalReachedParams::Reader in,
                                       std::uint8_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmDesiredStateEvent(const std::uint8_t& slot,
                                wire::ArmEvents::DesiredStateParams::Builder out) {
  out.setValue(wireArmState(slot));
}
suture::Errc decodeArmDesiredStateEvent(wire::ArmEvents::DesiredStateParams::Reader in,
                                        std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeArmGravityCompensationEvent(const std::uint8_t& slot,
                                       wire::ArmEvents::GravityCompensationParams::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeArmGravityCompensationEvent(
    wire::ArmEvents::GravityCompensationParams::Reader in, std::uint8_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmTrajectoryJRatioEvent(const double& slot,
                                    wire::ArmEvents::TrajectoryJRatioParams::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeArmTrajectoryJRatioEvent(wire::ArmEvents::TrajectoryJRatioParams::Reader in,
                                            double& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmTrajectoryJRatioVEvent(const double& slot,
                                     wire::ArmEvents::TrajectoryJRatioVParams::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeArmTrajectoryJRatioVEvent(wire::ArmEvents::TrajectoryJRatioVParams::Reader in,
                                             double& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmTrajectoryJRatioAEvent(const double& slot,
                                     wire::ArmEvents::TrajectoryJRatioAParams::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeArmTrajectoryJRatioAEvent(wire::ArmEvents::TrajectoryJRatioAParams::Reader in,
                                             double& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmMeasuredJsColumn(const JointStateSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initMeasuredJs());
}
suture::Errc decodeArmMeasuredJsColumn(wire::ArmStateRow::Reader in, JointStateSlot& slot,
                                       suture::Duration shift) {
  return in.hasMeasuredJs() ? fromWire(in.getMeasuredJs(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmSetpointJsColumn(const JointStateSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initSetpointJs());
}
suture::Errc decodeArmSetpointJsColumn(wire::ArmStateRow::Reader in, JointStateSlot& slot,
                                       suture::Duration shift) {
  return in.hasSetpointJs() ? fromWire(in.getSetpointJs(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmMeasuredCpColumn(const PoseStampedSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initMeasuredCp());
}
suture::Errc decodeArmMeasuredCpColumn(wire::ArmStateRow::Reader in, PoseStampedSlot& slot,
                                       suture::Duration shift) {
  return in.hasMeasuredCp() ? fromWire(in.getMeasuredCp(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmSetpointCpColumn(const PoseStampedSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initSetpointCp());
}
suture::Errc decodeArmSetpointCpColumn(wire::ArmStateRow::Reader in, PoseStampedSlot& slot,
                                       suture::Duration shift) {
  return in.hasSetpointCp() ? fromWire(in.getSetpointCp(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmOperatingStateColumn(const OperatingStateSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initOperatingState());
}
suture::Errc decodeArmOperatingStateColumn(wire::ArmStateRow::Reader in, OperatingStateSlot& slot,
                                           suture::Duration shift) {
  return in.hasOperatingState() ? fromWire(in.getOperatingState(), slot, shift)
      : suture::Errc::Invalid;
}

void encodeArmConfigurationJsColumn(const JointConfigurationSlot& slot,
                                    wire::ArmStateRow::Builder out) {
  toWire(slot, out.initConfigurationJs());
}
suture::Errc decodeArmConfigurationJsColumn(wire::ArmStateRow::Reader in,
                                            JointConfigurationSlot& slot, suture::Duration shift) {
  return in.hasConfigurationJs() ? fromWire(in.getConfigurationJs(), slot, shift)
      : suture::Errc::Invalid;
}

void encodeArmPeriodStatisticsColumn(const IntervalStatisticsSlot& slot,
                                     wire::ArmStateRow::Builder out) {
  toWire(slot, out.initPeriodStatistics());
}
suture::Errc decodeArmPeriodStatisticsColumn(wire::ArmStateRow::Reader in,
                                             IntervalStatisticsSlot& slot, suture::Duration shift) {
  return in.hasPeriodStatistics() ? fromWire(in.getPeriodStatistics(), slot, shift)
      : suture::Errc::Invalid;
}

void encodeArmGoalJsColumn(const JointStateSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initGoalJs());
}
suture::Errc decodeArmGoalJsColumn(wire::ArmStateRow::Reader in, JointStateSlot& slot,
                                   suture::Duration shift) {
  return in.hasGoalJs() ? fromWire(in.getGoalJs(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmGoalCpColumn(const PoseStampedSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initGoalCp());
}
suture::Errc decodeArmGoalCpColumn(wire::ArmStateRow::Reader in, PoseStampedSlot& slot,
                                   suture::Duration shift) {
  return in.hasGoalCp() ? fromWire(in.getGoalCp(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmLocalMeasuredCpColumn(const PoseStampedSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initLocalMeasuredCp());
}
suture::Errc decodeArmLocalMeasuredCpColumn(wire::ArmStateRow::Reader in, PoseStampedSlot& slot,
                                            suture::Duration shift) {
  return in.hasLocalMeasuredCp() ? fromWire(in.getLocalMeasuredCp(), slot, shift)
      : suture::Errc::Invalid;
}

void encodeArmLocalSetpointCpColumn(const PoseStampedSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initLocalSetpointCp());
}
suture::Errc decodeArmLocalSetpointCpColumn(wire::ArmStateRow::Reader in, PoseStampedSlot& slot,
                                            suture::Duration shift) {
  return in.hasLocalSetpointCp() ? fromWire(in.getLocalSetpointCp(), slot, shift)
      : suture::Errc::Invalid;
}

void encodeArmMeasuredCvColumn(const TwistSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initMeasuredCv());
}
suture::Errc decodeArmMeasuredCvColumn(wire::ArmStateRow::Reader in, TwistSlot& slot,
                                       suture::Duration shift) {
  return in.hasMeasuredCv() ? fromWire(in.getMeasuredCv(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmSetpointCvColumn(const TwistSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initSetpointCv());
}
suture::Errc decodeArmSetpointCvColumn(wire::ArmStateRow::Reader in, TwistSlot& slot,
                                       suture::Duration shift) {
  return in.hasSetpointCv() ? fromWire(in.getSetpointCv(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmBodyMeasuredCfColumn(const WrenchSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initBodyMeasuredCf());
}
suture::Errc decodeArmBodyMeasuredCfColumn(wire::ArmStateRow::Reader in, WrenchSlot& slot,
                                           suture::Duration shift) {
  return in.hasBodyMeasuredCf() ? fromWire(in.getBodyMeasuredCf(), slot, shift)
      : suture::Errc::Invalid;
}

void encodeArmSpatialMeasuredCfColumn(const WrenchSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initSpatialMeasuredCf());
}
suture::Errc decodeArmSpatialMeasuredCfColumn(wire::ArmStateRow::Reader in, WrenchSlot& slot,
                                              suture::Duration shift) {
  return in.hasSpatialMeasuredCf() ? fromWire(in.getSpatialMeasuredCf(), slot, shift)
      : suture::Errc::Invalid;
}

void encodeArmMeasuredCsColumn(const CartesianStateSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initMeasuredCs());
}
suture::Errc decodeArmMeasuredCsColumn(wire::ArmStateRow::Reader in, CartesianStateSlot& slot,
                                       suture::Duration shift) {
  return in.hasMeasuredCs() ? fromWire(in.getMeasuredCs(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmBodyJacobianColumn(const JacobianSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initBodyJacobian());
}
suture::Errc decodeArmBodyJacobianColumn(wire::ArmStateRow::Reader in, JacobianSlot& slot,
                                         suture::Duration shift) {
  return in.hasBodyJacobian() ? fromWire(in.getBodyJacobian(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmSpatialJacobianColumn(const JacobianSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initSpatialJacobian());
}
suture::Errc decodeArmSpatialJacobianColumn(wire::ArmStateRow::Reader in, JacobianSlot& slot,
                                            suture::Duration shift) {
  return in.hasSpatialJacobian() ? fromWire(in.getSpatialJacobian(), slot, shift)
      : suture::Errc::Invalid;
}

void encodeArmBaseFrameColumn(const TransformStampedSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initBaseFrame());
}
suture::Errc decodeArmBaseFrameColumn(wire::ArmStateRow::Reader in, TransformStampedSlot& slot,
                                      suture::Duration shift) {
  return in.hasBaseFrame() ? fromWire(in.getBaseFrame(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmTrajectoryJRatioColumn(const double& slot, wire::ArmStateRow::Builder out) {
  out.setTrajectoryJRatio(slot);
}
suture::Errc decodeArmTrajectoryJRatioColumn(wire::ArmStateRow::Reader in, double& slot,
                                             suture::Duration) {
  slot = in.getTrajectoryJRatio();
  return suture::Errc{};
}

void encodeArmTrajectoryJRatioVColumn(const double& slot, wire::ArmStateRow::Builder out) {
  out.setTrajectoryJRatioV(slot);
}
suture::Errc decodeArmTrajectoryJRatioVColumn(wire::ArmStateRow::Reader in, double& slot,
                                              suture::Duration) {
  slot = in.getTrajectoryJRatioV();
  return suture::Errc{};
}

void encodeArmTrajectoryJRatioAColumn(const double& slot, wire::ArmStateRow::Builder out) {
  out.setTrajectoryJRatioA(slot);
}
suture::Errc decodeArmTrajectoryJRatioAColumn(wire::ArmStateRow::Reader in, double& slot,
                                              suture::Duration) {
  slot = in.getTrajectoryJRatioA();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeArmColumn(unsigned column, const std::byte* memory, wire::ArmStateRow::Builder out) {
  switch (column) {
    case ArmColumn::measured_js:
      return encodeArmMeasuredJsColumn(suture::slotIn<JointStateSlot>(memory), out);
    case ArmColumn::setpoint_js:
      return encodeArmSetpointJsColumn(suture::slotIn<JointStateSlot>(memory), out);
    case ArmColumn::measured_cp:
      return encodeArmMeasuredCpColumn(suture::slotIn<PoseStampedSlot>(memory), out);
    case ArmColumn::setpoint_cp:
      return encodeArmSetpointCpColumn(suture::slotIn<PoseStampedSlot>(memory), out);
    case ArmColumn::operating_state:
      return encodeArmOperatingStateColumn(suture::slotIn<OperatingStateSlot>(memory), out);
    case ArmColumn::configuration_js:
      return encodeArmConfigurationJsColumn(suture::slotIn<JointConfigurationSlot>(memory), out);
    case ArmColumn::period_statistics:
      return encodeArmPeriodStatisticsColumn(suture::slotIn<IntervalStatisticsSlot>(memory), out);
    case ArmColumn::goal_js:
      return encodeArmGoalJsColumn(suture::slotIn<JointStateSlot>(memory), out);
    case ArmColumn::goal_cp:
      return encodeArmGoalCpColumn(suture::slotIn<PoseStampedSlot>(memory), out);
    case ArmColumn::local_measured_cp:
      return encodeArmLocalMeasuredCpColumn(suture::slotIn<PoseStampedSlot>(memory), out);
    case ArmColumn::local_setpoint_cp:
      return encodeArmLocalSetpointCpColumn(suture::slotIn<PoseStampedSlot>(memory), out);
    case ArmColumn::measured_cv:
      return encodeArmMeasuredCvColumn(suture::slotIn<TwistSlot>(memory), out);
    case ArmColumn::setpoint_cv:
      return encodeArmSetpointCvColumn(suture::slotIn<TwistSlot>(memory), out);
    case ArmColumn::body_measured_cf:
      return encodeArmBodyMeasuredCfColumn(suture::slotIn<WrenchSlot>(memory), out);
    case ArmColumn::spatial_measured_cf:
      return encodeArmSpatialMeasuredCfColumn(suture::slotIn<WrenchSlot>(memory), out);
    case ArmColumn::measured_cs:
      return encodeArmMeasuredCsColumn(suture::slotIn<CartesianStateSlot>(memory), out);
    case ArmColumn::body_jacobian:
      return encodeArmBodyJacobianColumn(suture::slotIn<JacobianSlot>(memory), out);
    case ArmColumn::spatial_jacobian:
      return encodeArmSpatialJacobianColumn(suture::slotIn<JacobianSlot>(memory), out);
    case ArmColumn::base_frame:
      return encodeArmBaseFrameColumn(suture::slotIn<TransformStampedSlot>(memory), out);
    case ArmColumn::trajectory_j_ratio:
      return encodeArmTrajectoryJRatioColumn(suture::slotIn<double>(memory), out);
    case ArmColumn::trajectory_j_ratio_v:
      return encodeArmTrajectoryJRatioVColumn(suture::slotIn<double>(memory), out);
    case ArmColumn::trajectory_j_ratio_a:
      return encodeArmTrajectoryJRatioAColumn(suture::slotIn<double>(memory), out);
  }
}
suture::Errc decodeArmColumn(wire::ArmStateRow::Reader in, unsigned column, std::byte* memory,
                             suture::Duration shift) {
  switch (column) {
    case ArmColumn::measured_js:
      return decodeArmMeasuredJsColumn(in, suture::newSlot<JointStateSlot>(memory), shift);
    case ArmColumn::setpoint_js:
      return decodeArmSetpointJsColumn(in, suture::newSlot<JointStateSlot>(memory), shift);
    case ArmColumn::measured_cp:
      return decodeArmMeasuredCpColumn(in, suture::newSlot<PoseStampedSlot>(memory), shift);
    case ArmColumn::setpoint_cp:
      return decodeArmSetpointCpColumn(in, suture::newSlot<PoseStampedSlot>(memory), shift);
    case ArmColumn::operating_state:
      return decodeArmOperatingStateColumn(in, suture::newSlot<OperatingStateSlot>(memory), shift);
    case ArmColumn::configuration_js:
      return decodeArmConfigurationJsColumn(in, suture::newSlot<JointConfigurationSlot>(memory),
                                            shift);
    case ArmColumn::period_statistics:
      return decodeArmPeriodStatisticsColumn(in, suture::newSlot<IntervalStatisticsSlot>(memory),
                                             shift);
    case ArmColumn::goal_js:
      return decodeArmGoalJsColumn(in, suture::newSlot<JointStateSlot>(memory), shift);
    case ArmColumn::goal_cp:
      return decodeArmGoalCpColumn(in, suture::newSlot<PoseStampedSlot>(memory), shift);
    case ArmColumn::local_measured_cp:
      return decodeArmLocalMeasuredCpColumn(in, suture::newSlot<PoseStampedSlot>(memory), shift);
    case ArmColumn::local_setpoint_cp:
      return decodeArmLocalSetpointCpColumn(in, suture::newSlot<PoseStampedSlot>(memory), shift);
    case ArmColumn::measured_cv:
      return decodeArmMeasuredCvColumn(in, suture::newSlot<TwistSlot>(memory), shift);
    case ArmColumn::setpoint_cv:
      return decodeArmSetpointCvColumn(in, suture::newSlot<TwistSlot>(memory), shift);
    case ArmColumn::body_measured_cf:
      return decodeArmBodyMeasuredCfColumn(in, suture::newSlot<WrenchSlot>(memory), shift);
    case ArmColumn::spatial_measured_cf:
      return decodeArmSpatialMeasuredCfColumn(in, suture::newSlot<WrenchSlot>(memory), shift);
    case ArmColumn::measured_cs:
      return decodeArmMeasuredCsColumn(in, suture::newSlot<CartesianStateSlot>(memory), shift);
    case ArmColumn::body_jacobian:
      return decodeArmBodyJacobianColumn(in, suture::newSlot<JacobianSlot>(memory), shift);
    case ArmColumn::spatial_jacobian:
      return decodeArmSpatialJacobianColumn(in, suture::newSlot<JacobianSlot>(memory), shift);
    case ArmColumn::base_frame:
      return decodeArmBaseFrameColumn(in, suture::newSlot<TransformStampedSlot>(memory), shift);
    case ArmColumn::trajectory_j_ratio:
      return decodeArmTrajectoryJRatioColumn(in, suture::newSlot<double>(memory), shift);
    case ArmColumn::trajectory_j_ratio_v:
      return decodeArmTrajectoryJRatioVColumn(in, suture::newSlot<double>(memory), shift);
    case ArmColumn::trajectory_j_ratio_a:
      return decodeArmTrajectoryJRatioAColumn(in, suture::newSlot<double>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kArmCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Arm::EnableParams>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Arm::DisableParams>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Arm::HomeParams>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Arm::HoldParams>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 5,
     .sent = suture::codec::sentIn<wire::Arm::ServoCpParams>,
     .arguments = suture::codec::messageOf<wire::Arm::ServoCpParams, ArmServoCpArguments,
                                           encodeArmServoCp, decodeArmServoCp>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 6,
     .sent = suture::codec::sentIn<wire::Arm::ServoJpParams>,
     .arguments = suture::codec::messageOf<wire::Arm::ServoJpParams, ArmServoJpArguments,
                                           encodeArmServoJp, decodeArmServoJp>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 7,
     .sent = suture::codec::sentIn<wire::Arm::MoveJpParams>,
     .arguments = suture::codec::messageOf<wire::Arm::MoveJpParams, ArmMoveJpArguments,
                                           encodeArmMoveJp, decodeArmMoveJp>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 8,
     .sent = suture::codec::sentIn<wire::Arm::MeasuredJsParams>,
     .result = suture::codec::messageOf<wire::Arm::MeasuredJsResults, JointStateSlot,
                                        encodeArmMeasuredJsResult, decodeArmMeasuredJsResult>,
     .stamp = suture::codec::stampIn<wire::Arm::MeasuredJsResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 9,
     .sent = suture::codec::sentIn<wire::Arm::SetpointJsParams>,
     .result = suture::codec::messageOf<wire::Arm::SetpointJsResults, JointStateSlot,
                                        encodeArmSetpointJsResult, decodeArmSetpointJsResult>,
     .stamp = suture::codec::stampIn<wire::Arm::SetpointJsResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 10,
     .sent = suture::codec::sentIn<wire::Arm::MeasuredCpParams>,
     .result = suture::codec::messageOf<wire::Arm::MeasuredCpResults, PoseStampedSlot,
                                        encodeArmMeasuredCpResult, decodeArmMeasuredCpResult>,
     .stamp = suture::codec::stampIn<wire::Arm::MeasuredCpResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 11,
     .sent = suture::codec::sentIn<wire::Arm::SetpointCpParams>,
     .result = suture::codec::messageOf<wire::Arm::SetpointCpResults, PoseStampedSlot,
                                        encodeArmSetpointCpResult, decodeArmSetpointCpResult>,
     .stamp = suture::codec::stampIn<wire::Arm::SetpointCpResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 12,
     .sent = suture::codec::sentIn<wire::Arm::OperatingStateParams>,
     .result = suture::codec::messageOf<wire::Arm::OperatingStateResults, OperatingStateSlot,
                                        encodeArmOperatingStateResult,
                                        decodeArmOperatingStateResult>,
     .stamp = suture::codec::stampIn<wire::Arm::OperatingStateResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 13,
     .sent = suture::codec::sentIn<wire::Arm::ForwardKinematicsParams>,
     .arguments = suture::codec::messageOf<wire::Arm::ForwardKinematicsParams,
                                           ArmForwardKinematicsArguments,
                                           encodeArmForwardKinematics, decodeArmForwardKinematics>,
     .result = suture::codec::messageOf<wire::Arm::ForwardKinematicsResults, PoseStampedSlot,
                                        encodeArmForwardKinematicsResult,
                                        decodeArmForwardKinematicsResult>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 14,
     .sent = suture::codec::sentIn<wire::Arm::InverseKinematicsParams>,
     .arguments = suture::codec::messageOf<wire::Arm::InverseKinematicsParams,
                                           ArmInverseKinematicsArguments,
                                           encodeArmInverseKinematics, decodeArmInverseKinematics>,
     .result = suture::codec::messageOf<wire::Arm::InverseKinematicsResults, JointSolutionSlot,
                                        encodeArmInverseKinematicsResult,
                                        decodeArmInverseKinematicsResult>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 15,
     .sent = suture::codec::sentIn<wire::Arm::ConfigurationJsParams>,
     .result = suture::codec::messageOf<wire::Arm::ConfigurationJsResults, JointConfigurationSlot,
                                        encodeArmConfigurationJsResult,
                                        decodeArmConfigurationJsResult>,
     .stamp = suture::codec::stampIn<wire::Arm::ConfigurationJsResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 16,
     .sent = suture::codec::sentIn<wire::Arm::PeriodStatisticsParams>,
     .result = suture::codec::messageOf<wire::Arm::PeriodStatisticsResults, IntervalStatisticsSlot,
                                        encodeArmPeriodStatisticsResult,
                                        decodeArmPeriodStatisticsResult>,
     .stamp = suture::codec::stampIn<wire::Arm::PeriodStatisticsResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 17,
     .sent = suture::codec::sentIn<wire::Arm::PauseParams>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 18,
     .sent = suture::codec::sentIn<wire::Arm::ResumeParams>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 19,
     .sent = suture::codec::sentIn<wire::Arm::UnhomeParams>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 20,
     .sent = suture::codec::sentIn<wire::Arm::StateCommandParams>,
     .arguments = suture::codec::messageOf<wire::Arm::StateCommandParams, ArmStateCommandArguments,
                                           encodeArmStateCommand, decodeArmStateCommand>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 21,
     .sent = suture::codec::sentIn<wire::Arm::GoalJsParams>,
     .result = suture::codec::messageOf<wire::Arm::GoalJsResults, JointStateSlot,
                                        encodeArmGoalJsResult, decodeArmGoalJsResult>,
     .stamp = suture::codec::stampIn<wire::Arm::GoalJsResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 22,
     .sent = suture::codec::sentIn<wire::Arm::GoalCpParams>,
     .result = suture::codec::messageOf<wire::Arm::GoalCpResults, PoseStampedSlot,
                                        encodeArmGoalCpResult, decodeArmGoalCpResult>,
     .stamp = suture::codec::stampIn<wire::Arm::GoalCpResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 23,
     .sent = suture::codec::sentIn<wire::Arm::LocalMeasuredCpParams>,
     .result = suture::codec::messageOf<wire::Arm::LocalMeasuredCpResults, PoseStampedSlot,
                                        encodeArmLocalMeasuredCpResult,
                                        decodeArmLocalMeasuredCpResult>,
     .stamp = suture::codec::stampIn<wire::Arm::LocalMeasuredCpResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 24,
     .sent = suture::codec::sentIn<wire::Arm::LocalSetpointCpParams>,
     .result = suture::codec::messageOf<wire::Arm::LocalSetpointCpResults, PoseStampedSlot,
                                        encodeArmLocalSetpointCpResult,
                                        decodeArmLocalSetpointCpResult>,
     .stamp = suture::codec::stampIn<wire::Arm::LocalSetpointCpResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 25,
     .sent = suture::codec::sentIn<wire::Arm::MeasuredCvParams>,
     .result = suture::codec::messageOf<wire::Arm::MeasuredCvResults, TwistSlot,
                                        encodeArmMeasuredCvResult, decodeArmMeasuredCvResult>,
     .stamp = suture::codec::stampIn<wire::Arm::MeasuredCvResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 26,
     .sent = suture::codec::sentIn<wire::Arm::SetpointCvParams>,
     .result = suture::codec::messageOf<wire::Arm::SetpointCvResults, TwistSlot,
                                        encodeArmSetpointCvResult, decodeArmSetpointCvResult>,
     .stamp = suture::codec::stampIn<wire::Arm::SetpointCvResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 27,
     .sent = suture::codec::sentIn<wire::Arm::BodyMeasuredCfParams>,
     .result = suture::codec::messageOf<wire::Arm::BodyMeasuredCfResults, WrenchSlot,
                                        encodeArmBodyMeasuredCfResult,
                                        decodeArmBodyMeasuredCfResult>,
     .stamp = suture::codec::stampIn<wire::Arm::BodyMeasuredCfResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 28,
     .sent = suture::codec::sentIn<wire::Arm::SpatialMeasuredCfParams>,
     .result = suture::codec::messageOf<wire::Arm::SpatialMeasuredCfResults, WrenchSlot,
                                        encodeArmSpatialMeasuredCfResult,
                                        decodeArmSpatialMeasuredCfResult>,
     .stamp = suture::codec::stampIn<wire::Arm::SpatialMeasuredCfResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 29,
     .sent = suture::codec::sentIn<wire::Arm::MeasuredCsParams>,
     .result = suture::codec::messageOf<wire::Arm::MeasuredCsResults, CartesianStateSlot,
                                        encodeArmMeasuredCsResult, decodeArmMeasuredCsResult>,
     .stamp = suture::codec::stampIn<wire::Arm::MeasuredCsResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 30,
     .sent = suture::codec::sentIn<wire::Arm::BodyJacobianParams>,
     .result = suture::codec::messageOf<wire::Arm::BodyJacobianResults, JacobianSlot,
                                        encodeArmBodyJacobianResult, decodeArmBodyJacobianResult>,
     .stamp = suture::codec::stampIn<wire::Arm::BodyJacobianResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 31,
     .sent = suture::codec::sentIn<wire::Arm::SpatialJacobianParams>,
     .result = suture::codec::messageOf<wire::Arm::SpatialJacobianResults, JacobianSlot,
                                        encodeArmSpatialJacobianResult,
                                        decodeArmSpatialJacobianResult>,
     .stamp = suture::codec::stampIn<wire::Arm::SpatialJacobianResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 32,
     .sent = suture::codec::sentIn<wire::Arm::BaseFrameParams>,
     .result = suture::codec::messageOf<wire::Arm::BaseFrameResults, TransformStampedSlot,
                                        encodeArmBaseFrameResult, decodeArmBaseFrameResult>,
     .stamp = suture::codec::stampIn<wire::Arm::BaseFrameResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 33,
     .sent = suture::codec::sentIn<wire::Arm::SetBaseFrameParams>,
     .arguments = suture::codec::messageOf<wire::Arm::SetBaseFrameParams, ArmSetBaseFrameArguments,
                                           encodeArmSetBaseFrame, decodeArmSetBaseFrame>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 34,
     .sent = suture::codec::sentIn<wire::Arm::FreeParams>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 35,
     .sent = suture::codec::sentIn<wire::Arm::UseGravityCompensationParams>,
     .arguments = suture::codec::messageOf<wire::Arm::UseGravityCompensationParams,
                                           ArmUseGravityCompensationArguments,
                                           encodeArmUseGravityCompensation,
                                           decodeArmUseGravityCompensation>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 36,
     .sent = suture::codec::sentIn<wire::Arm::ServoJrParams>,
     .arguments = suture::codec::messageOf<wire::Arm::ServoJrParams, ArmServoJrArguments,
                                           encodeArmServoJr, decodeArmServoJr>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 37,
     .sent = suture::codec::sentIn<wire::Arm::ServoJvParams>,
     .arguments = suture::codec::messageOf<wire::Arm::ServoJvParams, ArmServoJvArguments,
                                           encodeArmServoJv, decodeArmServoJv>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 38,
     .sent = suture::codec::sentIn<wire::Arm::ServoJfParams>,
     .arguments = suture::codec::messageOf<wire::Arm::ServoJfParams, ArmServoJfArguments,
                                           encodeArmServoJf, decodeArmServoJf>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 39,
     .sent = suture::codec::sentIn<wire::Arm::ServoCrParams>,
     .arguments = suture::codec::messageOf<wire::Arm::ServoCrParams, ArmServoCrArguments,
                                           encodeArmServoCr, decodeArmServoCr>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 40,
     .sent = suture::codec::sentIn<wire::Arm::ServoCvParams>,
     .arguments = suture::codec::messageOf<wire::Arm::ServoCvParams, ArmServoCvArguments,
                                           encodeArmServoCv, decodeArmServoCv>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 41,
     .sent = suture::codec::sentIn<wire::Arm::BodyServoCfParams>,
     .arguments = suture::codec::messageOf<wire::Arm::BodyServoCfParams, ArmBodyServoCfArguments,
                                           encodeArmBodyServoCf, decodeArmBodyServoCf>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 42,
     .sent = suture::codec::sentIn<wire::Arm::SpatialServoCfParams>,
     .arguments = suture::codec::messageOf<wire::Arm::SpatialServoCfParams,
                                           ArmSpatialServoCfArguments, encodeArmSpatialServoCf,
                                           decodeArmSpatialServoCf>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 43,
     .sent = suture::codec::sentIn<wire::Arm::InterpolateJpParams>,
     .arguments = suture::codec::messageOf<wire::Arm::InterpolateJpParams,
                                           ArmInterpolateJpArguments, encodeArmInterpolateJp,
                                           decodeArmInterpolateJp>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 44,
     .sent = suture::codec::sentIn<wire::Arm::InterpolateJrParams>,
     .arguments = suture::codec::messageOf<wire::Arm::InterpolateJrParams,
                                           ArmInterpolateJrArguments, encodeArmInterpolateJr,
                                           decodeArmInterpolateJr>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 45,
     .sent = suture::codec::sentIn<wire::Arm::InterpolateCpParams>,
     .arguments = suture::codec::messageOf<wire::Arm::InterpolateCpParams,
                                           ArmInterpolateCpArguments, encodeArmInterpolateCp,
                                           decodeArmInterpolateCp>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 46,
     .sent = suture::codec::sentIn<wire::Arm::InterpolateCrParams>,
     .arguments = suture::codec::messageOf<wire::Arm::InterpolateCrParams,
                                           ArmInterpolateCrArguments, encodeArmInterpolateCr,
                                           decodeArmInterpolateCr>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 47,
     .sent = suture::codec::sentIn<wire::Arm::MoveJrParams>,
     .arguments = suture::codec::messageOf<wire::Arm::MoveJrParams, ArmMoveJrArguments,
                                           encodeArmMoveJr, decodeArmMoveJr>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 48,
     .sent = suture::codec::sentIn<wire::Arm::MoveCpParams>,
     .arguments = suture::codec::messageOf<wire::Arm::MoveCpParams, ArmMoveCpArguments,
                                           encodeArmMoveCp, decodeArmMoveCp>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 49,
     .sent = suture::codec::sentIn<wire::Arm::MoveCrParams>,
     .arguments = suture::codec::messageOf<wire::Arm::MoveCrParams, ArmMoveCrArguments,
                                           encodeArmMoveCr, decodeArmMoveCr>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 50,
     .sent = suture::codec::sentIn<wire::Arm::TrajectoryJSetRatioParams>,
     .arguments = suture::codec::messageOf<wire::Arm::TrajectoryJSetRatioParams,
                                           ArmTrajectoryJSetRatioArguments,
                                           encodeArmTrajectoryJSetRatio,
                                           decodeArmTrajectoryJSetRatio>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 51,
     .sent = suture::codec::sentIn<wire::Arm::TrajectoryJSetRatioVParams>,
     .arguments = suture::codec::messageOf<wire::Arm::TrajectoryJSetRatioVParams,
                                           ArmTrajectoryJSetRatioVArguments,
                                           encodeArmTrajectoryJSetRatioV,
                                           decodeArmTrajectoryJSetRatioV>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 52,
     .sent = suture::codec::sentIn<wire::Arm::TrajectoryJSetRatioAParams>,
     .arguments = suture::codec::messageOf<wire::Arm::TrajectoryJSetRatioAParams,
                                           ArmTrajectoryJSetRatioAArguments,
                                           encodeArmTrajectoryJSetRatioA,
                                           decodeArmTrajectoryJSetRatioA>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 53,
     .sent = suture::codec::sentIn<wire::Arm::TrajectoryJRatioParams>,
     .result = suture::codec::messageOf<wire::Arm::TrajectoryJRatioResults, double,
                                        encodeArmTrajectoryJRatioResult,
                                        decodeArmTrajectoryJRatioResult>,
     .stamp = suture::codec::stampIn<wire::Arm::TrajectoryJRatioResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 54,
     .sent = suture::codec::sentIn<wire::Arm::TrajectoryJRatioVParams>,
     .result = suture::codec::messageOf<wire::Arm::TrajectoryJRatioVResults, double,
                                        encodeArmTrajectoryJRatioVResult,
                                        decodeArmTrajectoryJRatioVResult>,
     .stamp = suture::codec::stampIn<wire::Arm::TrajectoryJRatioVResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 55,
     .sent = suture::codec::sentIn<wire::Arm::TrajectoryJRatioAParams>,
     .result = suture::codec::messageOf<wire::Arm::TrajectoryJRatioAResults, double,
                                        encodeArmTrajectoryJRatioAResult,
                                        decodeArmTrajectoryJRatioAResult>,
     .stamp = suture::codec::stampIn<wire::Arm::TrajectoryJRatioAResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 56,
     .sent = suture::codec::sentIn<wire::Arm::QueryCpParams>,
     .arguments = suture::codec::messageOf<wire::Arm::QueryCpParams, ArmQueryCpArguments,
                                           encodeArmQueryCp, decodeArmQueryCp>,
     .result = suture::codec::messageOf<wire::Arm::QueryCpResults, PoseStampedSlot,
                                        encodeArmQueryCpResult, decodeArmQueryCpResult>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 57,
     .sent = suture::codec::sentIn<wire::Arm::LocalQueryCpParams>,
     .arguments = suture::codec::messageOf<wire::Arm::LocalQueryCpParams, ArmLocalQueryCpArguments,
                                           encodeArmLocalQueryCp, decodeArmLocalQueryCp>,
     .result = suture::codec::messageOf<wire::Arm::LocalQueryCpResults, PoseStampedSlot,
                                        encodeArmLocalQueryCpResult, decodeArmLocalQueryCpResult>},
};

constexpr suture::codec::EventCodec kArmEventCodecs[] = {
    {.method = 4,
     .stamp = suture::codec::stampIn<wire::ArmEvents::StatusParams>,
     .payload = suture::codec::messageOf<wire::ArmEvents::StatusParams, suture::MessageSlot,
                                         encodeArmStatusEvent, decodeArmStatusEvent>},
    {.method = 3,
     .stamp = suture::codec::stampIn<wire::ArmEvents::WarningParams>,
     .payload = suture::codec::messageOf<wire::ArmEvents::WarningParams, suture::MessageSlot,
                                         encodeArmWarningEvent, decodeArmWarningEvent>},
    {.method = 5,
     .stamp = suture::codec::stampIn<wire::ArmEvents::ErrorParams>,
     .payload = suture::codec::messageOf<wire::ArmEvents::ErrorParams, suture::MessageSlot,
                                         encodeArmErrorEvent, decodeArmErrorEvent>},
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::ArmEvents::OperatingStateParams>,
     .payload = suture::codec::messageOf<wire::ArmEvents::OperatingStateParams, OperatingStateSlot,
                                         encodeArmOperatingStateEvent,
                                         decodeArmOperatingStateEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::ArmEvents::GoalReachedParams>,
     .payload = suture::codec::messageOf<wire::ArmEvents::GoalReachedParams, std::uint8_t,
                                         encodeArmGoalReachedEvent, decodeArmGoalReachedEvent>},
    {.method = 6,
     .stamp = suture::codec::stampIn<wire::ArmEvents::DesiredStateParams>,
     .payload = suture::codec::messageOf<wire::ArmEvents::DesiredStateParams, std::uint8_t,
                                         encodeArmDesiredStateEvent, decodeArmDesiredStateEvent>},
    {.method = 7,
     .stamp = suture::codec::stampIn<wire::ArmEvents::GravityCompensationParams>,
     .payload = suture::codec::messageOf<wire::ArmEvents::GravityCompensationParams, std::uint8_t,
                                         encodeArmGravityCompensationEvent,
                                         decodeArmGravityCompensationEvent>},
    {.method = 8,
     .stamp = suture::codec::stampIn<wire::ArmEvents::TrajectoryJRatioParams>,
     .payload = suture::codec::messageOf<wire::ArmEvents::TrajectoryJRatioParams, double,
                                         encodeArmTrajectoryJRatioEvent,
                                         decodeArmTrajectoryJRatioEvent>},
    {.method = 9,
     .stamp = suture::codec::stampIn<wire::ArmEvents::TrajectoryJRatioVParams>,
     .payload = suture::codec::messageOf<wire::ArmEvents::TrajectoryJRatioVParams, double,
                                         encodeArmTrajectoryJRatioVEvent,
                                         decodeArmTrajectoryJRatioVEvent>},
    {.method = 10,
     .stamp = suture::codec::stampIn<wire::ArmEvents::TrajectoryJRatioAParams>,
     .payload = suture::codec::messageOf<wire::ArmEvents::TrajectoryJRatioAParams, double,
                                         encodeArmTrajectoryJRatioAEvent,
                                         decodeArmTrajectoryJRatioAEvent>},
};

}  // namespace

const suture::codec::Codec& armCodec() {
  static const suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Arm>,
      .contract = capnp::typeId<wire::Arm>(),
      .subscriber = capnp::typeId<wire::ArmEvents>(),
      .commands = kArmCommandCodecs,
      .events = kArmEventCodecs,
      .row = suture::codec::rowOf<wire::ArmEvents::StateParams, wire::ArmStateRow, encodeArmColumn,
                                  decodeArmColumn>,
  };
  return kCodec;
}

}  // namespace robots
