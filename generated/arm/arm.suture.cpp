// Written by suturec from arm/arm.h. Do not edit.
#include "arm/arm.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "arm/arm.capnp.h"

// Defined in robot_types/cartesian.suture.cpp.
namespace robots {
void toWire(const CartesianStateSlot& slot, wire::CartesianState::Builder out);
suture::Errc fromWire(wire::CartesianState::Reader in, CartesianStateSlot& slot,
                      suture::Duration shift);
bool isValid(const CartesianStateSlot& slot, suture::FieldPath* path);
void toWire(const TwistSlot& slot, wire::Twist::Builder out);
suture::Errc fromWire(wire::Twist::Reader in, TwistSlot& slot, suture::Duration shift);
bool isValid(const TwistSlot& slot, suture::FieldPath* path);
void toWire(const TwistGoalSlot& slot, wire::TwistGoal::Builder out);
suture::Errc fromWire(wire::TwistGoal::Reader in, TwistGoalSlot& slot, suture::Duration shift);
bool isValid(const TwistGoalSlot& slot, suture::FieldPath* path);
void toWire(const WrenchSlot& slot, wire::Wrench::Builder out);
suture::Errc fromWire(wire::Wrench::Reader in, WrenchSlot& slot, suture::Duration shift);
bool isValid(const WrenchSlot& slot, suture::FieldPath* path);
void toWire(const WrenchGoalSlot& slot, wire::WrenchGoal::Builder out);
suture::Errc fromWire(wire::WrenchGoal::Reader in, WrenchGoalSlot& slot, suture::Duration shift);
bool isValid(const WrenchGoalSlot& slot, suture::FieldPath* path);
}  // namespace robots

// Defined in robot_types/joint_commands.suture.cpp.
namespace robots {
void toWire(const JacobianSlot& slot, wire::Jacobian::Builder out);
suture::Errc fromWire(wire::Jacobian::Reader in, JacobianSlot& slot, suture::Duration shift);
bool isValid(const JacobianSlot& slot, suture::FieldPath* path);
void toWire(const JointConfigurationSlot& slot, wire::JointConfiguration::Builder out);
suture::Errc fromWire(wire::JointConfiguration::Reader in, JointConfigurationSlot& slot,
                      suture::Duration shift);
bool isValid(const JointConfigurationSlot& slot, suture::FieldPath* path);
void toWire(const JointEffortGoalSlot& slot, wire::JointEffortGoal::Builder out);
suture::Errc fromWire(wire::JointEffortGoal::Reader in, JointEffortGoalSlot& slot,
                      suture::Duration shift);
bool isValid(const JointEffortGoalSlot& slot, suture::FieldPath* path);
void toWire(const JointVelocityGoalSlot& slot, wire::JointVelocityGoal::Builder out);
suture::Errc fromWire(wire::JointVelocityGoal::Reader in, JointVelocityGoalSlot& slot,
                      suture::Duration shift);
bool isValid(const JointVelocityGoalSlot& slot, suture::FieldPath* path);
}  // namespace robots

// Defined in robot_types/joints.suture.cpp.
namespace robots {
void toWire(const JointGoalSlot& slot, wire::JointGoal::Builder out);
suture::Errc fromWire(wire::JointGoal::Reader in, JointGoalSlot& slot, suture::Duration shift);
bool isValid(const JointGoalSlot& slot, suture::FieldPath* path);
void toWire(const JointSolutionSlot& slot, wire::JointSolution::Builder out);
suture::Errc fromWire(wire::JointSolution::Reader in, JointSolutionSlot& slot,
                      suture::Duration shift);
bool isValid(const JointSolutionSlot& slot, suture::FieldPath* path);
void toWire(const JointStateSlot& slot, wire::JointState::Builder out);
suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration shift);
bool isValid(const JointStateSlot& slot, suture::FieldPath* path);
}  // namespace robots

// Defined in robot_types/messages.suture.cpp.
namespace robots {
void toWire(const IntervalStatisticsSlot& slot, wire::IntervalStatistics::Builder out);
suture::Errc fromWire(wire::IntervalStatistics::Reader in, IntervalStatisticsSlot& slot,
                      suture::Duration shift);
bool isValid(const IntervalStatisticsSlot& slot, suture::FieldPath* path);
}  // namespace robots

// Defined in robot_types/operating_state.suture.cpp.
namespace robots {
wire::ArmState wireArmState(std::uint8_t slot);
bool isKnownArmState(std::uint8_t slot);
suture::Errc fromWire(wire::ArmState in, std::uint8_t& slot);
void toWire(const OperatingStateSlot& slot, wire::OperatingState::Builder out);
suture::Errc fromWire(wire::OperatingState::Reader in, OperatingStateSlot& slot,
                      suture::Duration shift);
bool isValid(const OperatingStateSlot& slot, suture::FieldPath* path);
}  // namespace robots

// Defined in robot_types/pose.suture.cpp.
namespace robots {
void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out);
suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift);
bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path);
void toWire(const TransformStampedSlot& slot, wire::TransformStamped::Builder out);
suture::Errc fromWire(wire::TransformStamped::Reader in, TransformStampedSlot& slot,
                      suture::Duration shift);
bool isValid(const TransformStampedSlot& slot, suture::FieldPath* path);
}  // namespace robots

// Defined in suture/standard/messages.suture.cpp.
namespace suture {
void toWire(const MessageSlot& slot, wire::Message::Builder out);
suture::Errc fromWire(wire::Message::Reader in, MessageSlot& slot, suture::Duration shift);
bool isValid(const MessageSlot& slot, suture::FieldPath* path);
}  // namespace suture

