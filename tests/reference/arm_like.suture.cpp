// Written by suturec from reference/arm_like.h. Do not edit.
#include "reference/arm_like.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace reference {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const PoseStamped& goal, ArmLikeServoCpArguments& slot) {
  return store(goal, slot.goal);
}

void shiftStamps(ArmLikeServoCpArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

bool store(const JointState& goal, ArmLikeServoJpArguments& slot) { return store(goal, slot.goal); }

bool store(const Mode& mode, ArmLikeSetModeArguments& slot) { return store(mode, slot.mode); }

bool store(const PoseStamped& to, ArmLikeDistanceArguments& slot) { return store(to, slot.to); }

void shiftStamps(ArmLikeDistanceArguments& slot, suture::Duration shift) {
  shiftStamps(slot.to, shift);
}

bool store(const PoseStamped& goal, const double& speed, const std::string& reason,
           ArmLikeMoveArguments& slot) {
  return store(goal, slot.goal) && store(speed, slot.speed) && store(reason, slot.reason);
}

void shiftStamps(ArmLikeMoveArguments& slot, suture::Duration shift) {
  shiftStamps(slot.goal, shift);
}

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

void shiftStamps(ArmLikeMovedPayload& slot, suture::Duration shift) {
  shiftStamps(slot.value, shift);
}

// Defined in reference/arm_like.wire.cpp.
const suture::codec::Codec& armLikeCodec();

namespace {

bool acceptsArmLikeServoCp(const ArmLikeServoCpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmLikeServoJp(const ArmLikeServoJpArguments& slot, suture::FieldPath* path) {
  return isValid(slot.goal, path) || suture::refusedAt(path, "goal");
}

bool acceptsArmLikeSetMode(const ArmLikeSetModeArguments& slot, suture::FieldPath* path) {
  return isKnownMode(slot.mode) || suture::refusedAt(path, "mode");
}

bool acceptsArmLikeDistance(const ArmLikeDistanceArguments& slot, suture::FieldPath* path) {
  return isValid(slot.to, path) || suture::refusedAt(path, "to");
}

bool acceptsArmLikeDistanceResult(const double& slot, suture::FieldPath*) { return isValid(slot); }

bool acceptsArmLikeMove(const ArmLikeMoveArguments& slot, suture::FieldPath* path) {
  if (!isValid(slot.goal, path)) return suture::refusedAt(path, "goal");
  return suture::inRange(slot.speed, 0, 1) || suture::refusedAt(path, "speed");
}

bool acceptsArmLikeLimit(const ArmLikeLimitArguments& slot, suture::FieldPath* path) {
  if (!isValid(slot.speed)) return suture::refusedAt(path, "speed");
  return isKnownMode(slot.mode) || suture::refusedAt(path, "mode");
}

bool acceptsArmLikeModeEvent(const std::uint8_t& slot, suture::FieldPath*) {
  return isKnownMode(slot);
}

bool acceptsArmLikeMovedEvent(const ArmLikeMovedPayload& slot, suture::FieldPath* path) {
  if (!isValid(slot.value, path)) return suture::refusedAt(path, "value");
  return isValid(slot.value2) || suture::refusedAt(path, "value2");
}

constexpr suture::CommandInfo kArmLikeCommands[] = {
    {.name = "servo_cp",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmLikeServoCpArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(500'000'000),
     .accepts = suture::checkSlot<ArmLikeServoCpArguments, acceptsArmLikeServoCp>,
     .shiftArguments = suture::shiftSlot<ArmLikeServoCpArguments>},
    {.name = "servo_jp",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmLikeServoJpArguments>,
     .depth = 16,
     .latest = true,
     .accepts = suture::checkSlot<ArmLikeServoJpArguments, acceptsArmLikeServoJp>},
    {.name = "hold", .kind = suture::CommandKind::Void, .depth = 4},
    {.name = "set_mode",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmLikeSetModeArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmLikeSetModeArguments, acceptsArmLikeSetMode>},
    {.name = "measured_cp",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = ArmLikeColumn::measured_cp,
     .acceptsResult = suture::checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = suture::shiftSlot<PoseStampedSlot>},
    {.name = "measured_js",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<JointStateSlot>,
     .depth = 16,
     .column = ArmLikeColumn::measured_js,
     .acceptsResult = suture::checkSlot<JointStateSlot, isValid>},
    {.name = "distance",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<ArmLikeDistanceArguments>,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmLikeDistanceArguments, acceptsArmLikeDistance>,
     .acceptsResult = suture::checkSlot<double, acceptsArmLikeDistanceResult>,
     .shiftArguments = suture::shiftSlot<ArmLikeDistanceArguments>},
    {.name = "move",
     .kind = suture::CommandKind::WriteReturn,
     .argumentsSize = suture::slotSize<ArmLikeMoveArguments>,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .deadline = suture::Duration(200'000'000),
     .accepts = suture::checkSlot<ArmLikeMoveArguments, acceptsArmLikeMove>,
     .shiftArguments = suture::shiftSlot<ArmLikeMoveArguments>},
    {.name = "reset",
     .kind = suture::CommandKind::VoidReturn,
     .resultSize = suture::slotSize<std::uint32_t>,
     .depth = 16},
    {.name = "limit",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArmLikeLimitArguments>,
     .depth = 2,
     .accepts = suture::checkSlot<ArmLikeLimitArguments, acceptsArmLikeLimit>},
    {.name = "park", .kind = suture::CommandKind::Void, .depth = 16},
};

constexpr suture::EventInfo kArmLikeEvents[] = {
    {.name = "mode",
     .payloadSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<std::uint8_t, acceptsArmLikeModeEvent>},
    {.name = "arrived",
     .payloadSize = suture::slotSize<PoseStampedSlot>,
     .depth = 4,
     .accepts = suture::checkSlot<PoseStampedSlot, isValid>,
     .shiftPayload = suture::shiftSlot<PoseStampedSlot>},
    {.name = "stopped", .depth = 16},
    {.name = "moved",
     .payloadSize = suture::slotSize<ArmLikeMovedPayload>,
     .depth = 16,
     .accepts = suture::checkSlot<ArmLikeMovedPayload, acceptsArmLikeMovedEvent>,
     .shiftPayload = suture::shiftSlot<ArmLikeMovedPayload>},
};

// The self-description, as in reference/arm_like.suture.json.
constexpr char kArmLikeDescription[] = R"json(
{"name": "reference::ArmLike", "hash": "968897e2572bbf86158430dd4ed899ee",
"core": "ade49bdab2d2ca197c01302850714adb", "commands": [{"name": "servo_cp", "kind": "write",
"ordinal": 1, "wire": "servoCp", "doc": "Follows a stream of poses.", "parameters": [{
"name": "goal", "type": {"kind": "struct", "name": "reference::PoseStamped"}}], "queue": 16,
"latest": true, "ttl": 0.5}, {"name": "servo_jp", "kind": "write", "ordinal": 2, "wire": "servoJp",
"parameters": [{"name": "goal", "type": {"kind": "struct", "name": "reference::JointState"}}],
"queue": 16, "latest": true}, {"name": "hold", "kind": "void", "ordinal": 3, "queue": 4}, {
"name": "set_mode", "kind": "write", "ordinal": 4, "wire": "setMode", "parameters": [{
"name": "mode", "type": {"kind": "enum", "name": "reference::Mode"}}], "queue": 16}, {
"name": "measured_cp", "kind": "read", "ordinal": 5, "wire": "measuredCp", "result": {"type": {
"kind": "struct", "name": "reference::PoseStamped"}}, "queue": 16}, {"name": "measured_js",
"kind": "read", "ordinal": 6, "wire": "measuredJs", "result": {"type": {"kind": "struct",
"name": "reference::JointState"}}, "queue": 16}, {"name": "distance", "kind": "qualified read",
"ordinal": 7, "parameters": [{"name": "to", "type": {"kind": "struct",
"name": "reference::PoseStamped"}}], "result": {"type": {"kind": "Float64"}}, "queue": 16}, {
"name": "move", "kind": "write with return", "ordinal": 8,
"doc": "Moves along a line; answers whether it can.", "parameters": [{"name": "goal", "type": {
"kind": "struct", "name": "reference::PoseStamped"}}, {"name": "speed", "type": {"kind": "Float64"
}, "range": [0.0, 1.0]}, {"name": "reason", "type": {"kind": "text", "capacity": 15}}], "result": {
"type": {"kind": "Bool"}}, "queue": 16, "deadline": 0.2}, {"name": "reset",
"kind": "void with return", "ordinal": 9,
"doc": "Forgets what it was told; answers how much that was.", "result": {"type": {"kind": "UInt32"
}}, "queue": 16}, {"name": "limit", "kind": "write", "ordinal": 10, "parameters": [{
"name": "speed", "type": {"kind": "Float64"}}, {"name": "mode", "type": {"kind": "enum",
"name": "reference::Mode"}}], "queue": 2}, {"name": "park", "kind": "void", "ordinal": 11,
"doc": "Folds the arm.", "queue": 16, "optional": true}], "events": [{"name": "mode",
"kind": "write", "ordinal": 1, "payload": {"type": {"kind": "enum", "name": "reference::Mode"}},
"queue": 16, "latched": true}, {"name": "arrived", "kind": "write", "ordinal": 2, "payload": {
"type": {"kind": "struct", "name": "reference::PoseStamped"}}, "queue": 4}, {"name": "stopped",
"kind": "void", "ordinal": 3, "queue": 16}, {"name": "moved", "kind": "write", "ordinal": 4,
"doc": "Where it is and how fast.", "payload": [{"name": "value", "type": {"kind": "struct",
"name": "reference::PoseStamped"}}, {"name": "value2", "type": {"kind": "Float64"}}], "queue": 16}
], "enums": [{"name": "reference::Mode", "underlying": "UInt8", "enumerators": [{
"name": "Disabled", "value": 0, "wire": "disabled"}, {"name": "Enabled", "value": 1,
"wire": "enabled"}]}], "structs": [{"name": "reference::PoseStamped",
"doc": "A pose with its time.", "fields": [{"name": "pose", "doc": "tip in base", "type": {
"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}, {"name": "valid", "type": {"kind": "Bool"}, "default": false}]}, {
"name": "reference::JointState", "fields": [{"name": "name", "type": {"kind": "list", "element": {
"kind": "text", "capacity": 15}, "capacity": 8}}, {"name": "position", "type": {"kind": "list",
"element": {"kind": "Float64"}, "capacity": 8}, "unit": "rad"}]}], "wire": [{
"id": "@0xeba4d683d0a91822", "kind": "interface", "name": "ArmLike", "cxx": "reference::ArmLike",
"members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0, "name": "events",
"is": "@0xdb1787086decafde"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2,
"name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "servoCp", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "goal", "is": "@0x9e5a942c3e52a9b7"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "servoJp", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "goal", "is": "@0xe82fac248b31c66b"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 3, "name": "hold", "is": "kind \"void\"", "parameters": [
{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 4, "name": "setMode",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "mode", "is": "@0x89daa6df134ae03e"}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 5, "name": "measuredCp",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0x9e5a942c3e52a9b7"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 6, "name": "measuredJs", "is": "kind \"read\"", "parameters": [{"at": 0,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "@0xe82fac248b31c66b"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 7,
"name": "distance", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "to",
"is": "@0x9e5a942c3e52a9b7"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "Float64"}]}, {"at": 8, "name": "move",
"is": "kind \"writeReturn\"", "parameters": [{"at": 0, "name": "goal", "is": "@0x9e5a942c3e52a9b7"
}, {"at": 1, "name": "speed", "is": "Float64"}, {"at": 2, "name": "reason", "is": "Text"}, {
"at": 3, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Bool"}]}, {"at": 9, "name": "reset", "is": "kind \"voidReturn\"", "parameters": [{"at": 0,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "UInt32"}]}, {"at": 10, "name": "limit", "is": "kind \"write\"", "parameters": [{"at": 0,
"name": "speed", "is": "Float64"}, {"at": 1, "name": "mode", "is": "@0x89daa6df134ae03e"}, {
"at": 2, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 11, "name": "park",
"is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}]
}, {"id": "@0xdb1787086decafde", "kind": "interface", "name": "ArmLikeEvents", "members": [{
"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xd6b993de04cbfb08"}]}, {
"at": 1, "name": "mode", "parameters": [{"at": 0, "name": "value", "is": "@0x89daa6df134ae03e"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "arrived", "parameters": [{"at": 0,
"name": "value", "is": "@0x9e5a942c3e52a9b7"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 3, "name": "stopped", "parameters": [{"at": 0, "name": "stamp", "is": "Int64"}]}, {"at": 4,
"name": "moved", "parameters": [{"at": 0, "name": "value", "is": "@0x9e5a942c3e52a9b7"}, {"at": 1,
"name": "value2", "is": "Float64"}, {"at": 2, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xd6b993de04cbfb08", "kind": "struct", "name": "ArmLikeStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "measuredCp", "is": "@0x9e5a942c3e52a9b7"}, {
"at": 4, "name": "measuredJs", "is": "@0xe82fac248b31c66b"}]}, {"id": "@0x9e5a942c3e52a9b7",
"kind": "struct", "name": "PoseStamped", "members": [{"at": 0, "name": "pose",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 1, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 2, "name": "valid", "is": "Bool"}]}, {
"id": "@0xe82fac248b31c66b", "kind": "struct", "name": "JointState", "members": [{"at": 0,
"name": "name", "is": "List(Text)"}, {"at": 1, "name": "position",
"is": "List(Float64) unit \"rad\""}]}, {"id": "@0x89daa6df134ae03e", "kind": "enum", "name": "Mode",
"members": [{"at": 0, "name": "disabled"}, {"at": 1, "name": "enabled"}]}]})json";

}  // namespace
}  // namespace reference

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<reference::ArmLike>() {
  static constexpr InterfaceInfo kInfo{
      .name = "reference::ArmLike",
      .hash = "968897e2572bbf86158430dd4ed899ee",
      .description = reference::kArmLikeDescription,
      .commands = reference::kArmLikeCommands,
      .events = reference::kArmLikeEvents,
      .codec = &reference::armLikeCodec,
  };
  return kInfo;
}

auto Provided<reference::ArmLike>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(reference::ArmLikeServoJpArguments::goal)>(scratch.servo_jp_goal);
  reserveFor<decltype(reference::ArmLikeMoveArguments::reason)>(scratch.move_reason);
  return scratch;
}

// A function for each command of reference::ArmLike, so that a stack in a debugger names it.
struct Provided<reference::ArmLike>::Dispatch {
  static Errc execute_servo_cp(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<reference::ArmLikeServoCpArguments>(arguments);
    load(slot.goal, scratch.servo_cp_goal);
    implementation.servo_cp(scratch.servo_cp_goal);
    return Errc{};
  }

  static Errc execute_servo_jp(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<reference::ArmLikeServoJpArguments>(arguments);
    load(slot.goal, scratch.servo_jp_goal);
    implementation.servo_jp(scratch.servo_jp_goal);
    return Errc{};
  }

  static Errc execute_hold(Contract& implementation) {
    implementation.hold();
    return Errc{};
  }

  static Errc execute_set_mode(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<reference::ArmLikeSetModeArguments>(arguments);
    load(slot.mode, scratch.set_mode_mode);
    implementation.set_mode(scratch.set_mode_mode);
    return Errc{};
  }

  static Errc execute_measured_cp(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<reference::PoseStampedSlot>(result);
    return store(implementation.measured_cp(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_measured_js(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<reference::JointStateSlot>(result);
    return store(implementation.measured_js(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_distance(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<reference::ArmLikeDistanceArguments>(arguments);
    load(slot.to, scratch.distance_to);
    auto& answer = newSlot<double>(result);
    return store(implementation.distance(scratch.distance_to), answer) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_move(Contract& implementation, Scratch& scratch, const std::byte* arguments,
                           std::byte* result) {
    const auto& slot = slotIn<reference::ArmLikeMoveArguments>(arguments);
    load(slot.goal, scratch.move_goal);
    load(slot.speed, scratch.move_speed);
    load(slot.reason, scratch.move_reason);
    auto& answer = newSlot<std::uint8_t>(result);
    return store(implementation.move(scratch.move_goal, scratch.move_speed, scratch.move_reason),
                 answer) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_reset(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::uint32_t>(result);
    return store(implementation.reset(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_limit(Contract& implementation, Scratch& scratch,
                            const std::byte* arguments) {
    const auto& slot = slotIn<reference::ArmLikeLimitArguments>(arguments);
    load(slot.speed, scratch.limit_speed);
    load(slot.mode, scratch.limit_mode);
    implementation.limit(scratch.limit_speed, scratch.limit_mode);
    return Errc{};
  }

  static Errc execute_park(Contract& implementation) {
    implementation.park();
    return Errc{};
  }
};

Errc Provided<reference::ArmLike>::execute(std::uint16_t command, const std::byte* arguments,
                                           std::byte* result) {
  using ::reference::ArmLikeCommand;
  switch (command) {
    case ArmLikeCommand::servo_cp:
      return Dispatch::execute_servo_cp(implementation_, scratch_, arguments);
    case ArmLikeCommand::servo_jp:
      return Dispatch::execute_servo_jp(implementation_, scratch_, arguments);
    case ArmLikeCommand::hold: return Dispatch::execute_hold(implementation_);
    case ArmLikeCommand::set_mode:
      return Dispatch::execute_set_mode(implementation_, scratch_, arguments);
    case ArmLikeCommand::measured_cp: return Dispatch::execute_measured_cp(implementation_, result);
    case ArmLikeCommand::measured_js: return Dispatch::execute_measured_js(implementation_, result);
    case ArmLikeCommand::distance:
      return Dispatch::execute_distance(implementation_, scratch_, arguments, result);
    case ArmLikeCommand::move:
      return Dispatch::execute_move(implementation_, scratch_, arguments, result);
    case ArmLikeCommand::reset: return Dispatch::execute_reset(implementation_, result);
    case ArmLikeCommand::limit:
      return Dispatch::execute_limit(implementation_, scratch_, arguments);
    case ArmLikeCommand::park: return Dispatch::execute_park(implementation_);
  }
  return Errc::Invalid;
}

}  // namespace suture
