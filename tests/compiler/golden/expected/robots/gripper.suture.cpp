// Written by suturec from robots/gripper.h. Do not edit.
#include "robots/gripper.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "robots/gripper.capnp.h"

// Defined in robots/arm.suture.cpp.
namespace robots {
void toWire(const EverythingSlot& slot, wire::Everything::Builder out);
suture::Errc fromWire(wire::Everything::Reader in, EverythingSlot& slot, suture::Duration shift);
bool isValid(const EverythingSlot& slot, suture::FieldPath* path);
wire::Mode wireMode(std::int8_t slot);
bool isKnownMode(std::int8_t slot);
suture::Errc fromWire(wire::Mode in, std::int8_t& slot);
}  // namespace robots

// Defined in robots/geometry.suture.cpp.
namespace robots {
void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out);
suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift);
bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path);
}  // namespace robots

namespace robots {

using suture::CommandInfo;
using suture::CommandKind;
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
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::slotIn;
using suture::slotSize;
using suture::store;

bool store(const double& width, GripperOpenArguments& slot) { return store(width, slot.width); }

bool store(const double& width, GripperFitsArguments& slot) { return store(width, slot.width); }

bool store(const double& value, const bool& value2, GripperGrippedPayload& slot) {
  return store(value, slot.value) && store(value2, slot.value2);
}

void load(const GripperGrippedPayload& slot, double& value, bool& value2) {
  load(slot.value, value);
  load(slot.value2, value2);
}

bool store(const std::int32_t& name, NamesQueueArguments& slot) { return store(name, slot.name); }

bool store(const double& range, const double& slot, const double& store_,
           NamesNameArguments& arguments_) {
  return store(range, arguments_.range) && store(slot, arguments_.slot) &&
      store(store_, arguments_.store);
}

namespace {

bool acceptsGripperOpen(const GripperOpenArguments& slot, FieldPath* path) {
  return isValid(slot.width) || refusedAt(path, "width");
}

bool acceptsGripperOpeningResult(const double& slot, FieldPath*) { return isValid(slot); }

bool acceptsGripperFits(const GripperFitsArguments& slot, FieldPath* path) {
  return isValid(slot.width) || refusedAt(path, "width");
}

bool acceptsGripperGrippedEvent(const GripperGrippedPayload& slot, FieldPath* path) {
  return isValid(slot.value) || refusedAt(path, "value");
}

// --- Gripper over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class GripperSink final : public suture::rpc::EventSink {
 public:
  explicit GripperSink(wire::GripperEvents::Client subscriber) : subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(ArmEvent::mode_changed): {
        const auto& slot = slotIn<std::int8_t>(payload);
        auto request = subscriber_.modeChangedRequest();
        request.setValue(wireMode(slot));
        return request.send().ignoreResult();
      }
      case numberOf(ArmEvent::stopped): {
        return subscriber_.stoppedRequest().send().ignoreResult();
      }
      case numberOf(ArmEvent::arrived): {
        const auto& slot = slotIn<PoseStampedSlot>(payload);
        auto request = subscriber_.arrivedRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case numberOf(ArmEvent::moved): {
        const auto& slot = slotIn<ArmMovedPayload>(payload);
        auto request = subscriber_.movedRequest();
        toWire(slot.value, request.initValue());
        request.setValue2(slot.value2);
        request.setValue3(wireMode(slot.value3));
        return request.send().ignoreResult();
      }
      case numberOf(GripperEvent::gripped): {
        const auto& slot = slotIn<GripperGrippedPayload>(payload);
        auto request = subscriber_.grippedRequest();
        request.setValue(slot.value);
        request.setValue2(slot.value2 != 0);
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
      const auto& slot = slotIn<std::int8_t>(columns[1]);
      out.setMode(wireMode(slot));
    }
    if (row.hasValue(2)) {
      const auto& slot = slotIn<EverythingSlot>(columns[2]);
      toWire(slot, out.initEverything());
    }
    if (row.hasValue(3)) {
      const auto& slot = slotIn<double>(columns[3]);
      out.setLoad(slot);
    }
    if (row.hasValue(4)) {
      const auto& slot = slotIn<double>(columns[4]);
      out.setOpening(slot);
    }
    return request.send().ignoreResult();
  }

