// Written by suturec from arm/arm.h. Do not edit.
#include "arm/arm.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const PoseStamped& goal, ArmServoCpArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(ArmServoCpArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const JointGoal& goal, ArmServoJpArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(ArmServoJpArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const JointGoal& goal, ArmMoveJpArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(ArmMoveJpArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const JointGoal& q, ArmForwardKinematicsArguments& slot) { return store(q, slot.q); }

void shiftStamps(ArmForwardKinematicsArguments& slot, suture::Duration shift) {
  shiftStamps(slot.q, shift);
}

bool store(const PoseStamped& goal, ArmInverseKinematicsArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmInverseKinematicsArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const std::string& name, ArmStateCommandArguments& slot) {
  return store(name, slot.name);
}

bool store(const TransformStamped& base, ArmSetBaseFrameArguments& slot) {
  return store(base, slot.base);
}

void shiftStamps(ArmSetBaseFrameArguments& slot, suture::Duration shift) {
  shiftStamps(slot.base, shift);
}

bool store(const bool& use, ArmUseGravityCompensationArguments& slot) {
  return store(use, slot.use);
}

bool store(const JointGoal& step, ArmServoJrArguments& slot) { return store(step, slot.step); }

void shiftStamps(ArmServoJrArguments& slot, suture::Duration shift) {
  shiftStamps(slot.step, shift);
}

bool store(const JointVelocityGoal& goal, ArmServoJvArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmServoJvArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const JointEffortGoal& goal, ArmServoJfArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmServoJfArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const PoseStamped& step, ArmServoCrArguments& slot) { return store(step, slot.step); }

void shiftStamps(ArmServoCrArguments& slot, suture::Duration shift) {
  shiftStamps(slot.step, shift);
}

