// Written by suturec from arm/gripper.h. Do not edit.
#include "arm/gripper.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

// Defined in arm/gripper.wire.cpp.
const suture::codec::Codec& gripperCodec();

namespace {

constexpr suture::CommandInfo kGripperCommands[] = {
    {.name = "configuration_js",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<JointConfigurationSlot>,
     .depth = 16,
     .column = GripperColumn::configuration_js,
     .acceptsResult = suture::checkSlot<JointConfigurationSlot, isValid>},
    {.name = "measured_js",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<JointStateSlot>,
     .depth = 16,
     .column = GripperColumn::measured_js,
     .acceptsResult = suture::checkSlot<JointStateSlot, isValid>,
     .shiftResult = suture::shiftSlot<JointStateSlot>},
};

constexpr suture::EventInfo kGripperEvents[] = {
    {.name = "closed", .payloadSize = suture::slotSize<std::uint8_t>, .depth = 16, .latched = true},
};

// The self-description, as in arm/gripper.suture.json.
constexpr char kGripperDescription[] = R"json(
{"name": "robots::Gripper",
"doc": "The master provides this as an interface of its own, \"Gripper\". Reads are from the end of its\nlast cycle. Joint vectors have one entry, the angle between the handles in rad: 0 is closed, and\na smaller angle is squeezed harder. Nothing drives the gripper, so it is measured with or\nwithout power of the master.",
"hash": "2461ceda32472c5d29c39c8e214fcaf4", "crtk": true, "commands": [{"name": "configuration_js",
"kind": "read", "ordinal": 1, "wire": "configurationJs",
"doc": "Says what the joint is and what it may do.", "result": {"type": {"kind": "struct",
"name": "robots::JointConfiguration"}}, "queue": 16}, {"name": "measured_js", "kind": "read",
"ordinal": 2, "wire": "measuredJs",
"doc": "Says where the joint is. The stamp is that of the drives' cycle that measured it. Before the\nfirst such cycle the value is not valid.",
"result": {"type": {"kind": "struct", "name": "robots::JointState"}}, "queue": 16}], "events": [{
"name": "closed", "kind": "write", "ordinal": 1,
"doc": "Reports if the gripper is closed, each time that this changes, and the last one to a client\nthat connects: dVRK's gripper/closed.",
"payload": {"type": {"kind": "Bool"}}, "queue": 16, "latched": true}], "enums": [{
"name": "robots::JointType", "underlying": "UInt8", "enumerators": [{"name": "Undefined",
"value": 0, "wire": "undefined"}, {"name": "Prismatic", "value": 1, "wire": "prismatic"}, {
"name": "Revolute", "value": 2, "wire": "revolute"}, {"name": "Universal", "value": 3,
"wire": "universal"}, {"name": "BallSocket", "value": 4, "wire": "ballSocket"}, {
"name": "Inactive", "value": 5, "wire": "inactive"}]}], "structs": [{
"name": "robots::JointConfiguration",
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
"default": false}]}, {"name": "robots::JointState",
"doc": "A JointState is the state of all joints of an arm, in chain order: CRTK's measured_js and\nsetpoint_js. A list is empty if its quantity is not known, and as long as `name` otherwise.",
"fields": [{"name": "name", "type": {"kind": "list", "element": {"kind": "text", "capacity": 15},
"capacity": 8}}, {"name": "position", "type": {"kind": "list", "element": {"kind": "Float64"},
"capacity": 8}, "unit": "rad"}, {"name": "velocity", "type": {"kind": "list", "element": {
"kind": "Float64"}, "capacity": 8}, "unit": "rad/s"}, {"name": "effort", "type": {"kind": "list",
"element": {"kind": "Float64"}, "capacity": 8}, "unit": "N.m"}, {"name": "stamp", "type": {
"kind": "time", "clock": "steady"}}, {"name": "valid",
"doc": "If it is false, do not use the state.", "type": {"kind": "Bool"}, "default": false}]}],
"wire": [{"id": "@0x8486a1563ccf77e4", "kind": "interface", "name": "Gripper",
"cxx": "robots::Gripper", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xc5f5014ab20db54c"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "configurationJs",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xf723b5ed0dc2d63c"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 2, "name": "measuredJs", "is": "kind \"read\"", "parameters": [{"at": 0,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "@0xac24dfe518a4963f"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xc5f5014ab20db54c", "kind": "interface", "name": "GripperEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xb54cebda06a7e912"}]}, {"at": 1,
"name": "closed", "parameters": [{"at": 0, "name": "value", "is": "Bool"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}]}, {"id": "@0xb54cebda06a7e912", "kind": "struct",
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
      .hash = "2461ceda32472c5d29c39c8e214fcaf4",
      .description = robots::kGripperDescription,
      .commands = robots::kGripperCommands,
      .events = robots::kGripperEvents,
      .codec = &robots::gripperCodec,
  };
  return kInfo;
}

// A function for each command of robots::Gripper, so that a stack in a debugger names it.
struct Provided<robots::Gripper>::Dispatch {
  static Errc execute_configuration_js(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::JointConfigurationSlot>(result);
    return store(implementation.configuration_js(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_measured_js(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::JointStateSlot>(result);
    return store(implementation.measured_js(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::Gripper>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                        std::byte* result) {
  using ::robots::GripperCommand;
  switch (command) {
    case GripperCommand::configuration_js:
      return Dispatch::execute_configuration_js(implementation_, result);
    case GripperCommand::measured_js: return Dispatch::execute_measured_js(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