namespace robots {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Duration;
using suture::Errc;
using suture::EventInfo;
using suture::FieldPath;
using suture::checkSlot;
using suture::newSlot;
using suture::refusedAt;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::fromWire;
using suture::rpc::inRange;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::shiftSlot;
using suture::slotIn;
using suture::slotSize;
using suture::store;

bool store(const PoseStamped& goal, ArmServoCpArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(ArmServoCpArguments& slot, Duration shift) { shiftStamps(slot.goal, shift); }

bool store(const JointGoal& goal, ArmServoJpArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(ArmServoJpArguments& slot, Duration shift) { shiftStamps(slot.goal, shift); }

bool store(const JointGoal& goal, ArmMoveJpArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(ArmMoveJpArguments& slot, Duration shift) { shiftStamps(slot.goal, shift); }

bool store(const JointGoal& q, ArmForwardKinematicsArguments& slot) { return store(q, slot.q); }

void shiftStamps(ArmForwardKinematicsArguments& slot, Duration shift) {
  shiftStamps(slot.q, shift);
}

bool store(const PoseStamped& goal, ArmInverseKinematicsArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmInverseKinematicsArguments& slot, Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const std::string& name, ArmStateCommandArguments& slot) {
  return store(name, slot.name);
}

bool store(const TransformStamped& base, ArmSetBaseFrameArguments& slot) {
  return store(base, slot.base);
}

void shiftStamps(ArmSetBaseFrameArguments& slot, Duration shift) { shiftStamps(slot.base, shift); }

bool store(const bool& use, ArmUseGravityCompensationArguments& slot) {
  return store(use, slot.use);
}

bool store(const JointGoal& step, ArmServoJrArguments& slot) { return store(step, slot.step); }

void shiftStamps(ArmServoJrArguments& slot, Duration shift) { shiftStamps(slot.step, shift); }

bool store(const JointVelocityGoal& goal, ArmServoJvArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmServoJvArguments& slot, Duration shift) { shiftStamps(slot.goal, shift); }

bool store(const JointEffortGoal& goal, ArmServoJfArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmServoJfArguments& slot, Duration shift) { shiftStamps(slot.goal, shift); }

bool store(const PoseStamped& step, ArmServoCrArguments& slot) { return store(step, slot.step); }

void shiftStamps(ArmServoCrArguments& slot, Duration shift) { shiftStamps(slot.step, shift); }

bool store(const TwistGoal& goal, ArmServoCvArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(ArmServoCvArguments& slot, Duration shift) { shiftStamps(slot.goal, shift); }

bool store(const WrenchGoal& goal, ArmBodyServoCfArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(ArmBodyServoCfArguments& slot, Duration shift) { shiftStamps(slot.goal, shift); }

bool store(const WrenchGoal& goal, ArmSpatialServoCfArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmSpatialServoCfArguments& slot, Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const JointGoal& goal, ArmInterpolateJpArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmInterpolateJpArguments& slot, Duration shift) { shiftStamps(slot.goal, shift); }

bool store(const JointGoal& step, ArmInterpolateJrArguments& slot) {
  return store(step, slot.step);
}

void shiftStamps(ArmInterpolateJrArguments& slot, Duration shift) { shiftStamps(slot.step, shift); }

bool store(const PoseStamped& goal, ArmInterpolateCpArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmInterpolateCpArguments& slot, Duration shift) { shiftStamps(slot.goal, shift); }

bool store(const PoseStamped& step, ArmInterpolateCrArguments& slot) {
  return store(step, slot.step);
}

void shiftStamps(ArmInterpolateCrArguments& slot, Duration shift) { shiftStamps(slot.step, shift); }

bool store(const JointGoal& step, ArmMoveJrArguments& slot) { return store(step, slot.step); }

void shiftStamps(ArmMoveJrArguments& slot, Duration shift) { shiftStamps(slot.step, shift); }

bool store(const PoseStamped& goal, ArmMoveCpArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(ArmMoveCpArguments& slot, Duration shift) { shiftStamps(slot.goal, shift); }

bool store(const PoseStamped& step, ArmMoveCrArguments& slot) { return store(step, slot.step); }

void shiftStamps(ArmMoveCrArguments& slot, Duration shift) { shiftStamps(slot.step, shift); }

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

void shiftStamps(ArmQueryCpArguments& slot, Duration shift) { shiftStamps(slot.q, shift); }

bool store(const JointGoal& q, ArmLocalQueryCpArguments& slot) { return store(q, slot.q); }

void shiftStamps(ArmLocalQueryCpArguments& slot, Duration shift) { shiftStamps(slot.q, shift); }

namespace {

// By place in the contract, the place in the lock: a base got more since.
constexpr std::uint8_t kArmWireEvents[] = {3, 2, 4, 0, 1, 5, 6, 7, 8, 9};

bool acceptsArmServoCp(const ArmServoCpArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmServoJp(const ArmServoJpArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmMoveJp(const ArmMoveJpArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmForwardKinematics(const ArmForwardKinematicsArguments& slot, FieldPath* path) {
  return isValid(slot.q, path) || refusedAt(path, "q");
}

bool acceptsArmInverseKinematics(const ArmInverseKinematicsArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmSetBaseFrame(const ArmSetBaseFrameArguments& slot, FieldPath* path) {
  return isValid(slot.base, path) || refusedAt(path, "base");
}

bool acceptsArmServoJr(const ArmServoJrArguments& slot, FieldPath* path) {
  return isValid(slot.step, path) || refusedAt(path, "step");
}

bool acceptsArmServoJv(const ArmServoJvArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmServoJf(const ArmServoJfArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmServoCr(const ArmServoCrArguments& slot, FieldPath* path) {
  return isValid(slot.step, path) || refusedAt(path, "step");
}

bool acceptsArmServoCv(const ArmServoCvArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmBodyServoCf(const ArmBodyServoCfArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmSpatialServoCf(const ArmSpatialServoCfArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmInterpolateJp(const ArmInterpolateJpArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmInterpolateJr(const ArmInterpolateJrArguments& slot, FieldPath* path) {
  return isValid(slot.step, path) || refusedAt(path, "step");
}

bool acceptsArmInterpolateCp(const ArmInterpolateCpArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmInterpolateCr(const ArmInterpolateCrArguments& slot, FieldPath* path) {
  return isValid(slot.step, path) || refusedAt(path, "step");
}

bool acceptsArmMoveJr(const ArmMoveJrArguments& slot, FieldPath* path) {
  return isValid(slot.step, path) || refusedAt(path, "step");
}

bool acceptsArmMoveCp(const ArmMoveCpArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmMoveCr(const ArmMoveCrArguments& slot, FieldPath* path) {
  return isValid(slot.step, path) || refusedAt(path, "step");
}

bool acceptsArmTrajectoryJSetRatio(const ArmTrajectoryJSetRatioArguments& slot, FieldPath* path) {
  return inRange(slot.ratio, 0.01, 1) || refusedAt(path, "ratio");
}

bool acceptsArmTrajectoryJSetRatioV(const ArmTrajectoryJSetRatioVArguments& slot, FieldPath* path) {
  return inRange(slot.ratio, 0.01, 1) || refusedAt(path, "ratio");
}

bool acceptsArmTrajectoryJSetRatioA(const ArmTrajectoryJSetRatioAArguments& slot, FieldPath* path) {
  return inRange(slot.ratio, 0.01, 1) || refusedAt(path, "ratio");
}

bool acceptsArmTrajectoryJRatioResult(const double& slot, FieldPath*) { return isValid(slot); }
bool acceptsArmTrajectoryJRatioVResult(const double& slot, FieldPath*) { return isValid(slot); }
bool acceptsArmTrajectoryJRatioAResult(const double& slot, FieldPath*) { return isValid(slot); }

bool acceptsArmQueryCp(const ArmQueryCpArguments& slot, FieldPath* path) {
  return isValid(slot.q, path) || refusedAt(path, "q");
}

bool acceptsArmLocalQueryCp(const ArmLocalQueryCpArguments& slot, FieldPath* path) {
  return isValid(slot.q, path) || refusedAt(path, "q");
}

bool acceptsArmDesiredStateEvent(const std::uint8_t& slot, FieldPath*) {
  return isKnownArmState(slot);
}

bool acceptsArmTrajectoryJRatioEvent(const double& slot, FieldPath*) { return isValid(slot); }
bool acceptsArmTrajectoryJRatioVEvent(const double& slot, FieldPath*) { return isValid(slot); }
bool acceptsArmTrajectoryJRatioAEvent(const double& slot, FieldPath*) { return isValid(slot); }

// --- Arm over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class ArmSink final : public suture::rpc::EventSink {
 public:
  explicit ArmSink(wire::ArmEvents::Client subscriber) : subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(suture::MessagesEvent::status): {
        const auto& slot = slotIn<suture::MessageSlot>(payload);
        auto request = subscriber_.statusRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case numberOf(suture::MessagesEvent::warning): {
        const auto& slot = slotIn<suture::MessageSlot>(payload);
        auto request = subscriber_.warningRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case numberOf(suture::MessagesEvent::error): {
        const auto& slot = slotIn<suture::MessageSlot>(payload);
        auto request = subscriber_.errorRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case numberOf(ArmEvent::operating_state): {
        const auto& slot = slotIn<OperatingStateSlot>(payload);
        auto request = subscriber_.operatingStateRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case numberOf(ArmEvent::goal_reached): {
        const auto& slot = slotIn<std::uint8_t>(payload);
        auto request = subscriber_.goalReachedRequest();
        request.setValue(slot != 0);
        return request.send().ignoreResult();
      }
      case numberOf(ArmEvent::desired_state): {
        const auto& slot = slotIn<std::uint8_t>(payload);
        auto request = subscriber_.desiredStateRequest();
        request.setValue(wireArmState(slot));
        return request.send().ignoreResult();
      }
      case numberOf(ArmEvent::gravity_compensation): {
        const auto& slot = slotIn<std::uint8_t>(payload);
        auto request = subscriber_.gravityCompensationRequest();
        request.setValue(slot != 0);
        return request.send().ignoreResult();
      }
      case numberOf(ArmEvent::trajectory_j_ratio): {
        const auto& slot = slotIn<double>(payload);
        auto request = subscriber_.trajectoryJRatioRequest();
        request.setValue(slot);
        return request.send().ignoreResult();
      }
      case numberOf(ArmEvent::trajectory_j_ratio_v): {
        const auto& slot = slotIn<double>(payload);
        auto request = subscriber_.trajectoryJRatioVRequest();
        request.setValue(slot);
        return request.send().ignoreResult();
      }
      case numberOf(ArmEvent::trajectory_j_ratio_a): {
        const auto& slot = slotIn<double>(payload);
        auto request = subscriber_.trajectoryJRatioARequest();
        request.setValue(slot);
        return request.send().ignoreResult();
      }
    }
    return kj::READY_NOW;
  }

  kj::Promise<void> row(const suture::rt::StateTable::Row& row,
                        std::span<const std::byte* const> columns) override {
    auto request = subscriber_.stateRequest();
    auto out = request.initRow();
    out.setStamp(suture::toNanoseconds(row.stamp));
    out.setEvaluated(row.valid | row.invalid);
    out.setTooLarge(row.tooLarge | row.invalid);
    if (row.hasValue(0)) {
      const auto& slot = slotIn<JointStateSlot>(columns[0]);
      toWire(slot, out.initMeasuredJs());
    }
    if (row.hasValue(1)) {
      const auto& slot = slotIn<JointStateSlot>(columns[1]);
      toWire(slot, out.initSetpointJs());
    }
    if (row.hasValue(2)) {
      const auto& slot = slotIn<PoseStampedSlot>(columns[2]);
      toWire(slot, out.initMeasuredCp());
    }
    if (row.hasValue(3)) {
      const auto& slot = slotIn<PoseStampedSlot>(columns[3]);
      toWire(slot, out.initSetpointCp());
    }
    if (row.hasValue(4)) {
      const auto& slot = slotIn<OperatingStateSlot>(columns[4]);
      toWire(slot, out.initOperatingState());
    }
    if (row.hasValue(5)) {
      const auto& slot = slotIn<JointConfigurationSlot>(columns[5]);
      toWire(slot, out.initConfigurationJs());
    }
    if (row.hasValue(6)) {
      const auto& slot = slotIn<IntervalStatisticsSlot>(columns[6]);
      toWire(slot, out.initPeriodStatistics());
    }
    if (row.hasValue(7)) {
      const auto& slot = slotIn<JointStateSlot>(columns[7]);
      toWire(slot, out.initGoalJs());
    }
    if (row.hasValue(8)) {
      const auto& slot = slotIn<PoseStampedSlot>(columns[8]);
      toWire(slot, out.initGoalCp());
    }
    if (row.hasValue(9)) {
      const auto& slot = slotIn<PoseStampedSlot>(columns[9]);
      toWire(slot, out.initLocalMeasuredCp());
    }
    if (row.hasValue(10)) {
      const auto& slot = slotIn<PoseStampedSlot>(columns[10]);
      toWire(slot, out.initLocalSetpointCp());
    }
    if (row.hasValue(11)) {
      const auto& slot = slotIn<TwistSlot>(columns[11]);
      toWire(slot, out.initMeasuredCv());
    }
    if (row.hasValue(12)) {
      const auto& slot = slotIn<TwistSlot>(columns[12]);
      toWire(slot, out.initSetpointCv());
    }
    if (row.hasValue(13)) {
      const auto& slot = slotIn<WrenchSlot>(columns[13]);
      toWire(slot, out.initBodyMeasuredCf());
    }
    if (row.hasValue(14)) {
      const auto& slot = slotIn<WrenchSlot>(columns[14]);
      toWire(slot, out.initSpatialMeasuredCf());
    }
    if (row.hasValue(15)) {
      const auto& slot = slotIn<CartesianStateSlot>(columns[15]);
      toWire(slot, out.initMeasuredCs());
    }
    if (row.hasValue(16)) {
      const auto& slot = slotIn<JacobianSlot>(columns[16]);
      toWire(slot, out.initBodyJacobian());
    }
    if (row.hasValue(17)) {
      const auto& slot = slotIn<JacobianSlot>(columns[17]);
      toWire(slot, out.initSpatialJacobian());
    }
    if (row.hasValue(18)) {
      const auto& slot = slotIn<TransformStampedSlot>(columns[18]);
      toWire(slot, out.initBaseFrame());
    }
    if (row.hasValue(19)) {
      const auto& slot = slotIn<double>(columns[19]);
      out.setTrajectoryJRatio(slot);
    }
    if (row.hasValue(20)) {
      const auto& slot = slotIn<double>(columns[20]);
      out.setTrajectoryJRatioV(slot);
    }
    if (row.hasValue(21)) {
      const auto& slot = slotIn<double>(columns[21]);
      out.setTrajectoryJRatioA(slot);
    }
    return request.send().ignoreResult();
  }

 private:
  wire::ArmEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class ArmServant final : public wire::Arm::Server {
 public:
  explicit ArmServant(kj::Own<ServantPort> port)
      : base_(suture::interfaceInfo<suture::Messages>().binding().makeServant(kj::addRef(*port))),
        port_(kj::mv(port)) {}

  DispatchCallResult dispatchCall(std::uint64_t contract, std::uint16_t method,
                                  suture::rpc::AnyCall call) override {
    if (contract != capnp::typeId<wire::Arm>()) {
      return base_->dispatchCall(contract, method, call);
    }
    return wire::Arm::Server::dispatchCall(contract, method, call);
  }

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<ArmSink>(in.getEvents()),
                     suture::fromWireNumbers(kArmWireEvents, in.getEventMask()), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> enable(EnableContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(ArmCommand::enable), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> disable(DisableContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(ArmCommand::disable), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> home(HomeContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(ArmCommand::home), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> hold(HoldContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(ArmCommand::hold), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> servoCp(ServoCpContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmServoCpArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::servo_cp), in.getSent(), fill);
  }

  kj::Promise<void> servoJp(ServoJpContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmServoJpArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::servo_jp), in.getSent(), fill);
  }

  kj::Promise<void> moveJp(MoveJpContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmMoveJpArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::move_jp), in.getSent(), fill);
  }

  kj::Promise<void> measuredJs(MeasuredJsContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<JointStateSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::measured_js), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> setpointJs(SetpointJsContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<JointStateSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::setpoint_js), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> measuredCp(MeasuredCpContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<PoseStampedSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::measured_cp), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> setpointCp(SetpointCpContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<PoseStampedSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::setpoint_cp), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> operatingState(OperatingStateContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<OperatingStateSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::operating_state), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> forwardKinematics(ForwardKinematicsContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmForwardKinematicsArguments>(memory);
      return in.hasQ() ? fromWire(in.getQ(), slot.q, port_->shift()) : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<PoseStampedSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(ArmCommand::forward_kinematics), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> inverseKinematics(InverseKinematicsContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmInverseKinematicsArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<JointSolutionSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(ArmCommand::inverse_kinematics), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> configurationJs(ConfigurationJsContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<JointConfigurationSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::configuration_js), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> periodStatistics(PeriodStatisticsContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<IntervalStatisticsSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::period_statistics), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> pause(PauseContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(ArmCommand::pause), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> resume(ResumeContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(ArmCommand::resume), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> unhome(UnhomeContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(ArmCommand::unhome), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> stateCommand(StateCommandContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmStateCommandArguments>(memory);
      return fromWire(in.getName(), slot.name);
    };
    return port_->command(numberOf(ArmCommand::state_command), in.getSent(), fill);
  }

  kj::Promise<void> goalJs(GoalJsContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<JointStateSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::goal_js), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> goalCp(GoalCpContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<PoseStampedSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::goal_cp), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> localMeasuredCp(LocalMeasuredCpContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<PoseStampedSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::local_measured_cp), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> localSetpointCp(LocalSetpointCpContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<PoseStampedSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::local_setpoint_cp), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> measuredCv(MeasuredCvContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<TwistSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::measured_cv), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> setpointCv(SetpointCvContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<TwistSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::setpoint_cv), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> bodyMeasuredCf(BodyMeasuredCfContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<WrenchSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::body_measured_cf), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> spatialMeasuredCf(SpatialMeasuredCfContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<WrenchSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::spatial_measured_cf), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> measuredCs(MeasuredCsContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<CartesianStateSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::measured_cs), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> bodyJacobian(BodyJacobianContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<JacobianSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::body_jacobian), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> spatialJacobian(SpatialJacobianContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<JacobianSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::spatial_jacobian), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> baseFrame(BaseFrameContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<TransformStampedSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::base_frame), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> setBaseFrame(SetBaseFrameContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmSetBaseFrameArguments>(memory);
      return in.hasBase() ? fromWire(in.getBase(), slot.base, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::set_base_frame), in.getSent(), fill);
  }

  kj::Promise<void> free(FreeContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(ArmCommand::free), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> useGravityCompensation(UseGravityCompensationContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmUseGravityCompensationArguments>(memory);
      slot.use = in.getUse();
      return Errc{};
    };
    return port_->command(numberOf(ArmCommand::use_gravity_compensation), in.getSent(), fill);
  }

  kj::Promise<void> servoJr(ServoJrContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmServoJrArguments>(memory);
      return in.hasStep() ? fromWire(in.getStep(), slot.step, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::servo_jr), in.getSent(), fill);
  }

  kj::Promise<void> servoJv(ServoJvContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmServoJvArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::servo_jv), in.getSent(), fill);
  }

  kj::Promise<void> servoJf(ServoJfContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmServoJfArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::servo_jf), in.getSent(), fill);
  }

  kj::Promise<void> servoCr(ServoCrContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmServoCrArguments>(memory);
      return in.hasStep() ? fromWire(in.getStep(), slot.step, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::servo_cr), in.getSent(), fill);
  }

  kj::Promise<void> servoCv(ServoCvContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmServoCvArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::servo_cv), in.getSent(), fill);
  }

  kj::Promise<void> bodyServoCf(BodyServoCfContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmBodyServoCfArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::body_servo_cf), in.getSent(), fill);
  }

  kj::Promise<void> spatialServoCf(SpatialServoCfContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmSpatialServoCfArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::spatial_servo_cf), in.getSent(), fill);
  }

  kj::Promise<void> interpolateJp(InterpolateJpContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmInterpolateJpArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::interpolate_jp), in.getSent(), fill);
  }

  kj::Promise<void> interpolateJr(InterpolateJrContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmInterpolateJrArguments>(memory);
      return in.hasStep() ? fromWire(in.getStep(), slot.step, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::interpolate_jr), in.getSent(), fill);
  }

  kj::Promise<void> interpolateCp(InterpolateCpContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmInterpolateCpArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::interpolate_cp), in.getSent(), fill);
  }

  kj::Promise<void> interpolateCr(InterpolateCrContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmInterpolateCrArguments>(memory);
      return in.hasStep() ? fromWire(in.getStep(), slot.step, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::interpolate_cr), in.getSent(), fill);
  }

  kj::Promise<void> moveJr(MoveJrContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmMoveJrArguments>(memory);
      return in.hasStep() ? fromWire(in.getStep(), slot.step, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::move_jr), in.getSent(), fill);
  }

  kj::Promise<void> moveCp(MoveCpContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmMoveCpArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::move_cp), in.getSent(), fill);
  }

  kj::Promise<void> moveCr(MoveCrContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmMoveCrArguments>(memory);
      return in.hasStep() ? fromWire(in.getStep(), slot.step, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmCommand::move_cr), in.getSent(), fill);
  }

  kj::Promise<void> trajectoryJSetRatio(TrajectoryJSetRatioContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmTrajectoryJSetRatioArguments>(memory);
      slot.ratio = in.getRatio();
      return Errc{};
    };
    return port_->command(numberOf(ArmCommand::trajectory_j_set_ratio), in.getSent(), fill);
  }