bool store(const TwistGoal& goal, ArmServoCvArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(ArmServoCvArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const WrenchGoal& goal, ArmBodyServoCfArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(ArmBodyServoCfArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const WrenchGoal& goal, ArmSpatialServoCfArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmSpatialServoCfArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const JointGoal& goal, ArmInterpolateJpArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmInterpolateJpArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const JointGoal& step, ArmInterpolateJrArguments& slot) {
  return store(step, slot.step);
}

void shiftStamps(ArmInterpolateJrArguments& slot, suture::Duration shift) {
  shiftStamps(slot.step, shift);
}

bool store(const PoseStamped& goal, ArmInterpolateCpArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmInterpolateCpArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const PoseStamped& step, ArmInterpolateCrArguments& slot) {
  return store(step, slot.step);
}

void shiftStamps(ArmInterpolateCrArguments& slot, suture::Duration shift) {
  shiftStamps(slot.step, shift);
}

bool store(const JointGoal& step, ArmMoveJrArguments& slot) { return store(step, slot.step); }

void shiftStamps(ArmMoveJrArguments& slot, suture::Duration shift) {
  shiftStamps(slot.step, shift);
}

bool store(const PoseStamped& goal, ArmMoveCpArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(ArmMoveCpArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const PoseStamped& step, ArmMoveCrArguments& slot) { return store(step, slot.step); }

void shiftStamps(ArmMoveCrArguments& slot, suture::Duration shift) {
  shiftStamps(slot.step, shift);
}

bool store(const double& ratio, ArmTrajectoryJSetRatioArguments& slot) {
  return store(ratio, slot.ratio);
}

bool store(const double& ratio, ArmTrajectoryJSetRatioVArguments& slot) {
  return store(ratio, slot.ratio);
}

bool store(const double& ratio, ArmTrajectoryJSetRatioAArguments& slot) {
  return store(ratio, slot.ratio);
}

bool store(const JointGoal& q, ArmQueryCpArguments& slot) { return store(q, slot.q); }

void shiftStamps(ArmQueryCpArguments& slot, suture::Duration shift) { shiftStamps(slot.q, shift); }

bool store(const JointGoal& q, ArmLocalQueryCpArguments& slot) { return store(q, slot.q); }

void shiftStamps(ArmLocalQueryCpArguments& slot, suture::Duration shift) {
  shiftStamps(slot.q, shift);
}

// Defined in arm/arm.wire.cpp.
const suture::codec::Codec& armCodec();

namespace {

// By place in the contract, the place in the lock: a base got more since.
constexpr std::uint8_t kArmWireEvents[] = {3, 2, 4, 0, 1, 5, 6, 7, 8, 9};

bool acceptsArmServoCp(const ArmServoCpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmServoJp(const ArmServoJpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmMoveJp(const ArmMoveJpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmForwardKinematics(const ArmForwardKinematicsArguments& slot,
                                 suture::FieldPath* path) {
  return isValid(slot.q, path) || suture::refusedAt(path, "q");
}

bool acceptsArmInverseKinematics(const ArmInverseKinematicsArguments& slot,
                                 suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmSetBaseFrame(const ArmSetBaseFrameArguments& slot, suture::FieldPath* path) {
  return isValid(slot.base, path) || suture::refusedAt(path, "base");
}

bool acceptsArmServoJr(const ArmServoJrArguments& slot, suture::FieldPath* path) {
  return isValid(slot.step, path) || suture::refusedAt(path, "step");
}

bool acceptsArmServoJv(const ArmServoJvArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmServoJf(const ArmServoJfArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmServoCr(const ArmServoCrArguments& slot, suture::FieldPath* path) {
  return isValid(slot.step, path) || suture::refusedAt(path, "step");
}

bool acceptsArmServoCv(const ArmServoCvArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmBodyServoCf(const ArmBodyServoCfArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmSpatialServoCf(const ArmSpatialServoCfArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmInterpolateJp(const ArmInterpolateJpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmInterpolateJr(const ArmInterpolateJrArguments& slot, suture::FieldPath* path) {
  return isValid(slot.step, path) || suture::refusedAt(path, "step");
}

bool acceptsArmInterpolateCp(const ArmInterpolateCpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmInterpolateCr(const ArmInterpolateCrArguments& slot, suture::FieldPath* path) {
  return isValid(slot.step, path) || suture::refusedAt(path, "step");
}

bool acceptsArmMoveJr(const ArmMoveJrArguments& slot, suture::FieldPath* path) {
  return isValid(slot.step, path) || suture::refusedAt(path, "step");
}

bool acceptsArmMoveCp(const ArmMoveCpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmMoveCr(const ArmMoveCrArguments& slot, suture::FieldPath* path) {
  return isValid(slot.step, path) || suture::refusedAt(path, "step");
}

bool acceptsArmTrajectoryJSetRatio(const ArmTrajectoryJSetRatioArguments& slot,
                                   suture::FieldPath* path) {
  return suture::inRange(slot.ratio, 0.01, 1) || suture::refusedAt(path, "ratio");
}

bool acceptsArmTrajectoryJSetRatioV(const ArmTrajectoryJSetRatioVArguments& slot,
                                    suture::FieldPath* path) {
  return suture::inRange(slot.ratio, 0.01, 1) || suture::refusedAt(path, "ratio");
}

bool acceptsArmTrajectoryJSetRatioA(const ArmTrajectoryJSetRatioAArguments& slot,
                                    suture::FieldPath* path) {
  return suture::inRange(slot.ratio, 0.01, 1) || suture::refusedAt(path, "ratio");
}

bool acceptsArmTrajectoryJRatioResult(const double& slot, suture::FieldPath*) {
  return isValid(slot);
}

bool acceptsArmTrajectoryJRatioVResult(const double& slot, suture::FieldPath*) {
  return isValid(slot);
}

bool acceptsArmTrajectoryJRatioAResult(const double& slot, suture::FieldPath*) {
  return isValid(slot);
}

bool acceptsArmQueryCp(const ArmQueryCpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.q, path) || suture::refusedAt(path, "q");
}

bool acceptsArmLocalQueryCp(const ArmLocalQueryCpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.q, path) || suture::refusedAt(path, "q");
}

bool acceptsArmDesiredStateEvent(const std::uint8_t& slot, suture::FieldPath*) {
  return isKnownArmState(slot);
}

bool acceptsArmTrajectoryJRatioEvent(const double& slot, suture::FieldPath*) {
  return isValid(slot);
}

bool acceptsArmTrajectoryJRatioVEvent(const double& slot, suture::FieldPath*) {
  return isValid(slot);
}

bool acceptsArmTrajectoryJRatioAEvent(const double& slot, suture::FieldPath*) {
  return isValid(slot);
}

constexpr suture::BoundedLevel kArmBodyJacobianResultLevels[] = {
    suture::levelAt<suture::BoundedList<double, 48>>(offsetof(JacobianSlot, coefficients)),
};

constexpr suture::BoundedLevel kArmSpatialJacobianResultLevels[] = {
    suture::levelAt<suture::BoundedList<double, 48>>(offsetof(JacobianSlot, coefficients)),
};

constexpr suture::CommandInfo kArmCommands[] = {
    {.name = "enable", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "disable", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "home", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "hold", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "servo_cp",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmServoCpArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(20'000'000),
     .accepts = suture::checkSlot<ArmServoCpArguments, acceptsArmServoCp>,
     .shiftArguments = suture::shiftSlot<ArmServoCpArguments>},
    {.name = "servo_jp",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmServoJpArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(20'000'000),
     .accepts = suture::checkSlot<ArmServoJpArguments, acceptsArmServoJp>,
     .shiftArguments = suture::shiftSlot<ArmServoJpArguments>},
    {.name = "move_jp",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmMoveJpArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmMoveJpArguments, acceptsArmMoveJp>,
     .shiftArguments = suture::shiftSlot<ArmMoveJpArguments>},
    {.name = "measured_js",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<JointStateSlot>,
     .depth = 16,
     .column = ArmColumn::measured_js,
     .acceptsResult = suture::checkSlot<JointStateSlot, isValid>,
     .shiftResult = suture::shiftSlot<JointStateSlot>},
    {.name = "setpoint_js",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<JointStateSlot>,
     .depth = 16,
     .column = ArmColumn::setpoint_js,
     .acceptsResult = suture::checkSlot<JointStateSlot, isValid>,
     .shiftResult = suture::shiftSlot<JointStateSlot>},
    {.name = "measured_cp",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = ArmColumn::measured_cp,
     .acceptsResult = suture::checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = suture::shiftSlot<PoseStampedSlot>},
    {.name = "setpoint_cp",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = ArmColumn::setpoint_cp,
     .acceptsResult = suture::checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = suture::shiftSlot<PoseStampedSlot>},
    {.name = "operating_state",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<OperatingStateSlot>,
     .depth = 16,
     .column = ArmColumn::operating_state,
     .acceptsResult = suture::checkSlot<OperatingStateSlot, isValid>,
     .shiftResult = suture::shiftSlot<OperatingStateSlot>},
    {.name = "forward_kinematics",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<ArmForwardKinematicsArguments>,
     .resultSize = suture::slotSize<PoseStampedSlot>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmForwardKinematicsArguments, acceptsArmForwardKinematics>,
     .acceptsResult = suture::checkSlot<PoseStampedSlot, isValid>,
     .shiftArguments = suture::shiftSlot<ArmForwardKinematicsArguments>,
     .shiftResult = suture::shiftSlot<PoseStampedSlot>},
    {.name = "inverse_kinematics",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<ArmInverseKinematicsArguments>,
     .resultSize = suture::slotSize<JointSolutionSlot>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmInverseKinematicsArguments, acceptsArmInverseKinematics>,
     .acceptsResult = suture::checkSlot<JointSolutionSlot, isValid>,
     .shiftArguments = suture::shiftSlot<ArmInverseKinematicsArguments>},
    {.name = "configuration_js",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<JointConfigurationSlot>,
     .depth = 16,
     .column = ArmColumn::configuration_js,
     .acceptsResult = suture::checkSlot<JointConfigurationSlot, isValid>},
    {.name = "period_statistics",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<IntervalStatisticsSlot>,
     .depth = 16,
     .column = ArmColumn::period_statistics,
     .acceptsResult = suture::checkSlot<IntervalStatisticsSlot, isValid>,
     .shiftResult = suture::shiftSlot<IntervalStatisticsSlot>},
    {.name = "pause", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "resume", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "unhome", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "state_command",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmStateCommandArguments>,
     .depth = 16},
    {.name = "goal_js",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<JointStateSlot>,
     .depth = 16,
     .column = ArmColumn::goal_js,
     .acceptsResult = suture::checkSlot<JointStateSlot, isValid>,
     .shiftResult = suture::shiftSlot<JointStateSlot>},
    {.name = "goal_cp",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = ArmColumn::goal_cp,
     .acceptsResult = suture::checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = suture::shiftSlot<PoseStampedSlot>},
    {.name = "local_measured_cp",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = ArmColumn::local_measured_cp,
     .acceptsResult = suture::checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = suture::shiftSlot<PoseStampedSlot>},
    {.name = "local_setpoint_cp",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = ArmColumn::local_setpoint_cp,
     .acceptsResult = suture::checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = suture::shiftSlot<PoseStampedSlot>},
    {.name = "measured_cv",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<TwistSlot>,
     .depth = 16,
     .column = ArmColumn::measured_cv,
     .acceptsResult = suture::checkSlot<TwistSlot, isValid>,
     .shiftResult = suture::shiftSlot<TwistSlot>},
    {.name = "setpoint_cv",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<TwistSlot>,
     .depth = 16,
     .column = ArmColumn::setpoint_cv,
     .acceptsResult = suture::checkSlot<TwistSlot, isValid>,
     .shiftResult = suture::shiftSlot<TwistSlot>},
    {.name = "body_measured_cf",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<WrenchSlot>,
     .depth = 16,
     .column = ArmColumn::body_measured_cf,
     .acceptsResult = suture::checkSlot<WrenchSlot, isValid>,
     .shiftResult = suture::shiftSlot<WrenchSlot>},
    {.name = "spatial_measured_cf",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<WrenchSlot>,
     .depth = 16,
     .column = ArmColumn::spatial_measured_cf,
     .acceptsResult = suture::checkSlot<WrenchSlot, isValid>,
     .shiftResult = suture::shiftSlot<WrenchSlot>},
    {.name = "measured_cs",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<CartesianStateSlot>,
     .depth = 16,
     .column = ArmColumn::measured_cs,
     .acceptsResult = suture::checkSlot<CartesianStateSlot, isValid>,
     .shiftResult = suture::shiftSlot<CartesianStateSlot>},
    {.name = "body_jacobian",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<JacobianSlot>,
     .depth = 16,
     .column = ArmColumn::body_jacobian,
     .acceptsResult = suture::checkSlot<JacobianSlot, isValid>,
     .shiftResult = suture::shiftSlot<JacobianSlot>,
     .resultLevels = kArmBodyJacobianResultLevels},
    {.name = "spatial_jacobian",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<JacobianSlot>,
     .depth = 16,
     .column = ArmColumn::spatial_jacobian,
     .acceptsResult = suture::checkSlot<JacobianSlot, isValid>,
     .shiftResult = suture::shiftSlot<JacobianSlot>,
     .resultLevels = kArmSpatialJacobianResultLevels},
    {.name = "base_frame",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<TransformStampedSlot>,
     .depth = 16,
     .column = ArmColumn::base_frame,
     .acceptsResult = suture::checkSlot<TransformStampedSlot, isValid>,
     .shiftResult = suture::shiftSlot<TransformStampedSlot>},
    {.name = "set_base_frame",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmSetBaseFrameArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmSetBaseFrameArguments, acceptsArmSetBaseFrame>,
     .shiftArguments = suture::shiftSlot<ArmSetBaseFrameArguments>},
    {.name = "free", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "use_gravity_compensation",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmUseGravityCompensationArguments>,
     .depth = 16},
    {.name = "servo_jr",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmServoJrArguments>,
     .depth = 16,
     .ttl = suture::Duration(20'000'000),
     .accepts = suture::checkSlot<ArmServoJrArguments, acceptsArmServoJr>,
     .shiftArguments = suture::shiftSlot<ArmServoJrArguments>},
    {.name = "servo_jv",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmServoJvArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(20'000'000),
     .accepts = suture::checkSlot<ArmServoJvArguments, acceptsArmServoJv>,
     .shiftArguments = suture::shiftSlot<ArmServoJvArguments>},
    {.name = "servo_jf",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmServoJfArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(20'000'000),
     .accepts = suture::checkSlot<ArmServoJfArguments, acceptsArmServoJf>,
     .shiftArguments = suture::shiftSlot<ArmServoJfArguments>},
    {.name = "servo_cr",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmServoCrArguments>,
     .depth = 16,
     .ttl = suture::Duration(20'000'000),
     .accepts = suture::checkSlot<ArmServoCrArguments, acceptsArmServoCr>,
     .shiftArguments = suture::shiftSlot<ArmServoCrArguments>},
    {.name = "servo_cv",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmServoCvArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(20'000'000),
     .accepts = suture::checkSlot<ArmServoCvArguments, acceptsArmServoCv>,
     .shiftArguments = suture::shiftSlot<ArmServoCvArguments>},
    {.name = "body_servo_cf",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmBodyServoCfArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(20'000'000),
     .accepts = suture::checkSlot<ArmBodyServoCfArguments, acceptsArmBodyServoCf>,
     .shiftArguments = suture::shiftSlot<ArmBodyServoCfArguments>},
    {.name = "spatial_servo_cf",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmSpatialServoCfArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(20'000'000),
     .accepts = suture::checkSlot<ArmSpatialServoCfArguments, acceptsArmSpatialServoCf>,
     .shiftArguments = suture::shiftSlot<ArmSpatialServoCfArguments>},
    {.name = "interpolate_jp",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmInterpolateJpArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(200'000'000),
     .accepts = suture::checkSlot<ArmInterpolateJpArguments, acceptsArmInterpolateJp>,
     .shiftArguments = suture::shiftSlot<ArmInterpolateJpArguments>},
    {.name = "interpolate_jr",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmInterpolateJrArguments>,
     .depth = 16,
     .ttl = suture::Duration(200'000'000),
     .accepts = suture::checkSlot<ArmInterpolateJrArguments, acceptsArmInterpolateJr>,
     .shiftArguments = suture::shiftSlot<ArmInterpolateJrArguments>},
    {.name = "interpolate_cp",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmInterpolateCpArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(200'000'000),
     .accepts = suture::checkSlot<ArmInterpolateCpArguments, acceptsArmInterpolateCp>,
     .shiftArguments = suture::shiftSlot<ArmInterpolateCpArguments>},
    {.name = "interpolate_cr",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmInterpolateCrArguments>,
     .depth = 16,
     .ttl = suture::Duration(200'000'000),
     .accepts = suture::checkSlot<ArmInterpolateCrArguments, acceptsArmInterpolateCr>,
     .shiftArguments = suture::shiftSlot<ArmInterpolateCrArguments>},
    {.name = "move_jr",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmMoveJrArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmMoveJrArguments, acceptsArmMoveJr>,
     .shiftArguments = suture::shiftSlot<ArmMoveJrArguments>},
    {.name = "move_cp",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmMoveCpArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmMoveCpArguments, acceptsArmMoveCp>,
     .shiftArguments = suture::shiftSlot<ArmMoveCpArguments>},
    {.name = "move_cr",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmMoveCrArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmMoveCrArguments, acceptsArmMoveCr>,
     .shiftArguments = suture::shiftSlot<ArmMoveCrArguments>},
    {.name = "trajectory_j_set_ratio",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmTrajectoryJSetRatioArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmTrajectoryJSetRatioArguments, acceptsArmTrajectoryJSetRatio>},
    {.name = "trajectory_j_set_ratio_v",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmTrajectoryJSetRatioVArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmTrajectoryJSetRatioVArguments, acceptsArmTrajectoryJSetRatioV>},
    {.name = "trajectory_j_set_ratio_a",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmTrajectoryJSetRatioAArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmTrajectoryJSetRatioAArguments, acceptsArmTrajectoryJSetRatioA>},
    {.name = "trajectory_j_ratio",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .column = ArmColumn::trajectory_j_ratio,
     .acceptsResult = suture::checkSlot<double, acceptsArmTrajectoryJRatioResult>},
    {.name = "trajectory_j_ratio_v",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .column = ArmColumn::trajectory_j_ratio_v,
     .acceptsResult = suture::checkSlot<double, acceptsArmTrajectoryJRatioVResult>},
    {.name = "trajectory_j_ratio_a",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .column = ArmColumn::trajectory_j_ratio_a,
     .acceptsResult = suture::checkSlot<double, acceptsArmTrajectoryJRatioAResult>},
    {.name = "query_cp",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<ArmQueryCpArguments>,
     .resultSize = suture::slotSize<PoseStampedSlot>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmQueryCpArguments, acceptsArmQueryCp>,
     .acceptsResult = suture::checkSlot<PoseStampedSlot, isValid>,
     .shiftArguments = suture::shiftSlot<ArmQueryCpArguments>,
     .shiftResult = suture::shiftSlot<PoseStampedSlot>},
    {.name = "local_query_cp",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<ArmLocalQueryCpArguments>,
     .resultSize = suture::slotSize<PoseStampedSlot>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmLocalQueryCpArguments, acceptsArmLocalQueryCp>,
     .acceptsResult = suture::checkSlot<PoseStampedSlot, isValid>,
     .shiftArguments = suture::shiftSlot<ArmLocalQueryCpArguments>,
     .shiftResult = suture::shiftSlot<PoseStampedSlot>},
};

constexpr suture::EventInfo kArmEvents[] = {
    {.name = "operating_state",
     .payloadSize = suture::slotSize<OperatingStateSlot>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<OperatingStateSlot, isValid>,
     .shiftPayload = suture::shiftSlot<OperatingStateSlot>},
    {.name = "goal_reached", .payloadSize = suture::slotSize<std::uint8_t>, .depth = 16},
    {.name = "desired_state",
     .payloadSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<std::uint8_t, acceptsArmDesiredStateEvent>},
    {.name = "gravity_compensation",
     .payloadSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true},
    {.name = "trajectory_j_ratio",
     .payloadSize = suture::slotSize<double>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<double, acceptsArmTrajectoryJRatioEvent>},
    {.name = "trajectory_j_ratio_v",
     .payloadSize = suture::slotSize<double>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<double, acceptsArmTrajectoryJRatioVEvent>},
    {.name = "trajectory_j_ratio_a",
     .payloadSize = suture::slotSize<double>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<double, acceptsArmTrajectoryJRatioAEvent>},
};

// The self-description, as in arm/arm.suture.json.
constexpr char kArmDescription[] = R"json(
{"name": "robots::Arm",
"doc": "Commands run in the arm's own thread before its next cycle; reads are from the end of its last\none. How a client calls and subscribes is in docs/howto/calling.md. Where a joint is prismatic,\nits units are m, m/s, m/s2 and N in place of rad, rad/s, rad/s2 and N.m.\n\nStates are those of CRTK. An arm starts, and restarts, in Undefined. When its drives answer and\npower is permitted it becomes Disabled, and is not homed. Motion commands need state Enabled; in\nany other the arm refuses them. It enters Fault by itself, and leaves it by enable() or\ndisable().\n\nAn arm that is not homed, or not any more after an encoder jumped or unhome(), does not know\nwhere its tip is: it refuses all Cartesian motion commands (`servo_c*`, `*_servo_cf`,\n`interpolate_c*`, `move_c*`), and obeys those of joints.\n\nAn arm that works through a cannula also refuses Cartesian motion until its wrist is far enough\nbeyond the remote centre: for a da Vinci it must be 45 mm beyond; once it was less, 47 mm.\nhome() and joint commands move the wrist through the cannula.\n\n`local_` poses are of the tool tip in the arm's base frame, all others in the reference frame of\nthe interface, in which base_frame() is the arm's base. The two frames are the same until some\nclient calls set_base_frame(), which counts for all clients.\n\nMotion does not queue: each motion command replaces the one before it, of joints or of the tip,\nand relative goals are relative to the set-point. A servo stream that falls silent for 0.1 s\nends as with hold(), and so does any stream whose client is gone.\n\nThe arm reports each refusal, and what happens to it, by the events warning and error, whose\n`code` is an ArmWarning (arm_warning.h). A refused motion command is reported once until the arm\nobeys again; a refused state command is reported each time.",
"hash": "1f5d06412eacd0fd4ccda12e8a351a33", "version": 2, "major": 2, "base": "suture::Messages",
"crtk": true, "commands": [{"name": "enable", "kind": "void", "ordinal": 1,
"doc": "Gives the drives power. The arm holds its position.", "queue": 16}, {"name": "disable",
"kind": "void", "ordinal": 2,
"doc": "Stops the arm at once and takes its power. It refuses motion until it is enabled again.",
"queue": 16}, {"name": "home", "kind": "void", "ordinal": 3,
"doc": "Moves the arm to its home position, if it is enabled. The move ends with goal_reached.",
"queue": 16}, {"name": "hold", "kind": "void", "ordinal": 4,
"doc": "Drops what is under way; the set-point stays where it is.", "queue": 16}, {
"name": "servo_cp", "kind": "write", "ordinal": 5, "wire": "servoCp",
"doc": "Streams Cartesian goals, newest wins. Beyond a joint limit the arm slides along it, at the\nnearest point that the limits admit, and warns of AtLimit. A goal that is out of reach, or\nfarther from the set-point than the rate limits admit, is dropped with a warning, OutOfReach\nor StepTooFar, and the set-point stays where it was. setpoint_cp keeps the goal's stamp.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::PoseStamped"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "servo_jp", "kind": "write", "ordinal": 6,
"wire": "servoJp",
"doc": "Streams joint goals, newest wins. A joint whose goal lies beyond its limit stays at the limit.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::JointGoal"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "move_jp", "kind": "write", "ordinal": 7,
"wire": "moveJp",
"doc": "Plans and executes a smooth motion of the joints from the set-point, and from the velocity\nthat it has: a move may replace another under way. It ends at rest and with goal_reached. A\ngoal beyond a joint limit is refused.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::JointGoal"}}],
"queue": 16}, {"name": "measured_js", "kind": "read", "ordinal": 8, "wire": "measuredJs",
"doc": "Says where the joints are, and what their motors give; `effort` is empty if the drives do not\nmeasure it. The stamp is that of the drives' cycle that measured them.",
"result": {"type": {"kind": "struct", "name": "robots::JointState"}}, "queue": 16}, {
"name": "setpoint_js", "kind": "read", "ordinal": 9, "wire": "setpointJs",
"doc": "Says where the joints are commanded to be in this cycle.", "result": {"type": {
"kind": "struct", "name": "robots::JointState"}}, "queue": 16}, {"name": "measured_cp",
"kind": "read", "ordinal": 10, "wire": "measuredCp",
"doc": "Says where the tool tip is. The stamp is that of the drives' cycle that measured the joints.",
"result": {"type": {"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {
"name": "setpoint_cp", "kind": "read", "ordinal": 11, "wire": "setpointCp",
"doc": "Says where the tool tip is commanded to be in this cycle. The stamp is that of the servo_cp or\ninterpolate_cp goal from which it came, else that of the arm's cycle.",
"result": {"type": {"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {
"name": "operating_state", "kind": "read", "ordinal": 12, "wire": "operatingState",
"doc": "Says in which state of CRTK the arm is, and whether it is homed.", "result": {"type": {
"kind": "struct", "name": "robots::OperatingState"}}, "queue": 16}, {"name": "forward_kinematics",
"kind": "qualified read", "ordinal": 13, "wire": "forwardKinematics",
"doc": "Computes the tool tip for a joint vector; it is not valid if the vector has the wrong length.",
"parameters": [{"name": "q", "type": {"kind": "struct", "name": "robots::JointGoal"}}], "result": {
"type": {"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {
"name": "inverse_kinematics", "kind": "qualified read", "ordinal": 14, "wire": "inverseKinematics",
"doc": "Computes a joint vector for a tool tip, searched from the present set-point.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::PoseStamped"}}],
"result": {"type": {"kind": "struct", "name": "robots::JointSolution"}}, "queue": 16}, {
"name": "configuration_js", "kind": "read", "ordinal": 15, "wire": "configurationJs",
"doc": "Says what the joints are and what they may do. Velocities are their rate limits, accelerations\nthose of moves, efforts the most that the motors give. For a da Vinci the efforts are from the\nliterature, the accelerations our own. A list is empty if it bounds no joint.",
"result": {"type": {"kind": "struct", "name": "robots::JointConfiguration"}}, "queue": 16}, {
"name": "period_statistics", "kind": "read", "ordinal": 16, "wire": "periodStatistics",
"doc": "Says how regularly the arm's task ran in the last second.", "result": {"type": {
"kind": "struct", "name": "robots::IntervalStatistics"}}, "queue": 16}, {"name": "pause",
"kind": "void", "ordinal": 17,
"doc": "Stops the arm where the joints are. It refuses motion until resume().", "queue": 16}, {
"name": "resume", "kind": "void", "ordinal": 18,
"doc": "Ends a pause: the arm is enabled and holds.", "queue": 16}, {"name": "unhome",
"kind": "void", "ordinal": 19,
"doc": "Makes the arm forget that it is homed, and ends home(): the arm holds where it is.",
"queue": 16}, {"name": "state_command", "kind": "write", "ordinal": 20, "wire": "stateCommand",
"doc": "Does what its name says: \"enable\", \"disable\", \"pause\", \"resume\", \"home\" or \"unhome\". Any other\nname is reported as an error.",
"parameters": [{"name": "name", "type": {"kind": "text", "capacity": 15}}], "queue": 16}, {
"name": "goal_js", "kind": "read", "ordinal": 21, "wire": "goalJs",
"doc": "Says where the present move ends; without one, it is the set-point.", "result": {"type": {
"kind": "struct", "name": "robots::JointState"}}, "queue": 16}, {"name": "goal_cp", "kind": "read",
"ordinal": 22, "wire": "goalCp",
"doc": "Says where the present move ends; without one, it is the set-point.", "result": {"type": {
"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {"name": "local_measured_cp",
"kind": "read", "ordinal": 23, "wire": "localMeasuredCp",
"doc": "Says where the tool tip is in the arm's base frame.", "result": {"type": {"kind": "struct",
"name": "robots::PoseStamped"}}, "queue": 16}, {"name": "local_setpoint_cp", "kind": "read",
"ordinal": 24, "wire": "localSetpointCp",
"doc": "Says where the tool tip is commanded to be, in the arm's base frame.", "result": {"type": {
"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {"name": "measured_cv",
"kind": "read", "ordinal": 25, "wire": "measuredCv",
"doc": "Says how the tip moves, in the directions of the reference frame.", "result": {"type": {
"kind": "struct", "name": "robots::Twist"}}, "queue": 16}, {"name": "setpoint_cv", "kind": "read",
"ordinal": 26, "wire": "setpointCv",
"doc": "Says how the set-point moves, whatever moves it, in the directions of the reference frame. If\nit jumped, and in the first cycle of a motion, this is 0. The stamp is that of the arm's\ncycle.",
"result": {"type": {"kind": "struct", "name": "robots::Twist"}}, "queue": 16}, {
"name": "body_measured_cf", "kind": "read", "ordinal": 27, "wire": "bodyMeasuredCf",
"doc": "Says with which wrench the arm presses at its tip, in the tip's own directions: the motors'\nefforts, less the arm's weight by its model, through the transposed Jacobian. It includes\nfriction, inertia and the errors of that model, so it is near a contact's force only if the\narm is slow and presses hard. Its sign is that of body_servo_cf, as in the da Vinci Research\nKit; what touches the tip presses on it with the opposite. It is not valid if the drives\nmeasure no effort, without power, and near a singularity. The stamp is that of the drives'\ncycle that measured the joints.",
"result": {"type": {"kind": "struct", "name": "robots::Wrench"}}, "queue": 16}, {
"name": "spatial_measured_cf", "kind": "read", "ordinal": 28, "wire": "spatialMeasuredCf",
"doc": "Says what body_measured_cf says, in the directions of the arm's base frame.", "result": {
"type": {"kind": "struct", "name": "robots::Wrench"}}, "queue": 16}, {"name": "measured_cs",
"kind": "read", "ordinal": 29, "wire": "measuredCs",
"doc": "Gives pose, velocity and force of one cycle, in the reference frame.", "result": {"type": {
"kind": "struct", "name": "robots::CartesianState"}}, "queue": 16}, {"name": "body_jacobian",
"kind": "read", "ordinal": 30, "wire": "bodyJacobian",
"doc": "Maps joint velocities to the velocity of the tip, in the tip's own directions. The stamp is\nthat of the drives' cycle that measured the joints.",
"result": {"type": {"kind": "struct", "name": "robots::Jacobian"}}, "queue": 16}, {
"name": "spatial_jacobian", "kind": "read", "ordinal": 31, "wire": "spatialJacobian",
"doc": "Maps joint velocities to the velocity of the tip, in the directions of the arm's base frame.",
"result": {"type": {"kind": "struct", "name": "robots::Jacobian"}}, "queue": 16}, {
"name": "base_frame", "kind": "read", "ordinal": 32, "wire": "baseFrame",
"doc": "Says where the arm's base is in the reference frame of this interface.", "result": {
"type": {"kind": "struct", "name": "robots::TransformStamped"}}, "queue": 16}, {
"name": "set_base_frame", "kind": "write", "ordinal": 33, "wire": "setBaseFrame",
"doc": "Sets where the arm's base is in the reference frame of this interface, for all clients. It is\nrefused if `base` names another reference frame than the interface's, while the arm moves or\nfollows a stream, and until no goal of a Cartesian stream in the reference frame, obeyed or\nrefused, has come for 0.1 s: the next one would be about the previous base.",
"parameters": [{"name": "base", "type": {"kind": "struct", "name": "robots::TransformStamped"}}],
"queue": 16}, {"name": "free", "kind": "void", "ordinal": 34,
"doc": "Lets the set-point follow the joints until another command. Drives that control efforts\nrelease the joints: their motors do no more than carry the arm, if they are to.",
"queue": 16}, {"name": "use_gravity_compensation", "kind": "write", "ordinal": 35,
"wire": "useGravityCompensation",
"doc": "Says if the motors carry the arm's weight, in every state that has power; at first they do.\nDrives that control efforts obey it. Without it a joint that is held sinks until its\ncontroller carries it, and one that is released falls.",
"parameters": [{"name": "use", "type": {"kind": "Bool"}}], "queue": 16}, {"name": "servo_jr",
"kind": "write", "ordinal": 36, "wire": "servoJr", "doc": "Steps the set-point by joint positions.",
"parameters": [{"name": "step", "type": {"kind": "struct", "name": "robots::JointGoal"}}],
"queue": 16, "ttl": 0.02}, {"name": "servo_jv", "kind": "write", "ordinal": 37, "wire": "servoJv",
"doc": "Streams joint velocities, newest wins: the set-point moves so fast, within the rate limits.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::JointVelocityGoal"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "servo_jf", "kind": "write", "ordinal": 38,
"wire": "servoJf",
"doc": "Streams what the motors give beside carrying the arm, newest wins. The joints are released;\nthose outside of the mask are held. If the drives control no effort, it moves the set-point at\na speed proportional to it.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::JointEffortGoal"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "servo_cr", "kind": "write", "ordinal": 39,
"wire": "servoCr",
"doc": "Steps the set-point: the translation is in the reference frame, the rotation turns the tip\nabout itself.",
"parameters": [{"name": "step", "type": {"kind": "struct", "name": "robots::PoseStamped"}}],
"queue": 16, "ttl": 0.02}, {"name": "servo_cv", "kind": "write", "ordinal": 40, "wire": "servoCv",
"doc": "Streams velocities of the tip, in the directions of the reference frame, newest wins.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::TwistGoal"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "body_servo_cf", "kind": "write", "ordinal": 41,
"wire": "bodyServoCf",
"doc": "Streams the wrench that the tip presses with beside carrying the arm, in the tip's own\ndirections, newest wins. The joints are released as by servo_jf; drives that control no effort\nmove the set-point at a speed proportional to the wrench.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::WrenchGoal"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "spatial_servo_cf", "kind": "write",
"ordinal": 42, "wire": "spatialServoCf",
"doc": "Streams wrenches as body_servo_cf does, in the directions of the arm's base frame.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::WrenchGoal"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "interpolate_jp", "kind": "write",
"ordinal": 43, "wire": "interpolateJp",
"doc": "Streams goals that come more slowly than the arm's cycles, newest wins. The set-point goes to\neach in a straight line of the joints, in as much time as lay between it and the goal before\nit, but no faster than the joints can, and stays there. Limits and reach are those of servo\ncommands.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::JointGoal"}}],
"queue": 16, "latest": true, "ttl": 0.2}, {"name": "interpolate_jr", "kind": "write", "ordinal": 44,
"wire": "interpolateJr", "doc": "Steps the goal of interpolate_jp by joint positions.",
"parameters": [{"name": "step", "type": {"kind": "struct", "name": "robots::JointGoal"}}],
"queue": 16, "ttl": 0.2}, {"name": "interpolate_cp", "kind": "write", "ordinal": 45,
"wire": "interpolateCp",
"doc": "Streams Cartesian goals that come more slowly than the arm's cycles, as interpolate_jp does.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::PoseStamped"}}],
"queue": 16, "latest": true, "ttl": 0.2}, {"name": "interpolate_cr", "kind": "write", "ordinal": 46,
"wire": "interpolateCr", "doc": "Steps the goal of interpolate_cp as servo_cr steps the set-point.",
"parameters": [{"name": "step", "type": {"kind": "struct", "name": "robots::PoseStamped"}}],
"queue": 16, "ttl": 0.2}, {"name": "move_jr", "kind": "write", "ordinal": 47, "wire": "moveJr",
"doc": "Moves as move_jp does, by joint positions from the set-point.", "parameters": [{
"name": "step", "type": {"kind": "struct", "name": "robots::JointGoal"}}], "queue": 16}, {
"name": "move_cp", "kind": "write", "ordinal": 48, "wire": "moveCp",
"doc": "Moves the tip to a pose, by the motion of the joints that move_jp plans: the path is not\nstraight in space. A goal that the joints cannot reach within their limits is refused.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::PoseStamped"}}],
"queue": 16}, {"name": "move_cr", "kind": "write", "ordinal": 49, "wire": "moveCr",
"doc": "Moves as move_cp does, by a step from the set-point that is given as servo_cr's.",
"parameters": [{"name": "step", "type": {"kind": "struct", "name": "robots::PoseStamped"}}],
"queue": 16}, {"name": "trajectory_j_set_ratio", "kind": "write", "ordinal": 50,
"wire": "trajectoryJSetRatio",
"doc": "Sets the fraction of the joints' velocity and acceleration limits that moves use.",
"parameters": [{"name": "ratio", "type": {"kind": "Float64"}, "range": [0.01, 1.0]}], "queue": 16},
{"name": "trajectory_j_set_ratio_v", "kind": "write", "ordinal": 51, "wire": "trajectoryJSetRatioV",
"doc": "Sets the fraction of the velocity limits alone.", "parameters": [{"name": "ratio", "type": {
"kind": "Float64"}, "range": [0.01, 1.0]}], "queue": 16}, {"name": "trajectory_j_set_ratio_a",
"kind": "write", "ordinal": 52, "wire": "trajectoryJSetRatioA",
"doc": "Sets the fraction of the acceleration limits alone.", "parameters": [{"name": "ratio",
"type": {"kind": "Float64"}, "range": [0.01, 1.0]}], "queue": 16}, {"name": "trajectory_j_ratio",
"kind": "read", "ordinal": 53, "wire": "trajectoryJRatio",
"doc": "Says the smaller of trajectory_j_ratio_v and trajectory_j_ratio_a.", "result": {"type": {
"kind": "Float64"}}, "queue": 16}, {"name": "trajectory_j_ratio_v", "kind": "read", "ordinal": 54,
"wire": "trajectoryJRatioV", "doc": "Says what trajectory_j_set_ratio_v has set.", "result": {
"type": {"kind": "Float64"}}, "queue": 16}, {"name": "trajectory_j_ratio_a", "kind": "read",
"ordinal": 55, "wire": "trajectoryJRatioA", "doc": "Says what trajectory_j_set_ratio_a has set.",
"result": {"type": {"kind": "Float64"}}, "queue": 16}, {"name": "query_cp",
"kind": "qualified read", "ordinal": 56, "wire": "queryCp",
"doc": "Computes the pose of link n for a vector of n joints, at most all of them; that of the base\nfor an empty one.",
"parameters": [{"name": "q", "type": {"kind": "struct", "name": "robots::JointGoal"}}], "result": {
"type": {"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {
"name": "local_query_cp", "kind": "qualified read", "ordinal": 57, "wire": "localQueryCp",
"doc": "Computes what query_cp does, in the arm's base frame.", "parameters": [{"name": "q",
"type": {"kind": "struct", "name": "robots::JointGoal"}}], "result": {"type": {"kind": "struct",
"name": "robots::PoseStamped"}}, "queue": 16}], "events": [{"name": "status", "kind": "write",
"ordinal": 1, "doc": "Reports that something has been done, and nothing is wrong.", "payload": {
"type": {"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages", "number": 3}, {"name": "warning", "kind": "write", "ordinal": 2,
"doc": "Reports that something was refused, or is not as it should be; the component goes on.",
"payload": {"type": {"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages", "number": 2}, {"name": "error", "kind": "write", "ordinal": 3,
"doc": "Reports that something failed, and needs somebody's attention.", "payload": {"type": {
"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages", "number": 4}, {"name": "operating_state", "kind": "write", "ordinal": 1,
"wire": "operatingState",
"doc": "Reports each change of the operating state, and the last one to a client that connects.",
"payload": {"type": {"kind": "struct", "name": "robots::OperatingState"}}, "queue": 16,
"latched": true, "number": 0}, {"name": "goal_reached", "kind": "write", "ordinal": 2,
"wire": "goalReached",
"doc": "Reports the end of a move: true at its goal, false if anything else ended it.", "payload": {
"type": {"kind": "Bool"}}, "queue": 16, "number": 1}, {"name": "desired_state", "kind": "write",
"ordinal": 6, "wire": "desiredState", "doc": "Reports the state that a command asked for.",
"payload": {"type": {"kind": "enum", "name": "robots::ArmState"}}, "queue": 16, "latched": true,
"number": 5}, {"name": "gravity_compensation", "kind": "write", "ordinal": 7,
"wire": "gravityCompensation", "doc": "Reports what use_gravity_compensation has set.", "payload": {
"type": {"kind": "Bool"}}, "queue": 16, "latched": true, "number": 6}, {
"name": "trajectory_j_ratio", "kind": "write", "ordinal": 8, "wire": "trajectoryJRatio",
"doc": "Reports a change of the fraction that trajectory_j_ratio says.", "payload": {"type": {
"kind": "Float64"}}, "queue": 16, "latched": true, "number": 7}, {"name": "trajectory_j_ratio_v",
"kind": "write", "ordinal": 9, "wire": "trajectoryJRatioV",
"doc": "Reports a change of the fraction of the velocity limits.", "payload": {"type": {
"kind": "Float64"}}, "queue": 16, "latched": true, "number": 8}, {"name": "trajectory_j_ratio_a",
"kind": "write", "ordinal": 10, "wire": "trajectoryJRatioA",
"doc": "Reports a change of the fraction of the acceleration limits.", "payload": {"type": {
"kind": "Float64"}}, "queue": 16, "latched": true, "number": 9}], "enums": [{
"name": "robots::ArmState", "doc": "An ArmState is one of the states of CRTK.",
"underlying": "UInt8", "enumerators": [{"name": "Undefined", "value": 0, "wire": "undefined"}, {
"name": "Disabled", "value": 1, "wire": "disabled"}, {"name": "Enabled", "value": 2,
"wire": "enabled"}, {"name": "Paused", "value": 3, "wire": "paused"}, {"name": "Fault", "value": 4,
"wire": "fault"}]}, {"name": "robots::JointType", "underlying": "UInt8", "enumerators": [{
"name": "Undefined", "value": 0, "wire": "undefined"}, {"name": "Prismatic", "value": 1,
"wire": "prismatic"}, {"name": "Revolute", "value": 2, "wire": "revolute"}, {"name": "Universal",
"value": 3, "wire": "universal"}, {"name": "BallSocket", "value": 4, "wire": "ballSocket"}, {
"name": "Inactive", "value": 5, "wire": "inactive"}]}], "structs": [{"name": "robots::PoseStamped",
"doc": "A PoseStamped is a pose at a time: what CRTK's measured_cp, setpoint_cp and servo_cp carry.",
"fields": [{"name": "pose",
"doc": "The pose is that of the interface's moving frame in its reference frame.", "type": {
"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "stamp",
"doc": "The pose was true at this time; for a set-point it is the stamp of the data from which it was\nmade.",
"type": {"kind": "time", "clock": "steady"}}, {"name": "valid",
"doc": "If it is false, do not use it.", "type": {"kind": "Bool"}, "default": false}]}, {
"name": "robots::JointGoal", "doc": "Says where joints shall go: CRTK's servo_jp and move_jp.",
"fields": [{"name": "position", "doc": "There is one entry for each joint, in chain order.",
"type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 8}, "unit": "rad"}, {
"name": "stamp", "type": {"kind": "time", "clock": "steady"}}]}, {"name": "robots::JointState",
"doc": "A JointState is the state of all joints of an arm, in chain order: CRTK's measured_js and\nsetpoint_js. A list is empty if its quantity is not known, and as long as `name` otherwise.",
"fields": [{"name": "name", "type": {"kind": "list", "element": {"kind": "text", "capacity": 15},
"capacity": 8}}, {"name": "position", "type": {"kind": "list", "element": {"kind": "Float64"},
"capacity": 8}, "unit": "rad"}, {"name": "velocity", "type": {"kind": "list", "element": {
"kind": "Float64"}, "capacity": 8}, "unit": "rad/s"}, {"name": "effort", "type": {"kind": "list",
"element": {"kind": "Float64"}, "capacity": 8}, "unit": "N.m"}, {"name": "stamp", "type": {
"kind": "time", "clock": "steady"}}, {"name": "valid",
"doc": "If it is false, do not use the state.", "type": {"kind": "Bool"}, "default": false}]}, {
"name": "robots::OperatingState", "doc": "An OperatingState is CRTK's operating_state.", "fields": [
{"name": "state", "type": {"kind": "enum", "name": "robots::ArmState"}, "default": "Undefined"}, {
"name": "sub_state", "wire": "subState",
"doc": "Says for people what the arm is doing within its state: \"holding\", \"servo_cp\".",
"type": {"kind": "text", "capacity": 15}}, {"name": "is_homed", "wire": "isHomed", "type": {
"kind": "Bool"}, "default": false}, {"name": "is_busy", "wire": "isBusy",
"doc": "This is true while a move is under way; servo commands do not set it.", "type": {
"kind": "Bool"}, "default": false}, {"name": "stamp",
"doc": "One of the above changed last at this time.", "type": {"kind": "time", "clock": "steady"}}]
}, {"name": "robots::JointSolution",
"doc": "A JointSolution is a joint vector that an arm computed, without heap so that a control loop may\nreturn it.",
"fields": [{"name": "position", "doc": "The first `joints` entries count.", "type": {
"kind": "array", "element": {"kind": "Float64"}, "length": 8}, "unit": "rad"}, {"name": "joints",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "found",
"doc": "If it is false, no joint vector within limits reaches the pose, and `position` is the nearest\none found.",
"type": {"kind": "Bool"}, "default": false}]}, {"name": "robots::JointConfiguration",
"doc": "Says what the joints are and what they may do, for CRTK's configuration_js. Corresponds to\ncisst's prmConfigurationJoint.",
"fields": [{"name": "name", "type": {"kind": "list", "element": {"kind": "text", "capacity": 15},
"capacity": 8}}, {"name": "type", "type": {"kind": "list", "element": {"kind": "enum",
"name": "robots::JointType"}, "capacity": 8}}, {"name": "position_min", "wire": "positionMin",
"type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 8}, "unit": "rad"}, {
"name": "position_max", "wire": "positionMax", "type": {"kind": "list", "element": {
"kind": "Float64"}, "capacity": 8}, "unit": "rad"}, {"name": "velocity_min", "wire": "velocityMin",
"type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 8}, "unit": "rad/s"}, {
"name": "velocity_max", "wire": "velocityMax", "type": {"kind": "list", "element": {
"kind": "Float64"}, "capacity": 8}, "unit": "rad/s"}, {"name": "acceleration_min",
"wire": "accelerationMin", "type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 8},
"unit": "rad/s2"}, {"name": "acceleration_max", "wire": "accelerationMax", "type": {"kind": "list",
"element": {"kind": "Float64"}, "capacity": 8}, "unit": "rad/s2"}, {"name": "effort_min",
"wire": "effortMin", "type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 8},
"unit": "N.m"}, {"name": "effort_max", "wire": "effortMax", "type": {"kind": "list", "element": {
"kind": "Float64"}, "capacity": 8}, "unit": "N.m"}, {"name": "valid", "type": {"kind": "Bool"},
"default": false}]}, {"name": "robots::IntervalStatistics",
"doc": "Says how regularly a task ran, over its last window.", "fields": [{
"name": "period_average", "wire": "periodAverage", "type": {"kind": "Float64"}, "unit": "s",
"default": 0.0}, {"name": "period_deviation", "wire": "periodDeviation", "type": {"kind": "Float64"
}, "unit": "s", "default": 0.0}, {"name": "period_min", "wire": "periodMin", "type": {
"kind": "Float64"}, "unit": "s", "default": 0.0}, {"name": "period_max", "wire": "periodMax",
"type": {"kind": "Float64"}, "unit": "s", "default": 0.0}, {"name": "samples", "type": {
"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "valid", "type": {"kind": "Bool"}, "default": false}]}, {"name": "robots::Twist",
"doc": "A Twist is a velocity, as CRTK's measured_cv says it. Corresponds to cisst's\nprmVelocityCartesianGet.",
"fields": [{"name": "linear", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "m/s"}, {"name": "angular", "type": {"kind": "matrix", "scalar": "Float64",
"rows": 3, "columns": 1}, "unit": "rad/s"}, {"name": "moving_frame", "wire": "movingFrame",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "reference_frame", "wire": "referenceFrame",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}, {"name": "valid", "doc": "If it is false, do not use it.", "type": {
"kind": "Bool"}, "default": false}]}, {"name": "robots::Wrench",
"doc": "A Wrench is force and torque at the tool tip, as CRTK's measured_cf says it. Corresponds to\ncisst's prmForceCartesianGet.",
"fields": [{"name": "force", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1
}, "unit": "N"}, {"name": "torque", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "N.m"}, {"name": "mask", "doc": "Says which components are known.", "type": {
"kind": "array", "element": {"kind": "Bool"}, "length": 6}}, {"name": "moving_frame",
"wire": "movingFrame", "type": {"kind": "UInt32"}, "default": 0}, {"name": "reference_frame",
"wire": "referenceFrame", "type": {"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {
"kind": "time", "clock": "steady"}}, {"name": "valid", "doc": "If it is false, do not use it.",
"type": {"kind": "Bool"}, "default": false}]}, {"name": "robots::CartesianState",
"doc": "A CartesianState is pose, velocity and force of one instant, as CRTK's measured_cs says it.\nCorresponds to cisst's prmStateCartesian.",
"fields": [{"name": "moving_frame", "wire": "movingFrame", "type": {"kind": "UInt32"}, "default": 0
}, {"name": "reference_frame", "wire": "referenceFrame", "type": {"kind": "UInt32"}, "default": 0},
{"name": "position", "type": {"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {
"name": "position_is_valid", "wire": "positionIsValid", "type": {"kind": "Bool"}, "default": false
}, {"name": "linear_velocity", "wire": "linearVelocity", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}, "unit": "m/s"}, {"name": "angular_velocity",
"wire": "angularVelocity", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1
}, "unit": "rad/s"}, {"name": "velocity_is_valid", "wire": "velocityIsValid", "type": {
"kind": "Bool"}, "default": false}, {"name": "force", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}, "unit": "N"}, {"name": "torque", "type": {
"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}, "unit": "N.m"}, {
"name": "force_is_valid", "wire": "forceIsValid", "type": {"kind": "Bool"}, "default": false}, {
"name": "stamp", "type": {"kind": "time", "clock": "steady"}}]}, {"name": "robots::Jacobian",
"doc": "A Jacobian is 6 x joints, column-major: linear rows first, in m/s and rad/s per unit of joint\nvelocity.",
"fields": [{"name": "joints", "type": {"kind": "UInt32"}, "default": 0}, {"name": "coefficients",
"type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 48}}, {"name": "stamp",
"type": {"kind": "time", "clock": "steady"}}, {"name": "valid", "type": {"kind": "Bool"},
"default": false}]}, {"name": "robots::TransformStamped",
"doc": "Says where one frame is in another, for a reader that cannot know from the interface which they\nare.",
"fields": [{"name": "transform", "doc": "The moving frame is here in the reference frame.",
"type": {"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "reference_frame",
"wire": "referenceFrame", "doc": "Each is suture::frameId() of a frame's name; 0 means not named.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "moving_frame", "wire": "movingFrame", "type": {
"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "valid", "doc": "If it is false, do not use it.", "type": {"kind": "Bool"}, "default": false
}]}, {"name": "robots::JointVelocityGoal",
"doc": "A JointVelocityGoal is the goal of CRTK's servo_jv; corresponds to cisst's prmVelocityJointSet.",
"fields": [{"name": "goal", "type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 8
}, "unit": "rad/s"}, {"name": "acceleration", "doc": "The list may be empty.", "type": {
"kind": "list", "element": {"kind": "Float64"}, "capacity": 8}, "unit": "rad/s2"}, {
"name": "deceleration", "doc": "The list may be empty.", "type": {"kind": "list", "element": {
"kind": "Float64"}, "capacity": 8}, "unit": "rad/s2"}, {"name": "guard",
"doc": "The joints shall not pass these positions; the list may be empty.", "type": {
"kind": "list", "element": {"kind": "Float64"}, "capacity": 8}, "unit": "rad"}, {"name": "mask",
"doc": "The mask says which joints count; if it is empty, all do.", "type": {"kind": "list",
"element": {"kind": "Bool"}, "capacity": 8}}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}]}, {"name": "robots::JointEffortGoal",
"doc": "A JointEffortGoal is the goal of CRTK's servo_jf; corresponds to cisst's prmForceTorqueJointSet.",
"fields": [{"name": "effort", "type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 8
}, "unit": "N.m"}, {"name": "mask",
"doc": "The mask says which joints count; if it is empty, all do.", "type": {"kind": "list",
"element": {"kind": "Bool"}, "capacity": 8}}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}]}, {"name": "robots::TwistGoal",
"doc": "A TwistGoal is a velocity to follow, by CRTK's servo_cv. Corresponds to cisst's\nprmVelocityCartesianSet.",
"fields": [{"name": "linear", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "m/s"}, {"name": "angular", "type": {"kind": "matrix", "scalar": "Float64",
"rows": 3, "columns": 1}, "unit": "rad/s"}, {"name": "linear_acceleration",
"wire": "linearAcceleration", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "m/s2"}, {"name": "angular_acceleration", "wire": "angularAcceleration",
"type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}, "unit": "rad/s2"}, {
"name": "mask", "doc": "Says which of x, y, z and the rotations about them count.", "type": {
"kind": "array", "element": {"kind": "Bool"}, "length": 6}}, {"name": "stamp", "type": {
"kind": "time", "clock": "steady"}}]}, {"name": "robots::WrenchGoal",
"doc": "A WrenchGoal is force and torque to apply, by CRTK's servo_cf. Corresponds to cisst's\nprmForceCartesianSet.",
"fields": [{"name": "force", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1
}, "unit": "N"}, {"name": "torque", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "N.m"}, {"name": "mask", "doc": "Says which components count.", "type": {
"kind": "array", "element": {"kind": "Bool"}, "length": 6}}, {"name": "stamp", "type": {
"kind": "time", "clock": "steady"}}]}, {"name": "suture::Message", "fields": [{"name": "text",
"doc": "The text is UTF-8, for people. A sender cuts a longer text, and ends it in \"...\" then.",
"type": {"kind": "text", "capacity": 255}}, {"name": "code",
"doc": "Says what it is about, by numbers that its sender documents; 0 means nothing in particular.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "counter",
"doc": "Counts the messages of its sender, of all three kinds together, from 1. A gap says that the\nlistener has missed some; a number seen before says that the last one was sent again.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}]}], "wire": [{"id": "@0xd2a6fc6237d6fd07", "kind": "interface", "name": "Arm",
"cxx": "robots::Arm", "major": 2, "version": 2, "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xdcbc184d8af1d03c"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "enable", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "disable", "is": "kind \"void\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 3,
"name": "home", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 4, "name": "hold", "is": "kind \"void\"", "parameters": [
{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 5, "name": "servoCp",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "goal", "is": "@0xe84bc0a4b9a0c529"}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 6, "name": "servoJp",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "goal", "is": "@0x8943f2eac122865a"}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 7, "name": "moveJp",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "goal", "is": "@0x8943f2eac122865a"}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 8, "name": "measuredJs",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xac24dfe518a4963f"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 9, "name": "setpointJs", "is": "kind \"read\"", "parameters": [{"at": 0,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "@0xac24dfe518a4963f"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 10,
"name": "measuredCp", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xe84bc0a4b9a0c529"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 11, "name": "setpointCp",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xe84bc0a4b9a0c529"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 12, "name": "operatingState", "is": "kind \"read\"", "parameters": [{
"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "@0x8109968bd491318f"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 13,
"name": "forwardKinematics", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "q",
"is": "@0x8943f2eac122865a"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xe84bc0a4b9a0c529"}]}, {"at": 14,
"name": "inverseKinematics", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0,
"name": "goal", "is": "@0xe84bc0a4b9a0c529"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0x871d0a082eb81ee3"
}]}, {"at": 15, "name": "configurationJs", "is": "kind \"read\"", "parameters": [{"at": 0,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "@0xf723b5ed0dc2d63c"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 16,
"name": "periodStatistics", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xff815195ac6343a7"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 17, "name": "pause", "is": "kind \"void\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 18,
"name": "resume", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 19, "name": "unhome", "is": "kind \"void\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 20,
"name": "stateCommand", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "name",
"is": "Text"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 21,
"name": "goalJs", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xac24dfe518a4963f"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 22, "name": "goalCp", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xe84bc0a4b9a0c529"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 23, "name": "localMeasuredCp", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xe84bc0a4b9a0c529"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 24, "name": "localSetpointCp",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xe84bc0a4b9a0c529"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 25, "name": "measuredCv", "is": "kind \"read\"", "parameters": [{"at": 0,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "@0xaa62fba3aef11562"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 26,
"name": "setpointCv", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xaa62fba3aef11562"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 27, "name": "bodyMeasuredCf",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xdefffdcf07aeb2d1"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 28, "name": "spatialMeasuredCf", "is": "kind \"read\"", "parameters": [{
"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "@0xdefffdcf07aeb2d1"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 29,
"name": "measuredCs", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xe8c20fc8c27161a7"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 30, "name": "bodyJacobian",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0x9172ad0b0a6919ab"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 31, "name": "spatialJacobian", "is": "kind \"read\"", "parameters": [{
"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "@0x9172ad0b0a6919ab"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 32,
"name": "baseFrame", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xee7e9483e69ea03a"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 33, "name": "setBaseFrame",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "base", "is": "@0xee7e9483e69ea03a"}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 34, "name": "free",
"is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 35, "name": "useGravityCompensation", "is": "kind \"write\"", "parameters": [{"at": 0,
"name": "use", "is": "Bool"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 36, "name": "servoJr", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "step",
"is": "@0x8943f2eac122865a"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 37, "name": "servoJv", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "goal",
"is": "@0xf166e3d075579061"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 38, "name": "servoJf", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "goal",
"is": "@0xd704fc0995280ce6"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 39, "name": "servoCr", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "step",
"is": "@0xe84bc0a4b9a0c529"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 40, "name": "servoCv", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "goal",
"is": "@0xb9f9a4ea2665be7e"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 41, "name": "bodyServoCf", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "goal",
"is": "@0x913714b88c44b8c4"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 42, "name": "spatialServoCf", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "goal",
"is": "@0x913714b88c44b8c4"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 43, "name": "interpolateJp", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "goal",
"is": "@0x8943f2eac122865a"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 44, "name": "interpolateJr", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "step",
"is": "@0x8943f2eac122865a"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 45, "name": "interpolateCp", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "goal",
"is": "@0xe84bc0a4b9a0c529"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 46, "name": "interpolateCr", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "step",
"is": "@0xe84bc0a4b9a0c529"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 47, "name": "moveJr", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "step",
"is": "@0x8943f2eac122865a"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 48, "name": "moveCp", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "goal",
"is": "@0xe84bc0a4b9a0c529"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 49, "name": "moveCr", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "step",
"is": "@0xe84bc0a4b9a0c529"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 50, "name": "trajectoryJSetRatio", "is": "kind \"write\"", "parameters": [{"at": 0,
"name": "ratio", "is": "Float64"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 51, "name": "trajectoryJSetRatioV", "is": "kind \"write\"", "parameters": [{"at": 0,
"name": "ratio", "is": "Float64"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 52, "name": "trajectoryJSetRatioA", "is": "kind \"write\"", "parameters": [{"at": 0,
"name": "ratio", "is": "Float64"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 53, "name": "trajectoryJRatio", "is": "kind \"read\"", "parameters": [{"at": 0,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 54,
"name": "trajectoryJRatioV", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Float64"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 55, "name": "trajectoryJRatioA",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]
}, {"at": 56, "name": "queryCp", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0,
"name": "q", "is": "@0x8943f2eac122865a"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"
}], "results": [{"at": 0, "name": "value", "is": "@0xe84bc0a4b9a0c529"}]}, {"at": 57,
"name": "localQueryCp", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "q",
"is": "@0x8943f2eac122865a"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xe84bc0a4b9a0c529"}]}]}, {
"id": "@0xb16d80f0d2b50980", "kind": "interface", "name": "Messages", "cxx": "suture::Messages",
"members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0, "name": "events",
"is": "@0xa02813b154cdd1d8"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2,
"name": "stateMask", "is": "UInt64"}]}]}, {"id": "@0xa02813b154cdd1d8", "kind": "interface",
"name": "MessagesEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0x814f9864e019fa96"}]}, {"at": 1, "name": "status", "parameters": [{"at": 0,
"name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 2, "name": "warning", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"},
{"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 3, "name": "error", "parameters": [{"at": 0,
"name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0x814f9864e019fa96", "kind": "struct", "name": "MessagesStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}]}, {"id": "@0xbd6bc34f74980c5d", "kind": "struct",
"name": "Message", "members": [{"at": 0, "name": "text", "is": "Text"}, {"at": 1, "name": "code",
"is": "UInt32"}, {"at": 2, "name": "counter", "is": "UInt32"}, {"at": 3, "name": "stamp",
"is": "Int64 clock \"steady\""}]}, {"id": "@0xdcbc184d8af1d03c", "kind": "interface",
"name": "ArmEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row",
"is": "@0x8c45d754ae03e800"}]}, {"at": 1, "name": "operatingState", "parameters": [{"at": 0,
"name": "value", "is": "@0x8109968bd491318f"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 2, "name": "goalReached", "parameters": [{"at": 0, "name": "value", "is": "Bool"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}, {"at": 3, "name": "warning", "parameters": [{"at": 0,
"name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 4, "name": "status", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 5, "name": "error", "parameters": [{"at": 0,
"name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 6, "name": "desiredState", "parameters": [{"at": 0, "name": "value",
"is": "@0xc9ed1800ca1df7eb"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 7,
"name": "gravityCompensation", "parameters": [{"at": 0, "name": "value", "is": "Bool"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}, {"at": 8, "name": "trajectoryJRatio", "parameters": [{"at": 0,
"name": "value", "is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 9,
"name": "trajectoryJRatioV", "parameters": [{"at": 0, "name": "value", "is": "Float64"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}, {"at": 10, "name": "trajectoryJRatioA", "parameters": [{"at": 0,
"name": "value", "is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0x8c45d754ae03e800", "kind": "struct", "name": "ArmStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "measuredJs", "is": "@0xac24dfe518a4963f"}, {"at": 3, "name": "setpointJs",
"is": "@0xac24dfe518a4963f"}, {"at": 4, "name": "measuredCp", "is": "@0xe84bc0a4b9a0c529"}, {
"at": 5, "name": "setpointCp", "is": "@0xe84bc0a4b9a0c529"}, {"at": 6, "name": "operatingState",
"is": "@0x8109968bd491318f"}, {"at": 7, "name": "tooLarge", "is": "UInt64"}, {"at": 8,
"name": "configurationJs", "is": "@0xf723b5ed0dc2d63c"}, {"at": 9, "name": "periodStatistics",
"is": "@0xff815195ac6343a7"}, {"at": 10, "name": "goalJs", "is": "@0xac24dfe518a4963f"}, {"at": 11,
"name": "goalCp", "is": "@0xe84bc0a4b9a0c529"}, {"at": 12, "name": "localMeasuredCp",
"is": "@0xe84bc0a4b9a0c529"}, {"at": 13, "name": "localSetpointCp", "is": "@0xe84bc0a4b9a0c529"}, {
"at": 14, "name": "measuredCv", "is": "@0xaa62fba3aef11562"}, {"at": 15, "name": "setpointCv",
"is": "@0xaa62fba3aef11562"}, {"at": 16, "name": "bodyMeasuredCf", "is": "@0xdefffdcf07aeb2d1"}, {
"at": 17, "name": "spatialMeasuredCf", "is": "@0xdefffdcf07aeb2d1"}, {"at": 18,
"name": "measuredCs", "is": "@0xe8c20fc8c27161a7"}, {"at": 19, "name": "bodyJacobian",
"is": "@0x9172ad0b0a6919ab"}, {"at": 20, "name": "spatialJacobian", "is": "@0x9172ad0b0a6919ab"}, {
"at": 21, "name": "baseFrame", "is": "@0xee7e9483e69ea03a"}, {"at": 22, "name": "trajectoryJRatio",
"is": "Float64"}, {"at": 23, "name": "trajectoryJRatioV", "is": "Float64"}, {"at": 24,
"name": "trajectoryJRatioA", "is": "Float64"}]}, {"id": "@0xac24dfe518a4963f", "kind": "struct",
"name": "JointState", "members": [{"at": 0, "name": "name", "is": "List(Text)"}, {"at": 1,
"name": "position", "is": "List(Float64) unit \"rad\""}, {"at": 2, "name": "velocity",
"is": "List(Float64) unit \"rad/s\""}, {"at": 3, "name": "effort",
"is": "List(Float64) unit \"N.m\""}, {"at": 4, "name": "stamp", "is": "Int64 clock \"steady\""}, {
"at": 5, "name": "valid", "is": "Bool"}]}, {"id": "@0xe84bc0a4b9a0c529", "kind": "struct",
"name": "PoseStamped", "members": [{"at": 0, "name": "pose",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 1, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 2, "name": "valid", "is": "Bool"}]}, {
"id": "@0x8109968bd491318f", "kind": "struct", "name": "OperatingState", "members": [{"at": 0,
"name": "state", "is": "@0xc9ed1800ca1df7eb"}, {"at": 1, "name": "subState", "is": "Text"}, {
"at": 2, "name": "isHomed", "is": "Bool"}, {"at": 3, "name": "isBusy", "is": "Bool"}, {"at": 4,
"name": "stamp", "is": "Int64 clock \"steady\""}]}, {"id": "@0xc9ed1800ca1df7eb", "kind": "enum",
"name": "ArmState", "members": [{"at": 0, "name": "undefined"}, {"at": 1, "name": "disabled"}, {
"at": 2, "name": "enabled"}, {"at": 3, "name": "paused"}, {"at": 4, "name": "fault"}]}, {
"id": "@0xf723b5ed0dc2d63c", "kind": "struct", "name": "JointConfiguration", "members": [{"at": 0,
"name": "name", "is": "List(Text)"}, {"at": 1, "name": "type", "is": "List(@0x9f3bef15df1181c0)"}, {
"at": 2, "name": "positionMin", "is": "List(Float64) unit \"rad\""}, {"at": 3,
"name": "positionMax", "is": "List(Float64) unit \"rad\""}, {"at": 4, "name": "velocityMin",
"is": "List(Float64) unit \"rad/s\""}, {"at": 5, "name": "velocityMax",
"is": "List(Float64) unit \"rad/s\""}, {"at": 6, "name": "accelerationMin",
"is": "List(Float64) unit \"rad/s2\""}, {"at": 7, "name": "accelerationMax",
"is": "List(Float64) unit \"rad/s2\""}, {"at": 8, "name": "effortMin",
"is": "List(Float64) unit \"N.m\""}, {"at": 9, "name": "effortMax",
"is": "List(Float64) unit \"N.m\""}, {"at": 10, "name": "valid", "is": "Bool"}]}, {
"id": "@0x9f3bef15df1181c0", "kind": "enum", "name": "JointType", "members": [{"at": 0,
"name": "undefined"}, {"at": 1, "name": "prismatic"}, {"at": 2, "name": "revolute"}, {"at": 3,
"name": "universal"}, {"at": 4, "name": "ballSocket"}, {"at": 5, "name": "inactive"}]}, {
"id": "@0xff815195ac6343a7", "kind": "struct", "name": "IntervalStatistics", "members": [{"at": 0,
"name": "periodAverage", "is": "Float64 unit \"s\""}, {"at": 1, "name": "periodDeviation",
"is": "Float64 unit \"s\""}, {"at": 2, "name": "periodMin", "is": "Float64 unit \"s\""}, {"at": 3,
"name": "periodMax", "is": "Float64 unit \"s\""}, {"at": 4, "name": "samples", "is": "UInt32"}, {
"at": 5, "name": "stamp", "is": "Int64 clock \"steady\""}, {"at": 6, "name": "valid", "is": "Bool"}
]}, {"id": "@0xaa62fba3aef11562", "kind": "struct", "name": "Twist", "members": [{"at": 0,
"name": "linear", "is": "/suture/types.capnp:Vec3 unit \"m/s\""}, {"at": 1, "name": "angular",
"is": "/suture/types.capnp:Vec3 unit \"rad/s\""}, {"at": 2, "name": "movingFrame", "is": "UInt32"},
{"at": 3, "name": "referenceFrame", "is": "UInt32"}, {"at": 4, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 5, "name": "valid", "is": "Bool"}]}, {
"id": "@0xdefffdcf07aeb2d1", "kind": "struct", "name": "Wrench", "members": [{"at": 0,
"name": "force", "is": "/suture/types.capnp:Vec3 unit \"N\""}, {"at": 1, "name": "torque",
"is": "/suture/types.capnp:Vec3 unit \"N.m\""}, {"at": 2, "name": "mask",
"is": "List(Bool) shape \"6\""}, {"at": 3, "name": "movingFrame", "is": "UInt32"}, {"at": 4,
"name": "referenceFrame", "is": "UInt32"}, {"at": 5, "name": "stamp", "is": "Int64 clock \"steady\""
}, {"at": 6, "name": "valid", "is": "Bool"}]}, {"id": "@0xe8c20fc8c27161a7", "kind": "struct",
"name": "CartesianState", "members": [{"at": 0, "name": "movingFrame", "is": "UInt32"}, {"at": 1,
"name": "referenceFrame", "is": "UInt32"}, {"at": 2, "name": "position",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 3, "name": "positionIsValid", "is": "Bool"}, {
"at": 4, "name": "linearVelocity", "is": "/suture/types.capnp:Vec3 unit \"m/s\""}, {"at": 5,
"name": "angularVelocity", "is": "/suture/types.capnp:Vec3 unit \"rad/s\""}, {"at": 6,
"name": "velocityIsValid", "is": "Bool"}, {"at": 7, "name": "force",
"is": "/suture/types.capnp:Vec3 unit \"N\""}, {"at": 8, "name": "torque",
"is": "/suture/types.capnp:Vec3 unit \"N.m\""}, {"at": 9, "name": "forceIsValid", "is": "Bool"}, {
"at": 10, "name": "stamp", "is": "Int64 clock \"steady\""}]}, {"id": "@0x9172ad0b0a6919ab",
"kind": "struct", "name": "Jacobian", "members": [{"at": 0, "name": "joints", "is": "UInt32"}, {
"at": 1, "name": "coefficients", "is": "List(Float64)"}, {"at": 2, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 3, "name": "valid", "is": "Bool"}]}, {
"id": "@0xee7e9483e69ea03a", "kind": "struct", "name": "TransformStamped", "members": [{"at": 0,
"name": "transform", "is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 1,
"name": "referenceFrame", "is": "UInt32"}, {"at": 2, "name": "movingFrame", "is": "UInt32"}, {
"at": 3, "name": "stamp", "is": "Int64 clock \"steady\""}, {"at": 4, "name": "valid", "is": "Bool"}
]}, {"id": "@0x8943f2eac122865a", "kind": "struct", "name": "JointGoal", "members": [{"at": 0,
"name": "position", "is": "List(Float64) unit \"rad\""}, {"at": 1, "name": "stamp",
"is": "Int64 clock \"steady\""}]}, {"id": "@0x871d0a082eb81ee3", "kind": "struct",
"name": "JointSolution", "members": [{"at": 0, "name": "position",
"is": "List(Float64) unit \"rad\" shape \"8\""}, {"at": 1, "name": "joints", "is": "UInt32"}, {
"at": 2, "name": "found", "is": "Bool"}]}, {"id": "@0xf166e3d075579061", "kind": "struct",
"name": "JointVelocityGoal", "members": [{"at": 0, "name": "goal",
"is": "List(Float64) unit \"rad/s\""}, {"at": 1, "name": "acceleration",
"is": "List(Float64) unit \"rad/s2\""}, {"at": 2, "name": "deceleration",
"is": "List(Float64) unit \"rad/s2\""}, {"at": 3, "name": "guard",
"is": "List(Float64) unit \"rad\""}, {"at": 4, "name": "mask", "is": "List(Bool)"}, {"at": 5,
"name": "stamp", "is": "Int64 clock \"steady\""}]}, {"id": "@0xd704fc0995280ce6", "kind": "struct",
"name": "JointEffortGoal", "members": [{"at": 0, "name": "effort",
"is": "List(Float64) unit \"N.m\""}, {"at": 1, "name": "mask", "is": "List(Bool)"}, {"at": 2,
"name": "stamp", "is": "Int64 clock \"steady\""}]}, {"id": "@0xb9f9a4ea2665be7e", "kind": "struct",
"name": "TwistGoal", "members": [{"at": 0, "name": "linear",
"is": "/suture/types.capnp:Vec3 unit \"m/s\""}, {"at": 1, "name": "angular",
"is": "/suture/types.capnp:Vec3 unit \"rad/s\""}, {"at": 2, "name": "linearAcceleration",
"is": "/suture/types.capnp:Vec3 unit \"m/s2\""}, {"at": 3, "name": "angularAcceleration",
"is": "/suture/types.capnp:Vec3 unit \"rad/s2\""}, {"at": 4, "name": "mask",
"is": "List(Bool) shape \"6\""}, {"at": 5, "name": "stamp", "is": "Int64 clock \"steady\""}]}, {
"id": "@0x913714b88c44b8c4", "kind": "struct", "name": "WrenchGoal", "members": [{"at": 0,
"name": "force", "is": "/suture/types.capnp:Vec3 unit \"N\""}, {"at": 1, "name": "torque",
"is": "/suture/types.capnp:Vec3 unit \"N.m\""}, {"at": 2, "name": "mask",
"is": "List(Bool) shape \"6\""}, {"at": 3, "name": "stamp", "is": "Int64 clock \"steady\""}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Arm>() {
  static const auto kEvents = extended<10>(interfaceInfo<suture::Messages>().events,
                                           robots::kArmEvents);
  static const InterfaceInfo kInfo{
      .name = "robots::Arm",
      .hash = "1f5d06412eacd0fd4ccda12e8a351a33",
      .description = robots::kArmDescription,
      .commands = robots::kArmCommands,
      .events = kEvents,
      .codec = &robots::armCodec,
      .base = &interfaceInfo<suture::Messages>,
      .toBase = &castToBase<robots::Arm, suture::Messages>,
      .wireEvents = robots::kArmWireEvents,
  };
  return kInfo;
}

auto Provided<robots::Arm>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(robots::ArmServoJpArguments::goal)>(scratch.servo_jp_goal);
  reserveFor<decltype(robots::ArmMoveJpArguments::goal)>(scratch.move_jp_goal);
  reserveFor<decltype(robots::ArmForwardKinematicsArguments::q)>(scratch.forward_kinematics_q);
  reserveFor<decltype(robots::ArmStateCommandArguments::name)>(scratch.state_command_name);
  reserveFor<decltype(robots::ArmServoJrArguments::step)>(scratch.servo_jr_step);
  reserveFor<decltype(robots::ArmServoJvArguments::goal)>(scratch.servo_jv_goal);
  reserveFor<decltype(robots::ArmServoJfArguments::goal)>(scratch.servo_jf_goal);
  reserveFor<decltype(robots::ArmInterpolateJpArguments::goal)>(scratch.interpolate_jp_goal);
  reserveFor<decltype(robots::ArmInterpolateJrArguments::step)>(scratch.interpolate_jr_step);
  reserveFor<decltype(robots::ArmMoveJrArguments::step)>(scratch.move_jr_step);
  reserveFor<decltype(robots::ArmQueryCpArguments::q)>(scratch.query_cp_q);
  reserveFor<decltype(robots::ArmLocalQueryCpArguments::q)>(scratch.local_query_cp_q);
  return scratch;
}

// A function for each command of robots::Arm, so that a stack in a debugger names it.
struct Provided<robots::Arm>::Dispatch {
  static Errc execute_enable(Contract& implementation) {
    implementation.enable();
    return Errc{};
  }

  static Errc execute_disable(Contract& implementation) {
    implementation.disable();
    return Errc{};
  }

  static Errc execute_home(Contract& implementation) {
    implementation.home();
    return Errc{};
  }

  static Errc execute_hold(Contract& implementation) {
    implementation.hold();
    return Errc{};
  }

  static Errc execute_servo_cp(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmServoCpArguments>(arguments);
    load(slot.goal, scratch.servo_cp_goal);
    implementation.servo_cp(scratch.servo_cp_goal);
    return Errc{};
  }

  static Errc execute_servo_jp(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmServoJpArguments>(arguments);
    load(slot.goal, scratch.servo_jp_goal);
    implementation.servo_jp(scratch.servo_jp_goal);
    return Errc{};
  }

  static Errc execute_move_jp(Contract& implementation, Scratch& scratch,
                              const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmMoveJpArguments>(arguments);
    load(slot.goal, scratch.move_jp_goal);
    implementation.move_jp(scratch.move_jp_goal);
    return Errc{};
  }

  static Errc execute_measured_js(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::JointStateSlot>(result);
    return store(implementation.measured_js(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_setpoint_js(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::JointStateSlot>(result);
    return store(implementation.setpoint_js(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_measured_cp(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PoseStampedSlot>(result);
    return store(implementation.measured_cp(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_setpoint_cp(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PoseStampedSlot>(result);
    return store(implementation.setpoint_cp(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_operating_state(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::OperatingStateSlot>(result);
    return store(implementation.operating_state(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_forward_kinematics(Contract& implementation, Scratch& scratch,
                                         const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<robots::ArmForwardKinematicsArguments>(arguments);
    load(slot.q, scratch.forward_kinematics_q);
    auto& answer = newSlot<robots::PoseStampedSlot>(result);
    return store(implementation.forward_kinematics(scratch.forward_kinematics_q), answer)
        ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_inverse_kinematics(Contract& implementation, Scratch& scratch,
                                         const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<robots::ArmInverseKinematicsArguments>(arguments);
    load(slot.goal, scratch.inverse_kinematics_goal);
    auto& answer = newSlot<robots::JointSolutionSlot>(result);
    return store(implementation.inverse_kinematics(scratch.inverse_kinematics_goal), answer)
        ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_configuration_js(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::JointConfigurationSlot>(result);
    return store(implementation.configuration_js(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_period_statistics(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::IntervalStatisticsSlot>(result);
    return store(implementation.period_statistics(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_pause(Contract& implementation) {
    implementation.pause();
    return Errc{};
  }

  static Errc execute_resume(Contract& implementation) {
    implementation.resume();
    return Errc{};
  }

  static Errc execute_unhome(Contract& implementation) {
    implementation.unhome();
    return Errc{};
  }

  static Errc execute_state_command(Contract& implementation, Scratch& scratch,
                                    const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmStateCommandArguments>(arguments);
    load(slot.name, scratch.state_command_name);
    implementation.state_command(scratch.state_command_name);
    return Errc{};
  }

  static Errc execute_goal_js(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::JointStateSlot>(result);
    return store(implementation.goal_js(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_goal_cp(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PoseStampedSlot>(result);
    return store(implementation.goal_cp(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_local_measured_cp(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PoseStampedSlot>(result);
    return store(implementation.local_measured_cp(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_local_setpoint_cp(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PoseStampedSlot>(result);
    return store(implementation.local_setpoint_cp(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_measured_cv(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::TwistSlot>(result);
    return store(implementation.measured_cv(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_setpoint_cv(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::TwistSlot>(result);
    return store(implementation.setpoint_cv(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_body_measured_cf(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::WrenchSlot>(result);
    return store(implementation.body_measured_cf(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_spatial_measured_cf(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::WrenchSlot>(result);
    return store(implementation.spatial_measured_cf(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_measured_cs(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::CartesianStateSlot>(result);
    return store(implementation.measured_cs(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_body_jacobian(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::JacobianSlot>(result);
    return store(implementation.body_jacobian(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_spatial_jacobian(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::JacobianSlot>(result);
    return store(implementation.spatial_jacobian(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_base_frame(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::TransformStampedSlot>(result);
    return store(implementation.base_frame(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_set_base_frame(Contract& implementation, Scratch& scratch,
                                     const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmSetBaseFrameArguments>(arguments);
    load(slot.base, scratch.set_base_frame_base);
    implementation.set_base_frame(scratch.set_base_frame_base);
    return Errc{};
  }

  static Errc execute_free(Contract& implementation) {
    implementation.free();
    return Errc{};
  }

  static Errc execute_use_gravity_compensation(Contract& implementation, Scratch& scratch,
                                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmUseGravityCompensationArguments>(arguments);
    load(slot.use, scratch.use_gravity_compensation_use);
    implementation.use_gravity_compensation(scratch.use_gravity_compensation_use);
    return Errc{};
  }

  static Errc execute_servo_jr(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmServoJrArguments>(arguments);
    load(slot.step, scratch.servo_jr_step);
    implementation.servo_jr(scratch.servo_jr_step);
    return Errc{};
  }

  static Errc execute_servo_jv(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmServoJvArguments>(arguments);
    load(slot.goal, scratch.servo_jv_goal);
    implementation.servo_jv(scratch.servo_jv_goal);
    return Errc{};
  }

  static Errc execute_servo_jf(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmServoJfArguments>(arguments);
    load(slot.goal, scratch.servo_jf_goal);
    implementation.servo_jf(scratch.servo_jf_goal);
    return Errc{};
  }

  static Errc execute_servo_cr(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmServoCrArguments>(arguments);
    load(slot.step, scratch.servo_cr_step);
    implementation.servo_cr(scratch.servo_cr_step);
    return Errc{};
  }

  static Errc execute_servo_cv(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmServoCvArguments>(arguments);
    load(slot.goal, scratch.servo_cv_goal);
    implementation.servo_cv(scratch.servo_cv_goal);
    return Errc{};
  }

  static Errc execute_body_servo_cf(Contract& implementation, Scratch& scratch,
                                    const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmBodyServoCfArguments>(arguments);
    load(slot.goal, scratch.body_servo_cf_goal);
    implementation.body_servo_cf(scratch.body_servo_cf_goal);
    return Errc{};
  }

  static Errc execute_spatial_servo_cf(Contract& implementation, Scratch& scratch,
                                       const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmSpatialServoCfArguments>(arguments);
    load(slot.goal, scratch.spatial_servo_cf_goal);
    implementation.spatial_servo_cf(scratch.spatial_servo_cf_goal);
    return Errc{};
  }

  static Errc execute_interpolate_jp(Contract& implementation, Scratch& scratch,
                                     const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmInterpolateJpArguments>(arguments);
    load(slot.goal, scratch.interpolate_jp_goal);
    implementation.interpolate_jp(scratch.interpolate_jp_goal);
    return Errc{};
  }

  static Errc execute_interpolate_jr(Contract& implementation, Scratch& scratch,
                                     const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmInterpolateJrArguments>(arguments);
    load(slot.step, scratch.interpolate_jr_step);
    implementation.interpolate_jr(scratch.interpolate_jr_step);
    return Errc{};
  }

  static Errc execute_interpolate_cp(Contract& implementation, Scratch& scratch,
                                     const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmInterpolateCpArguments>(arguments);
    load(slot.goal, scratch.interpolate_cp_goal);
    implementation.interpolate_cp(scratch.interpolate_cp_goal);
    return Errc{};
  }

  static Errc execute_interpolate_cr(Contract& implementation, Scratch& scratch,
                                     const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmInterpolateCrArguments>(arguments);
    load(slot.step, scratch.interpolate_cr_step);
    implementation.interpolate_cr(scratch.interpolate_cr_step);
    return Errc{};
  }

  static Errc execute_move_jr(Contract& implementation, Scratch& scratch,
                              const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmMoveJrArguments>(arguments);
    load(slot.step, scratch.move_jr_step);
    implementation.move_jr(scratch.move_jr_step);
    return Errc{};
  }

  static Errc execute_move_cp(Contract& implementation, Scratch& scratch,
                              const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmMoveCpArguments>(arguments);
    load(slot.goal, scratch.move_cp_goal);
    implementation.move_cp(scratch.move_cp_goal);
    return Errc{};
  }

  static Errc execute_move_cr(Contract& implementation, Scratch& scratch,
                              const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmMoveCrArguments>(arguments);
    load(slot.step, scratch.move_cr_step);
    implementation.move_cr(scratch.move_cr_step);
    return Errc{};
  }

  static Errc execute_trajectory_j_set_ratio(Contract& implementation, Scratch& scratch,
                                             const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmTrajectoryJSetRatioArguments>(arguments);
    load(slot.ratio, scratch.trajectory_j_set_ratio_ratio);
    implementation.trajectory_j_set_ratio(scratch.trajectory_j_set_ratio_ratio);
    return Errc{};
  }

  static Errc execute_trajectory_j_set_ratio_v(Contract& implementation, Scratch& scratch,
                                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmTrajectoryJSetRatioVArguments>(arguments);
    load(slot.ratio, scratch.trajectory_j_set_ratio_v_ratio);
    implementation.trajectory_j_set_ratio_v(scratch.trajectory_j_set_ratio_v_ratio);
    return Errc{};
  }

  static Errc execute_trajectory_j_set_ratio_a(Contract& implementation, Scratch& scratch,
                                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmTrajectoryJSetRatioAArguments>(arguments);
    load(slot.ratio, scratch.trajectory_j_set_ratio_a_ratio);
    implementation.trajectory_j_set_ratio_a(scratch.trajectory_j_set_ratio_a_ratio);
    return Errc{};
  }

  static Errc execute_trajectory_j_ratio(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<double>(result);
    return store(implementation.trajectory_j_ratio(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_trajectory_j_ratio_v(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<double>(result);
    return store(implementation.trajectory_j_ratio_v(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_trajectory_j_ratio_a(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<double>(result);
    return store(implementation.trajectory_j_ratio_a(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_query_cp(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<robots::ArmQueryCpArguments>(arguments);
    load(slot.q, scratch.query_cp_q);
    auto& answer = newSlot<robots::PoseStampedSlot>(result);
    return store(implementation.query_cp(scratch.query_cp_q), answer) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_local_query_cp(Contract& implementation, Scratch& scratch,
                                     const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<robots::ArmLocalQueryCpArguments>(arguments);
    load(slot.q, scratch.local_query_cp_q);
    auto& answer = newSlot<robots::PoseStampedSlot>(result);
    return store(implementation.local_query_cp(scratch.local_query_cp_q), answer)
        ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::Arm>::execute(std::uint16_t command, const std::byte* arguments,
                                    std::byte* result) {
  using ::robots::ArmCommand;
  switch (command) {
    case ArmCommand::enable: return Dispatch::execute_enable(implementation_);
    case ArmCommand::disable: return Dispatch::execute_disable(implementation_);
    case ArmCommand::home: return Dispatch::execute_home(implementation_);
    case ArmCommand::hold: return Dispatch::execute_hold(implementation_);
    case ArmCommand::servo_cp:
      return Dispatch::execute_servo_cp(implementation_, scratch_, arguments);
    case ArmCommand::servo_jp:
      return Dispatch::execute_servo_jp(implementation_, scratch_, arguments);
    case ArmCommand::move_jp:
      return Dispatch::execute_move_jp(implementation_, scratch_, arguments);
    case ArmCommand::measured_js: return Dispatch::execute_measured_js(implementation_, result);
    case ArmCommand::setpoint_js: return Dispatch::execute_setpoint_js(implementation_, result);
    case ArmCommand::measured_cp: return Dispatch::execute_measured_cp(implementation_, result);
    case ArmCommand::setpoint_cp: return Dispatch::execute_setpoint_cp(implementation_, result);
    case ArmCommand::operating_state:
      return Dispatch::execute_operating_state(implementation_, result);
    case ArmCommand::forward_kinematics:
      return Dispatch::execute_forward_kinematics(implementation_, scratch_, arguments, result);
    case ArmCommand::inverse_kinematics:
      return Dispatch::execute_inverse_kinematics(implementation_, scratch_, arguments, result);
    case ArmCommand::configuration_js:
      return Dispatch::execute_configuration_js(implementation_, result);
    case ArmCommand::period_statistics:
      return Dispatch::execute_period_statistics(implementation_, result);
    case ArmCommand::pause: return Dispatch::execute_pause(implementation_);
    case ArmCommand::resume: return Dispatch::execute_resume(implementation_);
    case ArmCommand::unhome: return Dispatch::execute_unhome(implementation_);
    case ArmCommand::state_command:
      return Dispatch::execute_state_command(implementation_, scratch_, arguments);
    case ArmCommand::goal_js: return Dispatch::execute_goal_js(implementation_, result);
    case ArmCommand::goal_cp: return Dispatch::execute_goal_cp(implementation_, result);
    case ArmCommand::local_measured_cp:
      return Dispatch::execute_local_measured_cp(implementation_, result);
    case ArmCommand::local_setpoint_cp:
      return Dispatch::execute_local_setpoint_cp(implementation_, result);
    case ArmCommand::measured_cv: return Dispatch::execute_measured_cv(implementation_, result);
    case ArmCommand::setpoint_cv: return Dispatch::execute_setpoint_cv(implementation_, result);
    case ArmCommand::body_measured_cf:
      return Dispatch::execute_body_measured_cf(implementation_, result);
    case ArmCommand::spatial_measured_cf:
      return Dispatch::execute_spatial_measured_cf(implementation_, result);
    case ArmCommand::measured_cs: return Dispatch::execute_measured_cs(implementation_, result);
    case ArmCommand::body_jacobian: return Dispatch::execute_body_jacobian(implementation_, result);
    case ArmCommand::spatial_jacobian:
      return Dispatch::execute_spatial_jacobian(implementation_, result);
    case ArmCommand::base_frame: return Dispatch::execute_base_frame(implementation_, result);
    case ArmCommand::set_base_frame:
      return Dispatch::execute_set_base_frame(implementation_, scratch_, arguments);
    case ArmCommand::free: return Dispatch::execute_free(implementation_);
    case ArmCommand::use_gravity_compensation:
      return Dispatch::execute_use_gravity_compensation(implementation_, scratch_, arguments);
    case ArmCommand::servo_jr:
      return Dispatch::execute_servo_jr(implementation_, scratch_, arguments);
    case ArmCommand::servo_jv:
      return Dispatch::execute_servo_jv(implementation_, scratch_, arguments);
    case ArmCommand::servo_jf:
      return Dispatch::execute_servo_jf(implementation_, scratch_, arguments);
    case ArmCommand::servo_cr:
      return Dispatch::execute_servo_cr(implementation_, scratch_, arguments);
    case ArmCommand::servo_cv:
      return Dispatch::execute_servo_cv(implementation_, scratch_, arguments);
    case ArmCommand::body_servo_cf:
      return Dispatch::execute_body_servo_cf(implementation_, scratch_, arguments);
    case ArmCommand::spatial_servo_cf:
      return Dispatch::execute_spatial_servo_cf(implementation_, scratch_, arguments);
    case ArmCommand::interpolate_jp:
      return Dispatch::execute_interpolate_jp(implementation_, scratch_, arguments);
    case ArmCommand::interpolate_jr:
      return Dispatch::execute_interpolate_jr(implementation_, scratch_, arguments);
    case ArmCommand::interpolate_cp:
      return Dispatch::execute_interpolate_cp(implementation_, scratch_, arguments);
    case ArmCommand::interpolate_cr:
      return Dispatch::execute_interpolate_cr(implementation_, scratch_, arguments);
    case ArmCommand::move_jr:
      return Dispatch::execute_move_jr(implementation_, scratch_, arguments);
    case ArmCommand::move_cp:
      return Dispatch::execute_move_cp(implementation_, scratch_, arguments);
    case ArmCommand::move_cr:
      return Dispatch::execute_move_cr(implementation_, scratch_, arguments);
    case ArmCommand::trajectory_j_set_ratio:
      return Dispatch::execute_trajectory_j_set_ratio(implementation_, scratch_, arguments);
    case ArmCommand::trajectory_j_set_ratio_v:
      return Dispatch::execute_trajectory_j_set_ratio_v(implementation_, scratch_, arguments);
    case ArmCommand::trajectory_j_set_ratio_a:
      return Dispatch::execute_trajectory_j_set_ratio_a(implementation_, scratch_, arguments);
    case ArmCommand::trajectory_j_ratio:
      return Dispatch::execute_trajectory_j_ratio(implementation_, result);
    case ArmCommand::trajectory_j_ratio_v:
      return Dispatch::execute_trajectory_j_ratio_v(implementation_, result);
    case ArmCommand::trajectory_j_ratio_a:
      return Dispatch::execute_trajectory_j_ratio_a(implementation_, result);
    case ArmCommand::query_cp:
      return Dispatch::execute_query_cp(implementation_, scratch_, arguments, result);
    case ArmCommand::local_query_cp:
      return Dispatch::execute_local_query_cp(implementation_, scratch_, arguments, result);
  }
  return Provided<suture::Messages>::execute(command, arguments, result);
}

}  // namespace suture
