// Written by suturec from drives/drives.h. Do not edit.
#include "drives/drives.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<DrivePower>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(DrivePower::NotReady) == 0);
static_assert(static_cast<std::uint8_t>(DrivePower::Stopped) == 1);
static_assert(static_cast<std::uint8_t>(DrivePower::Off) == 2);
static_assert(static_cast<std::uint8_t>(DrivePower::On) == 3);
static_assert(std::is_same_v<decltype(DriveFeedback::position), std::array<double, 8>>);
static_assert(std::is_same_v<decltype(DriveFeedback::velocity), std::array<double, 8>>);
static_assert(std::is_same_v<decltype(DriveFeedback::joints), std::uint32_t>);
static_assert(std::is_same_v<decltype(DriveFeedback::power), DrivePower>);
static_assert(std::is_same_v<decltype(DriveFeedback::permitted),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(DriveFeedback::stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(DriveFeedback::effort), std::array<double, 8>>);
static_assert(std::is_same_v<decltype(DriveFeedback::measures_effort), bool>);
static_assert(std::is_same_v<decltype(DriveFeedback::controls_effort), bool>);
static_assert(std::is_same_v<decltype(DriveGoal::position), std::array<double, 8>>);
static_assert(std::is_same_v<decltype(DriveGoal::joints), std::uint32_t>);
static_assert(std::is_same_v<decltype(DriveGoal::effort), std::array<double, 8>>);
static_assert(std::is_same_v<decltype(DriveGoal::released), std::array<bool, 8>>);
static_assert(std::is_same_v<decltype(DriveGoal::gravity_compensation), bool>);

}  // namespace

bool store(const DriveFeedback& value, DriveFeedbackSlot& slot) {
  bool fits = true;
  fits &= store(value.position, slot.position);
  fits &= store(value.velocity, slot.velocity);
  fits &= store(value.joints, slot.joints);
  fits &= store(value.power, slot.power);
  fits &= store(value.permitted, slot.permitted);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.effort, slot.effort);
  fits &= store(value.measures_effort, slot.measures_effort);
  fits &= store(value.controls_effort, slot.controls_effort);
  return fits;
}

void load(const DriveFeedbackSlot& slot, DriveFeedback& value) {
  load(slot.position, value.position);
  load(slot.velocity, value.velocity);
  load(slot.joints, value.joints);
  load(slot.power, value.power);
  load(slot.permitted, value.permitted);
  load(slot.stamp, value.stamp);
  load(slot.effort, value.effort);
  load(slot.measures_effort, value.measures_effort);
  load(slot.controls_effort, value.controls_effort);
}

void shiftStamps(DriveFeedbackSlot& slot, suture::Duration shift) {
  slot.permitted = suture::codec::shifted(slot.permitted, shift);
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const DriveGoal& value, DriveGoalSlot& slot) {
  bool fits = true;
  fits &= store(value.position, slot.position);
  fits &= store(value.joints, slot.joints);
  fits &= store(value.effort, slot.effort);
  fits &= store(value.released, slot.released);
  fits &= store(value.gravity_compensation, slot.gravity_compensation);
  return fits;
}

void load(const DriveGoalSlot& slot, DriveGoal& value) {
  load(slot.position, value.position);
  load(slot.joints, value.joints);
  load(slot.effort, value.effort);
  load(slot.released, value.released);
  load(slot.gravity_compensation, value.gravity_compensation);
}

bool store(const std::chrono::steady_clock::time_point& permitted, DrivesPowerOnArguments& slot) {
  return store(permitted, slot.permitted);
}

void shiftStamps(DrivesPowerOnArguments& slot, suture::Duration shift) {
  slot.permitted = suture::codec::shifted(slot.permitted, shift);
}

bool store(const DriveGoal& goal, DrivesServoJpArguments& slot) { return store(goal, slot.goal); }