 private:
  wire::GripperEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class GripperServant final : public wire::Gripper::Server {
 public:
  explicit GripperServant(kj::Own<ServantPort> port)
      : base_(suture::interfaceInfo<robots::Arm>().binding().makeServant(kj::addRef(*port))),
        port_(kj::mv(port)) {}

  DispatchCallResult dispatchCall(std::uint64_t contract, std::uint16_t method,
                                  suture::rpc::AnyCall call) override {
    if (contract != capnp::typeId<wire::Gripper>()) {
      return base_->dispatchCall(contract, method, call);
    }
    return wire::Gripper::Server::dispatchCall(contract, method, call);
  }

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<GripperSink>(in.getEvents()), in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> open(OpenContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<GripperOpenArguments>(memory);
      slot.width = in.getWidth();
      return Errc{};
    };
    return port_->command(numberOf(GripperCommand::open), in.getSent(), fill);
  }

  kj::Promise<void> opening(OpeningContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(GripperCommand::opening), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> fits(FitsContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<GripperFitsArguments>(memory);
      slot.width = in.getWidth();
      return Errc{};
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<std::uint8_t>(result);
      auto out = context.getResults();
      out.setValue(slot != 0);
    };
    return port_->call(numberOf(GripperCommand::fits), in.getSent(), fill, kj::mv(take));
  }

