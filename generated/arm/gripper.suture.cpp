// Written by suturec from arm/gripper.h. Do not edit.
#include "arm/gripper.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "arm/gripper.capnp.h"

// Defined in robot_types/joint_commands.suture.cpp.
namespace robots {
void toWire(const JointConfigurationSlot& slot, wire::JointConfiguration::Builder out);
suture::Errc fromWire(wire::JointConfiguration::Reader in, JointConfigurationSlot& slot,
                      suture::Duration shift);
bool isValid(const JointConfigurationSlot& slot, suture::FieldPath* path);
}  // namespace robots

// Defined in robot_types/joints.suture.cpp.
namespace robots {
void toWire(const JointStateSlot& slot, wire::JointState::Builder out);
suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration shift);
bool isValid(const JointStateSlot& slot, suture::FieldPath* path);
}  // namespace robots

namespace robots {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Errc;
using suture::EventInfo;
using suture::checkSlot;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::shiftSlot;
using suture::slotIn;
using suture::slotSize;

namespace {

// --- Gripper over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class GripperSink final : public suture::rpc::EventSink {
 public:
  explicit GripperSink(wire::GripperEvents::Client subscriber) : subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(GripperEvent::closed): {
        const auto& slot = slotIn<std::uint8_t>(payload);
        auto request = subscriber_.closedRequest();
        request.setValue(slot != 0);
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
      const auto& slot = slotIn<JointConfigurationSlot>(columns[0]);
      toWire(slot, out.initConfigurationJs());
    }
    if (row.hasValue(1)) {
      const auto& slot = slotIn<JointStateSlot>(columns[1]);
      toWire(slot, out.initMeasuredJs());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::GripperEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class GripperServant final : public wire::Gripper::Server {
 public:
  explicit GripperServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<GripperSink>(in.getEvents()), in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> configurationJs(ConfigurationJsContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<JointConfigurationSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(GripperCommand::configuration_js), in.getSent(),
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
    return port_->call(numberOf(GripperCommand::measured_js), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
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
      auto& slot = port_->column<JointConfigurationSlot>(0);
      const Errc error =
          in.hasConfigurationJs() ? fromWire(in.getConfigurationJs(), slot, port_->shift()) : Errc::Invalid;
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

  kj::Promise<void> closed(ClosedContext context) override {
    auto in = context.getParams();
    return port_->event<std::uint8_t>(numberOf(GripperEvent::closed), [&](std::uint8_t& slot) {
      slot = in.getValue();
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
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<GripperReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<GripperCommand>(record.command)) {
      case GripperCommand::configuration_js: {
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
      case GripperCommand::measured_js: {
        auto request = provider_.measuredJsRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<JointStateSlot>(call, response.getStamp(), [&](JointStateSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
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
    {.name = "configuration_js",
     .kind = CommandKind::Read,
     .resultSize = slotSize<JointConfigurationSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<JointConfigurationSlot, isValid>},
    {.name = "measured_js",
     .kind = CommandKind::Read,
     .resultSize = slotSize<JointStateSlot>,
     .depth = 16,
     .column = 1,
     .acceptsResult = checkSlot<JointStateSlot, isValid>,
     .shiftResult = shiftSlot<JointStateSlot>},
};

constexpr EventInfo kGripperEvents[] = {
    {.name = "closed", .payloadSize = slotSize<std::uint8_t>, .depth = 16, .latched = true},
};

// The self-description, as in arm/gripper.suture.json.
constexpr char kGripperDescription[] = R"json(
{"name": "robots::Gripper",
"doc": "The master provides it as an interface of its own, \"Gripper\". Reads are from the end of its last\ncycle. Joint vectors have one entry, the angle between the handles in rad: 0 is closed, and less\nis squeezed harder. Nothing drives it, so it is measured whether the master has power or not.",
"hash": "8f26aff2ded6f2b19bd320fa135689ae", "crtk": true, "commands": [{"name": "configuration_js",
"kind": "read", "ordinal": 1, "wire": "configurationJs", "doc": "What the joint is and may do.",
"result": {"type": {"kind": "struct", "name": "robots::JointConfiguration"}}, "queue": 16}, {
"name": "measured_js", "kind": "read", "ordinal": 2, "wire": "measuredJs",
"doc": "Where it is. Stamp: the drives' cycle that measured it. Not valid before there was one.",
"result": {"type": {"kind": "struct", "name": "robots::JointState"}}, "queue": 16}], "events": [{
"name": "closed", "kind": "write", "ordinal": 1,
"doc": "Whether it is closed, each time that changes, and the last one to whoever connects: dVRK's\ngripper/closed.",
"payload": {"type": {"kind": "Bool"}}, "queue": 16, "latched": true}], "enums": [{
"name": "robots::JointType", "underlying": "UInt8", "enumerators": [{"name": "Undefined",
"value": 0, "wire": "undefined"}, {"name": "Prismatic", "value": 1, "wire": "prismatic"}, {
"name": "Revolute", "value": 2, "wire": "revolute"}, {"name": "Universal", "value": 3,
"wire": "universal"}, {"name": "BallSocket", "value": 4, "wire": "ballSocket"}, {
"name": "Inactive", "value": 5, "wire": "inactive"}]}], "structs": [{
"name": "robots::JointConfiguration",
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
"default": false}]}, {"name": "robots::JointState",
"doc": "The state of all joints of an arm, in chain order: CRTK's measured_js and setpoint_js. A list is\nempty where its quantity is not known, and as long as `name` otherwise.",
"fields": [{"name": "name", "type": {"kind": "list", "element": {"kind": "text", "capacity": 15},
"capacity": 8}}, {"name": "position", "type": {"kind": "list", "element": {"kind": "Float64"},
"capacity": 8}, "unit": "rad"}, {"name": "velocity", "type": {"kind": "list", "element": {
"kind": "Float64"}, "capacity": 8}, "unit": "rad/s"}, {"name": "effort", "type": {"kind": "list",
"element": {"kind": "Float64"}, "capacity": 8}, "unit": "N.m"}, {"name": "stamp", "type": {
"kind": "time", "clock": "steady"}}, {"name": "valid", "doc": "False: do not use.", "type": {
"kind": "Bool"}, "default": false}]}], "wire": [{"id": "@0x8486a1563ccf77e4", "kind": "interface",
"name": "Gripper", "cxx": "robots::Gripper", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xc5f5014ab20db54c"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "configurationJs", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xf723b5ed0dc2d63c"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "measuredJs",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xac24dfe518a4963f"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}]}, {"id": "@0xc5f5014ab20db54c", "kind": "interface", "name": "GripperEvents",
"members": [{"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row",
"is": "@0xb54cebda06a7e912"}]}, {"at": 1, "name": "closed", "parameters": [{"at": 0,
"name": "value", "is": "Bool"}]}]}, {"id": "@0xb54cebda06a7e912", "kind": "struct",
"name": "GripperStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "configurationJs", "is": "@0xf723b5ed0dc2d63c"}, {"at": 4, "name": "measuredJs",
"is": "@0xac24dfe518a4963f"}]}, {"id": "@0xf723b5ed0dc2d63c", "kind": "struct",
"name": "JointConfiguration", "members": [{"at": 0, "name": "name", "is": "List(Text)"}, {"at": 1,
"name": "type", "is": "List(@0x9f3bef15df1181c0)"}, {"at": 2, "name": "positionMin",
"is": "List(Float64) unit \"rad\""}, {"at": 3, "name": "positionMax",
"is": "List(Float64) unit \"rad\""}, {"at": 4, "name": "velocityMin",
"is": "List(Float64) unit \"rad/s\""}, {"at": 5, "name": "velocityMax",
"is": "List(Float64) unit \"rad/s\""}, {"at": 6, "name": "accelerationMin",
"is": "List(Float64) unit \"rad/s2\""}, {"at": 7, "name": "accelerationMax",
"is": "List(Float64) unit \"rad/s2\""}, {"at": 8, "name": "effortMin",
"is": "List(Float64) unit \"N.m\""}, {"at": 9, "name": "effortMax",
"is": "List(Float64) unit \"N.m\""}, {"at": 10, "name": "valid", "is": "Bool"}]}, {
"id": "@0x9f3bef15df1181c0", "kind": "enum", "name": "JointType", "members": [{"at": 0,
"name": "undefined"}, {"at": 1, "name": "prismatic"}, {"at": 2, "name": "revolute"}, {"at": 3,
"name": "universal"}, {"at": 4, "name": "ballSocket"}, {"at": 5, "name": "inactive"}]}, {
"id": "@0xac24dfe518a4963f", "kind": "struct", "name": "JointState", "members": [{"at": 0,
"name": "name", "is": "List(Text)"}, {"at": 1, "name": "position",
"is": "List(Float64) unit \"rad\""}, {"at": 2, "name": "velocity",
"is": "List(Float64) unit \"rad/s\""}, {"at": 3, "name": "effort",
"is": "List(Float64) unit \"N.m\""}, {"at": 4, "name": "stamp", "is": "Int64 clock \"steady\""}, {
"at": 5, "name": "valid", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Gripper>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::Gripper",
      .hash = "8f26aff2ded6f2b19bd320fa135689ae",
      .description = robots::kGripperDescription,
      .commands = robots::kGripperCommands,
      .events = robots::kGripperEvents,
      .binding = &robots::gripperBinding,
  };
  return kInfo;
}

Errc Provided<robots::Gripper>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                        std::byte* result) {
  using ::robots::GripperCommand;
  switch (static_cast<GripperCommand>(command)) {
    case GripperCommand::configuration_js: {
      auto& slot = newSlot<robots::JointConfigurationSlot>(result);
      return store(implementation_.configuration_js(), slot) ? Errc{} : Errc::TooLarge;
    }
    case GripperCommand::measured_js: {
      auto& slot = newSlot<robots::JointStateSlot>(result);
      return store(implementation_.measured_js(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