  kj::Promise<void> trajectoryJSetRatioV(TrajectoryJSetRatioVContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmTrajectoryJSetRatioVArguments>(memory);
      slot.ratio = in.getRatio();
      return Errc{};
    };
    return port_->command(numberOf(ArmCommand::trajectory_j_set_ratio_v), in.getSent(), fill);
  }

  kj::Promise<void> trajectoryJSetRatioA(TrajectoryJSetRatioAContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmTrajectoryJSetRatioAArguments>(memory);
      slot.ratio = in.getRatio();
      return Errc{};
    };
    return port_->command(numberOf(ArmCommand::trajectory_j_set_ratio_a), in.getSent(), fill);
  }

  kj::Promise<void> trajectoryJRatio(TrajectoryJRatioContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::trajectory_j_ratio), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> trajectoryJRatioV(TrajectoryJRatioVContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::trajectory_j_ratio_v), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> trajectoryJRatioA(TrajectoryJRatioAContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmCommand::trajectory_j_ratio_a), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> queryCp(QueryCpContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmQueryCpArguments>(memory);
      return in.hasQ() ? fromWire(in.getQ(), slot.q, port_->shift()) : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<PoseStampedSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(ArmCommand::query_cp), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> localQueryCp(LocalQueryCpContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmLocalQueryCpArguments>(memory);
      return in.hasQ() ? fromWire(in.getQ(), slot.q, port_->shift()) : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<PoseStampedSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(ArmCommand::local_query_cp), in.getSent(), fill, kj::mv(take));
  }

 private:
  kj::Own<capnp::Capability::Server> base_;
  kj::Own<ServantPort> port_;
};

