// Written by suturec from reference/gripper_arm.h. Do not edit.
#include "reference/gripper_arm.suture.h"

#include <suture/transport/rpc/binding.h>
#include <suture/transport/rpc/proxy_port.h>
#include <suture/transport/rpc/servant_port.h>
#include <suture/transport/rpc/wire.h>

#include <type_traits>

#include "reference/gripper_arm.capnp.h"

// Defined in reference/arm_like.suture.cpp.
namespace reference {
void toWire(const JointStateSlot& slot, wire::JointState::Builder out);
suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration shift);
bool isValid(const JointStateSlot& slot);
wire::Mode wireMode(std::uint8_t slot);
suture::Errc fromWire(wire::Mode in, std::uint8_t& slot);
void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out);
suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift);
bool isValid(const PoseStampedSlot& slot);
}  // namespace reference

namespace reference {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Duration;
using suture::Errc;
using suture::EventInfo;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::allOf;
using suture::rpc::firstError;
using suture::rpc::fromWire;
using suture::rpc::fromWireList;
using suture::rpc::inRange;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::rpc::toWireList;

namespace {

constexpr CommandInfo kGripperArmCommands[] = {
    {.name = "servo_cp",
     .kind = CommandKind::Write,
     .argumentsSize = sizeof(ArmLikeServoCpArguments),
     .resultSize = 0,
     .depth = 16,
     .latest = true,
     .ttl = Duration(500'000'000),
     .column = -1},
    {.name = "servo_jp",
     .kind = CommandKind::Write,
     .argumentsSize = sizeof(ArmLikeServoJpArguments),
     .resultSize = 0,
     .depth = 16,
     .latest = true,
     .ttl = Duration(0),
     .column = -1},
    {.name = "hold",
     .kind = CommandKind::Void,
     .argumentsSize = 0,
     .resultSize = 0,
     .depth = 4,
     .latest = false,
     .ttl = Duration(0),
     .column = -1},
    {.name = "set_mode",
     .kind = CommandKind::Write,
     .argumentsSize = sizeof(ArmLikeSetModeArguments),
     .resultSize = 0,
     .depth = 16,
     .latest = false,
     .ttl = Duration(0),
     .column = -1},
    {.name = "measured_cp",
     .kind = CommandKind::Read,
     .argumentsSize = 0,
     .resultSize = sizeof(PoseStampedSlot),
     .depth = 16,
     .latest = false,
     .ttl = Duration(0),
     .column = 0},
    {.name = "measured_js",
     .kind = CommandKind::Read,
     .argumentsSize = 0,
     .resultSize = sizeof(JointStateSlot),
     .depth = 16,
     .latest = false,
     .ttl = Duration(0),
     .column = 1},
    {.name = "distance",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = sizeof(ArmLikeDistanceArguments),
     .resultSize = sizeof(double),
     .depth = 16,
     .latest = false,
     .ttl = Duration(0),
     .column = -1},
    {.name = "move",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = sizeof(ArmLikeMoveArguments),
     .resultSize = sizeof(std::uint8_t),
     .depth = 16,
     .latest = false,
     .ttl = Duration(0),
     .column = -1,
     .deadline = Duration(200'000'000)},
    {.name = "reset",
     .kind = CommandKind::VoidReturn,
     .argumentsSize = 0,
     .resultSize = sizeof(std::uint32_t),
     .depth = 16,
     .latest = false,
     .ttl = Duration(0),
     .column = -1},
    {.name = "limit",
     .kind = CommandKind::Write,
     .argumentsSize = sizeof(ArmLikeLimitArguments),
     .resultSize = 0,
     .depth = 2,
     .latest = false,
     .ttl = Duration(0),
     .column = -1},
    {.name = "park",
     .kind = CommandKind::Void,
     .argumentsSize = 0,
     .resultSize = 0,
     .depth = 16,
     .latest = false,
     .ttl = Duration(0),
     .column = -1},
    {.name = "close",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = sizeof(GripperArmCloseArguments),
     .resultSize = sizeof(double),
     .depth = 16,
     .latest = false,
     .ttl = Duration(0),
     .column = -1},
    {.name = "opening",
     .kind = CommandKind::Read,
     .argumentsSize = 0,
     .resultSize = sizeof(double),
     .depth = 16,
     .latest = false,
     .ttl = Duration(0),
     .column = 2},
};

constexpr EventInfo kGripperArmEvents[] = {
    {.name = "mode",
     .payloadSize = sizeof(std::uint8_t),
     .depth = 16,
     .latest = false,
     .latched = true},
    {.name = "arrived",
     .payloadSize = sizeof(PoseStampedSlot),
     .depth = 4,
     .latest = false,
     .latched = false},
    {.name = "stopped", .payloadSize = 0, .depth = 16, .latest = false, .latched = false},
    {.name = "moved",
     .payloadSize = sizeof(ArmLikeMovedPayload),
     .depth = 16,
     .latest = false,
     .latched = false},
    {.name = "gripped",
     .payloadSize = sizeof(double),
     .depth = 16,
     .latest = false,
     .latched = false},
};

// The self-description, as in reference/gripper_arm.suture.json.
constexpr char kGripperArmDescription[] = R"json({"name": "reference::GripperArm"})json";

}  // namespace

namespace {

// --- GripperArm over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class GripperArmSink final : public suture::rpc::EventSink {
 public:
  explicit GripperArmSink(wire::GripperArmEvents::Client subscriber) :
      subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (static_cast<GripperArmEvent>(event)) {
      case GripperArmEvent::mode: {
        const auto& slot = *reinterpret_cast<const std::uint8_t*>(payload);
        auto request = subscriber_.modeRequest();
        request.setValue(wireMode(slot));
        return request.send().ignoreResult();
      }
      case GripperArmEvent::arrived: {
        const auto& slot = *reinterpret_cast<const PoseStampedSlot*>(payload);
        auto request = subscriber_.arrivedRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case GripperArmEvent::stopped: {
        return subscriber_.stoppedRequest().send().ignoreResult();
      }
      case GripperArmEvent::moved: {
        const auto& slot = *reinterpret_cast<const ArmLikeMovedPayload*>(payload);
        auto request = subscriber_.movedRequest();
        toWire(slot.value, request.initValue());
        request.setValue2(slot.value2);
        return request.send().ignoreResult();
      }
      case GripperArmEvent::gripped: {
        const auto& slot = *reinterpret_cast<const double*>(payload);
        auto request = subscriber_.grippedRequest();
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
    out.setEvaluated(row.valid);
    out.setTooLarge(row.tooLarge);
    if (row.valid >> 0 & 1) {
      const auto& slot = *reinterpret_cast<const PoseStampedSlot*>(columns[0]);
      toWire(slot, out.initMeasuredCp());
    }
    if (row.valid >> 1 & 1) {
      const auto& slot = *reinterpret_cast<const JointStateSlot*>(columns[1]);
      toWire(slot, out.initMeasuredJs());
    }
    if (row.valid >> 2 & 1) {
      const auto& slot = *reinterpret_cast<const double*>(columns[2]);
      out.setOpening(slot);
    }
    return request.send().ignoreResult();
  }

 private:
  wire::GripperArmEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class GripperArmServant final : public wire::GripperArm::Server {
 public:
  explicit GripperArmServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<GripperArmSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> subscribe(wire::ArmLike::Server::SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(suture::interfaceInfo<reference::ArmLike>().binding().makeSink(in.getEvents()),
                     in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> servoCp(ServoCpContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<ArmLikeServoCpArguments*>(memory);
      const Errc error =
          in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
      if (error != Errc{}) return error;
      return isValid(slot.goal) ? Errc{} : Errc::Invalid;
    };
    return port_->command(commandId(GripperArmCommand::servo_cp), in.getSent(), fill);
  }

  kj::Promise<void> servoJp(ServoJpContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<ArmLikeServoJpArguments*>(memory);
      const Errc error =
          in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
      if (error != Errc{}) return error;
      return isValid(slot.goal) ? Errc{} : Errc::Invalid;
    };
    return port_->command(commandId(GripperArmCommand::servo_jp), in.getSent(), fill);
  }

  kj::Promise<void> hold(HoldContext context) override {
    auto in = context.getParams();
    return port_->command(commandId(GripperArmCommand::hold), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> setMode(SetModeContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<ArmLikeSetModeArguments*>(memory);
      return fromWire(in.getMode(), slot.mode);
    };
    return port_->command(commandId(GripperArmCommand::set_mode), in.getSent(), fill);
  }

  kj::Promise<void> measuredCp(MeasuredCpContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = *reinterpret_cast<const PoseStampedSlot*>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(commandId(GripperArmCommand::measured_cp), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> measuredJs(MeasuredJsContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = *reinterpret_cast<const JointStateSlot*>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(commandId(GripperArmCommand::measured_js), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> distance(DistanceContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<ArmLikeDistanceArguments*>(memory);
      const Errc error = in.hasTo() ? fromWire(in.getTo(), slot.to, port_->shift()) : Errc::Invalid;
      if (error != Errc{}) return error;
      return isValid(slot.to) ? Errc{} : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const double*>(result);
      auto out = context.getResults();
      out.setValue(slot);
    };
    return port_->call(commandId(GripperArmCommand::distance), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> move(MoveContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<ArmLikeMoveArguments*>(memory);
      slot.speed = in.getSpeed();
      const Errc error = firstError({
          in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid,
          fromWire(in.getReason(), slot.reason),
      });
      if (error != Errc{}) return error;
      return isValid(slot.goal) && inRange(slot.speed, 0, 1) ? Errc{} : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const std::uint8_t*>(result);
      auto out = context.getResults();
      out.setValue(slot != 0);
    };
    return port_->call(commandId(GripperArmCommand::move), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> reset(ResetContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const std::uint32_t*>(result);
      auto out = context.getResults();
      out.setValue(slot);
    };
    return port_->call(commandId(GripperArmCommand::reset), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> limit(LimitContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<ArmLikeLimitArguments*>(memory);
      slot.speed = in.getSpeed();
      const Errc error = fromWire(in.getMode(), slot.mode);
      if (error != Errc{}) return error;
      return isValid(slot.speed) ? Errc{} : Errc::Invalid;
    };
    return port_->command(commandId(GripperArmCommand::limit), in.getSent(), fill);
  }

  kj::Promise<void> park(ParkContext context) override {
    auto in = context.getParams();
    return port_->command(commandId(GripperArmCommand::park), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> close(CloseContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<GripperArmCloseArguments*>(memory);
      slot.width = in.getWidth();
      return isValid(slot.width) ? Errc{} : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const double*>(result);
      auto out = context.getResults();
      out.setValue(slot);
    };
    return port_->call(commandId(GripperArmCommand::close), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> opening(OpeningContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = *reinterpret_cast<const double*>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(commandId(GripperArmCommand::opening), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  static std::uint16_t commandId(GripperArmCommand command) {
    return static_cast<std::uint16_t>(command);
  }

  kj::Own<ServantPort> port_;
};

// --- GripperArm over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class GripperArmReceiver final : public wire::GripperArmEvents::Server {
 public:
  explicit GripperArmReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    suture::rt::ColumnSet valid = 0;
    if (in.getEvaluated() >> 0 & 1) {
      auto& slot = *reinterpret_cast<PoseStampedSlot*>(port_->column(0));
      const Errc error =
          in.hasMeasuredCp() ? fromWire(in.getMeasuredCp(), slot, port_->shift()) : Errc::Invalid;
      if (error == Errc{}) valid |= suture::rt::ColumnSet{1} << 0;
    }
    if (in.getEvaluated() >> 1 & 1) {
      auto& slot = *reinterpret_cast<JointStateSlot*>(port_->column(1));
      const Errc error =
          in.hasMeasuredJs() ? fromWire(in.getMeasuredJs(), slot, port_->shift()) : Errc::Invalid;
      if (error == Errc{}) valid |= suture::rt::ColumnSet{1} << 1;
    }
    if (in.getEvaluated() >> 2 & 1) {
      auto& slot = *reinterpret_cast<double*>(port_->column(2));
      slot = in.getOpening();
      valid |= suture::rt::ColumnSet{1} << 2;
    }
    port_->publish(in.getStamp(), valid, in.getTooLarge());
    return kj::READY_NOW;
  }

  kj::Promise<void> mode(ModeContext context) override {
    auto in = context.getParams();
    std::uint8_t slot;
    const Errc error = fromWire(in.getValue(), slot);
    return port_->event(eventId(GripperArmEvent::mode), error, slot);
  }

  kj::Promise<void> arrived(ArrivedContext context) override {
    auto in = context.getParams();
    PoseStampedSlot slot;
    const Errc error =
        in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    return port_->event(eventId(GripperArmEvent::arrived), error, slot);
  }

  kj::Promise<void> stopped(StoppedContext) override {
    return port_->event(eventId(GripperArmEvent::stopped));
  }

  kj::Promise<void> moved(MovedContext context) override {
    auto in = context.getParams();
    ArmLikeMovedPayload slot;
    slot.value2 = in.getValue2();
    const Errc error =
        in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid;
    return port_->event(eventId(GripperArmEvent::moved), error, slot);
  }

  kj::Promise<void> gripped(GrippedContext context) override {
    auto in = context.getParams();
    double slot;
    slot = in.getValue();
    const Errc error = Errc{};
    return port_->event(eventId(GripperArmEvent::gripped), error, slot);
  }

 private:
  static std::uint16_t eventId(GripperArmEvent event) { return static_cast<std::uint16_t>(event); }

  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class GripperArmProxy final : public suture::rpc::Proxy {
 public:
  GripperArmProxy(wire::GripperArm::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<GripperArmReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<GripperArmCommand>(record.command)) {
      case GripperArmCommand::servo_cp: {
        const auto& slot = *reinterpret_cast<const ArmLikeServoCpArguments*>(record.arguments());
        auto request = provider_.servoCpRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case GripperArmCommand::servo_jp: {
        const auto& slot = *reinterpret_cast<const ArmLikeServoJpArguments*>(record.arguments());
        auto request = provider_.servoJpRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case GripperArmCommand::hold: {
        auto request = provider_.holdRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case GripperArmCommand::set_mode: {
        const auto& slot = *reinterpret_cast<const ArmLikeSetModeArguments*>(record.arguments());
        auto request = provider_.setModeRequest();
        request.setMode(wireMode(slot.mode));
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case GripperArmCommand::measured_cp: {
        auto request = provider_.measuredCpRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PoseStampedSlot>(call, response.getStamp(), [&](PoseStampedSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case GripperArmCommand::measured_js: {
        auto request = provider_.measuredJsRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<JointStateSlot>(call, response.getStamp(), [&](JointStateSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case GripperArmCommand::distance: {
        const auto& slot = *reinterpret_cast<const ArmLikeDistanceArguments*>(record.arguments());
        auto request = provider_.distanceRequest();
        toWire(slot.to, request.initTo());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case GripperArmCommand::move: {
        const auto& slot = *reinterpret_cast<const ArmLikeMoveArguments*>(record.arguments());
        auto request = provider_.moveRequest();
        toWire(slot.goal, request.initGoal());
        request.setSpeed(slot.speed);
        toWire(slot.reason, request.initReason(slot.reason.size));
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::uint8_t>(call, [&](std::uint8_t& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case GripperArmCommand::reset: {
        auto request = provider_.resetRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::uint32_t>(call, [&](std::uint32_t& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case GripperArmCommand::limit: {
        const auto& slot = *reinterpret_cast<const ArmLikeLimitArguments*>(record.arguments());
        auto request = provider_.limitRequest();
        request.setSpeed(slot.speed);
        request.setMode(wireMode(slot.mode));
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case GripperArmCommand::park: {
        auto request = provider_.parkRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case GripperArmCommand::close: {
        const auto& slot = *reinterpret_cast<const GripperArmCloseArguments*>(record.arguments());
        auto request = provider_.closeRequest();
        request.setWidth(slot.width);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case GripperArmCommand::opening: {
        auto request = provider_.openingRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, response.getStamp(), [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::GripperArm::Client provider_;
  ProxyPort& port_;
};

class GripperArmBinding final : public suture::rpc::Binding {
 public:
  capnp::Capability::Client makeServant(kj::Own<ServantPort> port) const override {
    return wire::GripperArm::Client(kj::heap<GripperArmServant>(kj::mv(port)));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<GripperArmProxy>(contract.castAs<wire::GripperArm>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<GripperArmSink>(subscriber.castAs<wire::GripperArmEvents>());
  }
};

const suture::rpc::Binding& gripperArmBinding() {
  static const GripperArmBinding kBinding;
  return kBinding;
}

}  // namespace
}  // namespace reference

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<reference::GripperArm>() {
  static constexpr InterfaceInfo kInfo{
      .name = "reference::GripperArm",
      .hash = "gripper",
      .description = reference::kGripperArmDescription,
      .commands = reference::kGripperArmCommands,
      .events = reference::kGripperArmEvents,
      .binding = &reference::gripperArmBinding,
      .base = &interfaceInfo<reference::ArmLike>,
      .toBase = &castToBase<reference::GripperArm, reference::ArmLike>,
  };
  return kInfo;
}

Errc Provided<reference::GripperArm>::execute(std::uint16_t command, const std::byte* arguments,
                                              std::byte* result) {
  using ::reference::GripperArmCommand;
  switch (static_cast<GripperArmCommand>(command)) {
    case GripperArmCommand::servo_cp: {
      const auto& slot = *reinterpret_cast<const reference::ArmLikeServoCpArguments*>(arguments);
      load(slot.goal, scratch_.servo_cp_goal);
      implementation_.servo_cp(scratch_.servo_cp_goal);
      return Errc{};
    }
    case GripperArmCommand::servo_jp: {
      const auto& slot = *reinterpret_cast<const reference::ArmLikeServoJpArguments*>(arguments);
      load(slot.goal, scratch_.servo_jp_goal);
      implementation_.servo_jp(scratch_.servo_jp_goal);
      return Errc{};
    }
    case GripperArmCommand::hold: {
      implementation_.hold();
      return Errc{};
    }
    case GripperArmCommand::set_mode: {
      const auto& slot = *reinterpret_cast<const reference::ArmLikeSetModeArguments*>(arguments);
      load(slot.mode, scratch_.set_mode_mode);
      implementation_.set_mode(scratch_.set_mode_mode);
      return Errc{};
    }
    case GripperArmCommand::measured_cp: {
      auto& slot = *reinterpret_cast<reference::PoseStampedSlot*>(result);
      return store(implementation_.measured_cp(), slot) ? Errc{} : Errc::TooLarge;
    }
    case GripperArmCommand::measured_js: {
      auto& slot = *reinterpret_cast<reference::JointStateSlot*>(result);
      return store(implementation_.measured_js(), slot) ? Errc{} : Errc::TooLarge;
    }
    case GripperArmCommand::distance: {
      const auto& slot = *reinterpret_cast<const reference::ArmLikeDistanceArguments*>(arguments);
      load(slot.to, scratch_.distance_to);
      auto& answer = *reinterpret_cast<double*>(result);
      return store(implementation_.distance(scratch_.distance_to), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case GripperArmCommand::move: {
      const auto& slot = *reinterpret_cast<const reference::ArmLikeMoveArguments*>(arguments);
      load(slot.goal, scratch_.move_goal);
      load(slot.speed, scratch_.move_speed);
      load(slot.reason, scratch_.move_reason);
      auto& answer = *reinterpret_cast<std::uint8_t*>(result);
      return store(implementation_.move(scratch_.move_goal, scratch_.move_speed,
                                        scratch_.move_reason), answer) ? Errc{} : Errc::TooLarge;
    }
    case GripperArmCommand::reset: {
      auto& slot = *reinterpret_cast<std::uint32_t*>(result);
      return store(implementation_.reset(), slot) ? Errc{} : Errc::TooLarge;
    }
    case GripperArmCommand::limit: {
      const auto& slot = *reinterpret_cast<const reference::ArmLikeLimitArguments*>(arguments);
      load(slot.speed, scratch_.limit_speed);
      load(slot.mode, scratch_.limit_mode);
      implementation_.limit(scratch_.limit_speed, scratch_.limit_mode);
      return Errc{};
    }
    case GripperArmCommand::park: {
      implementation_.park();
      return Errc{};
    }
    case GripperArmCommand::close: {
      const auto& slot = *reinterpret_cast<const reference::GripperArmCloseArguments*>(arguments);
      load(slot.width, scratch_.close_width);
      auto& answer = *reinterpret_cast<double*>(result);
      return store(implementation_.close(scratch_.close_width), answer) ? Errc{} : Errc::TooLarge;
    }
    case GripperArmCommand::opening: {
      auto& slot = *reinterpret_cast<double*>(result);
      return store(implementation_.opening(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
