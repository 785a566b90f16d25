// Written by suturec from robots/arm.h. Do not edit.
#include "robots/arm.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/component/factory/json_reader.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<Mode>, std::int8_t>);
static_assert(static_cast<std::int8_t>(Mode::Disabled) == -1);
static_assert(static_cast<std::int8_t>(Mode::HoldStill) == 4);
static_assert(static_cast<std::int8_t>(Mode::Servo) == 2);
static_assert(std::is_same_v<decltype(Everything::on), bool>);
static_assert(std::is_same_v<decltype(Everything::tiny), std::int8_t>);
static_assert(std::is_same_v<decltype(Everything::count), std::uint64_t>);
static_assert(std::is_same_v<decltype(Everything::speed), double>);
static_assert(std::is_same_v<decltype(Everything::ratio), float>);
static_assert(std::is_same_v<decltype(Everything::mode), Mode>);
static_assert(std::is_same_v<decltype(Everything::label), std::string>);
static_assert(std::is_same_v<decltype(Everything::bytes), std::vector<std::uint8_t>>);
static_assert(std::is_same_v<decltype(Everything::flags), std::vector<bool>>);
static_assert(std::is_same_v<decltype(Everything::names), std::vector<std::string>>);
static_assert(std::is_same_v<decltype(Everything::pairs), std::vector<std::array<double, 2>>>);
static_assert(std::is_same_v<decltype(Everything::modes), std::array<robots::Mode, 2>>);
static_assert(std::is_same_v<decltype(Everything::goal), PoseStamped>);
static_assert(std::is_same_v<decltype(Everything::track), std::vector<robots::PoseStamped>>);
static_assert(std::is_same_v<decltype(Everything::point), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(Everything::plane), Eigen::Vector3f>);
static_assert(std::is_same_v<decltype(Everything::inertia), Eigen::Matrix3d>);
static_assert(std::is_same_v<decltype(Everything::jacobian), Eigen::Matrix<double, 6, 7>>);
static_assert(std::is_same_v<decltype(Everything::attitude), Eigen::Quaterniond>);
static_assert(std::is_same_v<decltype(Everything::period), std::chrono::milliseconds>);
static_assert(std::is_same_v<decltype(Everything::when), std::chrono::steady_clock::time_point>);

}  // namespace

bool store(const Everything& value, EverythingSlot& slot) {
  bool fits = true;
  fits &= store(value.on, slot.on);
  fits &= store(value.tiny, slot.tiny);
  fits &= store(value.count, slot.count);
  fits &= store(value.speed, slot.speed);
  fits &= store(value.ratio, slot.ratio);
  fits &= store(value.mode, slot.mode);
  fits &= store(value.label, slot.label);
  fits &= store(value.bytes, slot.bytes);
  fits &= store(value.flags, slot.flags);
  fits &= store(value.names, slot.names);
  fits &= store(value.pairs, slot.pairs);
  fits &= store(value.modes, slot.modes);
  fits &= store(value.goal, slot.goal);
  fits &= store(value.track, slot.track);
  fits &= store(value.point, slot.point);
  fits &= store(value.plane, slot.plane);
  fits &= store(value.inertia, slot.inertia);
  fits &= store(value.jacobian, slot.jacobian);
  fits &= store(value.attitude, slot.attitude);
  fits &= store(value.period, slot.period);
  fits &= store(value.when, slot.when);
  return fits;
}

void load(const EverythingSlot& slot, Everything& value) {
  load(slot.on, value.on);
  load(slot.tiny, value.tiny);
  load(slot.count, value.count);
  load(slot.speed, value.speed);
  load(slot.ratio, value.ratio);
  load(slot.mode, value.mode);
  load(slot.label, value.label);
  load(slot.bytes, value.bytes);
  load(slot.flags, value.flags);
  load(slot.names, value.names);
  load(slot.pairs, value.pairs);
  load(slot.modes, value.modes);
  load(slot.goal, value.goal);
  load(slot.track, value.track);
  load(slot.point, value.point);
  load(slot.plane, value.plane);
  load(slot.inertia, value.inertia);
  load(slot.jacobian, value.jacobian);
  load(slot.attitude, value.attitude);
  load(slot.period, value.period);
  load(slot.when, value.when);
}

