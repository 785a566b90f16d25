// Written by suturec from arm/arm.h. Do not edit.
#include "arm/arm.suture.h"

#include <suture/transport/rpc/binding.h>
#include <suture/transport/rpc/proxy_port.h>
#include <suture/transport/rpc/servant_port.h>
#include <suture/transport/rpc/wire.h>

#include <type_traits>

#include "arm/arm.capnp.h"

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

// Defined in robot_types/operating_state.suture.cpp.
namespace robots {
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
}  // namespace robots

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
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::shiftSlot;
using suture::slotIn;
using suture::slotSize;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<ArmWarning>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(ArmWarning::NotEnabled) == 0);
static_assert(static_cast<std::uint8_t>(ArmWarning::OutOfReach) == 1);
static_assert(static_cast<std::uint8_t>(ArmWarning::Malformed) == 2);
static_assert(static_cast<std::uint8_t>(ArmWarning::ClientGone) == 3);
static_assert(static_cast<std::uint8_t>(ArmWarning::WrongState) == 4);
static_assert(static_cast<std::uint8_t>(ArmWarning::FollowingError) == 5);
static_assert(static_cast<std::uint8_t>(ArmWarning::AtLimit) == 6);
static_assert(static_cast<std::uint8_t>(ArmWarning::StepTooFar) == 7);
static_assert(static_cast<std::uint8_t>(ArmWarning::PowerLost) == 8);
static_assert(static_cast<std::uint8_t>(ArmWarning::DrivesSilent) == 9);

}  // namespace

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

// --- between slots and Cap'n Proto

wire::ArmWarning wireArmWarning(std::uint8_t slot) {
  switch (static_cast<ArmWarning>(slot)) {
    case ArmWarning::NotEnabled: return wire::ArmWarning::NOT_ENABLED;
    case ArmWarning::OutOfReach: return wire::ArmWarning::OUT_OF_REACH;
    case ArmWarning::Malformed: return wire::ArmWarning::MALFORMED;
    case ArmWarning::ClientGone: return wire::ArmWarning::CLIENT_GONE;
    case ArmWarning::WrongState: return wire::ArmWarning::WRONG_STATE;
    case ArmWarning::FollowingError: return wire::ArmWarning::FOLLOWING_ERROR;
    case ArmWarning::AtLimit: return wire::ArmWarning::AT_LIMIT;
    case ArmWarning::StepTooFar: return wire::ArmWarning::STEP_TOO_FAR;
    case ArmWarning::PowerLost: return wire::ArmWarning::POWER_LOST;
    case ArmWarning::DrivesSilent: return wire::ArmWarning::DRIVES_SILENT;
  }
  return wire::ArmWarning{};
}

bool isKnownArmWarning(std::uint8_t slot) {
  switch (static_cast<ArmWarning>(slot)) {
    case ArmWarning::NotEnabled:
    case ArmWarning::OutOfReach:
    case ArmWarning::Malformed:
    case ArmWarning::ClientGone:
    case ArmWarning::WrongState:
    case ArmWarning::FollowingError:
    case ArmWarning::AtLimit:
    case ArmWarning::StepTooFar:
    case ArmWarning::PowerLost:
    case ArmWarning::DrivesSilent:
      return true;
  }
  return false;
}

Errc fromWire(wire::ArmWarning in, std::uint8_t& slot) {
  switch (in) {
    case wire::ArmWarning::NOT_ENABLED: return slot =
        static_cast<std::uint8_t>(ArmWarning::NotEnabled), Errc{};
    case wire::ArmWarning::OUT_OF_REACH: return slot =
        static_cast<std::uint8_t>(ArmWarning::OutOfReach), Errc{};
    case wire::ArmWarning::MALFORMED: return slot =
        static_cast<std::uint8_t>(ArmWarning::Malformed), Errc{};
    case wire::ArmWarning::CLIENT_GONE: return slot =
        static_cast<std::uint8_t>(ArmWarning::ClientGone), Errc{};
    case wire::ArmWarning::WRONG_STATE: return slot =
        static_cast<std::uint8_t>(ArmWarning::WrongState), Errc{};
    case wire::ArmWarning::FOLLOWING_ERROR: return slot =
        static_cast<std::uint8_t>(ArmWarning::FollowingError), Errc{};
    case wire::ArmWarning::AT_LIMIT: return slot =
        static_cast<std::uint8_t>(ArmWarning::AtLimit), Errc{};
    case wire::ArmWarning::STEP_TOO_FAR: return slot =
        static_cast<std::uint8_t>(ArmWarning::StepTooFar), Errc{};
    case wire::ArmWarning::POWER_LOST: return slot =
        static_cast<std::uint8_t>(ArmWarning::PowerLost), Errc{};
    case wire::ArmWarning::DRIVES_SILENT: return slot =
        static_cast<std::uint8_t>(ArmWarning::DrivesSilent), Errc{};
  }
  return Errc::Invalid;
}

