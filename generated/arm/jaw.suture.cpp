// Written by suturec from arm/jaw.h. Do not edit.
#include "arm/jaw.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const JointGoal& goal, JawServoJpArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(JawServoJpArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const JointEffortGoal& goal, JawServoJfArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(JawServoJfArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const JointGoal& goal, JawMoveJpArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(JawMoveJpArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

// Defined in arm/jaw.wire.cpp.
const suture::codec::Codec& jawCodec();

namespace {

bool acceptsJawServoJp(const JawServoJpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsJawServoJf(const JawServoJfArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsJawMoveJp(const JawMoveJpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

constexpr suture::CommandInfo kJawCommands[] = {
    {.name = "configuration_js",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<JointConfigurationSlot>,
     .depth = 16,
     .column = JawColumn::configuration_js,
     .acceptsResult = suture::checkSlot<JointConfigurationSlot, isValid>},
    {.name = "measured_js",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<JointStateSlot>,
     .depth = 16,
     .column = JawColumn::measured_js,
     .acceptsResult = suture::checkSlot<JointStateSlot, isValid>,
     .shiftResult = suture::shiftSlot<JointStateSlot>},
    {.name = "setpoint_js",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<JointStateSlot>,
     .depth = 16,
     .column = JawColumn::setpoint_js,
     .acceptsResult = suture::checkSlot<JointStateSlot, isValid>,
     .shiftResult = suture::shiftSlot<JointStateSlot>},
    {.name = "servo_jp",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<JawServoJpArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(20'000'000),
     .accepts = suture::checkSlot<JawServoJpArguments, acceptsJawServoJp>,
     .shiftArguments = suture::shiftSlot<JawServoJpArguments>},
    {.name = "servo_jf",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<JawServoJfArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(20'000'000),
     .accepts = suture::checkSlot<JawServoJfArguments, acceptsJawServoJf>,
     .shiftArguments = suture::shiftSlot<JawServoJfArguments>},
    {.name = "move_jp",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<JawMoveJpArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<JawMoveJpArguments, acceptsJawMoveJp>,
     .shiftArguments = suture::shiftSlot<JawMoveJpArguments>},
};

constexpr suture::EventInfo kJawEvents[] = {
    {.name = "goal_reached", .payloadSize = suture::slotSize<std::uint8_t>, .depth = 16},
};

// The self-description, as in arm/jaw.suture.json.
constexpr char kJawDescription[] = R"json(
{"name": "robots::Jaw",
"doc": "The arm that holds the instrument provides this as an interface of its own, \"Jaw\". Commands run\nin the arm's thread before its next cycle; reads are from the end of its last one. Joint vectors\nhave one entry, the angle between the blades in rad: 0 is closed, and a smaller angle presses\nthem together. It may be -0.698 to 1.396 rad (-40 to 80 degrees) on the large needle driver of a\nda Vinci.\n\nThe jaw has the power of its arm, and needs an arm that is enabled: otherwise it ignores\ncommands of motion and says so in a warning, once until it obeys again. When its arm stops being\nenabled, it stops where it is. Homing the arm leaves it as it is.\n\nA command replaces the one before it. A servo stream that falls silent for 0.1 s, or whose\nclient is gone, leaves the set-point where it is.\n\nStatus, warning and error are the standard messages. Their `code` is an ArmWarning\n(arm_warning.h).",
"hash": "7932e43af74de045e5562a71644d3339", "base": "suture::Messages", "crtk": true, "commands": [
{"name": "configuration_js", "kind": "read", "ordinal": 1, "wire": "configurationJs",
"doc": "Says what the joint is and what it may do. Its effort limit is published\n(LARGE_NEEDLE_DRIVER_400006.json); its acceleration limit, which is that of moves, is not.",
"result": {"type": {"kind": "struct", "name": "robots::JointConfiguration"}}, "queue": 16}, {
"name": "measured_js", "kind": "read", "ordinal": 2, "wire": "measuredJs",
"doc": "Says where the joint is. The stamp is that of the drives' cycle that measured it.",
"result": {"type": {"kind": "struct", "name": "robots::JointState"}}, "queue": 16}, {
"name": "setpoint_js", "kind": "read", "ordinal": 3, "wire": "setpointJs",
"doc": "Says where the joint shall be. The effort is that of servo_jf, else 0.", "result": {
"type": {"kind": "struct", "name": "robots::JointState"}}, "queue": 16}, {"name": "servo_jp",
"kind": "write", "ordinal": 4, "wire": "servoJp",
"doc": "Streams goals, newest wins. The set-point goes there no faster than the joint can; a goal\nbeyond a limit leads only to the limit.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::JointGoal"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "servo_jf", "kind": "write", "ordinal": 5,
"wire": "servoJf",
"doc": "Streams efforts, newest wins; a negative one closes. The simulated jaw has no mass: an effort\nmoves the set-point at a speed proportional to it.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::JointEffortGoal"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "move_jp", "kind": "write", "ordinal": 6,
"wire": "moveJp",
"doc": "Plans and executes a smooth motion from the set-point and the velocity that it has. Ends with\ngoal_reached.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::JointGoal"}}],
"queue": 16}], "events": [{"name": "status", "kind": "write", "ordinal": 1,
"doc": "Reports that something has been done, and nothing is wrong.", "payload": {"type": {
"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages"}, {"name": "warning", "kind": "write", "ordinal": 2,
"doc": "Reports that something was refused, or is not as it should be; the component goes on.",
"payload": {"type": {"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages"}, {"name": "error", "kind": "write", "ordinal": 3,
"doc": "Reports that something failed, and needs somebody's attention.", "payload": {"type": {
"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages"}, {"name": "goal_reached", "kind": "write", "ordinal": 4,
"wire": "goalReached",
"doc": "Reports the end of a move: true at its goal, false if something else replaced it.",
"payload": {"type": {"kind": "Bool"}}, "queue": 16}], "enums": [{"name": "robots::JointType",
"underlying": "UInt8", "enumerators": [{"name": "Undefined", "value": 0, "wire": "undefined"}, {
"name": "Prismatic", "value": 1, "wire": "prismatic"}, {"name": "Revolute", "value": 2,
"wire": "revolute"}, {"name": "Universal", "value": 3, "wire": "universal"}, {"name": "BallSocket",
"value": 4, "wire": "ballSocket"}, {"name": "Inactive", "value": 5, "wire": "inactive"}]}],
"structs": [{"name": "robots::JointConfiguration",
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
"doc": "If it is false, do not use the state.", "type": {"kind": "Bool"}, "default": false}]}, {
"name": "robots::JointGoal", "doc": "Says where joints shall go: CRTK's servo_jp and move_jp.",
"fields": [{"name": "position", "doc": "There is one entry for each joint, in chain order.",
"type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 8}, "unit": "rad"}, {
"name": "stamp", "type": {"kind": "time", "clock": "steady"}}]}, {
"name": "robots::JointEffortGoal",
"doc": "A JointEffortGoal is the goal of CRTK's servo_jf; corresponds to cisst's prmForceTorqueJointSet.",
"fields": [{"name": "effort", "type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 8
}, "unit": "N.m"}, {"name": "mask",
"doc": "The mask says which joints count; if it is empty, all do.", "type": {"kind": "list",
"element": {"kind": "Bool"}, "capacity": 8}}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}]}, {"name": "suture::Message", "fields": [{"name": "text",
"doc": "The text is UTF-8, for people. A sender cuts a longer text, and ends it in \"...\" then.",
"type": {"kind": "text", "capacity": 255}}, {"name": "code",
"doc": "Says what it is about, by numbers that its sender documents; 0 means nothing in particular.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "counter",
"doc": "Counts the messages of its sender, of all three kinds together, from 1. A gap says that the\nlistener has missed some; a number seen before says that the last one was sent again.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}]}], "wire": [{"id": "@0xf5776c4cb1ab9076", "kind": "interface", "name": "Jaw",
"cxx": "robots::Jaw", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xd6c2953fc4455ac0"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "configurationJs",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xf723b5ed0dc2d63c"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 2, "name": "measuredJs", "is": "kind \"read\"", "parameters": [{"at": 0,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "@0xac24dfe518a4963f"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 3,
"name": "setpointJs", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xac24dfe518a4963f"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 4, "name": "servoJp", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "goal", "is": "@0x8943f2eac122865a"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 5, "name": "servoJf", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "goal", "is": "@0xd704fc0995280ce6"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 6, "name": "moveJp", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "goal", "is": "@0x8943f2eac122865a"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}]}, {"id": "@0xb16d80f0d2b50980", "kind": "interface",
"name": "Messages", "cxx": "suture::Messages", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xa02813b154cdd1d8"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}]}, {
"id": "@0xa02813b154cdd1d8", "kind": "interface", "name": "MessagesEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0x814f9864e019fa96"}]}, {"at": 1,
"name": "status", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "warning", "parameters": [{"at": 0,
"name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 3, "name": "error", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0x814f9864e019fa96", "kind": "struct",
"name": "MessagesStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}]}, {
"id": "@0xbd6bc34f74980c5d", "kind": "struct", "name": "Message", "members": [{"at": 0,
"name": "text", "is": "Text"}, {"at": 1, "name": "code", "is": "UInt32"}, {"at": 2,
"name": "counter", "is": "UInt32"}, {"at": 3, "name": "stamp", "is": "Int64 clock \"steady\""}]}, {
"id": "@0xd6c2953fc4455ac0", "kind": "interface", "name": "JawEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xa03ee03faaaeccdd"}]}, {"at": 1,
"name": "status", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "warning", "parameters": [{"at": 0,
"name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 3, "name": "error", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 4, "name": "goalReached", "parameters": [{
"at": 0, "name": "value", "is": "Bool"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xa03ee03faaaeccdd", "kind": "struct", "name": "JawStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "configurationJs",
"is": "@0xf723b5ed0dc2d63c"}, {"at": 4, "name": "measuredJs", "is": "@0xac24dfe518a4963f"}, {
"at": 5, "name": "setpointJs", "is": "@0xac24dfe518a4963f"}]}, {"id": "@0xf723b5ed0dc2d63c",
"kind": "struct", "name": "JointConfiguration", "members": [{"at": 0, "name": "name",
"is": "List(Text)"}, {"at": 1, "name": "type", "is": "List(@0x9f3bef15df1181c0)"}, {"at": 2,
"name": "positionMin", "is": "List(Float64) unit \"rad\""}, {"at": 3, "name": "positionMax",
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
"at": 5, "name": "valid", "is": "Bool"}]}, {"id": "@0x8943f2eac122865a", "kind": "struct",
"name": "JointGoal", "members": [{"at": 0, "name": "position", "is": "List(Float64) unit \"rad\""},
{"at": 1, "name": "stamp", "is": "Int64 clock \"steady\""}]}, {"id": "@0xd704fc0995280ce6",
"kind": "struct", "name": "JointEffortGoal", "members": [{"at": 0, "name": "effort",
"is": "List(Float64) unit \"N.m\""}, {"at": 1, "name": "mask", "is": "List(Bool)"}, {"at": 2,
"name": "stamp", "is": "Int64 clock \"steady\""}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Jaw>() {
  static const auto kEvents = extended<4>(interfaceInfo<suture::Messages>().events,
                                          robots::kJawEvents);
  static const InterfaceInfo kInfo{
      .name = "robots::Jaw",
      .hash = "7932e43af74de045e5562a71644d3339",
      .description = robots::kJawDescription,
      .commands = robots::kJawCommands,
      .events = kEvents,
      .codec = &robots::jawCodec,
      .base = &interfaceInfo<suture::Messages>,
      .toBase = &castToBase<robots::Jaw, suture::Messages>,
  };
  return kInfo;
}

auto Provided<robots::Jaw>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(robots::JawServoJpArguments::goal)>(scratch.servo_jp_goal);
  reserveFor<decltype(robots::JawServoJfArguments::goal)>(scratch.servo_jf_goal);
  reserveFor<decltype(robots::JawMoveJpArguments::goal)>(scratch.move_jp_goal);
  return scratch;
}

// A function for each command of robots::Jaw, so that a stack in a debugger names it.
struct Provided<robots::Jaw>::Dispatch {
  static Errc execute_configuration_js(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::JointConfigurationSlot>(result);
    return store(implementation.configuration_js(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_measured_js(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::JointStateSlot>(result);
    return store(implementation.measured_js(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_setpoint_js(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::JointStateSlot>(result);
    return store(implementation.setpoint_js(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_servo_jp(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::JawServoJpArguments>(arguments);
    load(slot.goal, scratch.servo_jp_goal);
    implementation.servo_jp(scratch.servo_jp_goal);
    return Errc{};
  }

  static Errc execute_servo_jf(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::JawServoJfArguments>(arguments);
    load(slot.goal, scratch.servo_jf_goal);
    implementation.servo_jf(scratch.servo_jf_goal);
    return Errc{};
  }

  static Errc execute_move_jp(Contract& implementation, Scratch& scratch,
                              const std::byte* arguments) {
    const auto& slot = slotIn<robots::JawMoveJpArguments>(arguments);
    load(slot.goal, scratch.move_jp_goal);
    implementation.move_jp(scratch.move_jp_goal);
    return Errc{};
  }
};

Errc Provided<robots::Jaw>::execute(std::uint16_t command, const std::byte* arguments,
                                    std::byte* result) {
  using ::robots::JawCommand;
  switch (command) {
    case JawCommand::configuration_js:
      return Dispatch::execute_configuration_js(implementation_, result);
    case JawCommand::measured_js: return Dispatch::execute_measured_js(implementation_, result);
    case JawCommand::setpoint_js: return Dispatch::execute_setpoint_js(implementation_, result);
    case JawCommand::servo_jp:
      return Dispatch::execute_servo_jp(implementation_, scratch_, arguments);
    case JawCommand::servo_jf:
      return Dispatch::execute_servo_jf(implementation_, scratch_, arguments);
    case JawCommand::move_jp:
      return Dispatch::execute_move_jp(implementation_, scratch_, arguments);
  }
  return Provided<suture::Messages>::execute(command, arguments, result);
}

}  // namespace suture