bool isKnownDrivePower(std::uint8_t slot) {
  switch (static_cast<DrivePower>(slot)) {
    case DrivePower::NotReady:
    case DrivePower::Stopped:
    case DrivePower::Off:
    case DrivePower::On:
      return true;
  }
  return false;
}

bool isValid(const DriveFeedbackSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.position, path)) return suture::refusedAt(path, "position");
  if (!isValid(slot.velocity, path)) return suture::refusedAt(path, "velocity");
  if (!isKnownDrivePower(slot.power)) return suture::refusedAt(path, "power");
  return isValid(slot.effort, path) || suture::refusedAt(path, "effort");
}

bool isValid(const DriveGoalSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.position, path)) return suture::refusedAt(path, "position");
  return isValid(slot.effort, path) || suture::refusedAt(path, "effort");
}

// Defined in drives/drives.wire.cpp.
const suture::codec::Codec& drivesCodec();

namespace {

bool acceptsDrivesServoJp(const DrivesServoJpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsDrivesPowerEvent(const std::uint8_t& slot, suture::FieldPath*) {
  return isKnownDrivePower(slot);
}

constexpr suture::CommandInfo kDrivesCommands[] = {
    {.name = "power_on",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<DrivesPowerOnArguments>,
     .depth = 16,
     .shiftArguments = suture::shiftSlot<DrivesPowerOnArguments>},
    {.name = "power_off", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "servo_jp",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<DrivesServoJpArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(20'000'000),
     .accepts = suture::checkSlot<DrivesServoJpArguments, acceptsDrivesServoJp>},
    {.name = "feedback",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<DriveFeedbackSlot>,
     .depth = 16,
     .column = DrivesColumn::feedback,
     .acceptsResult = suture::checkSlot<DriveFeedbackSlot, isValid>,
     .shiftResult = suture::shiftSlot<DriveFeedbackSlot>},
};

constexpr suture::EventInfo kDrivesEvents[] = {
    {.name = "power",
     .payloadSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<std::uint8_t, acceptsDrivesPowerEvent>},
};

// The self-description, as in drives/drives.suture.json.
constexpr char kDrivesDescription[] = R"json(
{"name": "robots::Drives",
"doc": "Commands run in the drives' own thread before its next cycle; the read is from the end of its\nlast one.",
"hash": "ea2b8319e8fefe56d2d3045775c87b3c", "commands": [{"name": "power_on", "kind": "write",
"ordinal": 1, "wire": "powerOn",
"doc": "Releases the brakes. The joints hold where they are. `permitted` is that of the feedback that\nthis answers: drives that have stopped since then, or may not have power, stay as they are.",
"parameters": [{"name": "permitted", "type": {"kind": "time", "clock": "steady"}}], "queue": 16}, {
"name": "power_off", "kind": "void", "ordinal": 2, "wire": "powerOff",
"doc": "Lets the brakes hold the joints where they are. The joints of an arm that has none sink by\ntheir weight.",
"queue": 16}, {"name": "servo_jp", "kind": "write", "ordinal": 3, "wire": "servoJp",
"doc": "Streams goals, newest wins. Without power, or with the wrong number of joints, a goal changes\nnothing. A stream that falls silent for 0.1 s leaves the joints where they are: they are held\nthere, and no effort of a goal acts any more.",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "robots::DriveGoal"}}],
"queue": 16, "latest": true, "ttl": 0.02}, {"name": "feedback", "kind": "read", "ordinal": 4,
"result": {"type": {"kind": "struct", "name": "robots::DriveFeedback"}}, "queue": 16}], "events": [
{"name": "power", "kind": "write", "ordinal": 1,
"doc": "Reports each change, and the last one to a client that connects.", "payload": {"type": {
"kind": "enum", "name": "robots::DrivePower"}}, "queue": 16, "latched": true}], "enums": [{
"name": "robots::DrivePower", "underlying": "UInt8", "enumerators": [{"name": "NotReady",
"value": 0, "wire": "notReady", "doc": "since they started, nobody has permitted them power"}, {
"name": "Stopped", "value": 1, "wire": "stopped",
"doc": "by the emergency stop, or because nobody permits power any more"}, {"name": "Off",
"value": 2, "wire": "off",
"doc": "without power, which they are permitted to have: what brakes they have are on"}, {
"name": "On", "value": 3, "wire": "on", "doc": "the joints follow their goals"}]}], "structs": [{
"name": "robots::DriveGoal",
"doc": "Says where the actuators shall be, in the same order, and what their motors do beside that. The\nentry of a gripper has no effect.",
"fields": [{"name": "position", "doc": "The first `joints` entries count.", "type": {
"kind": "array", "element": {"kind": "Float64"}, "length": 8}, "unit": "rad"}, {"name": "joints",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "effort",
"doc": "The motors give this beside what holds the joints and carries the arm. All together is cut to\nwhat a motor can give.",
"type": {"kind": "array", "element": {"kind": "Float64"}, "length": 8}, "unit": "N.m"}, {
"name": "released",
"doc": "There is an entry for each joint of the chain, not for each actuator. A joint for which it is\ntrue is not held: its position here has no effect. At more than its rate limit it is slowed\ndown.",
"type": {"kind": "array", "element": {"kind": "Bool"}, "length": 8}}, {
"name": "gravity_compensation", "wire": "gravityCompensation",
"doc": "If it is true, the motors carry the arm's weight. It counts until the next goal, also after\nthe stream has ended.",
"type": {"kind": "Bool"}, "default": true}]}, {"name": "robots::DriveFeedback",
"doc": "A DriveFeedback is what the drives measure in each of their cycles. It is of actuators, in the\norder of the joints of the chain, and of the tool behind them: a slave's jaw, or a master's\ngripper, which nothing drives. coupling.h says how the actuators of an arm turn its joints; most\nare their joint. The actuator of a prismatic joint has m, m/s and N.",
"fields": [{"name": "position", "doc": "The first `joints` entries count.", "type": {
"kind": "array", "element": {"kind": "Float64"}, "length": 8}, "unit": "rad"}, {"name": "velocity",
"type": {"kind": "array", "element": {"kind": "Float64"}, "length": 8}, "unit": "rad/s"}, {
"name": "joints", "type": {"kind": "UInt32"}, "default": 0}, {"name": "power", "type": {
"kind": "enum", "name": "robots::DrivePower"}, "default": "NotReady"}, {"name": "permitted",
"doc": "They were last permitted to have power at this time. If this changes, they have stopped\nmeanwhile, or are other drives, which an arm may not have seen.",
"type": {"kind": "time", "clock": "steady"}}, {"name": "stamp",
"doc": "The stamp is that of the drives' cycle.", "type": {"kind": "time", "clock": "steady"}}, {
"name": "effort", "doc": "The motors give these efforts, as their currents show them.", "type": {
"kind": "array", "element": {"kind": "Float64"}, "length": 8}, "unit": "N.m"}, {
"name": "measures_effort", "wire": "measuresEffort",
"doc": "This is true if `effort` is measured. Joints that are simulated without mass need none, and\nhave 0; so does a simulated jaw, which has no mass whatever this says.",
"type": {"kind": "Bool"}, "default": false}, {"name": "controls_effort", "wire": "controlsEffort",
"doc": "This is true if the drives obey what a goal says beside positions. Joints that are simulated\nwithout mass have no effort, so their drives follow positions only.",
"type": {"kind": "Bool"}, "default": false}]}], "wire": [{"id": "@0x91efda82df1adc01",
"kind": "interface", "name": "Drives", "cxx": "robots::Drives", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0xe59a5d931070aa84"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {
"at": 1, "name": "powerOn", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "permitted",
"is": "Int64 clock \"steady\""}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 2, "name": "powerOff", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 3, "name": "servoJp", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "goal", "is": "@0xe3033c33c5a1f822"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 4, "name": "feedback", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xc6e6797127c781ed"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xe59a5d931070aa84", "kind": "interface", "name": "DrivesEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xf51328c4223872e4"}]}, {"at": 1,
"name": "power", "parameters": [{"at": 0, "name": "value", "is": "@0xd2f9073be1a76833"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}]}, {"id": "@0xf51328c4223872e4", "kind": "struct",
"name": "DrivesStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "feedback", "is": "@0xc6e6797127c781ed"}]}, {"id": "@0xc6e6797127c781ed", "kind": "struct",
"name": "DriveFeedback", "members": [{"at": 0, "name": "position",
"is": "List(Float64) unit \"rad\" shape \"8\""}, {"at": 1, "name": "velocity",
"is": "List(Float64) unit \"rad/s\" shape \"8\""}, {"at": 2, "name": "joints", "is": "UInt32"}, {
"at": 3, "name": "power", "is": "@0xd2f9073be1a76833"}, {"at": 4, "name": "permitted",
"is": "Int64 clock \"steady\""}, {"at": 5, "name": "stamp", "is": "Int64 clock \"steady\""}, {
"at": 6, "name": "effort", "is": "List(Float64) unit \"N.m\" shape \"8\""}, {"at": 7,
"name": "measuresEffort", "is": "Bool"}, {"at": 8, "name": "controlsEffort", "is": "Bool"}]}, {
"id": "@0xd2f9073be1a76833", "kind": "enum", "name": "DrivePower", "members": [{"at": 0,
"name": "notReady"}, {"at": 1, "name": "stopped"}, {"at": 2, "name": "off"}, {"at": 3, "name": "on"
}]}, {"id": "@0xe3033c33c5a1f822", "kind": "struct", "name": "DriveGoal", "members": [{"at": 0,
"name": "position", "is": "List(Float64) unit \"rad\" shape \"8\""}, {"at": 1, "name": "joints",
"is": "UInt32"}, {"at": 2, "name": "effort", "is": "List(Float64) unit \"N.m\" shape \"8\""}, {
"at": 3, "name": "released", "is": "List(Bool) shape \"8\""}, {"at": 4,
"name": "gravityCompensation", "is": "Bool = true"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Drives>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::Drives",
      .hash = "ea2b8319e8fefe56d2d3045775c87b3c",
      .description = robots::kDrivesDescription,
      .commands = robots::kDrivesCommands,
      .events = robots::kDrivesEvents,
      .codec = &robots::drivesCodec,
  };
  return kInfo;
}

// A function for each command of robots::Drives, so that a stack in a debugger names it.
struct Provided<robots::Drives>::Dispatch {
  static Errc execute_power_on(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::DrivesPowerOnArguments>(arguments);
    load(slot.permitted, scratch.power_on_permitted);
    implementation.power_on(scratch.power_on_permitted);
    return Errc{};
  }

  static Errc execute_power_off(Contract& implementation) {
    implementation.power_off();
    return Errc{};
  }

  static Errc execute_servo_jp(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::DrivesServoJpArguments>(arguments);
    load(slot.goal, scratch.servo_jp_goal);
    implementation.servo_jp(scratch.servo_jp_goal);
    return Errc{};
  }

  static Errc execute_feedback(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::DriveFeedbackSlot>(result);
    return store(implementation.feedback(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::Drives>::execute(std::uint16_t command, const std::byte* arguments,
                                       std::byte* result) {
  using ::robots::DrivesCommand;
  switch (command) {
    case DrivesCommand::power_on:
      return Dispatch::execute_power_on(implementation_, scratch_, arguments);
    case DrivesCommand::power_off: return Dispatch::execute_power_off(implementation_);
    case DrivesCommand::servo_jp:
      return Dispatch::execute_servo_jp(implementation_, scratch_, arguments);
    case DrivesCommand::feedback: return Dispatch::execute_feedback(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
