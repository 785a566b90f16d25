// Written by suturec from reference/arm_like.h. Do not edit.
#include "reference/arm_like.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "reference/arm_like.capnp.h"

// Defined in reference/arm_types.suture.cpp.
namespace reference {
void toWire(const JointStateSlot& slot, wire::JointState::Builder out);
suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration shift);
bool isValid(const JointStateSlot& slot, suture::FieldPath* path);
wire::Mode wireMode(std::uint8_t slot);
bool isKnownMode(std::uint8_t slot);
suture::Errc fromWire(wire::Mode in, std::uint8_t& slot);
void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out);
suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift);
bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path);
}  // namespace reference

namespace reference {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Duration;
using suture::Errc;
using suture::EventInfo;
using suture::FieldPath;
using suture::checkSlot;
using suture::load;
using suture::newSlot;
using suture::refusedAt;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::firstError;
using suture::rpc::fromWire;
using suture::rpc::inRange;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::shiftSlot;
using suture::slotIn;
using suture::slotSize;
using suture::store;

bool store(const PoseStamped& goal, ArmLikeServoCpArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmLikeServoCpArguments& slot, Duration shift) { shiftStamps(slot.goal, shift); }

bool store(const JointState& goal, ArmLikeServoJpArguments& slot) { return store(goal, slot.goal); }

bool store(const Mode& mode, ArmLikeSetModeArguments& slot) { return store(mode, slot.mode); }

bool store(const PoseStamped& to, ArmLikeDistanceArguments& slot) { return store(to, slot.to); }

void shiftStamps(ArmLikeDistanceArguments& slot, Duration shift) { shiftStamps(slot.to, shift); }

bool store(const PoseStamped& goal, const double& speed, const std::string& reason,
           ArmLikeMoveArguments& slot) {
  return store(goal, slot.goal) && store(speed, slot.speed) && store(reason, slot.reason);
}

void shiftStamps(ArmLikeMoveArguments& slot, Duration shift) { shiftStamps(slot.goal, shift); }

bool store(const double& speed, const Mode& mode, ArmLikeLimitArguments& slot) {
  return store(speed, slot.speed) && store(mode, slot.mode);
}

bool store(const PoseStamped& value, const double& value2, ArmLikeMovedPayload& slot) {
  return store(value, slot.value) && store(value2, slot.value2);
}

void load(const ArmLikeMovedPayload& slot, PoseStamped& value, double& value2) {
  load(slot.value, value);
  load(slot.value2, value2);
}

void shiftStamps(ArmLikeMovedPayload& slot, Duration shift) { shiftStamps(slot.value, shift); }

namespace {

bool acceptsArmLikeServoCp(const ArmLikeServoCpArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmLikeServoJp(const ArmLikeServoJpArguments& slot, FieldPath* path) {
  return isValid(slot.goal, path) || refusedAt(path, "goal");
}

bool acceptsArmLikeSetMode(const ArmLikeSetModeArguments& slot, FieldPath* path) {
  return isKnownMode(slot.mode) || refusedAt(path, "mode");
}

bool acceptsArmLikeDistance(const ArmLikeDistanceArguments& slot, FieldPath* path) {
  return isValid(slot.to, path) || refusedAt(path, "to");
}

bool acceptsArmLikeDistanceResult(const double& slot, FieldPath*) { return isValid(slot); }

bool acceptsArmLikeMove(const ArmLikeMoveArguments& slot, FieldPath* path) {
  if (!isValid(slot.goal, path)) return refusedAt(path, "goal");
  return inRange(slot.speed, 0, 1) || refusedAt(path, "speed");
}

bool acceptsArmLikeLimit(const ArmLikeLimitArguments& slot, FieldPath* path) {
  if (!isValid(slot.speed)) return refusedAt(path, "speed");
  return isKnownMode(slot.mode) || refusedAt(path, "mode");
}

bool acceptsArmLikeModeEvent(const std::uint8_t& slot, FieldPath*) { return isKnownMode(slot); }

bool acceptsArmLikeMovedEvent(const ArmLikeMovedPayload& slot, FieldPath* path) {
  if (!isValid(slot.value, path)) return refusedAt(path, "value");
  return isValid(slot.value2) || refusedAt(path, "value2");
}

// --- ArmLike over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class ArmLikeSink final : public suture::rpc::EventSink {
 public:
  explicit ArmLikeSink(wire::ArmLikeEvents::Client subscriber) : subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(ArmLikeEvent::mode): {
        const auto& slot = slotIn<std::uint8_t>(payload);
        auto request = subscriber_.modeRequest();
        request.setValue(wireMode(slot));
        return request.send().ignoreResult();
      }
      case numberOf(ArmLikeEvent::arrived): {
        const auto& slot = slotIn<PoseStampedSlot>(payload);
        auto request = subscriber_.arrivedRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case numberOf(ArmLikeEvent::stopped): {
        return subscriber_.stoppedRequest().send().ignoreResult();
      }
      case numberOf(ArmLikeEvent::moved): {
        const auto& slot = slotIn<ArmLikeMovedPayload>(payload);
        auto request = subscriber_.movedRequest();
        toWire(slot.value, request.initValue());
        request.setValue2(slot.value2);
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
      const auto& slot = slotIn<PoseStampedSlot>(columns[0]);
      toWire(slot, out.initMeasuredCp());
    }
    if (row.hasValue(1)) {
      const auto& slot = slotIn<JointStateSlot>(columns[1]);
      toWire(slot, out.initMeasuredJs());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::ArmLikeEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class ArmLikeServant final : public wire::ArmLike::Server {
 public:
  explicit ArmLikeServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<ArmLikeSink>(in.getEvents()), in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> servoCp(ServoCpContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmLikeServoCpArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmLikeCommand::servo_cp), in.getSent(), fill);
  }

  kj::Promise<void> servoJp(ServoJpContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmLikeServoJpArguments>(memory);
      return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(ArmLikeCommand::servo_jp), in.getSent(), fill);
  }

  kj::Promise<void> hold(HoldContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(ArmLikeCommand::hold), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> setMode(SetModeContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmLikeSetModeArguments>(memory);
      return fromWire(in.getMode(), slot.mode);
    };
    return port_->command(numberOf(ArmLikeCommand::set_mode), in.getSent(), fill);
  }

  kj::Promise<void> measuredCp(MeasuredCpContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<PoseStampedSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmLikeCommand::measured_cp), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> measuredJs(MeasuredJsContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<JointStateSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(ArmLikeCommand::measured_js), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> distance(DistanceContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmLikeDistanceArguments>(memory);
      return in.hasTo() ? fromWire(in.getTo(), slot.to, port_->shift()) : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
    };
    return port_->call(numberOf(ArmLikeCommand::distance), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> move(MoveContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmLikeMoveArguments>(memory);
      slot.speed = in.getSpeed();
      return firstError({
          in.hasGoal() ? fromWire(in.getGoal(), slot.goal, port_->shift()) : Errc::Invalid,
          fromWire(in.getReason(), slot.reason),
      });
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<std::uint8_t>(result);
      auto out = context.getResults();
      out.setValue(slot != 0);
    };
    return port_->call(numberOf(ArmLikeCommand::move), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> reset(ResetContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<std::uint32_t>(result);
      auto out = context.getResults();
      out.setValue(slot);
    };
    return port_->call(numberOf(ArmLikeCommand::reset), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> limit(LimitContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<ArmLikeLimitArguments>(memory);
      slot.speed = in.getSpeed();
      return fromWire(in.getMode(), slot.mode);
    };
    return port_->command(numberOf(ArmLikeCommand::limit), in.getSent(), fill);
  }

  kj::Promise<void> park(ParkContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(ArmLikeCommand::park), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- ArmLike over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class ArmLikeReceiver final : public wire::ArmLikeEvents::Server {
 public:
  explicit ArmLikeReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<PoseStampedSlot>(0);
      const Errc error =
          in.hasMeasuredCp() ? fromWire(in.getMeasuredCp(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    if (columns.hasValue(1)) {
      auto& slot = port_->column<JointStateSlot>(1);
      const Errc error =
          in.hasMeasuredJs() ? fromWire(in.getMeasuredJs(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(1, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> mode(ModeContext context) override {
    auto in = context.getParams();
    return port_->event<std::uint8_t>(numberOf(ArmLikeEvent::mode), [&](std::uint8_t& slot) {
      return fromWire(in.getValue(), slot);
    });
  }

  kj::Promise<void> arrived(ArrivedContext context) override {
    auto in = context.getParams();
    return port_->event<PoseStampedSlot>(numberOf(ArmLikeEvent::arrived),
                                         [&](PoseStampedSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

  kj::Promise<void> stopped(StoppedContext) override {
    return port_->event(numberOf(ArmLikeEvent::stopped));
  }

  kj::Promise<void> moved(MovedContext context) override {
    auto in = context.getParams();
    return port_->event<ArmLikeMovedPayload>(numberOf(ArmLikeEvent::moved),
                                             [&](ArmLikeMovedPayload& slot) {
      slot.value2 = in.getValue2();
      return in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid;
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class ArmLikeProxy final : public suture::rpc::Proxy {
 public:
  ArmLikeProxy(wire::ArmLike::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<ArmLikeReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<ArmLikeCommand>(record.command)) {
      case ArmLikeCommand::servo_cp: {
        const auto& slot = slotIn<ArmLikeServoCpArguments>(record.arguments());
        auto request = provider_.servoCpRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmLikeCommand::servo_jp: {
        const auto& slot = slotIn<ArmLikeServoJpArguments>(record.arguments());
        auto request = provider_.servoJpRequest();
        toWire(slot.goal, request.initGoal());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmLikeCommand::hold: {
        auto request = provider_.holdRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmLikeCommand::set_mode: {
        const auto& slot = slotIn<ArmLikeSetModeArguments>(record.arguments());
        auto request = provider_.setModeRequest();
        request.setMode(wireMode(slot.mode));
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmLikeCommand::measured_cp: {
        auto request = provider_.measuredCpRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PoseStampedSlot>(call, response.getStamp(), [&](PoseStampedSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmLikeCommand::measured_js: {
        auto request = provider_.measuredJsRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<JointStateSlot>(call, response.getStamp(), [&](JointStateSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case ArmLikeCommand::distance: {
        const auto& slot = slotIn<ArmLikeDistanceArguments>(record.arguments());
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
      case ArmLikeCommand::move: {
        const auto& slot = slotIn<ArmLikeMoveArguments>(record.arguments());
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
      case ArmLikeCommand::reset: {
        auto request = provider_.resetRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::uint32_t>(call, [&](std::uint32_t& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case ArmLikeCommand::limit: {
        const auto& slot = slotIn<ArmLikeLimitArguments>(record.arguments());
        auto request = provider_.limitRequest();
        request.setSpeed(slot.speed);
        request.setMode(wireMode(slot.mode));
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case ArmLikeCommand::park: {
        auto request = provider_.parkRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::ArmLike::Client provider_;
  ProxyPort& port_;
};

class ArmLikeBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<ArmLikeServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<ArmLikeProxy>(contract.castAs<wire::ArmLike>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<ArmLikeSink>(subscriber.castAs<wire::ArmLikeEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::ArmLike>();
  }
};

const suture::rpc::Binding& armLikeBinding() {
  static const ArmLikeBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kArmLikeCommands[] = {
    {.name = "servo_cp",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmLikeServoCpArguments>,
     .depth = 16,
     .latest = true,
     .ttl = Duration(500'000'000),
     .accepts = checkSlot<ArmLikeServoCpArguments, acceptsArmLikeServoCp>,
     .shiftArguments = shiftSlot<ArmLikeServoCpArguments>},
    {.name = "servo_jp",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmLikeServoJpArguments>,
     .depth = 16,
     .latest = true,
     .accepts = checkSlot<ArmLikeServoJpArguments, acceptsArmLikeServoJp>},
    {.name = "hold", .kind = CommandKind::Void, .depth = 4},
    {.name = "set_mode",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmLikeSetModeArguments>,
     .depth = 16,
     .accepts = checkSlot<ArmLikeSetModeArguments, acceptsArmLikeSetMode>},
    {.name = "measured_cp",
     .kind = CommandKind::Read,
     .resultSize = slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = shiftSlot<PoseStampedSlot>},
    {.name = "measured_js",
     .kind = CommandKind::Read,
     .resultSize = slotSize<JointStateSlot>,
     .depth = 16,
     .column = 1,
     .acceptsResult = checkSlot<JointStateSlot, isValid>},
    {.name = "distance",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = slotSize<ArmLikeDistanceArguments>,
     .resultSize = slotSize<double>,
     .depth = 16,
     .accepts = checkSlot<ArmLikeDistanceArguments, acceptsArmLikeDistance>,
     .acceptsResult = checkSlot<double, acceptsArmLikeDistanceResult>,
     .shiftArguments = shiftSlot<ArmLikeDistanceArguments>},
    {.name = "move",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = slotSize<ArmLikeMoveArguments>,
     .resultSize = slotSize<std::uint8_t>,
     .depth = 16,
     .deadline = Duration(200'000'000),
     .accepts = checkSlot<ArmLikeMoveArguments, acceptsArmLikeMove>,
     .shiftArguments = shiftSlot<ArmLikeMoveArguments>},
    {.name = "reset",
     .kind = CommandKind::VoidReturn,
     .resultSize = slotSize<std::uint32_t>,
     .depth = 16},
    {.name = "limit",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<ArmLikeLimitArguments>,
     .depth = 2,
     .accepts = checkSlot<ArmLikeLimitArguments, acceptsArmLikeLimit>},
    {.name = "park", .kind = CommandKind::Void, .depth = 16},
};

constexpr EventInfo kArmLikeEvents[] = {
    {.name = "mode",
     .payloadSize = slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true,
     .accepts = checkSlot<std::uint8_t, acceptsArmLikeModeEvent>},
    {.name = "arrived",
     .payloadSize = slotSize<PoseStampedSlot>,
     .depth = 4,
     .accepts = checkSlot<PoseStampedSlot, isValid>,
     .shiftPayload = shiftSlot<PoseStampedSlot>},
    {.name = "stopped", .depth = 16},
    {.name = "moved",
     .payloadSize = slotSize<ArmLikeMovedPayload>,
     .depth = 16,
     .accepts = checkSlot<ArmLikeMovedPayload, acceptsArmLikeMovedEvent>,
     .shiftPayload = shiftSlot<ArmLikeMovedPayload>},
};

// The self-description, as in reference/arm_like.suture.json.
constexpr char kArmLikeDescription[] = R"json({"name": "reference::ArmLike"})json";

}  // namespace
}  // namespace reference

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<reference::ArmLike>() {
  static constexpr InterfaceInfo kInfo{
      .name = "reference::ArmLike",
      .hash = "reference",
      .description = reference::kArmLikeDescription,
      .commands = reference::kArmLikeCommands,
      .events = reference::kArmLikeEvents,
      .binding = &reference::armLikeBinding,
  };
  return kInfo;
}

auto Provided<reference::ArmLike>::Scratch::reserved() -> Scratch {
  Scratch scratch{};
  reserveFor<decltype(reference::ArmLikeServoJpArguments::goal)>(scratch.servo_jp_goal);
  reserveFor<decltype(reference::ArmLikeMoveArguments::reason)>(scratch.move_reason);
  return scratch;
}

Errc Provided<reference::ArmLike>::execute(std::uint16_t command, const std::byte* arguments,
                                           std::byte* result) {
  using ::reference::ArmLikeCommand;
  switch (static_cast<ArmLikeCommand>(command)) {
    case ArmLikeCommand::servo_cp: {
      const auto& slot = slotIn<reference::ArmLikeServoCpArguments>(arguments);
      load(slot.goal, scratch_.servo_cp_goal);
      implementation_.servo_cp(scratch_.servo_cp_goal);
      return Errc{};
    }
    case ArmLikeCommand::servo_jp: {
      const auto& slot = slotIn<reference::ArmLikeServoJpArguments>(arguments);
      load(slot.goal, scratch_.servo_jp_goal);
      implementation_.servo_jp(scratch_.servo_jp_goal);
      return Errc{};
    }
    case ArmLikeCommand::hold: {
      implementation_.hold();
      return Errc{};
    }
    case ArmLikeCommand::set_mode: {
      const auto& slot = slotIn<reference::ArmLikeSetModeArguments>(arguments);
      load(slot.mode, scratch_.set_mode_mode);
      implementation_.set_mode(scratch_.set_mode_mode);
      return Errc{};
    }
    case ArmLikeCommand::measured_cp: {
      auto& slot = newSlot<reference::PoseStampedSlot>(result);
      return store(implementation_.measured_cp(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmLikeCommand::measured_js: {
      auto& slot = newSlot<reference::JointStateSlot>(result);
      return store(implementation_.measured_js(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmLikeCommand::distance: {
      const auto& slot = slotIn<reference::ArmLikeDistanceArguments>(arguments);
      load(slot.to, scratch_.distance_to);
      auto& answer = newSlot<double>(result);
      return store(implementation_.distance(scratch_.distance_to), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case ArmLikeCommand::move: {
      const auto& slot = slotIn<reference::ArmLikeMoveArguments>(arguments);
      load(slot.goal, scratch_.move_goal);
      load(slot.speed, scratch_.move_speed);
      load(slot.reason, scratch_.move_reason);
      auto& answer = newSlot<std::uint8_t>(result);
      return store(implementation_.move(scratch_.move_goal, scratch_.move_speed,
                                        scratch_.move_reason), answer) ? Errc{} : Errc::TooLarge;
    }
    case ArmLikeCommand::reset: {
      auto& slot = newSlot<std::uint32_t>(result);
      return store(implementation_.reset(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmLikeCommand::limit: {
      const auto& slot = slotIn<reference::ArmLikeLimitArguments>(arguments);
      load(slot.speed, scratch_.limit_speed);
      load(slot.mode, scratch_.limit_mode);
      implementation_.limit(scratch_.limit_speed, scratch_.limit_mode);
      return Errc{};
    }
    case ArmLikeCommand::park: {
      implementation_.park();
      return Errc{};
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