// --- Arm over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class ArmReceiver final : public wire::ArmEvents::Server {
 public:
  explicit ArmReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<JointStateSlot>(0);
      const Errc error =
          in.hasMeasuredJs() ? fromWire(in.getMeasuredJs(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    if (columns.hasValue(1)) {
      auto& slot = port_->column<JointStateSlot>(1);
      const Errc error =
          in.hasSetpointJs() ? fromWire(in.getSetpointJs(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(1, error);
    }
    if (columns.hasValue(2)) {
      auto& slot = port_->column<PoseStampedSlot>(2);
      const Errc error =
          in.hasMeasuredCp() ? fromWire(in.getMeasuredCp(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(2, error);
    }
    if (columns.hasValue(3)) {
      auto& slot = port_->column<PoseStampedSlot>(3);
      const Errc error =
          in.hasSetpointCp() ? fromWire(in.getSetpointCp(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(3, error);
    }
    if (columns.hasValue(4)) {
      auto& slot = port_->column<OperatingStateSlot>(4);
      const Errc error =
          in.hasOperatingState() ? fromWire(in.getOperatingState(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(4, error);
    }
    if (columns.hasValue(5)) {
      auto& slot = port_->column<JointConfigurationSlot>(5);
      const Errc error =
          in.hasConfigurationJs() ? fromWire(in.getConfigurationJs(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(5, error);
    }
    if (columns.hasValue(6)) {
      auto& slot = port_->column<IntervalStatisticsSlot>(6);
      const Errc error =
          in.hasPeriodStatistics() ? fromWire(in.getPeriodStatistics(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(6, error);
    }
    if (columns.hasValue(7)) {
      auto& slot = port_->column<JointStateSlot>(7);
      const Errc error =
          in.hasGoalJs() ? fromWire(in.getGoalJs(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(7, error);
    }
    if (columns.hasValue(8)) {
      auto& slot = port_->column<PoseStampedSlot>(8);
      const Errc error =
          in.hasGoalCp() ? fromWire(in.getGoalCp(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(8, error);
    }
    if (columns.hasValue(9)) {
      auto& slot = port_->column<PoseStampedSlot>(9);
      const Errc error =
          in.hasLocalMeasuredCp() ? fromWire(in.getLocalMeasuredCp(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(9, error);
    }
    if (columns.hasValue(10)) {
      auto& slot = port_->column<PoseStampedSlot>(10);
      const Errc error =
          in.hasLocalSetpointCp() ? fromWire(in.getLocalSetpointCp(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(10, error);
    }
    if (columns.hasValue(11)) {
      auto& slot = port_->column<TwistSlot>(11);
      const Errc error =
          in.hasMeasuredCv() ? fromWire(in.getMeasuredCv(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(11, error);
    }
    if (columns.hasValue(12)) {
      auto& slot = port_->column<TwistSlot>(12);
      const Errc error =
          in.hasSetpointCv() ? fromWire(in.getSetpointCv(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(12, error);
    }
    if (columns.hasValue(13)) {
      auto& slot = port_->column<WrenchSlot>(13);
      const Errc error =
          in.hasBodyMeasuredCf() ? fromWire(in.getBodyMeasuredCf(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(13, error);
    }
    if (columns.hasValue(14)) {
      auto& slot = port_->column<WrenchSlot>(14);
      const Errc error =
          in.hasSpatialMeasuredCf() ? fromWire(in.getSpatialMeasuredCf(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(14, error);
    }
    if (columns.hasValue(15)) {
      auto& slot = port_->column<CartesianStateSlot>(15);
      const Errc error =
          in.hasMeasuredCs() ? fromWire(in.getMeasuredCs(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(15, error);
    }
    if (columns.hasValue(16)) {
      auto& slot = port_->column<JacobianSlot>(16);
      const Errc error =
          in.hasBodyJacobian() ? fromWire(in.getBodyJacobian(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(16, error);
    }
    if (columns.hasValue(17)) {
      auto& slot = port_->column<JacobianSlot>(17);
      const Errc error =
          in.hasSpatialJacobian() ? fromWire(in.getSpatialJacobian(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(17, error);
    }
    if (columns.hasValue(18)) {
      auto& slot = port_->column<TransformStampedSlot>(18);
      const Errc error =
          in.hasBaseFrame() ? fromWire(in.getBaseFrame(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(18, error);
    }
    if (columns.hasValue(19)) {
      auto& slot = port_->column<double>(19);
      slot = in.getTrajectoryJRatio();
    }
    if (columns.hasValue(20)) {
      auto& slot = port_->column<double>(20);
      slot = in.getTrajectoryJRatioV();
    }
    if (columns.hasValue(21)) {
      auto& slot = port_->column<double>(21);
      slot = in.getTrajectoryJRatioA();
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> status(StatusContext context) override {
    auto in = context.getParams();
    return port_->event<suture::MessageSlot>(numberOf(suture::MessagesEvent::status),
                                             [&](suture::MessageSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

  kj::Promise<void> warning(WarningContext context) override {
    auto in = context.getParams();
    return port_->event<suture::MessageSlot>(numberOf(suture::MessagesEvent::warning),
                                             [&](suture::MessageSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

  kj::Promise<void> error(ErrorContext context) override {
    auto in = context.getParams();
    return port_->event<suture::MessageSlot>(numberOf(suture::MessagesEvent::error),
                                             [&](suture::MessageSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

  kj::Promise<void> operatingState(OperatingStateContext context) override {
    auto in = context.getParams();
    return port_->event<OperatingStateSlot>(numberOf(ArmEvent::operating_state),
                                            [&](OperatingStateSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

  kj::Promise<void> goalReached(GoalReachedContext context) override {
    auto in = context.getParams();
    return port_->event<std::uint8_t>(numberOf(ArmEvent::goal_reached), [&](std::uint8_t& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

  kj::Promise<void> desiredState(DesiredStateContext context) override {
    auto in = context.getParams();
    return port_->event<std::uint8_t>(numberOf(ArmEvent::desired_state), [&](std::uint8_t& slot) {
      return fromWire(in.getValue(), slot);
    });
  }

  kj::Promise<void> gravityCompensation(GravityCompensationContext context) override {
    auto in = context.getParams();
    return port_->event<std::uint8_t>(numberOf(ArmEvent::gravity_compensation),
                                      [&](std::uint8_t& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

  kj::Promise<void> trajectoryJRatio(TrajectoryJRatioContext context) override {
    auto in = context.getParams();
    return port_->event<double>(numberOf(ArmEvent::trajectory_j_ratio), [&](double& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

  kj::Promise<void> trajectoryJRatioV(TrajectoryJRatioVContext context) override {
    auto in = context.getParams();
    return port_->event<double>(numberOf(ArmEvent::trajectory_j_ratio_v), [&](double& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

  kj::Promise<void> trajectoryJRatioA(TrajectoryJRatioAContext context) override {
    auto in = context.getParams();
    return port_->event<double>(numberOf(ArmEvent::trajectory_j_ratio_a), [&](double& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class ArmProxy final : public suture::rpc::Proxy {
 public:
  ArmProxy(wire::Arm::Client provider, ProxyPort& port)
      : base_(suture::interfaceInfo<suture::Messages>().binding().makeProxy(provider, port)),
        provider_(kj::mv(provider)),
        port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<ArmReceiver>(kj::addRef(port_)));
    request.setEventMask(suture::toWireNumbers(kArmWireEvents, events));
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<ArmCommand>(record.command)) {
      case ArmCommand::enable: {
        auto request = provider_.enableRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::disable: {
        auto request = provider_.disableRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::home: {
        auto request = provider_.homeRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::hold: {
        auto request = provider_.holdRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::servo_cp: {
        const auto& slot = slotIn<ArmServoCpArguments>(record.arguments());
        auto request = provider_.servoCpRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::servo_jp: {
        const auto& slot = slotIn<ArmServoJpArguments>(record.arguments());
        auto request = provider_.servoJpRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::move_jp: {
        const auto& slot = slotIn<ArmMoveJpArguments>(record.arguments());
        auto request = provider_.moveJpRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::measured_js: {
        auto request = provider_.measuredJsRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<JointStateSlot>(call, response.getStamp(), [&](JointStateSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::setpoint_js: {
        auto request = provider_.setpointJsRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<JointStateSlot>(call, response.getStamp(), [&](JointStateSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::measured_cp: {
        auto request = provider_.measuredCpRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PoseStampedSlot>(call, response.getStamp(), [&](PoseStampedSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::setpoint_cp: {
        auto request = provider_.setpointCpRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PoseStampedSlot>(call, response.getStamp(), [&](PoseStampedSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::operating_state: {
        auto request = provider_.operatingStateRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<OperatingStateSlot>(call, response.getStamp(),
                                           [&](OperatingStateSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::forward_kinematics: {
        const auto& slot = slotIn<ArmForwardKinematicsArguments>(record.arguments());
        auto request = provider_.forwardKinematicsRequest();
        toWire(slot.q, request.initQ());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PoseStampedSlot>(call, [&](PoseStampedSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::inverse_kinematics: {
        const auto& slot = slotIn<ArmInverseKinematicsArguments>(record.arguments());
        auto request = provider_.inverseKinematicsRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<JointSolutionSlot>(call, [&](JointSolutionSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::configuration_js: {
        auto request = provider_.configurationJsRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<JointConfigurationSlot>(call, response.getStamp(),
                                               [&](JointConfigurationSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::period_statistics: {
        auto request = provider_.periodStatisticsRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<IntervalStatisticsSlot>(call, response.getStamp(),
                                               [&](IntervalStatisticsSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::pause: {
        auto request = provider_.pauseRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::resume: {
        auto request = provider_.resumeRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::unhome: {
        auto request = provider_.unhomeRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::state_command: {
        const auto& slot = slotIn<ArmStateCommandArguments>(record.arguments());
        auto request = provider_.stateCommandRequest();
        toWire(slot.name, request.initName(slot.name.size));
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::goal_js: {
        auto request = provider_.goalJsRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<JointStateSlot>(call, response.getStamp(), [&](JointStateSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::goal_cp: {
        auto request = provider_.goalCpRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PoseStampedSlot>(call, response.getStamp(), [&](PoseStampedSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::local_measured_cp: {
        auto request = provider_.localMeasuredCpRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PoseStampedSlot>(call, response.getStamp(), [&](PoseStampedSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::local_setpoint_cp: {
        auto request = provider_.localSetpointCpRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PoseStampedSlot>(call, response.getStamp(), [&](PoseStampedSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::measured_cv: {
        auto request = provider_.measuredCvRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<TwistSlot>(call, response.getStamp(), [&](TwistSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::setpoint_cv: {
        auto request = provider_.setpointCvRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<TwistSlot>(call, response.getStamp(), [&](TwistSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::body_measured_cf: {
        auto request = provider_.bodyMeasuredCfRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<WrenchSlot>(call, response.getStamp(), [&](WrenchSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::spatial_measured_cf: {
        auto request = provider_.spatialMeasuredCfRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<WrenchSlot>(call, response.getStamp(), [&](WrenchSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::measured_cs: {
        auto request = provider_.measuredCsRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<CartesianStateSlot>(call, response.getStamp(),
                                           [&](CartesianStateSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::body_jacobian: {
        auto request = provider_.bodyJacobianRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<JacobianSlot>(call, response.getStamp(), [&](JacobianSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::spatial_jacobian: {
        auto request = provider_.spatialJacobianRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<JacobianSlot>(call, response.getStamp(), [&](JacobianSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::base_frame: {
        auto request = provider_.baseFrameRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<TransformStampedSlot>(call, response.getStamp(),
                                             [&](TransformStampedSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::set_base_frame: {
        const auto& slot = slotIn<ArmSetBaseFrameArguments>(record.arguments());
        auto request = provider_.setBaseFrameRequest();
        toWire(slot.base, request.initBase());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::free: {
        auto request = provider_.freeRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::use_gravity_compensation: {
        const auto& slot = slotIn<ArmUseGravityCompensationArguments>(record.arguments());
        auto request = provider_.useGravityCompensationRequest();
        request.setUse(slot.use != 0);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::servo_jr: {
        const auto& slot = slotIn<ArmServoJrArguments>(record.arguments());
        auto request = provider_.servoJrRequest();
        toWire(slot.step, request.initStep());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::servo_jv: {
        const auto& slot = slotIn<ArmServoJvArguments>(record.arguments());
        auto request = provider_.servoJvRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::servo_jf: {
        const auto& slot = slotIn<ArmServoJfArguments>(record.arguments());
        auto request = provider_.servoJfRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::servo_cr: {
        const auto& slot = slotIn<ArmServoCrArguments>(record.arguments());
        auto request = provider_.servoCrRequest();
        toWire(slot.step, request.initStep());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::servo_cv: {
        const auto& slot = slotIn<ArmServoCvArguments>(record.arguments());
        auto request = provider_.servoCvRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::body_servo_cf: {
        const auto& slot = slotIn<ArmBodyServoCfArguments>(record.arguments());
        auto request = provider_.bodyServoCfRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::spatial_servo_cf: {
        const auto& slot = slotIn<ArmSpatialServoCfArguments>(record.arguments());
        auto request = provider_.spatialServoCfRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::interpolate_jp: {
        const auto& slot = slotIn<ArmInterpolateJpArguments>(record.arguments());
        auto request = provider_.interpolateJpRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::interpolate_jr: {
        const auto& slot = slotIn<ArmInterpolateJrArguments>(record.arguments());
        auto request = provider_.interpolateJrRequest();
        toWire(slot.step, request.initStep());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::interpolate_cp: {
        const auto& slot = slotIn<ArmInterpolateCpArguments>(record.arguments());
        auto request = provider_.interpolateCpRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::interpolate_cr: {
        const auto& slot = slotIn<ArmInterpolateCrArguments>(record.arguments());
        auto request = provider_.interpolateCrRequest();
        toWire(slot.step, request.initStep());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::move_jr: {
        const auto& slot = slotIn<ArmMoveJrArguments>(record.arguments());
        auto request = provider_.moveJrRequest();
        toWire(slot.step, request.initStep());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::move_cp: {
        const auto& slot = slotIn<ArmMoveCpArguments>(record.arguments());
        auto request = provider_.moveCpRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::move_cr: {
        const auto& slot = slotIn<ArmMoveCrArguments>(record.arguments());
        auto request = provider_.moveCrRequest();
        toWire(slot.step, request.initStep());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::trajectory_j_set_ratio: {
        const auto& slot = slotIn<ArmTrajectoryJSetRatioArguments>(record.arguments());
        auto request = provider_.trajectoryJSetRatioRequest();
        request.setRatio(slot.ratio);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::trajectory_j_set_ratio_v: {
        const auto& slot = slotIn<ArmTrajectoryJSetRatioVArguments>(record.arguments());
        auto request = provider_.trajectoryJSetRatioVRequest();
        request.setRatio(slot.ratio);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::trajectory_j_set_ratio_a: {
        const auto& slot = slotIn<ArmTrajectoryJSetRatioAArguments>(record.arguments());
        auto request = provider_.trajectoryJSetRatioARequest();
        request.setRatio(slot.ratio);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmCommand::trajectory_j_ratio: {
        auto request = provider_.trajectoryJRatioRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, response.getStamp(), [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case ArmCommand::trajectory_j_ratio_v: {
        auto request = provider_.trajectoryJRatioVRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, response.getStamp(), [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case ArmCommand::trajectory_j_ratio_a: {
        auto request = provider_.trajectoryJRatioARequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, response.getStamp(), [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case ArmCommand::query_cp: {
        const auto& slot = slotIn<ArmQueryCpArguments>(record.arguments());
        auto request = provider_.queryCpRequest();
        toWire(slot.q, request.initQ());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PoseStampedSlot>(call, [&](PoseStampedSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmCommand::local_query_cp: {
        const auto& slot = slotIn<ArmLocalQueryCpArguments>(record.arguments());
        auto request = provider_.localQueryCpRequest();
        toWire(slot.q, request.initQ());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PoseStampedSlot>(call, [&](PoseStampedSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
    }
    return base_->send(record);
  }

 private:
  kj::Own<suture::rpc::Proxy> base_;
  wire::Arm::Client provider_;
  ProxyPort& port_;
};

class ArmBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<ArmServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<ArmProxy>(contract.castAs<wire::Arm>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<ArmSink>(subscriber.castAs<wire::ArmEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::Arm>();
  }
};

const suture::rpc::Binding& armBinding() {
  static const ArmBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kArmCommands[] = {
    {.name = "enable", .kind = CommandKind::Void, .depth = 16},
    {.name = "disable", .kind = CommandKind::Void, .depth = 16},
    {.name = "home", .kind = CommandKind::Void, .depth = 16},
    {.name = "hold", .kind = CommandKind::Void, .depth = 16},
    {.name = "servo_cp",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmServoCpArguments>,
     .depth = 16,
     .latest = true,
     .ttl = Duration(20'000'000),
     .accepts = checkSlot<ArmServoCpArguments, acceptsArmServoCp>,
     .shiftArguments = shiftSlot<ArmServoCpArguments>},
    {.name = "servo_jp",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmServoJpArguments>,
     .depth = 16,
     .latest = true,
     .ttl = Duration(20'000'000),
     .accepts = checkSlot<ArmServoJpArguments, acceptsArmServoJp>,
     .shiftArguments = shiftSlot<ArmServoJpArguments>},
    {.name = "move_jp",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmMoveJpArguments>,
     .depth = 16,
     .accepts = checkSlot<ArmMoveJpArguments, acceptsArmMoveJp>,
     .shiftArguments = shiftSlot<ArmMoveJpArguments>},
    {.name = "measured_js",
     .kind = CommandKind::Read,
     .resultSize = slotSize<JointStateSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<JointStateSlot, isValid>,
     .shiftResult = shiftSlot<JointStateSlot>},
    {.name = "setpoint_js",
     .kind = CommandKind::Read,
     .resultSize = slotSize<JointStateSlot>,
     .depth = 16,
     .column = 1,
     .acceptsResult = checkSlot<JointStateSlot, isValid>,
     .shiftResult = shiftSlot<JointStateSlot>},
    {.name = "measured_cp",
     .kind = CommandKind::Read,
     .resultSize = slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = 2,
     .acceptsResult = checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = shiftSlot<PoseStampedSlot>},
    {.name = "setpoint_cp",
     .kind = CommandKind::Read,
     .resultSize = slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = 3,
     .acceptsResult = checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = shiftSlot<PoseStampedSlot>},
    {.name = "operating_state",
     .kind = CommandKind::Read,
     .resultSize = slotSize<OperatingStateSlot>,
     .depth = 16,
     .column = 4,
     .acceptsResult = checkSlot<OperatingStateSlot, isValid>,
     .shiftResult = shiftSlot<OperatingStateSlot>},
    {.name = "forward_kinematics",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = slotSize<ArmForwardKinematicsArguments>,
     .resultSize = slotSize<PoseStampedSlot>,
     .depth = 16,
     .accepts = checkSlot<ArmForwardKinematicsArguments, acceptsArmForwardKinematics>,
     .acceptsResult = checkSlot<PoseStampedSlot, isValid>,
     .shiftArguments = shiftSlot<ArmForwardKinematicsArguments>,
     .shiftResult = shiftSlot<PoseStampedSlot>},
    {.name = "inverse_kinematics",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = slotSize<ArmInverseKinematicsArguments>,
     .resultSize = slotSize<JointSolutionSlot>,
     .depth = 16,
     .accepts = checkSlot<ArmInverseKinematicsArguments, acceptsArmInverseKinematics>,
     .acceptsResult = checkSlot<JointSolutionSlot, isValid>,
     .shiftArguments = shiftSlot<ArmInverseKinematicsArguments>},
    {.name = "configuration_js",
     .kind = CommandKind::Read,
     .resultSize = slotSize<JointConfigurationSlot>,
     .depth = 16,
     .column = 5,
     .acceptsResult = checkSlot<JointConfigurationSlot, isValid>},
    {.name = "period_statistics",
     .kind = CommandKind::Read,
     .resultSize = slotSize<IntervalStatisticsSlot>,
     .depth = 16,
     .column = 6,
     .acceptsResult = checkSlot<IntervalStatisticsSlot, isValid>,
     .shiftResult = shiftSlot<IntervalStatisticsSlot>},
    {.name = "pause", .kind = CommandKind::Void, .depth = 16},
    {.name = "resume", .kind = CommandKind::Void, .depth = 16},
    {.name = "unhome", .kind = CommandKind::Void, .depth = 16},
    {.name = "state_command",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmStateCommandArguments>,
     .depth = 16},
    {.name = "goal_js",
     .kind = CommandKind::Read,
     .resultSize = slotSize<JointStateSlot>,
     .depth = 16,
     .column = 7,
     .acceptsResult = checkSlot<JointStateSlot, isValid>,
     .shiftResult = shiftSlot<JointStateSlot>},
    {.name = "goal_cp",
     .kind = CommandKind::Read,
     .resultSize = slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = 8,
     .acceptsResult = checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = shiftSlot<PoseStampedSlot>},
    {.name = "local_measured_cp",
     .kind = CommandKind::Read,
     .resultSize = slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = 9,
     .acceptsResult = checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = shiftSlot<PoseStampedSlot>},
    {.name = "local_setpoint_cp",
     .kind = CommandKind::Read,
     .resultSize = slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = 10,
     .acceptsResult = checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = shiftSlot<PoseStampedSlot>},
    {.name = "measured_cv",
     .kind = CommandKind::Read,
     .resultSize = slotSize<TwistSlot>,
     .depth = 16,
     .column = 11,
     .acceptsResult = checkSlot<TwistSlot, isValid>,
     .shiftResult = shiftSlot<TwistSlot>},
    {.name = "setpoint_cv",
     .kind = CommandKind::Read,
     .resultSize = slotSize<TwistSlot>,
     .depth = 16,
     .column = 12,
     .acceptsResult = checkSlot<TwistSlot, isValid>,
     .shiftResult = shiftSlot<TwistSlot>},
    {.name = "body_measured_cf",
     .kind = CommandKind::Read,
     .resultSize = slotSize<WrenchSlot>,
     .depth = 16,
     .column = 13,
     .acceptsResult = checkSlot<WrenchSlot, isValid>,
     .shiftResult = shiftSlot<WrenchSlot>},
    {.name = "spatial_measured_cf",
     .kind = CommandKind::Read,
     .resultSize = slotSize<WrenchSlot>,
     .depth = 16,
     .column = 14,
     .acceptsResult = checkSlot<WrenchSlot, isValid>,
     .shiftResult = shiftSlot<WrenchSlot>},
    {.name = "measured_cs",
     .kind = CommandKind::Read,
     .resultSize = slotSize<CartesianStateSlot>,
     .depth = 16,
     .column = 15,
     .acceptsResult = checkSlot<CartesianStateSlot, isValid>,
     .shiftResult = shiftSlot<CartesianStateSlot>},
    {.name = "body_jacobian",
     .kind = CommandKind::Read,
     .resultSize = slotSize<JacobianSlot>,
     .depth = 16,
     .column = 16,
     .acceptsResult = checkSlot<JacobianSlot, isValid>,
     .shiftResult = shiftSlot<JacobianSlot>},
    {.name = "spatial_jacobian",
     .kind = CommandKind::Read,
     .resultSize = slotSize<JacobianSlot>,
     .depth = 16,
     .column = 17,
     .acceptsResult = checkSlot<JacobianSlot, isValid>,
     .shiftResult = shiftSlot<JacobianSlot>},
    {.name = "base_frame",
     .kind = CommandKind::Read,
     .resultSize = slotSize<TransformStampedSlot>,
     .depth = 16,
     .column = 18,
     .acceptsResult = checkSlot<TransformStampedSlot, isValid>,
     .shiftResult = shiftSlot<TransformStampedSlot>},
    {.name = "set_base_frame",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmSetBaseFrameArguments>,
     .depth = 16,
     .accepts = checkSlot<ArmSetBaseFrameArguments, acceptsArmSetBaseFrame>,
     .shiftArguments = shiftSlot<ArmSetBaseFrameArguments>},
    {.name = "free", .kind = CommandKind::Void, .depth = 16},
    {.name = "use_gravity_compensation",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmUseGravityCompensationArguments>,
     .depth = 16},
    {.name = "servo_jr",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmServoJrArguments>,
     .depth = 16,
     .ttl = Duration(20'000'000),
     .accepts = checkSlot<ArmServoJrArguments, acceptsArmServoJr>,
     .shiftArguments = shiftSlot<ArmServoJrArguments>},
    {.name = "servo_jv",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmServoJvArguments>,
     .depth = 16,
     .latest = true,
     .ttl = Duration(20'000'000),
     .accepts = checkSlot<ArmServoJvArguments, acceptsArmServoJv>,
     .shiftArguments = shiftSlot<ArmServoJvArguments>},
    {.name = "servo_jf",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmServoJfArguments>,
     .depth = 16,
     .latest = true,
     .ttl = Duration(20'000'000),
     .accepts = checkSlot<ArmServoJfArguments, acceptsArmServoJf>,
     .shiftArguments = shiftSlot<ArmServoJfArguments>},
    {.name = "servo_cr",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmServoCrArguments>,
     .depth = 16,
     .ttl = Duration(20'000'000),
     .accepts = checkSlot<ArmServoCrArguments, acceptsArmServoCr>,
     .shiftArguments = shiftSlot<ArmServoCrArguments>},
    {.name = "servo_cv",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmServoCvArguments>,
     .depth = 16,
     .latest = true,
     .ttl = Duration(20'000'000),
     .accepts = checkSlot<ArmServoCvArguments, acceptsArmServoCv>,
     .shiftArguments = shiftSlot<ArmServoCvArguments>},
    {.name = "body_servo_cf",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmBodyServoCfArguments>,
     .depth = 16,
     .latest = true,
     .ttl = Duration(20'000'000),
     .accepts = checkSlot<ArmBodyServoCfArguments, acceptsArmBodyServoCf>,
     .shiftArguments = shiftSlot<ArmBodyServoCfArguments>},
    {.name = "spatial_servo_cf",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmSpatialServoCfArguments>,
     .depth = 16,
     .latest = true,
     .ttl = Duration(20'000'000),
     .accepts = checkSlot<ArmSpatialServoCfArguments, acceptsArmSpatialServoCf>,
     .shiftArguments = shiftSlot<ArmSpatialServoCfArguments>},
    {.name = "interpolate_jp",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmInterpolateJpArguments>,
     .depth = 16,
     .latest = true,
     .ttl = Duration(200'000'000),
     .accepts = checkSlot<ArmInterpolateJpArguments, acceptsArmInterpolateJp>,
     .shiftArguments = shiftSlot<ArmInterpolateJpArguments>},
    {.name = "interpolate_jr",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmInterpolateJrArguments>,
     .depth = 16,
     .ttl = Duration(200'000'000),
     .accepts = checkSlot<ArmInterpolateJrArguments, acceptsArmInterpolateJr>,
     .shiftArguments = shiftSlot<ArmInterpolateJrArguments>},
    {.name = "interpolate_cp",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmInterpolateCpArguments>,
     .depth = 16,
     .latest = true,
     .ttl = Duration(200'000'000),
     .accepts = checkSlot<ArmInterpolateCpArguments, acceptsArmInterpolateCp>,
     .shiftArguments = shiftSlot<ArmInterpolateCpArguments>},
    {.name = "interpolate_cr",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmInterpolateCrArguments>,
     .depth = 16,
     .ttl = Duration(200'000'000),
     .accepts = checkSlot<ArmInterpolateCrArguments, acceptsArmInterpolateCr>,
     .shiftArguments = shiftSlot<ArmInterpolateCrArguments>},
    {.name = "move_jr",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmMoveJrArguments>,
     .depth = 16,
     .accepts = checkSlot<ArmMoveJrArguments, acceptsArmMoveJr>,
     .shiftArguments = shiftSlot<ArmMoveJrArguments>},
    {.name = "move_cp",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmMoveCpArguments>,
     .depth = 16,
     .accepts = checkSlot<ArmMoveCpArguments, acceptsArmMoveCp>,
     .shiftArguments = shiftSlot<ArmMoveCpArguments>},
    {.name = "move_cr",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmMoveCrArguments>,
     .depth = 16,
     .accepts = checkSlot<ArmMoveCrArguments, acceptsArmMoveCr>,
     .shiftArguments = shiftSlot<ArmMoveCrArguments>},
    {.name = "trajectory_j_set_ratio",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmTrajectoryJSetRatioArguments>,
     .depth = 16,
     .accepts = checkSlot<ArmTrajectoryJSetRatioArguments, acceptsArmTrajectoryJSetRatio>},
    {.name = "trajectory_j_set_ratio_v",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmTrajectoryJSetRatioVArguments>,
     .depth = 16,
     .accepts = checkSlot<ArmTrajectoryJSetRatioVArguments, acceptsArmTrajectoryJSetRatioV>},
    {.name = "trajectory_j_set_ratio_a",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmTrajectoryJSetRatioAArguments>,
     .depth = 16,
     .accepts = checkSlot<ArmTrajectoryJSetRatioAArguments, acceptsArmTrajectoryJSetRatioA>},
    {.name = "trajectory_j_ratio",
     .kind = CommandKind::Read,
     .resultSize = slotSize<double>,
     .depth = 16,
     .column = 19,
     .acceptsResult = checkSlot<double, acceptsArmTrajectoryJRatioResult>},
    {.name = "trajectory_j_ratio_v",
     .kind = CommandKind::Read,
     .resultSize = slotSize<double>,
     .depth = 16,
     .column = 20,
     .acceptsResult = checkSlot<double, acceptsArmTrajectoryJRatioVResult>},
    {.name = "trajectory_j_ratio_a",
     .kind = CommandKind::Read,
     .resultSize = slotSize<double>,
     .depth = 16,
     .column = 21,
     .acceptsResult = checkSlot<double, acceptsArmTrajectoryJRatioAResult>},
    {.name = "query_cp",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = slotSize<ArmQueryCpArguments>,
     .resultSize = slotSize<PoseStampedSlot>,
     .depth = 16,
     .accepts = checkSlot<ArmQueryCpArguments, acceptsArmQueryCp>,
     .acceptsResult = checkSlot<PoseStampedSlot, isValid>,
     .shiftArguments = shiftSlot<ArmQueryCpArguments>,
     .shiftResult = shiftSlot<PoseStampedSlot>},
    {.name = "local_query_cp",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = slotSize<ArmLocalQueryCpArguments>,
     .resultSize = slotSize<PoseStampedSlot>,
     .depth = 16,
     .accepts = checkSlot<ArmLocalQueryCpArguments, acceptsArmLocalQueryCp>,
     .acceptsResult = checkSlot<PoseStampedSlot, isValid>,
     .shiftArguments = shiftSlot<ArmLocalQueryCpArguments>,
     .shiftResult = shiftSlot<PoseStampedSlot>},
};

constexpr EventInfo kArmEvents[] = {
    {.name = "operating_state",
     .payloadSize = slotSize<OperatingStateSlot>,
     .depth = 16,
     .latched = true,
     .accepts = checkSlot<OperatingStateSlot, isValid>,
     .shiftPayload = shiftSlot<OperatingStateSlot>},
    {.name = "goal_reached", .payloadSize = slotSize<std::uint8_t>, .depth = 16},
    {.name = "desired_state",
     .payloadSize = slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true,
     .accepts = checkSlot<std::uint8_t, acceptsArmDesiredStateEvent>},
    {.name = "gravity_compensation",
     .payloadSize = slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true},
    {.name = "trajectory_j_ratio",
     .payloadSize = slotSize<double>,
     .depth = 16,
     .latched = true,
     .accepts = checkSlot<double, acceptsArmTrajectoryJRatioEvent>},
    {.name = "trajectory_j_ratio_v",
     .payloadSize = slotSize<double>,
     .depth = 16,
     .latched = true,
     .accepts = checkSlot<double, acceptsArmTrajectoryJRatioVEvent>},
    {.name = "trajectory_j_ratio_a",
     .payloadSize = slotSize<double>,
     .depth = 16,
     .latched = true,
     .accepts = checkSlot<double, acceptsArmTrajectoryJRatioAEvent>},
};

// The self-description, as in arm/arm.suture.json.
constexpr char kArmDescription[] = R"json(
{"name": "robots::Arm",
"doc": "Commands run in the arm's own thread before its next cycle; reads are from the end of its last\none. An arm starts, and restarts, undefined; once it hears of its drives, and they may have\npower, it is disabled and not homed. Until it is enabled it ignores motion commands.\n\nAn arm that is not homed, or not any more after an encoder jumped or unhome(), does not know\nwhere its tip is. It refuses Cartesian motion, servo, interpolation and moves, and obeys joint\ncommands.\n\nSo does an arm that works through a cannula until its wrist is far enough beyond the remote\ncentre: a da Vinci's is 45 mm beyond it, and 2 mm more to begin. Joint commands and homing are\nwhat inserts it.\n\n`local_` poses are of the tool tip in the arm's base frame, all others in the reference frame of\nthe interface, in which base_frame() is the arm's base; the two are one until somebody sets\nanother. A motion command replaces the one before it, of whichever space; relative goals are\nrelative to the set-point. A servo stream that falls silent for 0.1 s ends as hold(), and so\ndoes any stream whose client is gone.\n\nStatus, warning and error are the standard messages. Their `code` is an ArmWarning\n(arm_warning.h) where the arm refuses a command or something has befallen it; each reason is\ntold once until the arm obeys again, a refused state command each time.",
"hash": "01d839824ecc91650f9758cc15eb526a", "version": 2, "major": 2, "base": "suture::Messages",
"crtk": true, "commands": [{"name": "enable", "kind": "void", "ordinal": 1,
"doc": "Gives the drives power; the arm holds its position.", "queue": 16}, {"name": "disable",
"kind": "void", "ordinal": 2,
"doc": "Stops at once, without power, and ignores motion until enabled again.", "queue": 16}, {
"name": "home", "kind": "void", "ordinal": 3,
"doc": "Moves to the home position; needs an enabled arm. Ends with goal_reached.", "queue": 16}, {
"name": "hold", "kind": "void", "ordinal": 4,
"doc": "Drops what is under way; the set-point stays where it is.", "queue": 16}, {
"name": "servo_cp", "kind": "write", "ordinal": 5, "wire": "servoCp",
"doc": "Streams Cartesian goals, newest wins. Beyond a joint limit the arm slides along that, at the\nnearest that the limits leave; a goal out of reach, or too far for one step, leaves the\nset-point. It says so. setpoint_cp keeps the goal's stamp.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::PoseStamped"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "servo_jp", "kind": "write", "ordinal": 6,
"wire": "servoJp",
"doc": "Streams joint goals, newest wins. A joint whose goal lies beyond its limit stays at that.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::JointGoal"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "move_jp", "kind": "write", "ordinal": 7,
"wire": "moveJp",
"doc": "Moves plan and execute a smooth motion from the set-point, and from the velocity that it has:\none may begin while it moves. Each ends at rest and with goal_reached.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::JointGoal"}}],
"queue": 16}, {"name": "measured_js", "kind": "read", "ordinal": 8, "wire": "measuredJs",
"doc": "Where the joints are, and what their motors give, which is empty of drives that do not measure\nit. Stamp: the drives' cycle that measured them.",
"result": {"type": {"kind": "struct", "name": "robots::JointState"}}, "queue": 16}, {
"name": "setpoint_js", "kind": "read", "ordinal": 9, "wire": "setpointJs",
"doc": "Where the joints shall be.", "result": {"type": {"kind": "struct",
"name": "robots::JointState"}}, "queue": 16}, {"name": "measured_cp", "kind": "read", "ordinal": 10,
"wire": "measuredCp",
"doc": "Where the tool tip is. Stamp: the drives' cycle that measured the joints.", "result": {
"type": {"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {"name": "setpoint_cp",
"kind": "read", "ordinal": 11, "wire": "setpointCp",
"doc": "Where the tool tip shall be. Stamp: that of the servo_cp or interpolate_cp goal it came from,\nelse the arm's cycle.",
"result": {"type": {"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {
"name": "operating_state", "kind": "read", "ordinal": 12, "wire": "operatingState", "result": {
"type": {"kind": "struct", "name": "robots::OperatingState"}}, "queue": 16}, {
"name": "forward_kinematics", "kind": "qualified read", "ordinal": 13, "wire": "forwardKinematics",
"doc": "The tool tip for a joint vector; not valid if it has the wrong length.", "parameters": [{
"name": "q", "type": {"kind": "struct", "name": "robots::JointGoal"}}], "result": {"type": {
"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {"name": "inverse_kinematics",
"kind": "qualified read", "ordinal": 14, "wire": "inverseKinematics",
"doc": "A joint vector for a tool tip, searched from the present set-point.", "parameters": [{
"name": "goal", "type": {"kind": "struct", "name": "robots::PoseStamped"}}], "result": {"type": {
"kind": "struct", "name": "robots::JointSolution"}}, "queue": 16}, {"name": "configuration_js",
"kind": "read", "ordinal": 15, "wire": "configurationJs",
"doc": "What the joints are and may do. Velocities are their rate limits, accelerations those of\nmoves. Efforts are the most that the motors give; of a da Vinci they are published\n(dynamics/davinci_inertia.cpp: ftmax), accelerations are not. Where nothing is bounded the\nlists are empty.",
"result": {"type": {"kind": "struct", "name": "robots::JointConfiguration"}}, "queue": 16}, {
"name": "period_statistics", "kind": "read", "ordinal": 16, "wire": "periodStatistics",
"doc": "How regularly the arm's task ran in the last second.", "result": {"type": {
"kind": "struct", "name": "robots::IntervalStatistics"}}, "queue": 16}, {"name": "pause",
"kind": "void", "ordinal": 17,
"doc": "Stops where the joints are and ignores motion until resume().", "queue": 16}, {
"name": "resume", "kind": "void", "ordinal": 18, "queue": 16}, {"name": "unhome", "kind": "void",
"ordinal": 19, "doc": "Forgets that it is homed.", "queue": 16}, {"name": "state_command",
"kind": "write", "ordinal": 20, "wire": "stateCommand",
"doc": "One of the six above, by name; anything else is an `error`.", "parameters": [{
"name": "name", "type": {"kind": "text", "capacity": 15}}], "queue": 16}, {"name": "goal_js",
"kind": "read", "ordinal": 21, "wire": "goalJs",
"doc": "Where the move under way ends; without one, the set-point.", "result": {"type": {
"kind": "struct", "name": "robots::JointState"}}, "queue": 16}, {"name": "goal_cp", "kind": "read",
"ordinal": 22, "wire": "goalCp",
"doc": "Where the move under way ends; without one, the set-point.", "result": {"type": {
"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {"name": "local_measured_cp",
"kind": "read", "ordinal": 23, "wire": "localMeasuredCp", "result": {"type": {"kind": "struct",
"name": "robots::PoseStamped"}}, "queue": 16}, {"name": "local_setpoint_cp", "kind": "read",
"ordinal": 24, "wire": "localSetpointCp", "result": {"type": {"kind": "struct",
"name": "robots::PoseStamped"}}, "queue": 16}, {"name": "measured_cv", "kind": "read",
"ordinal": 25, "wire": "measuredCv",
"doc": "How the tip moves, in the directions of the reference frame, which the twist names.",
"result": {"type": {"kind": "struct", "name": "robots::Twist"}}, "queue": 16}, {
"name": "setpoint_cv", "kind": "read", "ordinal": 26, "wire": "setpointCv",
"doc": "How the set-point moves, whatever moves it, in the same directions. Where it jumped, and in\nthe first cycle of a motion, it is 0. Stamp: the arm's cycle.",
"result": {"type": {"kind": "struct", "name": "robots::Twist"}}, "queue": 16}, {
"name": "body_measured_cf", "kind": "read", "ordinal": 27, "wire": "bodyMeasuredCf",
"doc": "This is the wrench that the arm presses with at its tip, in the tip's own directions: the\nmotors' efforts, less the arm's weight as its model has it, through the transposed Jacobian.\nFriction, inertia and what that model has wrong are in it, so it is near a contact's force\nonly when the arm is slow and presses hard. Its sign is that of servo_cf, as in the da Vinci\nResearch Kit; what touches the tip presses on it with the opposite. Not valid where the drives\nmeasure no effort, without power, and beside a singularity. Stamp: the drives' cycle that\nmeasured the joints.",
"result": {"type": {"kind": "struct", "name": "robots::Wrench"}}, "queue": 16}, {
"name": "spatial_measured_cf", "kind": "read", "ordinal": 28, "wire": "spatialMeasuredCf",
"doc": "The same in the directions of the arm's base frame.", "result": {"type": {"kind": "struct",
"name": "robots::Wrench"}}, "queue": 16}, {"name": "measured_cs", "kind": "read", "ordinal": 29,
"wire": "measuredCs", "doc": "Pose, velocity and force of one cycle, in the reference frame.",
"result": {"type": {"kind": "struct", "name": "robots::CartesianState"}}, "queue": 16}, {
"name": "body_jacobian", "kind": "read", "ordinal": 30, "wire": "bodyJacobian",
"doc": "From joint velocities to those of the tip, in its own directions. Stamp: the drives' cycle\nthat measured the joints.",
"result": {"type": {"kind": "struct", "name": "robots::Jacobian"}}, "queue": 16}, {
"name": "spatial_jacobian", "kind": "read", "ordinal": 31, "wire": "spatialJacobian",
"doc": "The same in the directions of the arm's base frame.", "result": {"type": {"kind": "struct",
"name": "robots::Jacobian"}}, "queue": 16}, {"name": "base_frame", "kind": "read", "ordinal": 32,
"wire": "baseFrame", "result": {"type": {"kind": "struct", "name": "robots::TransformStamped"}},
"queue": 16}, {"name": "set_base_frame", "kind": "write", "ordinal": 33, "wire": "setBaseFrame",
"doc": "The arm's base in the reference frame of this interface. Refused if it is given in another\none, and while the arm moves or follows a stream.",
"parameters": [{"name": "base", "type": {"kind": "struct", "name": "robots::TransformStamped"}}],
"queue": 16}, {"name": "free", "kind": "void", "ordinal": 34,
"doc": "Lets go: the set-point follows the joints until another command.", "queue": 16}, {
"name": "use_gravity_compensation", "kind": "write", "ordinal": 35,
"wire": "useGravityCompensation",
"doc": "For the record: it is told in gravity_compensation and changes no motor, which is the business\nof the drives.",
"parameters": [{"name": "use", "type": {"kind": "Bool"}}], "queue": 16}, {"name": "servo_jr",
"kind": "write", "ordinal": 36, "wire": "servoJr", "parameters": [{"name": "step", "type": {
"kind": "struct", "name": "robots::JointGoal"}}], "queue": 16, "ttl": 0.02}, {"name": "servo_jv",
"kind": "write", "ordinal": 37, "wire": "servoJv", "parameters": [{"name": "goal", "type": {
"kind": "struct", "name": "robots::JointVelocityGoal"}}], "queue": 16, "latest": true, "ttl": 0.02
}, {"name": "servo_jf", "kind": "write", "ordinal": 38, "wire": "servoJf", "parameters": [{
"name": "goal", "type": {"kind": "struct", "name": "robots::JointEffortGoal"}}], "queue": 16,
"latest": true, "ttl": 0.02}, {"name": "servo_cr", "kind": "write", "ordinal": 39,
"wire": "servoCr",
"doc": "The step's translation in the reference frame; its rotation turns the tip about itself.",
"parameters": [{"name": "step", "type": {"kind": "struct", "name": "robots::PoseStamped"}}],
"queue": 16, "ttl": 0.02}, {"name": "servo_cv", "kind": "write", "ordinal": 40, "wire": "servoCv",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::TwistGoal"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "body_servo_cf", "kind": "write", "ordinal": 41,
"wire": "bodyServoCf", "doc": "In the tip's own directions.", "parameters": [{"name": "goal",
"type": {"kind": "struct", "name": "robots::WrenchGoal"}}], "queue": 16, "latest": true, "ttl": 0.02
}, {"name": "spatial_servo_cf", "kind": "write", "ordinal": 42, "wire": "spatialServoCf",
"doc": "In the directions of the arm's base frame.", "parameters": [{"name": "goal", "type": {
"kind": "struct", "name": "robots::WrenchGoal"}}], "queue": 16, "latest": true, "ttl": 0.02}, {
"name": "interpolate_jp", "kind": "write", "ordinal": 43, "wire": "interpolateJp",
"doc": "Goals that come more slowly than the arm's cycles, newest wins. The set-point goes to each in\na straight line of the joints, in as much time as lay between it and the goal before it, but\nno faster than the joints can, and stays there. Limits and reach are as of servo commands.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::JointGoal"}}],
"queue": 16, "latest": true, "ttl": 0.2}, {"name": "interpolate_jr", "kind": "write", "ordinal": 44,
"wire": "interpolateJr", "parameters": [{"name": "step", "type": {"kind": "struct",
"name": "robots::JointGoal"}}], "queue": 16, "ttl": 0.2}, {"name": "interpolate_cp",
"kind": "write", "ordinal": 45, "wire": "interpolateCp", "parameters": [{"name": "goal", "type": {
"kind": "struct", "name": "robots::PoseStamped"}}], "queue": 16, "latest": true, "ttl": 0.2}, {
"name": "interpolate_cr", "kind": "write", "ordinal": 46, "wire": "interpolateCr", "parameters": [{
"name": "step", "type": {"kind": "struct", "name": "robots::PoseStamped"}}], "queue": 16, "ttl": 0.2
}, {"name": "move_jr", "kind": "write", "ordinal": 47, "wire": "moveJr", "parameters": [{
"name": "step", "type": {"kind": "struct", "name": "robots::JointGoal"}}], "queue": 16}, {
"name": "move_cp", "kind": "write", "ordinal": 48, "wire": "moveCp", "parameters": [{
"name": "goal", "type": {"kind": "struct", "name": "robots::PoseStamped"}}], "queue": 16}, {
"name": "move_cr", "kind": "write", "ordinal": 49, "wire": "moveCr", "parameters": [{
"name": "step", "type": {"kind": "struct", "name": "robots::PoseStamped"}}], "queue": 16}, {
"name": "trajectory_j_set_ratio", "kind": "write", "ordinal": 50, "wire": "trajectoryJSetRatio",
"doc": "How fast moves are, of what the joints can do: velocity and acceleration together.",
"parameters": [{"name": "ratio", "type": {"kind": "Float64"}, "range": [0.01, 1.0]}], "queue": 16},
{"name": "trajectory_j_set_ratio_v", "kind": "write", "ordinal": 51, "wire": "trajectoryJSetRatioV",
"parameters": [{"name": "ratio", "type": {"kind": "Float64"}, "range": [0.01, 1.0]}], "queue": 16},
{"name": "trajectory_j_set_ratio_a", "kind": "write", "ordinal": 52, "wire": "trajectoryJSetRatioA",
"parameters": [{"name": "ratio", "type": {"kind": "Float64"}, "range": [0.01, 1.0]}], "queue": 16},
{"name": "trajectory_j_ratio", "kind": "read", "ordinal": 53, "wire": "trajectoryJRatio",
"doc": "The smaller of the two below.", "result": {"type": {"kind": "Float64"}}, "queue": 16}, {
"name": "trajectory_j_ratio_v", "kind": "read", "ordinal": 54, "wire": "trajectoryJRatioV",
"result": {"type": {"kind": "Float64"}}, "queue": 16}, {"name": "trajectory_j_ratio_a",
"kind": "read", "ordinal": 55, "wire": "trajectoryJRatioA", "result": {"type": {"kind": "Float64"}
}, "queue": 16}, {"name": "query_cp", "kind": "qualified read", "ordinal": 56, "wire": "queryCp",
"doc": "The pose of the link behind as many joints as the vector has, at most all: none, the base.",
"parameters": [{"name": "q", "type": {"kind": "struct", "name": "robots::JointGoal"}}], "result": {
"type": {"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {
"name": "local_query_cp", "kind": "qualified read", "ordinal": 57, "wire": "localQueryCp",
"doc": "The same in the arm's base frame.", "parameters": [{"name": "q", "type": {"kind": "struct",
"name": "robots::JointGoal"}}], "result": {"type": {"kind": "struct", "name": "robots::PoseStamped"
}}, "queue": 16}], "events": [{"name": "status", "kind": "write", "ordinal": 1,
"doc": "All is well; something has been done.", "payload": {"type": {"kind": "struct",
"name": "suture::Message"}}, "queue": 16, "latched": true, "from": "suture::Messages", "number": 3
}, {"name": "warning", "kind": "write", "ordinal": 2,
"doc": "Something was refused, or is not as it should be; the component goes on.", "payload": {
"type": {"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages", "number": 2}, {"name": "error", "kind": "write", "ordinal": 3,
"doc": "Something failed, and somebody should see to it.", "payload": {"type": {"kind": "struct",
"name": "suture::Message"}}, "queue": 16, "latched": true, "from": "suture::Messages", "number": 4
}, {"name": "operating_state", "kind": "write", "ordinal": 1, "wire": "operatingState",
"doc": "Each change of the operating state, and the last one to whoever connects.", "payload": {
"type": {"kind": "struct", "name": "robots::OperatingState"}}, "queue": 16, "latched": true,
"number": 0}, {"name": "goal_reached", "kind": "write", "ordinal": 2, "wire": "goalReached",
"doc": "A move ended: true at its goal, false when something else replaced it.", "payload": {
"type": {"kind": "Bool"}}, "queue": 16, "number": 1}, {"name": "desired_state", "kind": "write",
"ordinal": 6, "wire": "desiredState", "doc": "The state that a command asked for.", "payload": {
"type": {"kind": "enum", "name": "robots::ArmState"}}, "queue": 16, "latched": true, "number": 5}, {
"name": "gravity_compensation", "kind": "write", "ordinal": 7, "wire": "gravityCompensation",
"payload": {"type": {"kind": "Bool"}}, "queue": 16, "latched": true, "number": 6}, {
"name": "trajectory_j_ratio", "kind": "write", "ordinal": 8, "wire": "trajectoryJRatio",
"payload": {"type": {"kind": "Float64"}}, "queue": 16, "latched": true, "number": 7}, {
"name": "trajectory_j_ratio_v", "kind": "write", "ordinal": 9, "wire": "trajectoryJRatioV",
"payload": {"type": {"kind": "Float64"}}, "queue": 16, "latched": true, "number": 8}, {
"name": "trajectory_j_ratio_a", "kind": "write", "ordinal": 10, "wire": "trajectoryJRatioA",
"payload": {"type": {"kind": "Float64"}}, "queue": 16, "latched": true, "number": 9}], "enums": [{
"name": "robots::ArmState", "doc": "The states of CRTK.", "underlying": "UInt8", "enumerators": [{
"name": "Undefined", "value": 0, "wire": "undefined"}, {"name": "Disabled", "value": 1,
"wire": "disabled"}, {"name": "Enabled", "value": 2, "wire": "enabled"}, {"name": "Paused",
"value": 3, "wire": "paused"}, {"name": "Fault", "value": 4, "wire": "fault"}]}, {
"name": "robots::JointType", "underlying": "UInt8", "enumerators": [{"name": "Undefined",
"value": 0, "wire": "undefined"}, {"name": "Prismatic", "value": 1, "wire": "prismatic"}, {
"name": "Revolute", "value": 2, "wire": "revolute"}, {"name": "Universal", "value": 3,
"wire": "universal"}, {"name": "BallSocket", "value": 4, "wire": "ballSocket"}, {
"name": "Inactive", "value": 5, "wire": "inactive"}]}], "structs": [{"name": "robots::PoseStamped",
"doc": "A pose at a time: what CRTK's measured_cp, setpoint_cp and servo_cp carry.", "fields": [{
"name": "pose", "doc": "The moving frame of the interface in its reference frame.", "type": {
"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "stamp",
"doc": "When the pose was true; of a set-point, the stamp of the data it was made from.", "type": {
"kind": "time", "clock": "steady"}}, {"name": "valid", "doc": "False: do not use.", "type": {
"kind": "Bool"}, "default": false}]}, {"name": "robots::JointGoal",
"doc": "Where joints shall go: CRTK's servo_jp and move_jp.", "fields": [{"name": "position",
"doc": "One entry a joint, in chain order.", "type": {"kind": "list", "element": {"kind": "Float64"
}, "capacity": 8}, "unit": "rad"}, {"name": "stamp", "type": {"kind": "time", "clock": "steady"}}]
}, {"name": "robots::JointState",
"doc": "The state of all joints of an arm, in chain order: CRTK's measured_js and setpoint_js. A list is\nempty where its quantity is not known, and as long as `name` otherwise.",
"fields": [{"name": "name", "type": {"kind": "list", "element": {"kind": "text", "capacity": 15},
"capacity": 8}}, {"name": "position", "type": {"kind": "list", "element": {"kind": "Float64"},
"capacity": 8}, "unit": "rad"}, {"name": "velocity", "type": {"kind": "list", "element": {
"kind": "Float64"}, "capacity": 8}, "unit": "rad/s"}, {"name": "effort", "type": {"kind": "list",
"element": {"kind": "Float64"}, "capacity": 8}, "unit": "N.m"}, {"name": "stamp", "type": {
"kind": "time", "clock": "steady"}}, {"name": "valid", "doc": "False: do not use.", "type": {
"kind": "Bool"}, "default": false}]}, {"name": "robots::OperatingState",
"doc": "CRTK's operating_state.", "fields": [{"name": "state", "type": {"kind": "enum",
"name": "robots::ArmState"}, "default": "Undefined"}, {"name": "sub_state", "wire": "subState",
"doc": "What the arm is doing within its state, for people: \"holding\", \"servo_cp\".", "type": {
"kind": "text", "capacity": 15}}, {"name": "is_homed", "wire": "isHomed", "type": {"kind": "Bool"},
"default": false}, {"name": "is_busy", "wire": "isBusy",
"doc": "A move is under way; servo commands do not set it.", "type": {"kind": "Bool"},
"default": false}, {"name": "stamp", "doc": "When the arm entered this state.", "type": {
"kind": "time", "clock": "steady"}}]}, {"name": "robots::JointSolution",
"doc": "A joint vector that an arm computed, without heap so that a control loop may return it.",
"fields": [{"name": "position", "doc": "The first `joints` entries count.", "type": {
"kind": "array", "element": {"kind": "Float64"}, "length": 8}, "unit": "rad"}, {"name": "joints",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "found",
"doc": "False: no joint vector within limits reaches the pose; `position` is the nearest one found.",
"type": {"kind": "Bool"}, "default": false}]}, {"name": "robots::JointConfiguration",
"doc": "What the joints are and may do: CRTK's configuration_js. prmConfigurationJoint.",
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
"doc": "How regularly a task ran, over its last window.", "fields": [{"name": "period_average",
"wire": "periodAverage", "type": {"kind": "Float64"}, "unit": "s", "default": 0.0}, {
"name": "period_deviation", "wire": "periodDeviation", "type": {"kind": "Float64"}, "unit": "s",
"default": 0.0}, {"name": "period_min", "wire": "periodMin", "type": {"kind": "Float64"},
"unit": "s", "default": 0.0}, {"name": "period_max", "wire": "periodMax", "type": {
"kind": "Float64"}, "unit": "s", "default": 0.0}, {"name": "samples", "type": {"kind": "UInt32"},
"default": 0}, {"name": "stamp", "type": {"kind": "time", "clock": "steady"}}, {"name": "valid",
"type": {"kind": "Bool"}, "default": false}]}, {"name": "robots::Twist",
"doc": "A velocity: CRTK's measured_cv. The cisst libraries' prmVelocityCartesianGet.", "fields": [
{"name": "linear", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1},
"unit": "m/s"}, {"name": "angular", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "rad/s"}, {"name": "moving_frame", "wire": "movingFrame", "type": {
"kind": "UInt32"}, "default": 0}, {"name": "reference_frame", "wire": "referenceFrame", "type": {
"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "valid", "doc": "False: do not use.", "type": {"kind": "Bool"}, "default": false}]}, {
"name": "robots::Wrench",
"doc": "Force and torque at the tool tip: CRTK's measured_cf. prmForceCartesianGet.", "fields": [{
"name": "force", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1},
"unit": "N"}, {"name": "torque", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "N.m"}, {"name": "mask", "doc": "Which components are known.", "type": {
"kind": "array", "element": {"kind": "Bool"}, "length": 6}}, {"name": "moving_frame",
"wire": "movingFrame", "type": {"kind": "UInt32"}, "default": 0}, {"name": "reference_frame",
"wire": "referenceFrame", "type": {"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {
"kind": "time", "clock": "steady"}}, {"name": "valid", "doc": "False: do not use.", "type": {
"kind": "Bool"}, "default": false}]}, {"name": "robots::CartesianState",
"doc": "Pose, velocity and force of one instant: CRTK's measured_cs. prmStateCartesian.",
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
"doc": "6 x joints, column-major: linear rows first, in m/s and rad/s per unit of joint velocity.",
"fields": [{"name": "joints", "type": {"kind": "UInt32"}, "default": 0}, {"name": "coefficients",
"type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 48}}, {"name": "stamp",
"type": {"kind": "time", "clock": "steady"}}, {"name": "valid", "type": {"kind": "Bool"},
"default": false}]}, {"name": "robots::TransformStamped",
"doc": "Where one frame is in another, for whoever cannot know from the interface which they are.",
"fields": [{"name": "transform", "doc": "The moving frame in the reference frame.", "type": {
"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "reference_frame",
"wire": "referenceFrame", "doc": "suture::frameId() of their names; 0: not named.", "type": {
"kind": "UInt32"}, "default": 0}, {"name": "moving_frame", "wire": "movingFrame", "type": {
"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "valid", "doc": "False: do not use.", "type": {"kind": "Bool"}, "default": false}]}, {
"name": "robots::JointVelocityGoal", "doc": "CRTK's servo_jv: prmVelocityJointSet.", "fields": [{
"name": "goal", "type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 8},
"unit": "rad/s"}, {"name": "acceleration", "doc": "Optional.", "type": {"kind": "list", "element": {
"kind": "Float64"}, "capacity": 8}, "unit": "rad/s2"}, {"name": "deceleration", "doc": "Optional.",
"type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 8}, "unit": "rad/s2"}, {
"name": "guard", "doc": "Optional: the positions not to pass.", "type": {"kind": "list",
"element": {"kind": "Float64"}, "capacity": 8}, "unit": "rad"}, {"name": "mask",
"doc": "Optional: which joints count; empty: all.", "type": {"kind": "list", "element": {
"kind": "Bool"}, "capacity": 8}}, {"name": "stamp", "type": {"kind": "time", "clock": "steady"}}]},
{"name": "robots::JointEffortGoal", "doc": "CRTK's servo_jf: prmForceTorqueJointSet.", "fields": [{
"name": "effort", "type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 8},
"unit": "N.m"}, {"name": "mask", "doc": "Optional: which joints count; empty: all.", "type": {
"kind": "list", "element": {"kind": "Bool"}, "capacity": 8}}, {"name": "stamp", "type": {
"kind": "time", "clock": "steady"}}]}, {"name": "robots::TwistGoal",
"doc": "A velocity to follow: CRTK's servo_cv. prmVelocityCartesianSet.", "fields": [{
"name": "linear", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1},
"unit": "m/s"}, {"name": "angular", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "rad/s"}, {"name": "linear_acceleration", "wire": "linearAcceleration",
"type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}, "unit": "m/s2"}, {
"name": "angular_acceleration", "wire": "angularAcceleration", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}, "unit": "rad/s2"}, {"name": "mask",
"doc": "Which of x, y, z and the rotations about them count.", "type": {"kind": "array",
"element": {"kind": "Bool"}, "length": 6}}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}]}, {"name": "robots::WrenchGoal",
"doc": "Force and torque to apply: CRTK's servo_cf. prmForceCartesianSet.", "fields": [{
"name": "force", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1},
"unit": "N"}, {"name": "torque", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "N.m"}, {"name": "mask", "doc": "Which components count.", "type": {
"kind": "array", "element": {"kind": "Bool"}, "length": 6}}, {"name": "stamp", "type": {
"kind": "time", "clock": "steady"}}]}, {"name": "suture::Message", "fields": [{"name": "text",
"doc": "UTF-8, for people. Those who send cut what is longer, and end it in \"...\" then.",
"type": {"kind": "text", "capacity": 255}}, {"name": "code",
"doc": "What it is about, by numbers that its sender documents; 0: nothing in particular.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "counter",
"doc": "Counts the messages of its sender, of all three kinds together, from 1: a gap says that the\nlistener has missed some, a number seen before that the last one has been told again.",
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
"name": "value", "is": "@0xbd6bc34f74980c5d"}]}, {"at": 2, "name": "warning", "parameters": [{
"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}]}, {"at": 3, "name": "error", "parameters": [
{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}]}]}, {"id": "@0x814f9864e019fa96",
"kind": "struct", "name": "MessagesStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"
}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}]},
{"id": "@0xbd6bc34f74980c5d", "kind": "struct", "name": "Message", "members": [{"at": 0,
"name": "text", "is": "Text"}, {"at": 1, "name": "code", "is": "UInt32"}, {"at": 2,
"name": "counter", "is": "UInt32"}, {"at": 3, "name": "stamp", "is": "Int64 clock \"steady\""}]}, {
"id": "@0xdcbc184d8af1d03c", "kind": "interface", "name": "ArmEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0x8c45d754ae03e800"}]}, {"at": 1,
"name": "operatingState", "parameters": [{"at": 0, "name": "value", "is": "@0x8109968bd491318f"}]},
{"at": 2, "name": "goalReached", "parameters": [{"at": 0, "name": "value", "is": "Bool"}]}, {
"at": 3, "name": "warning", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}]
}, {"at": 4, "name": "status", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"
}]}, {"at": 5, "name": "error", "parameters": [{"at": 0, "name": "value",
"is": "@0xbd6bc34f74980c5d"}]}, {"at": 6, "name": "desiredState", "parameters": [{"at": 0,
"name": "value", "is": "@0xc9ed1800ca1df7eb"}]}, {"at": 7, "name": "gravityCompensation",
"parameters": [{"at": 0, "name": "value", "is": "Bool"}]}, {"at": 8, "name": "trajectoryJRatio",
"parameters": [{"at": 0, "name": "value", "is": "Float64"}]}, {"at": 9, "name": "trajectoryJRatioV",
"parameters": [{"at": 0, "name": "value", "is": "Float64"}]}, {"at": 10,
"name": "trajectoryJRatioA", "parameters": [{"at": 0, "name": "value", "is": "Float64"}]}]}, {
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
      .hash = "01d839824ecc91650f9758cc15eb526a",
      .description = robots::kArmDescription,
      .commands = robots::kArmCommands,
      .events = kEvents,
      .binding = &robots::armBinding,
      .base = &interfaceInfo<suture::Messages>,
      .toBase = &castToBase<robots::Arm, suture::Messages>,
      .wireEvents = robots::kArmWireEvents,
  };
  return kInfo;
}

auto Provided<robots::Arm>::Scratch::reserved() -> Scratch {
  Scratch scratch{};
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

Errc Provided<robots::Arm>::execute(std::uint16_t command, const std::byte* arguments,
                                    std::byte* result) {
  using ::robots::ArmCommand;
  switch (static_cast<ArmCommand>(command)) {
    case ArmCommand::enable: {
      implementation_.enable();
      return Errc{};
    }
    case ArmCommand::disable: {
      implementation_.disable();
      return Errc{};
    }
    case ArmCommand::home: {
      implementation_.home();
      return Errc{};
    }
    case ArmCommand::hold: {
      implementation_.hold();
      return Errc{};
    }
    case ArmCommand::servo_cp: {
      const auto& slot = slotIn<robots::ArmServoCpArguments>(arguments);
      load(slot.goal, scratch_.servo_cp_goal);
      implementation_.servo_cp(scratch_.servo_cp_goal);
      return Errc{};
    }
    case ArmCommand::servo_jp: {
      const auto& slot = slotIn<robots::ArmServoJpArguments>(arguments);
      load(slot.goal, scratch_.servo_jp_goal);
      implementation_.servo_jp(scratch_.servo_jp_goal);
      return Errc{};
    }
    case ArmCommand::move_jp: {
      const auto& slot = slotIn<robots::ArmMoveJpArguments>(arguments);
      load(slot.goal, scratch_.move_jp_goal);
      implementation_.move_jp(scratch_.move_jp_goal);
      return Errc{};
    }
    case ArmCommand::measured_js: {
      auto& slot = newSlot<robots::JointStateSlot>(result);
      return store(implementation_.measured_js(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::setpoint_js: {
      auto& slot = newSlot<robots::JointStateSlot>(result);
      return store(implementation_.setpoint_js(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::measured_cp: {
      auto& slot = newSlot<robots::PoseStampedSlot>(result);
      return store(implementation_.measured_cp(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::setpoint_cp: {
      auto& slot = newSlot<robots::PoseStampedSlot>(result);
      return store(implementation_.setpoint_cp(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::operating_state: {
      auto& slot = newSlot<robots::OperatingStateSlot>(result);
      return store(implementation_.operating_state(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::forward_kinematics: {
      const auto& slot = slotIn<robots::ArmForwardKinematicsArguments>(arguments);
      load(slot.q, scratch_.forward_kinematics_q);
      auto& answer = newSlot<robots::PoseStampedSlot>(result);
      return store(implementation_.forward_kinematics(scratch_.forward_kinematics_q), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::inverse_kinematics: {
      const auto& slot = slotIn<robots::ArmInverseKinematicsArguments>(arguments);
      load(slot.goal, scratch_.inverse_kinematics_goal);
      auto& answer = newSlot<robots::JointSolutionSlot>(result);
      return store(implementation_.inverse_kinematics(scratch_.inverse_kinematics_goal), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::configuration_js: {
      auto& slot = newSlot<robots::JointConfigurationSlot>(result);
      return store(implementation_.configuration_js(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::period_statistics: {
      auto& slot = newSlot<robots::IntervalStatisticsSlot>(result);
      return store(implementation_.period_statistics(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::pause: {
      implementation_.pause();
      return Errc{};
    }
    case ArmCommand::resume: {
      implementation_.resume();
      return Errc{};
    }
    case ArmCommand::unhome: {
      implementation_.unhome();
      return Errc{};
    }
    case ArmCommand::state_command: {
      const auto& slot = slotIn<robots::ArmStateCommandArguments>(arguments);
      load(slot.name, scratch_.state_command_name);
      implementation_.state_command(scratch_.state_command_name);
      return Errc{};
    }
    case ArmCommand::goal_js: {
      auto& slot = newSlot<robots::JointStateSlot>(result);
      return store(implementation_.goal_js(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::goal_cp: {
      auto& slot = newSlot<robots::PoseStampedSlot>(result);
      return store(implementation_.goal_cp(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::local_measured_cp: {
      auto& slot = newSlot<robots::PoseStampedSlot>(result);
      return store(implementation_.local_measured_cp(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::local_setpoint_cp: {
      auto& slot = newSlot<robots::PoseStampedSlot>(result);
      return store(implementation_.local_setpoint_cp(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::measured_cv: {
      auto& slot = newSlot<robots::TwistSlot>(result);
      return store(implementation_.measured_cv(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::setpoint_cv: {
      auto& slot = newSlot<robots::TwistSlot>(result);
      return store(implementation_.setpoint_cv(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::body_measured_cf: {
      auto& slot = newSlot<robots::WrenchSlot>(result);
      return store(implementation_.body_measured_cf(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::spatial_measured_cf: {
      auto& slot = newSlot<robots::WrenchSlot>(result);
      return store(implementation_.spatial_measured_cf(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::measured_cs: {
      auto& slot = newSlot<robots::CartesianStateSlot>(result);
      return store(implementation_.measured_cs(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::body_jacobian: {
      auto& slot = newSlot<robots::JacobianSlot>(result);
      return store(implementation_.body_jacobian(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::spatial_jacobian: {
      auto& slot = newSlot<robots::JacobianSlot>(result);
      return store(implementation_.spatial_jacobian(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::base_frame: {
      auto& slot = newSlot<robots::TransformStampedSlot>(result);
      return store(implementation_.base_frame(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::set_base_frame: {
      const auto& slot = slotIn<robots::ArmSetBaseFrameArguments>(arguments);
      load(slot.base, scratch_.set_base_frame_base);
      implementation_.set_base_frame(scratch_.set_base_frame_base);
      return Errc{};
    }
    case ArmCommand::free: {
      implementation_.free();
      return Errc{};
    }
    case ArmCommand::use_gravity_compensation: {
      const auto& slot = slotIn<robots::ArmUseGravityCompensationArguments>(arguments);
      load(slot.use, scratch_.use_gravity_compensation_use);
      implementation_.use_gravity_compensation(scratch_.use_gravity_compensation_use);
      return Errc{};
    }
    case ArmCommand::servo_jr: {
      const auto& slot = slotIn<robots::ArmServoJrArguments>(arguments);
      load(slot.step, scratch_.servo_jr_step);
      implementation_.servo_jr(scratch_.servo_jr_step);
      return Errc{};
    }
    case ArmCommand::servo_jv: {
      const auto& slot = slotIn<robots::ArmServoJvArguments>(arguments);
      load(slot.goal, scratch_.servo_jv_goal);
      implementation_.servo_jv(scratch_.servo_jv_goal);
      return Errc{};
    }
    case ArmCommand::servo_jf: {
      const auto& slot = slotIn<robots::ArmServoJfArguments>(arguments);
      load(slot.goal, scratch_.servo_jf_goal);
      implementation_.servo_jf(scratch_.servo_jf_goal);
      return Errc{};
    }
    case ArmCommand::servo_cr: {
      const auto& slot = slotIn<robots::ArmServoCrArguments>(arguments);
      load(slot.step, scratch_.servo_cr_step);
      implementation_.servo_cr(scratch_.servo_cr_step);
      return Errc{};
    }
    case ArmCommand::servo_cv: {
      const auto& slot = slotIn<robots::ArmServoCvArguments>(arguments);
      load(slot.goal, scratch_.servo_cv_goal);
      implementation_.servo_cv(scratch_.servo_cv_goal);
      return Errc{};
    }
    case ArmCommand::body_servo_cf: {
      const auto& slot = slotIn<robots::ArmBodyServoCfArguments>(arguments);
      load(slot.goal, scratch_.body_servo_cf_goal);
      implementation_.body_servo_cf(scratch_.body_servo_cf_goal);
      return Errc{};
    }
    case ArmCommand::spatial_servo_cf: {
      const auto& slot = slotIn<robots::ArmSpatialServoCfArguments>(arguments);
      load(slot.goal, scratch_.spatial_servo_cf_goal);
      implementation_.spatial_servo_cf(scratch_.spatial_servo_cf_goal);
      return Errc{};
    }
    case ArmCommand::interpolate_jp: {
      const auto& slot = slotIn<robots::ArmInterpolateJpArguments>(arguments);
      load(slot.goal, scratch_.interpolate_jp_goal);
      implementation_.interpolate_jp(scratch_.interpolate_jp_goal);
      return Errc{};
    }
    case ArmCommand::interpolate_jr: {
      const auto& slot = slotIn<robots::ArmInterpolateJrArguments>(arguments);
      load(slot.step, scratch_.interpolate_jr_step);
      implementation_.interpolate_jr(scratch_.interpolate_jr_step);
      return Errc{};
    }
    case ArmCommand::interpolate_cp: {
      const auto& slot = slotIn<robots::ArmInterpolateCpArguments>(arguments);
      load(slot.goal, scratch_.interpolate_cp_goal);
      implementation_.interpolate_cp(scratch_.interpolate_cp_goal);
      return Errc{};
    }
    case ArmCommand::interpolate_cr: {
      const auto& slot = slotIn<robots::ArmInterpolateCrArguments>(arguments);
      load(slot.step, scratch_.interpolate_cr_step);
      implementation_.interpolate_cr(scratch_.interpolate_cr_step);
      return Errc{};
    }
    case ArmCommand::move_jr: {
      const auto& slot = slotIn<robots::ArmMoveJrArguments>(arguments);
      load(slot.step, scratch_.move_jr_step);
      implementation_.move_jr(scratch_.move_jr_step);
      return Errc{};
    }
    case ArmCommand::move_cp: {
      const auto& slot = slotIn<robots::ArmMoveCpArguments>(arguments);
      load(slot.goal, scratch_.move_cp_goal);
      implementation_.move_cp(scratch_.move_cp_goal);
      return Errc{};
    }
    case ArmCommand::move_cr: {
      const auto& slot = slotIn<robots::ArmMoveCrArguments>(arguments);
      load(slot.step, scratch_.move_cr_step);
      implementation_.move_cr(scratch_.move_cr_step);
      return Errc{};
    }
    case ArmCommand::trajectory_j_set_ratio: {
      const auto& slot = slotIn<robots::ArmTrajectoryJSetRatioArguments>(arguments);
      load(slot.ratio, scratch_.trajectory_j_set_ratio_ratio);
      implementation_.trajectory_j_set_ratio(scratch_.trajectory_j_set_ratio_ratio);
      return Errc{};
    }
    case ArmCommand::trajectory_j_set_ratio_v: {
      const auto& slot = slotIn<robots::ArmTrajectoryJSetRatioVArguments>(arguments);
      load(slot.ratio, scratch_.trajectory_j_set_ratio_v_ratio);
      implementation_.trajectory_j_set_ratio_v(scratch_.trajectory_j_set_ratio_v_ratio);
      return Errc{};
    }
    case ArmCommand::trajectory_j_set_ratio_a: {
      const auto& slot = slotIn<robots::ArmTrajectoryJSetRatioAArguments>(arguments);
      load(slot.ratio, scratch_.trajectory_j_set_ratio_a_ratio);
      implementation_.trajectory_j_set_ratio_a(scratch_.trajectory_j_set_ratio_a_ratio);
      return Errc{};
    }
    case ArmCommand::trajectory_j_ratio: {
      auto& slot = newSlot<double>(result);
      return store(implementation_.trajectory_j_ratio(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::trajectory_j_ratio_v: {
      auto& slot = newSlot<double>(result);
      return store(implementation_.trajectory_j_ratio_v(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::trajectory_j_ratio_a: {
      auto& slot = newSlot<double>(result);
      return store(implementation_.trajectory_j_ratio_a(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::query_cp: {
      const auto& slot = slotIn<robots::ArmQueryCpArguments>(arguments);
      load(slot.q, scratch_.query_cp_q);
      auto& answer = newSlot<robots::PoseStampedSlot>(result);
      return store(implementation_.query_cp(scratch_.query_cp_q), answer) ? Errc{} : Errc::TooLarge;
    }
    case ArmCommand::local_query_cp: {
      const auto& slot = slotIn<robots::ArmLocalQueryCpArguments>(arguments);
      load(slot.q, scratch_.local_query_cp_q);
      auto& answer = newSlot<robots::PoseStampedSlot>(result);
      return store(implementation_.local_query_cp(scratch_.local_query_cp_q), answer)
          ? Errc{} : Errc::TooLarge;
    }
  }
  return Provided<suture::Messages>::execute(command, arguments, result);
}

}  // namespace suture