void reserve(const EverythingSlot*, Everything& value) {
  suture::reserveFor<decltype(EverythingSlot::label)>(value.label);
  suture::reserveFor<decltype(EverythingSlot::bytes)>(value.bytes);
  suture::reserveFor<decltype(EverythingSlot::flags)>(value.flags);
  suture::reserveFor<decltype(EverythingSlot::names)>(value.names);
  suture::reserveFor<decltype(EverythingSlot::pairs)>(value.pairs);
  suture::reserveFor<decltype(EverythingSlot::track)>(value.track);
}

void shiftStamps(EverythingSlot& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
  for (auto& element : suture::elementsIn(slot.track)) {
    shiftStamps(element, shift);
  }
  slot.when = suture::codec::shifted(slot.when, shift);
}

bool store(const PoseStamped& goal, ArmServoCpArguments& slot) { return store(goal, slot.goal); }

void shiftStamps(ArmServoCpArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const double& speed, ArmSetSpeedArguments& slot) { return store(speed, slot.speed); }

bool store(const PoseStamped& x, const double& tolerance, ArmInverseKinematicsArguments& slot) {
  return store(x, slot.x) && store(tolerance, slot.tolerance);
}

void shiftStamps(ArmInverseKinematicsArguments& slot, suture::Duration shift) {
  shiftStamps(slot.x, shift);
}

bool store(const double& width, const Mode& mode, ArmGraspArguments& slot) {
  return store(width, slot.width) && store(mode, slot.mode);
}

bool store(const PoseStamped& value, const double& value2, const Mode& value3,
           ArmMovedPayload& slot) {
  return store(value, slot.value) && store(value2, slot.value2) && store(value3, slot.value3);
}

void load(const ArmMovedPayload& slot, PoseStamped& value, double& value2, Mode& value3) {
  load(slot.value, value);
  load(slot.value2, value2);
  load(slot.value3, value3);
}

void shiftStamps(ArmMovedPayload& slot, suture::Duration shift) { shiftStamps(slot.value, shift); }

bool isKnownMode(std::int8_t slot) {
  switch (static_cast<Mode>(slot)) {
    case Mode::Disabled:
    case Mode::HoldStill:
    case Mode::Servo:
      return true;
  }
  return false;
}