namespace {

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

bool acceptsArmWarningEvent(const std::uint8_t& slot, FieldPath*) {
  return isKnownArmWarning(slot);
}

// --- Arm over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class ArmSink final : public suture::rpc::EventSink {
 public:
  explicit ArmSink(wire::ArmEvents::Client subscriber) : subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
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
      case numberOf(ArmEvent::warning): {
        const auto& slot = slotIn<std::uint8_t>(payload);
        auto request = subscriber_.warningRequest();
        request.setValue(wireArmWarning(slot));
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
    return request.send().ignoreResult();
  }

 private:
  wire::ArmEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class ArmServant final : public wire::Arm::Server {
 public:
  explicit ArmServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<ArmSink>(in.getEvents()), in.getEventMask(), in.getStateMask());
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

 private:
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
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
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

  kj::Promise<void> warning(WarningContext context) override {
    auto in = context.getParams();
    return port_->event<std::uint8_t>(numberOf(ArmEvent::warning), [&](std::uint8_t& slot) {
      return fromWire(in.getValue(), slot);
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class ArmProxy final : public suture::rpc::Proxy {
 public:
  ArmProxy(wire::Arm::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<ArmReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
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
    }
    return kj::READY_NOW;
  }

 private:
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
};

constexpr EventInfo kArmEvents[] = {
    {.name = "operating_state",
     .payloadSize = slotSize<OperatingStateSlot>,
     .depth = 16,
     .latched = true,
     .accepts = checkSlot<OperatingStateSlot, isValid>,
     .shiftPayload = shiftSlot<OperatingStateSlot>},
    {.name = "goal_reached", .payloadSize = slotSize<std::uint8_t>, .depth = 16},
    {.name = "warning",
     .payloadSize = slotSize<std::uint8_t>,
     .depth = 16,
     .accepts = checkSlot<std::uint8_t, acceptsArmWarningEvent>},
};

// The self-description, as in arm/arm.suture.json.
constexpr char kArmDescription[] = R"json(
{"name": "robots::Arm",
"doc": "Commands run in the arm's own thread before its next cycle; reads are from the end of its last\none. Poses are of the tool tip in the arm's base frame. An arm starts, and restarts, undefined;\nonce it hears of its drives, and they may have power, it is disabled and not homed. Until it is\nenabled it ignores motion commands.",
"hash": "0e2a36dfe81e908684a738f811010407", "commands": [{"name": "enable", "kind": "void",
"ordinal": 1, "doc": "Gives the drives power; the arm holds its position.", "queue": 16}, {
"name": "disable", "kind": "void", "ordinal": 2,
"doc": "Stops at once, without power, and ignores motion until enabled again.", "queue": 16}, {
"name": "home", "kind": "void", "ordinal": 3,
"doc": "Moves to the home position; needs an enabled arm. Ends with goal_reached.", "queue": 16}, {
"name": "hold", "kind": "void", "ordinal": 4,
"doc": "Drops what is under way; the set-point stays where it is.", "queue": 16}, {
"name": "servo_cp", "kind": "write", "ordinal": 5, "wire": "servoCp",
"doc": "Streams Cartesian goals, newest wins. Beyond a joint limit the arm slides along that, at the\nnearest that the limits leave; a goal out of reach, or too far for one step, leaves the\nset-point. All three it says in `warning`. setpoint_cp keeps the goal's stamp.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::PoseStamped"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "servo_jp", "kind": "write", "ordinal": 6,
"wire": "servoJp",
"doc": "Streams joint goals, newest wins. A joint whose goal lies beyond its limit stays at that.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::JointGoal"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "move_jp", "kind": "write", "ordinal": 7,
"wire": "moveJp",
"doc": "Plans and executes a smooth motion from the set-point. Ends with goal_reached.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::JointGoal"}}],
"queue": 16}, {"name": "measured_js", "kind": "read", "ordinal": 8, "wire": "measuredJs",
"doc": "Where the joints are. Stamp: the drives' cycle that measured them.", "result": {"type": {
"kind": "struct", "name": "robots::JointState"}}, "queue": 16}, {"name": "setpoint_js",
"kind": "read", "ordinal": 9, "wire": "setpointJs", "doc": "Where the joints shall be.", "result": {
"type": {"kind": "struct", "name": "robots::JointState"}}, "queue": 16}, {"name": "measured_cp",
"kind": "read", "ordinal": 10, "wire": "measuredCp",
"doc": "Where the tool tip is. Stamp: the drives' cycle that measured the joints.", "result": {
"type": {"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {"name": "setpoint_cp",
"kind": "read", "ordinal": 11, "wire": "setpointCp",
"doc": "Where the tool tip shall be. Stamp: that of the servo_cp goal it came from, else the arm's\ncycle.",
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
"kind": "struct", "name": "robots::JointSolution"}}, "queue": 16}], "events": [{
"name": "operating_state", "kind": "write", "ordinal": 1, "wire": "operatingState",
"doc": "Each change of the operating state, and the last one to whoever connects.", "payload": {
"type": {"kind": "struct", "name": "robots::OperatingState"}}, "queue": 16, "latched": true}, {
"name": "goal_reached", "kind": "write", "ordinal": 2, "wire": "goalReached",
"doc": "A move ended: true at its goal, false when something else replaced it.", "payload": {
"type": {"kind": "Bool"}}, "queue": 16}, {"name": "warning", "kind": "write", "ordinal": 3,
"doc": "The arm refused a command, or something has befallen it. Each reason is told once until the\narm obeys again; a refused state command is told each time.",
"payload": {"type": {"kind": "enum", "name": "robots::ArmWarning"}}, "queue": 16}], "enums": [{
"name": "robots::ArmState", "doc": "The states of CRTK.", "underlying": "UInt8", "enumerators": [{
"name": "Undefined", "value": 0, "wire": "undefined"}, {"name": "Disabled", "value": 1,
"wire": "disabled"}, {"name": "Enabled", "value": 2, "wire": "enabled"}, {"name": "Paused",
"value": 3, "wire": "paused"}, {"name": "Fault", "value": 4, "wire": "fault"}]}, {
"name": "robots::ArmWarning", "doc": "Why an arm does not do what it is asked.",
"underlying": "UInt8", "enumerators": [{"name": "NotEnabled", "value": 0, "wire": "notEnabled",
"doc": "motion commands need an enabled arm"}, {"name": "OutOfReach", "value": 1,
"wire": "outOfReach", "doc": "no joint vector reaches the goal; for a move, none within limits"}, {
"name": "Malformed", "value": 2, "wire": "malformed",
"doc": "the goal has the wrong length, is not finite or not a pose"}, {"name": "ClientGone",
"value": 3, "wire": "clientGone",
"doc": "the client whose stream it followed is gone; the arm holds"}, {"name": "WrongState",
"value": 4, "wire": "wrongState",
"doc": "the operating state does not admit the command: operating_states.h"}, {
"name": "FollowingError", "value": 5, "wire": "followingError",
"doc": "a joint trailed its set-point by more than its bound; the arm is in FAULT"}, {
"name": "AtLimit", "value": 6, "wire": "atLimit",
"doc": "what it follows leads beyond a joint limit: the arm slides along it; once\nuntil it leads within again"
}, {"name": "StepTooFar", "value": 7, "wire": "stepTooFar",
"doc": "a servo goal lies farther from the set-point than the rates allow"}, {"name": "PowerLost",
"value": 8, "wire": "powerLost",
"doc": "the drives have no power any more, or may not have it: the arm is disabled"}, {
"name": "DrivesSilent", "value": 9, "wire": "drivesSilent",
"doc": "the drives have measured nothing for 250 ms; the arm is in FAULT"}]}], "structs": [{
"name": "robots::PoseStamped",
"doc": "A pose at a time: what CRTK's measured_cp, setpoint_cp and servo_cp carry.", "fields": [{
"name": "pose", "doc": "Tool tip in the base frame.", "type": {"kind": "isometry",
"scalar": "Float64"}, "unit": "m"}, {"name": "stamp",
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
"type": {"kind": "Bool"}, "default": false}]}], "wire": [{"id": "@0xd2a6fc6237d6fd07",
"kind": "interface", "name": "Arm", "cxx": "robots::Arm", "members": [{"at": 0, "name": "subscribe",
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
}]}]}, {"id": "@0xdcbc184d8af1d03c", "kind": "interface", "name": "ArmEvents", "members": [{
"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0x8c45d754ae03e800"}]}, {
"at": 1, "name": "operatingState", "parameters": [{"at": 0, "name": "value",
"is": "@0x8109968bd491318f"}]}, {"at": 2, "name": "goalReached", "parameters": [{"at": 0,
"name": "value", "is": "Bool"}]}, {"at": 3, "name": "warning", "parameters": [{"at": 0,
"name": "value", "is": "@0xa4117f14f97ed1bb"}]}]}, {"id": "@0x8c45d754ae03e800", "kind": "struct",
"name": "ArmStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "measuredJs", "is": "@0xac24dfe518a4963f"},
{"at": 3, "name": "setpointJs", "is": "@0xac24dfe518a4963f"}, {"at": 4, "name": "measuredCp",
"is": "@0xe84bc0a4b9a0c529"}, {"at": 5, "name": "setpointCp", "is": "@0xe84bc0a4b9a0c529"}, {
"at": 6, "name": "operatingState", "is": "@0x8109968bd491318f"}, {"at": 7, "name": "tooLarge",
"is": "UInt64"}]}, {"id": "@0xac24dfe518a4963f", "kind": "struct", "name": "JointState",
"members": [{"at": 0, "name": "name", "is": "List(Text)"}, {"at": 1, "name": "position",
"is": "List(Float64) unit \"rad\""}, {"at": 2, "name": "velocity",
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
"id": "@0xa4117f14f97ed1bb", "kind": "enum", "name": "ArmWarning", "members": [{"at": 0,
"name": "notEnabled"}, {"at": 1, "name": "outOfReach"}, {"at": 2, "name": "malformed"}, {"at": 3,
"name": "clientGone"}, {"at": 4, "name": "wrongState"}, {"at": 5, "name": "followingError"}, {
"at": 6, "name": "atLimit"}, {"at": 7, "name": "stepTooFar"}, {"at": 8, "name": "powerLost"}, {
"at": 9, "name": "drivesSilent"}]}, {"id": "@0x8943f2eac122865a", "kind": "struct",
"name": "JointGoal", "members": [{"at": 0, "name": "position", "is": "List(Float64) unit \"rad\""},
{"at": 1, "name": "stamp", "is": "Int64 clock \"steady\""}]}, {"id": "@0x871d0a082eb81ee3",
"kind": "struct", "name": "JointSolution", "members": [{"at": 0, "name": "position",
"is": "List(Float64) unit \"rad\" shape \"8\""}, {"at": 1, "name": "joints", "is": "UInt32"}, {
"at": 2, "name": "found", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Arm>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::Arm",
      .hash = "0e2a36dfe81e908684a738f811010407",
      .description = robots::kArmDescription,
      .commands = robots::kArmCommands,
      .events = robots::kArmEvents,
      .binding = &robots::armBinding,
  };
  return kInfo;
}

auto Provided<robots::Arm>::Scratch::reserved() -> Scratch {
  Scratch scratch{};
  reserveFor<decltype(robots::ArmServoJpArguments::goal)>(scratch.servo_jp_goal);
  reserveFor<decltype(robots::ArmMoveJpArguments::goal)>(scratch.move_jp_goal);
  reserveFor<decltype(robots::ArmForwardKinematicsArguments::q)>(scratch.forward_kinematics_q);
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
  }
  return Errc::Invalid;
}

}  // namespace suture