 private:
  kj::Own<capnp::Capability::Server> base_;
  kj::Own<ServantPort> port_;
};

// --- Gripper over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class GripperReceiver final : public wire::GripperEvents::Server {
 public:
  explicit GripperReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

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
      auto& slot = port_->column<std::int8_t>(1);
      const Errc error = fromWire(in.getMode(), slot);
      columns.enter(1, error);
    }
    if (columns.hasValue(2)) {
      auto& slot = port_->column<EverythingSlot>(2);
      const Errc error =
          in.hasEverything() ? fromWire(in.getEverything(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(2, error);
    }
    if (columns.hasValue(3)) {
      auto& slot = port_->column<double>(3);
      slot = in.getLoad();
    }
    if (columns.hasValue(4)) {
      auto& slot = port_->column<double>(4);
      slot = in.getOpening();
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> modeChanged(ModeChangedContext context) override {
    auto in = context.getParams();
    return port_->event<std::int8_t>(numberOf(ArmEvent::mode_changed), [&](std::int8_t& slot) {
      return fromWire(in.getValue(), slot);
    });
  }

  kj::Promise<void> stopped(StoppedContext) override {
    return port_->event(numberOf(ArmEvent::stopped));
  }

  kj::Promise<void> arrived(ArrivedContext context) override {
    auto in = context.getParams();
    return port_->event<PoseStampedSlot>(numberOf(ArmEvent::arrived), [&](PoseStampedSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

  kj::Promise<void> moved(MovedContext context) override {
    auto in = context.getParams();
    return port_->event<ArmMovedPayload>(numberOf(ArmEvent::moved), [&](ArmMovedPayload& slot) {
      slot.value2 = in.getValue2();
      return firstError({
          in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid,
          fromWire(in.getValue3(), slot.value3),
      });
    });
  }

  kj::Promise<void> gripped(GrippedContext context) override {
    auto in = context.getParams();
    return port_->event<GripperGrippedPayload>(numberOf(GripperEvent::gripped),
                                               [&](GripperGrippedPayload& slot) {
      slot.value = in.getValue();
      slot.value2 = in.getValue2();
      return Errc{};
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class GripperProxy final : public suture::rpc::Proxy {
 public:
  GripperProxy(wire::Gripper::Client provider, ProxyPort& port)
      : base_(suture::interfaceInfo<robots::Arm>().binding().makeProxy(provider, port)),
        provider_(kj::mv(provider)),
        port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<GripperReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<GripperCommand>(record.command)) {
      case GripperCommand::open: {
        const auto& slot = slotIn<GripperOpenArguments>(record.arguments());
        auto request = provider_.openRequest();
        request.setWidth(slot.width);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case GripperCommand::opening: {
        auto request = provider_.openingRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, response.getStamp(), [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case GripperCommand::fits: {
        const auto& slot = slotIn<GripperFitsArguments>(record.arguments());
        auto request = provider_.fitsRequest();
        request.setWidth(slot.width);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::uint8_t>(call, [&](std::uint8_t& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
    }
    return base_->send(record);
  }

 private:
  kj::Own<suture::rpc::Proxy> base_;
  wire::Gripper::Client provider_;
  ProxyPort& port_;
};

class GripperBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<GripperServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<GripperProxy>(contract.castAs<wire::Gripper>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<GripperSink>(subscriber.castAs<wire::GripperEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::Gripper>();
  }
};

const suture::rpc::Binding& gripperBinding() {
  static const GripperBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kGripperCommands[] = {
    {.name = "open",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<GripperOpenArguments>,
     .depth = 16,
     .accepts = checkSlot<GripperOpenArguments, acceptsGripperOpen>},
    {.name = "opening",
     .kind = CommandKind::Read,
     .resultSize = slotSize<double>,
     .depth = 16,
     .column = 4,
     .acceptsResult = checkSlot<double, acceptsGripperOpeningResult>},
    {.name = "fits",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = slotSize<GripperFitsArguments>,
     .resultSize = slotSize<std::uint8_t>,
     .depth = 16,
     .inCallersThread = true,
     .accepts = checkSlot<GripperFitsArguments, acceptsGripperFits>},
};

constexpr EventInfo kGripperEvents[] = {
    {.name = "gripped",
     .payloadSize = slotSize<GripperGrippedPayload>,
     .depth = 16,
     .accepts = checkSlot<GripperGrippedPayload, acceptsGripperGrippedEvent>},
};

// The self-description, as in robots/gripper.suture.json.
constexpr char kGripperDescription[] = R"json(
{"name": "robots::Gripper", "doc": "An arm with a gripper.",
"hash": "80297788a323ca7bff040107b64d3705", "core": "a9b1e581d8cd565de2fe8b81c0049693",
"version": 2, "base": "robots::Arm", "since": 2, "commands": [{"name": "enable", "kind": "void",
"ordinal": 1, "queue": 4, "from": "robots::Arm"}, {"name": "servo_cp", "kind": "write",
"ordinal": 2, "wire": "servoCp", "doc": "Follow the goal.", "parameters": [{"name": "goal",
"type": {"kind": "struct", "name": "robots::PoseStamped"}}], "queue": 16, "latest": true,
"ttl": 0.02, "from": "robots::Arm"}, {"name": "set_speed", "kind": "write", "ordinal": 3,
"wire": "setSpeed", "parameters": [{"name": "speed", "type": {"kind": "Float64"}, "unit": "m/s"}],
"queue": 16, "from": "robots::Arm"}, {"name": "measured_cp", "kind": "read", "ordinal": 4,
"wire": "measuredCp", "result": {"type": {"kind": "struct", "name": "robots::PoseStamped"}},
"queue": 16, "from": "robots::Arm"}, {"name": "mode", "kind": "read", "ordinal": 5, "result": {
"type": {"kind": "enum", "name": "robots::Mode"}}, "queue": 16, "from": "robots::Arm"}, {
"name": "everything", "kind": "read", "ordinal": 6, "result": {"type": {"kind": "struct",
"name": "robots::Everything"}}, "queue": 16, "from": "robots::Arm"}, {"name": "inverse_kinematics",
"kind": "qualified read", "ordinal": 7, "wire": "inverseKinematics", "parameters": [{"name": "x",
"type": {"kind": "struct", "name": "robots::PoseStamped"}}, {"name": "tolerance", "type": {
"kind": "Float64"}, "range": [0.0, 1.0]}], "result": {"type": {"kind": "struct",
"name": "robots::Everything"}}, "queue": 16, "from": "robots::Arm"}, {"name": "grasp",
"kind": "write with return", "ordinal": 8,
"doc": "Closes the gripper; answers whether it holds something.", "parameters": [{"name": "width",
"type": {"kind": "Float64"}}, {"name": "mode", "type": {"kind": "enum", "name": "robots::Mode"}}],
"result": {"type": {"kind": "Bool"}}, "queue": 2, "deadline": 0.05, "from": "robots::Arm"}, {
"name": "next_token", "kind": "void with return", "ordinal": 9, "wire": "nextToken", "result": {
"type": {"kind": "UInt32"}}, "queue": 16, "from": "robots::Arm", "since": 1}, {"name": "park",
"kind": "void", "ordinal": 10, "queue": 16, "optional": true, "direct": true, "from": "robots::Arm",
"deprecated": "use enable"}, {"name": "load", "kind": "read", "ordinal": 11, "result": {"type": {
"kind": "Float64"}}, "queue": 16, "optional": true, "from": "robots::Arm"}, {"name": "open",
"kind": "write", "ordinal": 1, "parameters": [{"name": "width", "type": {"kind": "Float64"},
"unit": "m"}], "queue": 16}, {"name": "opening", "kind": "read", "ordinal": 2, "result": {"type": {
"kind": "Float64"}}, "queue": 16, "since": 2}, {"name": "fits", "kind": "qualified read",
"ordinal": 3, "parameters": [{"name": "width", "type": {"kind": "Float64"}}], "result": {"type": {
"kind": "Bool"}}, "queue": 16, "concurrent": true}], "events": [{"name": "mode_changed",
"kind": "write", "ordinal": 1, "wire": "modeChanged", "payload": {"type": {"kind": "enum",
"name": "robots::Mode"}}, "queue": 8, "latched": true, "from": "robots::Arm"}, {"name": "stopped",
"kind": "void", "ordinal": 2, "queue": 16, "from": "robots::Arm"}, {"name": "arrived",
"kind": "write", "ordinal": 3, "payload": {"type": {"kind": "struct", "name": "robots::PoseStamped"
}}, "queue": 16, "from": "robots::Arm"}, {"name": "moved", "kind": "write", "ordinal": 4,
"doc": "Where, how fast and why.", "payload": [{"name": "value", "type": {"kind": "struct",
"name": "robots::PoseStamped"}}, {"name": "value2", "type": {"kind": "Float64"}}, {
"name": "value3", "type": {"kind": "enum", "name": "robots::Mode"}}], "queue": 16, "latched": true,
"from": "robots::Arm"}, {"name": "gripped", "kind": "write", "ordinal": 5, "payload": [{
"name": "value", "type": {"kind": "Float64"}}, {"name": "value2", "type": {"kind": "Bool"}}],
"queue": 16, "since": 2}], "enums": [{"name": "robots::Mode", "doc": "What the arm does.",
"underlying": "Int8", "enumerators": [{"name": "Disabled", "value": -1, "wire": "disabled"}, {
"name": "HoldStill", "value": 4, "wire": "holdStill", "doc": "Brakes off, set-point frozen."}, {
"name": "Servo", "value": 2, "wire": "servo"}]}], "structs": [{"name": "robots::PoseStamped",
"doc": "A pose with its time.", "fields": [{"name": "pose", "type": {"kind": "isometry",
"scalar": "Float64"}}, {"name": "stamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "valid", "type": {"kind": "Bool"}, "default": false}]}, {"name": "robots::Everything",
"doc": "Every kind of member.\n\nTwo paragraphs.", "fields": [{"name": "on", "type": {
"kind": "Bool"}, "default": false}, {"name": "tiny", "type": {"kind": "Int8"}, "default": 0}, {
"name": "count", "type": {"kind": "UInt64"}, "default": 0}, {"name": "speed",
"doc": "Along the path.", "type": {"kind": "Float64"}, "unit": "m/s", "range": [-0.5, 2.0],
"default": 0.25}, {"name": "ratio", "type": {"kind": "Float32"}, "default": 0.0}, {"name": "mode",
"type": {"kind": "enum", "name": "robots::Mode"}, "default": "Servo"}, {"name": "label", "type": {
"kind": "text", "capacity": 16}}, {"name": "bytes", "type": {"kind": "list", "element": {
"kind": "UInt8"}, "capacity": 32}}, {"name": "flags", "type": {"kind": "list", "element": {
"kind": "Bool"}, "capacity": 4}}, {"name": "names", "type": {"kind": "list", "element": {
"kind": "text", "capacity": 8}, "capacity": 3}}, {"name": "pairs", "type": {"kind": "list",
"element": {"kind": "array", "element": {"kind": "Float64"}, "length": 2}, "capacity": 5}}, {
"name": "modes", "type": {"kind": "array", "element": {"kind": "enum", "name": "robots::Mode"},
"length": 2}}, {"name": "goal", "type": {"kind": "struct", "name": "robots::PoseStamped"}}, {
"name": "track", "type": {"kind": "list", "element": {"kind": "struct",
"name": "robots::PoseStamped"}, "capacity": 2}}, {"name": "point", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}, "unit": "m"}, {"name": "plane", "type": {
"kind": "matrix", "scalar": "Float32", "rows": 3, "columns": 1}}, {"name": "inertia", "type": {
"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 3}}, {"name": "jacobian", "type": {
"kind": "matrix", "scalar": "Float64", "rows": 6, "columns": 7}}, {"name": "attitude", "type": {
"kind": "quaternion", "scalar": "Float64"}}, {"name": "period", "type": {"kind": "duration",
"period": "1/1000"}, "default": 0.0}, {"name": "when", "type": {"kind": "time", "clock": "steady"}}
]}], "wire": [{"id": "@0xb9e926d064e78714", "kind": "interface", "name": "Gripper",
"cxx": "robots::Gripper", "version": 2, "members": [{"at": 0, "name": "subscribe", "parameters": [{
"at": 0, "name": "events", "is": "@0x9acb6a7a5fa48866"}, {"at": 1, "name": "eventMask",
"is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "open",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "width", "is": "Float64 unit \"m\""}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "opening",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]
}, {"at": 3, "name": "fits", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0,
"name": "width", "is": "Float64"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "Bool"}]}]}, {"id": "@0x974e120931408f6d",
"kind": "interface", "name": "Arm", "cxx": "robots::Arm", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xa6aa5daf71e0a4ba"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "enable", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "servoCp", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "goal", "is": "@0xe61654a89cf5f1dd"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 3, "name": "setSpeed", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "speed", "is": "Float64 unit \"m/s\""}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 4, "name": "measuredCp", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xe61654a89cf5f1dd"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 5, "name": "mode", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xab8c3dd92b2643d4"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 6, "name": "everything",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xe827b555e2bdb416"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 7, "name": "inverseKinematics", "is": "kind \"qualifiedRead\"",
"parameters": [{"at": 0, "name": "x", "is": "@0xe61654a89cf5f1dd"}, {"at": 1, "name": "tolerance",
"is": "Float64"}, {"at": 2, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xe827b555e2bdb416"}]}, {"at": 8, "name": "grasp",
"is": "kind \"writeReturn\"", "parameters": [{"at": 0, "name": "width", "is": "Float64"}, {"at": 1,
"name": "mode", "is": "@0xab8c3dd92b2643d4"}, {"at": 2, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Bool"}]}, {"at": 9,
"name": "nextToken", "is": "kind \"voidReturn\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "UInt32"}]}, {
"at": 10, "name": "park", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 11, "name": "load", "is": "kind \"read\"", "parameters": [
{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xa6aa5daf71e0a4ba",
"kind": "interface", "name": "ArmEvents", "members": [{"at": 0, "name": "state", "parameters": [{
"at": 0, "name": "row", "is": "@0xd633b378dcab35c1"}]}, {"at": 1, "name": "modeChanged",
"parameters": [{"at": 0, "name": "value", "is": "@0xab8c3dd92b2643d4"}]}, {"at": 2,
"name": "stopped"}, {"at": 3, "name": "arrived", "parameters": [{"at": 0, "name": "value",
"is": "@0xe61654a89cf5f1dd"}]}, {"at": 4, "name": "moved", "parameters": [{"at": 0, "name": "value",
"is": "@0xe61654a89cf5f1dd"}, {"at": 1, "name": "value2", "is": "Float64"}, {"at": 2,
"name": "value3", "is": "@0xab8c3dd92b2643d4"}]}]}, {"id": "@0xd633b378dcab35c1", "kind": "struct",
"name": "ArmStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "measuredCp", "is": "@0xe61654a89cf5f1dd"}, {"at": 4, "name": "mode",
"is": "@0xab8c3dd92b2643d4"}, {"at": 5, "name": "everything", "is": "@0xe827b555e2bdb416"}, {
"at": 6, "name": "load", "is": "Float64"}]}, {"id": "@0xe61654a89cf5f1dd", "kind": "struct",
"name": "PoseStamped", "members": [{"at": 0, "name": "pose", "is": "/suture/types.capnp:Pose"}, {
"at": 1, "name": "stamp", "is": "Int64 clock \"steady\""}, {"at": 2, "name": "valid", "is": "Bool"}
]}, {"id": "@0xab8c3dd92b2643d4", "kind": "enum", "name": "Mode", "members": [{"at": 0,
"name": "disabled"}, {"at": 1, "name": "holdStill"}, {"at": 2, "name": "servo"}]}, {
"id": "@0xe827b555e2bdb416", "kind": "struct", "name": "Everything", "members": [{"at": 0,
"name": "on", "is": "Bool"}, {"at": 1, "name": "tiny", "is": "Int8"}, {"at": 2, "name": "count",
"is": "UInt64"}, {"at": 3, "name": "speed", "is": "Float64 unit \"m/s\" = 0.25"}, {"at": 4,
"name": "ratio", "is": "Float32"}, {"at": 5, "name": "mode", "is": "@0xab8c3dd92b2643d4 = servo"}, {
"at": 6, "name": "label", "is": "Text"}, {"at": 7, "name": "bytes", "is": "Data"}, {"at": 8,
"name": "flags", "is": "List(Bool)"}, {"at": 9, "name": "names", "is": "List(Text)"}, {"at": 10,
"name": "pairs", "is": "List(List(Float64)) shape \"*,2\""}, {"at": 11, "name": "modes",
"is": "List(@0xab8c3dd92b2643d4) shape \"2\""}, {"at": 12, "name": "goal",
"is": "@0xe61654a89cf5f1dd"}, {"at": 13, "name": "track", "is": "List(@0xe61654a89cf5f1dd)"}, {
"at": 14, "name": "point", "is": "/suture/types.capnp:Vec3 unit \"m\""}, {"at": 15, "name": "plane",
"is": "List(Float32) shape \"3x1\""}, {"at": 16, "name": "inertia", "is": "/suture/types.capnp:Mat3"
}, {"at": 17, "name": "jacobian", "is": "List(Float64) shape \"6x7\""}, {"at": 18,
"name": "attitude", "is": "/suture/types.capnp:Quat"}, {"at": 19, "name": "period",
"is": "Int64 period \"1/1000\""}, {"at": 20, "name": "when", "is": "Int64 clock \"steady\""}]}, {
"id": "@0x9acb6a7a5fa48866", "kind": "interface", "name": "GripperEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0x8d73a8caf926376a"}]}, {"at": 1,
"name": "modeChanged", "parameters": [{"at": 0, "name": "value", "is": "@0xab8c3dd92b2643d4"}]}, {
"at": 2, "name": "stopped"}, {"at": 3, "name": "arrived", "parameters": [{"at": 0, "name": "value",
"is": "@0xe61654a89cf5f1dd"}]}, {"at": 4, "name": "moved", "parameters": [{"at": 0, "name": "value",
"is": "@0xe61654a89cf5f1dd"}, {"at": 1, "name": "value2", "is": "Float64"}, {"at": 2,
"name": "value3", "is": "@0xab8c3dd92b2643d4"}]}, {"at": 5, "name": "gripped", "parameters": [{
"at": 0, "name": "value", "is": "Float64"}, {"at": 1, "name": "value2", "is": "Bool"}]}]}, {
"id": "@0x8d73a8caf926376a", "kind": "struct", "name": "GripperStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "measuredCp", "is": "@0xe61654a89cf5f1dd"}, {
"at": 4, "name": "mode", "is": "@0xab8c3dd92b2643d4"}, {"at": 5, "name": "everything",
"is": "@0xe827b555e2bdb416"}, {"at": 6, "name": "load", "is": "Float64"}, {"at": 7,
"name": "opening", "is": "Float64"}]}]})json";

bool acceptsNamesTitle(const NamesNameArguments& slot, FieldPath* path) {
  if (!isValid(slot.range)) return refusedAt(path, "range");
  if (!isValid(slot.slot)) return refusedAt(path, "slot");
  return isValid(slot.store) || refusedAt(path, "store");
}

bool acceptsNamesRangeResult(const double& slot, FieldPath*) { return isValid(slot); }
bool acceptsNamesLatchedEvent(const double& slot, FieldPath*) { return isValid(slot); }

// --- Names over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class NamesSink final : public suture::rpc::EventSink {
 public:
  explicit NamesSink(wire::NamesEvents::Client subscriber) : subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(NamesEvent::latched): {
        const auto& slot = slotIn<double>(payload);
        auto request = subscriber_.latchedRequest();
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
      const auto& slot = slotIn<double>(columns[0]);
      out.setRange(slot);
    }
    return request.send().ignoreResult();
  }

 private:
  wire::NamesEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class NamesServant final : public wire::Names::Server {
 public:
  explicit NamesServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<NamesSink>(in.getEvents()), in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> queue(QueueContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<NamesQueueArguments>(memory);
      slot.name = in.getName();
      return Errc{};
    };
    return port_->command(numberOf(NamesCommand::queue), in.getSent(), fill);
  }

  kj::Promise<void> title(TitleContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<NamesNameArguments>(memory);
      slot.range = in.getRange();
      slot.slot = in.getSlot();
      slot.store = in.getStore();
      return Errc{};
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<std::uint8_t>(result);
      auto out = context.getResults();
      out.setValue(slot != 0);
    };
    return port_->call(numberOf(NamesCommand::name), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> range(RangeContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(NamesCommand::range), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- Names over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class NamesReceiver final : public wire::NamesEvents::Server {
 public:
  explicit NamesReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<double>(0);
      slot = in.getRange();
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> latched(LatchedContext context) override {
    auto in = context.getParams();
    return port_->event<double>(numberOf(NamesEvent::latched), [&](double& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class NamesProxy final : public suture::rpc::Proxy {
 public:
  NamesProxy(wire::Names::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<NamesReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<NamesCommand>(record.command)) {
      case NamesCommand::queue: {
        const auto& slot = slotIn<NamesQueueArguments>(record.arguments());
        auto request = provider_.queueRequest();
        request.setName(slot.name);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case NamesCommand::name: {
        const auto& slot = slotIn<NamesNameArguments>(record.arguments());
        auto request = provider_.titleRequest();
        request.setRange(slot.range);
        request.setSlot(slot.slot);
        request.setStore(slot.store);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::uint8_t>(call, [&](std::uint8_t& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case NamesCommand::range: {
        auto request = provider_.rangeRequest();
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
  wire::Names::Client provider_;
  ProxyPort& port_;
};

class NamesBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<NamesServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<NamesProxy>(contract.castAs<wire::Names>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<NamesSink>(subscriber.castAs<wire::NamesEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::Names>();
  }
};

const suture::rpc::Binding& namesBinding() {
  static const NamesBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kNamesCommands[] = {
    {.name = "queue",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<NamesQueueArguments>,
     .depth = 4},
    {.name = "name",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = slotSize<NamesNameArguments>,
     .resultSize = slotSize<std::uint8_t>,
     .depth = 16,
     .accepts = checkSlot<NamesNameArguments, acceptsNamesTitle>},
    {.name = "range",
     .kind = CommandKind::Read,
     .resultSize = slotSize<double>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<double, acceptsNamesRangeResult>},
};

constexpr EventInfo kNamesEvents[] = {
    {.name = "latched",
     .payloadSize = slotSize<double>,
     .depth = 16,
     .latched = true,
     .accepts = checkSlot<double, acceptsNamesLatchedEvent>},
};

// The self-description, as in robots/gripper.suture.json.
constexpr char kNamesDescription[] = R"json(
{"name": "robots::Names", "doc": "Members that are called as arguments of the annotations are.",
"hash": "e54c0cb37918bd57e34585c46706a1ad", "commands": [{"name": "queue", "kind": "write",
"ordinal": 1, "parameters": [{"name": "name", "type": {"kind": "Int32"}}], "queue": 4}, {
"name": "name", "kind": "write with return", "ordinal": 2, "wire": "title", "parameters": [{
"name": "range", "type": {"kind": "Float64"}}, {"name": "slot", "type": {"kind": "Float64"}}, {
"name": "store", "type": {"kind": "Float64"}}], "result": {"type": {"kind": "Bool"}}, "queue": 16},
{"name": "range", "kind": "read", "ordinal": 3, "result": {"type": {"kind": "Float64"}}, "queue": 16
}], "events": [{"name": "latched", "kind": "write", "ordinal": 1, "payload": {"type": {
"kind": "Float64"}}, "queue": 16, "latched": true}], "enums": [], "structs": [], "wire": [{
"id": "@0xa213f67f20043abb", "kind": "interface", "name": "Names", "cxx": "robots::Names",
"members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0, "name": "events",
"is": "@0xf43423c9c422881d"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2,
"name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "queue", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "name", "is": "Int32"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "title", "is": "kind \"writeReturn\"",
"parameters": [{"at": 0, "name": "range", "is": "Float64"}, {"at": 1, "name": "slot",
"is": "Float64"}, {"at": 2, "name": "store", "is": "Float64"}, {"at": 3, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Bool"}]}, {"at": 3,
"name": "range", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Float64"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xf43423c9c422881d", "kind": "interface",
"name": "NamesEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0x87faafafa7e923b7"}]}, {"at": 1, "name": "latched", "parameters": [{
"at": 0, "name": "value", "is": "Float64"}]}]}, {"id": "@0x87faafafa7e923b7", "kind": "struct",
"name": "NamesStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "range", "is": "Float64"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Gripper>() {
  static const auto kCommands = extended<14>(interfaceInfo<robots::Arm>().commands,
                                             robots::kGripperCommands);
  static const auto kEvents = extended<5>(interfaceInfo<robots::Arm>().events,
                                          robots::kGripperEvents);
  static const InterfaceInfo kInfo{
      .name = "robots::Gripper",
      .hash = "80297788a323ca7bff040107b64d3705",
      .description = robots::kGripperDescription,
      .commands = kCommands,
      .events = kEvents,
      .binding = &robots::gripperBinding,
      .base = &interfaceInfo<robots::Arm>,
      .toBase = &castToBase<robots::Gripper, robots::Arm>,
  };
  return kInfo;
}

template <>
const InterfaceInfo& interfaceInfo<robots::Names>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::Names",
      .hash = "e54c0cb37918bd57e34585c46706a1ad",
      .description = robots::kNamesDescription,
      .commands = robots::kNamesCommands,
      .events = robots::kNamesEvents,
      .binding = &robots::namesBinding,
  };
  return kInfo;
}

Errc Provided<robots::Gripper>::execute(std::uint16_t command, const std::byte* arguments,
                                        std::byte* result) {
  using ::robots::GripperCommand;
  switch (static_cast<GripperCommand>(command)) {
    case GripperCommand::open: {
      const auto& slot = slotIn<robots::GripperOpenArguments>(arguments);
      load(slot.width, scratch_.open_width);
      implementation_.open(scratch_.open_width);
      return Errc{};
    }
    case GripperCommand::opening: {
      auto& slot = newSlot<double>(result);
      return store(implementation_.opening(), slot) ? Errc{} : Errc::TooLarge;
    }
    case GripperCommand::fits: {
      const auto& slot = slotIn<robots::GripperFitsArguments>(arguments);
      load(slot.width, scratch_.fits_width);
      auto& answer = newSlot<std::uint8_t>(result);
      return store(implementation_.fits(scratch_.fits_width), answer) ? Errc{} : Errc::TooLarge;
    }
  }
  return Provided<robots::Arm>::execute(command, arguments, result);
}

Errc Provided<robots::Names>::execute(std::uint16_t command, const std::byte* arguments,
                                      std::byte* result) {
  using ::robots::NamesCommand;
  switch (static_cast<NamesCommand>(command)) {
    case NamesCommand::queue: {
      const auto& slot = slotIn<robots::NamesQueueArguments>(arguments);
      load(slot.name, scratch_.queue_name);
      implementation_.queue(scratch_.queue_name);
      return Errc{};
    }
    case NamesCommand::name: {
      const auto& slot = slotIn<robots::NamesNameArguments>(arguments);
      load(slot.range, scratch_.name_range);
      load(slot.slot, scratch_.name_slot);
      load(slot.store, scratch_.name_store);
      auto& answer = newSlot<std::uint8_t>(result);
      return store(implementation_.name(scratch_.name_range, scratch_.name_slot,
                                        scratch_.name_store), answer) ? Errc{} : Errc::TooLarge;
    }
    case NamesCommand::range: {
      auto& slot = newSlot<double>(result);
      return store(implementation_.range(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