bool isValid(const EverythingSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.speed, -0.5, 2)) return suture::refusedAt(path, "speed");
  if (!isValid(slot.ratio)) return suture::refusedAt(path, "ratio");
  if (!isKnownMode(slot.mode)) return suture::refusedAt(path, "mode");
  if (!suture::allOf(slot.pairs, path, [path](const std::array<double, 2>& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "pairs");
  }
  if (!suture::allOf(slot.modes, path, [](const std::int8_t& element) {
    return isKnownMode(element);
  })) {
    return suture::refusedAt(path, "modes");
  }
  if (!isValid(slot.goal, path)) return suture::refusedAt(path, "goal");
  if (!suture::allOf(slot.track, path, [path](const PoseStampedSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "track");
  }
  if (!isValid(slot.point, path)) return suture::refusedAt(path, "point");
  if (!isValid(slot.plane, path)) return suture::refusedAt(path, "plane");
  if (!isValid(slot.inertia)) return suture::refusedAt(path, "inertia");
  if (!isValid(slot.jacobian)) return suture::refusedAt(path, "jacobian");
  return isValid(slot.attitude) || suture::refusedAt(path, "attitude");
}

// Defined in robots/arm.wire.cpp.
const suture::codec::Codec& armCodec();

namespace {

bool acceptsArmServoCp(const ArmServoCpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmSetSpeed(const ArmSetSpeedArguments& slot, suture::FieldPath* path) {
  return isValid(slot.speed) || suture::refusedAt(path, "speed");
}

bool acceptsArmModeResult(const std::int8_t& slot, suture::FieldPath*) { return isKnownMode(slot); }

bool acceptsArmInverseKinematics(const ArmInverseKinematicsArguments& slot,
                                 suture::FieldPath* path) {
  if (!isValid(slot.x, path)) return suture::refusedAt(path, "x");
  return suture::inRange(slot.tolerance, 0, 1) || suture::refusedAt(path, "tolerance");
}

bool acceptsArmGrasp(const ArmGraspArguments& slot, suture::FieldPath* path) {
  if (!isValid(slot.width)) return suture::refusedAt(path, "width");
  return isKnownMode(slot.mode) || suture::refusedAt(path, "mode");
}

bool acceptsArmLoadResult(const double& slot, suture::FieldPath*) { return isValid(slot); }

bool acceptsArmModeChangedEvent(const std::int8_t& slot, suture::FieldPath*) {
  return isKnownMode(slot);
}

bool acceptsArmMovedEvent(const ArmMovedPayload& slot, suture::FieldPath* path) {
  if (!isValid(slot.value, path)) return suture::refusedAt(path, "value");
  if (!isValid(slot.value2)) return suture::refusedAt(path, "value2");
  return isKnownMode(slot.value3) || suture::refusedAt(path, "value3");
}

constexpr suture::CommandInfo kArmCommands[] = {
    {.name = "enable", .kind = suture::CommandKind::Void, .depth = 4},
    {.name = "servo_cp",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmServoCpArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(20'000'000),
     .accepts = suture::checkSlot<ArmServoCpArguments, acceptsArmServoCp>,
     .shiftArguments = suture::shiftSlot<ArmServoCpArguments>},
    {.name = "set_speed",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmSetSpeedArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmSetSpeedArguments, acceptsArmSetSpeed>},
    {.name = "measured_cp",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = ArmColumn::measured_cp,
     .acceptsResult = suture::checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = suture::shiftSlot<PoseStampedSlot>},
    {.name = "mode",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::int8_t>,
     .depth = 16,
     .column = ArmColumn::mode,
     .acceptsResult = suture::checkSlot<std::int8_t, acceptsArmModeResult>},
    {.name = "everything",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<EverythingSlot>,
     .depth = 16,
     .column = ArmColumn::everything,
     .acceptsResult = suture::checkSlot<EverythingSlot, isValid>,
     .shiftResult = suture::shiftSlot<EverythingSlot>},
    {.name = "inverse_kinematics",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<ArmInverseKinematicsArguments>,
     .resultSize = suture::slotSize<EverythingSlot>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmInverseKinematicsArguments, acceptsArmInverseKinematics>,
     .acceptsResult = suture::checkSlot<EverythingSlot, isValid>,
     .shiftArguments = suture::shiftSlot<ArmInverseKinematicsArguments>,
     .shiftResult = suture::shiftSlot<EverythingSlot>},
    {.name = "grasp",
     .kind = suture::CommandKind::WriteReturn,
     .argumentsSize = suture::slotSize<ArmGraspArguments>,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 2,
     .deadline = suture::Duration(50'000'000),
     .accepts = suture::checkSlot<ArmGraspArguments, acceptsArmGrasp>},
    {.name = "next_token",
     .kind = suture::CommandKind::VoidReturn,
     .resultSize = suture::slotSize<std::uint32_t>,
     .depth = 16},
    {.name = "park", .kind = suture::CommandKind::Void, .depth = 16, .inCallersThread = true},
    {.name = "load",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .column = ArmColumn::load,
     .acceptsResult = suture::checkSlot<double, acceptsArmLoadResult>},
};

constexpr suture::EventInfo kArmEvents[] = {
    {.name = "mode_changed",
     .payloadSize = suture::slotSize<std::int8_t>,
     .depth = 8,
     .latched = true,
     .accepts = suture::checkSlot<std::int8_t, acceptsArmModeChangedEvent>},
    {.name = "stopped", .depth = 16},
    {.name = "arrived",
     .payloadSize = suture::slotSize<PoseStampedSlot>,
     .depth = 16,
     .accepts = suture::checkSlot<PoseStampedSlot, isValid>,
     .shiftPayload = suture::shiftSlot<PoseStampedSlot>},
    {.name = "moved",
     .payloadSize = suture::slotSize<ArmMovedPayload>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<ArmMovedPayload, acceptsArmMovedEvent>,
     .shiftPayload = suture::shiftSlot<ArmMovedPayload>},
};

// The self-description, as in robots/arm.suture.json.
constexpr char kArmDescription[] = R"json(
{"name": "robots::Arm", "doc": "A robot arm.", "hash": "d8de998c5ba084a28d01192de0814d0b",
"core": "bec890e4e4cf5450b64adb3019e10edb", "commands": [{"name": "enable", "kind": "void",
"ordinal": 1, "queue": 4}, {"name": "servo_cp", "kind": "write", "ordinal": 2, "wire": "servoCp",
"doc": "Follow the goal.", "parameters": [{"name": "goal", "type": {"kind": "struct",
"name": "robots::PoseStamped"}}], "queue": 16, "latest": true, "ttl": 0.02}, {"name": "set_speed",
"kind": "write", "ordinal": 3, "wire": "setSpeed", "parameters": [{"name": "speed", "type": {
"kind": "Float64"}, "unit": "m/s"}], "queue": 16}, {"name": "measured_cp", "kind": "read",
"ordinal": 4, "wire": "measuredCp", "result": {"type": {"kind": "struct",
"name": "robots::PoseStamped"}}, "queue": 16}, {"name": "mode", "kind": "read", "ordinal": 5,
"result": {"type": {"kind": "enum", "name": "robots::Mode"}}, "queue": 16}, {"name": "everything",
"kind": "read", "ordinal": 6, "result": {"type": {"kind": "struct", "name": "robots::Everything"}},
"queue": 16}, {"name": "inverse_kinematics", "kind": "qualified read", "ordinal": 7,
"wire": "inverseKinematics", "parameters": [{"name": "x", "type": {"kind": "struct",
"name": "robots::PoseStamped"}}, {"name": "tolerance", "type": {"kind": "Float64"}, "range": [0.0,
1.0]}], "result": {"type": {"kind": "struct", "name": "robots::Everything"}}, "queue": 16}, {
"name": "grasp", "kind": "write with return", "ordinal": 8,
"doc": "Closes the gripper; answers whether it holds something.", "parameters": [{"name": "width",
"type": {"kind": "Float64"}}, {"name": "mode", "type": {"kind": "enum", "name": "robots::Mode"}}],
"result": {"type": {"kind": "Bool"}}, "queue": 2, "deadline": 0.05}, {"name": "next_token",
"kind": "void with return", "ordinal": 9, "wire": "nextToken", "result": {"type": {"kind": "UInt32"
}}, "queue": 16, "since": 1}, {"name": "park", "kind": "void", "ordinal": 10, "queue": 16,
"optional": true, "direct": true, "deprecated": "use enable"}, {"name": "load", "kind": "read",
"ordinal": 11, "result": {"type": {"kind": "Float64"}}, "queue": 16, "optional": true}], "events": [
{"name": "mode_changed", "kind": "write", "ordinal": 1, "wire": "modeChanged", "payload": {
"type": {"kind": "enum", "name": "robots::Mode"}}, "queue": 8, "latched": true}, {
"name": "stopped", "kind": "void", "ordinal": 2, "queue": 16}, {"name": "arrived", "kind": "write",
"ordinal": 3, "payload": {"type": {"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16},
{"name": "moved", "kind": "write", "ordinal": 4, "doc": "Where, how fast and why.", "payload": [{
"name": "value", "type": {"kind": "struct", "name": "robots::PoseStamped"}}, {"name": "value2",
"type": {"kind": "Float64"}}, {"name": "value3", "type": {"kind": "enum", "name": "robots::Mode"}}
], "queue": 16, "latched": true}], "enums": [{"name": "robots::Mode", "doc": "What the arm does.",
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
]}], "wire": [{"id": "@0x974e120931408f6d", "kind": "interface", "name": "Arm",
"cxx": "robots::Arm", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xa6aa5daf71e0a4ba"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "enable", "is": "kind \"void\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 2,
"name": "servoCp", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "goal",
"is": "@0xe61654a89cf5f1dd"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 3, "name": "setSpeed", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "speed",
"is": "Float64 unit \"m/s\""}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 4, "name": "measuredCp", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xe61654a89cf5f1dd"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 5, "name": "mode", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xab8c3dd92b2643d4"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 6, "name": "everything", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xe827b555e2bdb416"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 7, "name": "inverseKinematics",
"is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "x", "is": "@0xe61654a89cf5f1dd"},
{"at": 1, "name": "tolerance", "is": "Float64"}, {"at": 2, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xe827b555e2bdb416"
}]}, {"at": 8, "name": "grasp", "is": "kind \"writeReturn\"", "parameters": [{"at": 0,
"name": "width", "is": "Float64"}, {"at": 1, "name": "mode", "is": "@0xab8c3dd92b2643d4"}, {
"at": 2, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Bool"}]}, {"at": 9, "name": "nextToken", "is": "kind \"voidReturn\"", "parameters": [{
"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "UInt32"}]}, {"at": 10, "name": "park", "is": "kind \"void\"", "parameters": [{"at": 0,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 11, "name": "load", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xa6aa5daf71e0a4ba", "kind": "interface", "name": "ArmEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xd633b378dcab35c1"}]}, {"at": 1,
"name": "modeChanged", "parameters": [{"at": 0, "name": "value", "is": "@0xab8c3dd92b2643d4"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "stopped", "parameters": [{"at": 0,
"name": "stamp", "is": "Int64"}]}, {"at": 3, "name": "arrived", "parameters": [{"at": 0,
"name": "value", "is": "@0xe61654a89cf5f1dd"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 4, "name": "moved", "parameters": [{"at": 0, "name": "value", "is": "@0xe61654a89cf5f1dd"}, {
"at": 1, "name": "value2", "is": "Float64"}, {"at": 2, "name": "value3", "is": "@0xab8c3dd92b2643d4"
}, {"at": 3, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xd633b378dcab35c1", "kind": "struct",
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
"is": "Int64 period \"1/1000\""}, {"at": 20, "name": "when", "is": "Int64 clock \"steady\""}]}]})json";

}  // namespace
}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, Mode& value) {
  static constexpr Mode kValues[] = {Mode::Disabled, Mode::HoldStill, Mode::Servo};
  const int index = suture::enumeratorFromJson(in, {"Disabled", "HoldStill", "Servo"});
  if (index >= 0) value = kValues[index];
}

}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Arm>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::Arm",
      .hash = "d8de998c5ba084a28d01192de0814d0b",
      .description = robots::kArmDescription,
      .commands = robots::kArmCommands,
      .events = robots::kArmEvents,
      .codec = &robots::armCodec,
  };
  return kInfo;
}

// A function for each command of robots::Arm, so that a stack in a debugger names it.
struct Provided<robots::Arm>::Dispatch {
  static Errc execute_enable(Contract& implementation) {
    implementation.enable();
    return Errc{};
  }

  static Errc execute_servo_cp(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmServoCpArguments>(arguments);
    load(slot.goal, scratch.servo_cp_goal);
    implementation.servo_cp(scratch.servo_cp_goal);
    return Errc{};
  }

  static Errc execute_set_speed(Contract& implementation, Scratch& scratch,
                                const std::byte* arguments) {
    const auto& slot = slotIn<robots::ArmSetSpeedArguments>(arguments);
    load(slot.speed, scratch.set_speed_speed);
    implementation.set_speed(scratch.set_speed_speed);
    return Errc{};
  }

  static Errc execute_measured_cp(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PoseStampedSlot>(result);
    return store(implementation.measured_cp(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_mode(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::int8_t>(result);
    return store(implementation.mode(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_everything(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::EverythingSlot>(result);
    return store(implementation.everything(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_inverse_kinematics(Contract& implementation, Scratch& scratch,
                                         const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<robots::ArmInverseKinematicsArguments>(arguments);
    load(slot.x, scratch.inverse_kinematics_x);
    load(slot.tolerance, scratch.inverse_kinematics_tolerance);
    auto& answer = newSlot<robots::EverythingSlot>(result);
    return store(implementation.inverse_kinematics(scratch.inverse_kinematics_x,
                                                   scratch.inverse_kinematics_tolerance), answer)
        ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_grasp(Contract& implementation, Scratch& scratch, const std::byte* arguments,
                            std::byte* result) {
    const auto& slot = slotIn<robots::ArmGraspArguments>(arguments);
    load(slot.width, scratch.grasp_width);
    load(slot.mode, scratch.grasp_mode);
    auto& answer = newSlot<std::uint8_t>(result);
    return store(implementation.grasp(scratch.grasp_width, scratch.grasp_mode), answer)
        ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_next_token(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::uint32_t>(result);
    return store(implementation.next_token(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_park(Contract& implementation) {
    implementation.park();
    return Errc{};
  }

  static Errc execute_load(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<double>(result);
    return store(implementation.load(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::Arm>::execute(std::uint16_t command, const std::byte* arguments,
                                    std::byte* result) {
  using ::robots::ArmCommand;
  switch (command) {
    case ArmCommand::enable: return Dispatch::execute_enable(implementation_);
    case ArmCommand::servo_cp:
      return Dispatch::execute_servo_cp(implementation_, scratch_, arguments);
    case ArmCommand::set_speed:
      return Dispatch::execute_set_speed(implementation_, scratch_, arguments);
    case ArmCommand::measured_cp: return Dispatch::execute_measured_cp(implementation_, result);
    case ArmCommand::mode: return Dispatch::execute_mode(implementation_, result);
    case ArmCommand::everything: return Dispatch::execute_everything(implementation_, result);
    case ArmCommand::inverse_kinematics:
      return Dispatch::execute_inverse_kinematics(implementation_, scratch_, arguments, result);
    case ArmCommand::grasp:
      return Dispatch::execute_grasp(implementation_, scratch_, arguments, result);
    case ArmCommand::next_token: return Dispatch::execute_next_token(implementation_, result);
    case ArmCommand::park: return Dispatch::execute_park(implementation_);
    case ArmCommand::load: return Dispatch::execute_load(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
