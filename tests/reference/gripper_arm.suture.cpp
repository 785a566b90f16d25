// Written by suturec from reference/gripper_arm.h. Do not edit.
#include "reference/gripper_arm.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace reference {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const double& width, GripperArmCloseArguments& slot) { return store(width, slot.width); }

bool store(const double& width, GripperArmFitsArguments& slot) { return store(width, slot.width); }

// Defined in reference/gripper_arm.wire.cpp.
const suture::codec::Codec& gripperArmCodec();

namespace {

bool acceptsGripperArmClose(const GripperArmCloseArguments& slot, suture::FieldPath* path) {
  return isValid(slot.width) || suture::refusedAt(path, "width");
}

bool acceptsGripperArmCloseResult(const double& slot, suture::FieldPath*) { return isValid(slot); }

bool acceptsGripperArmOpeningResult(const double& slot, suture::FieldPath*) {
  return isValid(slot);
}

bool acceptsGripperArmFits(const GripperArmFitsArguments& slot, suture::FieldPath* path) {
  return isValid(slot.width) || suture::refusedAt(path, "width");
}

bool acceptsGripperArmGrippedEvent(const double& slot, suture::FieldPath*) { return isValid(slot); }

constexpr suture::CommandInfo kGripperArmCommands[] = {
    {.name = "close",
     .kind = suture::CommandKind::WriteReturn,
     .argumentsSize = suture::slotSize<GripperArmCloseArguments>,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .accepts = suture::checkSlot<GripperArmCloseArguments, acceptsGripperArmClose>,
     .acceptsResult = suture::checkSlot<double, acceptsGripperArmCloseResult>},
    {.name = "opening",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .column = GripperArmColumn::opening,
     .acceptsResult = suture::checkSlot<double, acceptsGripperArmOpeningResult>},
    {.name = "release", .kind = suture::CommandKind::Void, .depth = 16, .inCallersThread = true},
    {.name = "fits",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<GripperArmFitsArguments>,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .inCallersThread = true,
     .accepts = suture::checkSlot<GripperArmFitsArguments, acceptsGripperArmFits>},
};

constexpr suture::EventInfo kGripperArmEvents[] = {
    {.name = "gripped",
     .payloadSize = suture::slotSize<double>,
     .depth = 16,
     .accepts = suture::checkSlot<double, acceptsGripperArmGrippedEvent>},
};

// The self-description, as in reference/gripper_arm.suture.json.
constexpr char kGripperArmDescription[] = R"json(
{"name": "reference::GripperArm", "doc": "An arm with a gripper.",
"hash": "c1c7385c67e2f6e0bab4035e9d4df09b", "core": "ea75de2555913e707d8051daa4c04489",
"base": "reference::ArmLike", "commands": [{"name": "servo_cp", "kind": "write", "ordinal": 1,
"wire": "servoCp", "doc": "Follows a stream of poses.", "parameters": [{"name": "goal", "type": {
"kind": "struct", "name": "reference::PoseStamped"}}], "queue": 16, "latest": true, "ttl": 0.5,
"from": "reference::ArmLike"}, {"name": "servo_jp", "kind": "write", "ordinal": 2,
"wire": "servoJp", "parameters": [{"name": "goal", "type": {"kind": "struct",
"name": "reference::JointState"}}], "queue": 16, "latest": true, "from": "reference::ArmLike"}, {
"name": "hold", "kind": "void", "ordinal": 3, "queue": 4, "from": "reference::ArmLike"}, {
"name": "set_mode", "kind": "write", "ordinal": 4, "wire": "setMode", "parameters": [{
"name": "mode", "type": {"kind": "enum", "name": "reference::Mode"}}], "queue": 16,
"from": "reference::ArmLike"}, {"name": "measured_cp", "kind": "read", "ordinal": 5,
"wire": "measuredCp", "result": {"type": {"kind": "struct", "name": "reference::PoseStamped"}},
"queue": 16, "from": "reference::ArmLike"}, {"name": "measured_js", "kind": "read", "ordinal": 6,
"wire": "measuredJs", "result": {"type": {"kind": "struct", "name": "reference::JointState"}},
"queue": 16, "from": "reference::ArmLike"}, {"name": "distance", "kind": "qualified read",
"ordinal": 7, "parameters": [{"name": "to", "type": {"kind": "struct",
"name": "reference::PoseStamped"}}], "result": {"type": {"kind": "Float64"}}, "queue": 16,
"from": "reference::ArmLike"}, {"name": "move", "kind": "write with return", "ordinal": 8,
"doc": "Moves along a line; answers whether it can.", "parameters": [{"name": "goal", "type": {
"kind": "struct", "name": "reference::PoseStamped"}}, {"name": "speed", "type": {"kind": "Float64"
}, "range": [0.0, 1.0]}, {"name": "reason", "type": {"kind": "text", "capacity": 15}}], "result": {
"type": {"kind": "Bool"}}, "queue": 16, "deadline": 0.2, "from": "reference::ArmLike"}, {
"name": "reset", "kind": "void with return", "ordinal": 9,
"doc": "Forgets what it was told; answers how much that was.", "result": {"type": {"kind": "UInt32"
}}, "queue": 16, "from": "reference::ArmLike"}, {"name": "limit", "kind": "write", "ordinal": 10,
"parameters": [{"name": "speed", "type": {"kind": "Float64"}}, {"name": "mode", "type": {
"kind": "enum", "name": "reference::Mode"}}], "queue": 2, "from": "reference::ArmLike"}, {
"name": "park", "kind": "void", "ordinal": 11, "doc": "Folds the arm.", "queue": 16,
"optional": true, "from": "reference::ArmLike"}, {"name": "close", "kind": "write with return",
"ordinal": 1, "doc": "Closes to this width; answers the width that it could reach.", "parameters": [
{"name": "width", "type": {"kind": "Float64"}, "unit": "m"}], "result": {"type": {"kind": "Float64"
}}, "queue": 16}, {"name": "opening", "kind": "read", "ordinal": 2, "result": {"type": {
"kind": "Float64"}}, "queue": 16}, {"name": "release", "kind": "void", "ordinal": 3,
"doc": "Lets go at once.", "queue": 16, "direct": true}, {"name": "fits", "kind": "qualified read",
"ordinal": 4, "parameters": [{"name": "width", "type": {"kind": "Float64"}, "unit": "m"}],
"result": {"type": {"kind": "Bool"}}, "queue": 16, "concurrent": true}], "events": [{
"name": "mode", "kind": "write", "ordinal": 1, "payload": {"type": {"kind": "enum",
"name": "reference::Mode"}}, "queue": 16, "latched": true, "from": "reference::ArmLike"}, {
"name": "arrived", "kind": "write", "ordinal": 2, "payload": {"type": {"kind": "struct",
"name": "reference::PoseStamped"}}, "queue": 4, "from": "reference::ArmLike"}, {"name": "stopped",
"kind": "void", "ordinal": 3, "queue": 16, "from": "reference::ArmLike"}, {"name": "moved",
"kind": "write", "ordinal": 4, "doc": "Where it is and how fast.", "payload": [{"name": "value",
"type": {"kind": "struct", "name": "reference::PoseStamped"}}, {"name": "value2", "type": {
"kind": "Float64"}}], "queue": 16, "from": "reference::ArmLike"}, {"name": "gripped",
"kind": "write", "ordinal": 5, "payload": {"type": {"kind": "Float64"}}, "queue": 16}], "enums": [{
"name": "reference::Mode", "underlying": "UInt8", "enumerators": [{"name": "Disabled", "value": 0,
"wire": "disabled"}, {"name": "Enabled", "value": 1, "wire": "enabled"}]}], "structs": [{
"name": "reference::PoseStamped", "doc": "A pose with its time.", "fields": [{"name": "pose",
"doc": "tip in base", "type": {"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {
"name": "stamp", "type": {"kind": "time", "clock": "steady"}}, {"name": "valid", "type": {
"kind": "Bool"}, "default": false}]}, {"name": "reference::JointState", "fields": [{"name": "name",
"type": {"kind": "list", "element": {"kind": "text", "capacity": 15}, "capacity": 8}}, {
"name": "position", "type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 8},
"unit": "rad"}]}], "wire": [{"id": "@0xc640d7e85c8505d7", "kind": "interface", "name": "GripperArm",
"cxx": "reference::GripperArm", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xc4dcbf461eed82fb"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "close",
"is": "kind \"writeReturn\"", "parameters": [{"at": 0, "name": "width", "is": "Float64 unit \"m\""
}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Float64"}]}, {"at": 2, "name": "opening", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 3,
"name": "release", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 4, "name": "fits", "is": "kind \"qualifiedRead\"",
"parameters": [{"at": 0, "name": "width", "is": "Float64 unit \"m\""}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Bool"}]}]}, {
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
"members": [{"at": 0, "name": "disabled"}, {"at": 1, "name": "enabled"}]}, {
"id": "@0xc4dcbf461eed82fb", "kind": "interface", "name": "GripperArmEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xaad3d7925d80f23f"}]}, {"at": 1,
"name": "mode", "parameters": [{"at": 0, "name": "value", "is": "@0x89daa6df134ae03e"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "arrived", "parameters": [{"at": 0,
"name": "value", "is": "@0x9e5a942c3e52a9b7"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 3, "name": "stopped", "parameters": [{"at": 0, "name": "stamp", "is": "Int64"}]}, {"at": 4,
"name": "moved", "parameters": [{"at": 0, "name": "value", "is": "@0x9e5a942c3e52a9b7"}, {"at": 1,
"name": "value2", "is": "Float64"}, {"at": 2, "name": "stamp", "is": "Int64"}]}, {"at": 5,
"name": "gripped", "parameters": [{"at": 0, "name": "value", "is": "Float64"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}]}, {"id": "@0xaad3d7925d80f23f", "kind": "struct",
"name": "GripperArmStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "measuredCp", "is": "@0x9e5a942c3e52a9b7"}, {"at": 4, "name": "measuredJs",
"is": "@0xe82fac248b31c66b"}, {"at": 5, "name": "opening", "is": "Float64"}]}]})json";

}  // namespace
}  // namespace reference

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<reference::GripperArm>() {
  static const auto kCommands = extended<15>(interfaceInfo<reference::ArmLike>().commands,
                                             reference::kGripperArmCommands);
  static const auto kEvents = extended<5>(interfaceInfo<reference::ArmLike>().events,
                                          reference::kGripperArmEvents);
  static const InterfaceInfo kInfo{
      .name = "reference::GripperArm",
      .hash = "c1c7385c67e2f6e0bab4035e9d4df09b",
      .description = reference::kGripperArmDescription,
      .commands = kCommands,
      .events = kEvents,
      .codec = &reference::gripperArmCodec,
      .base = &interfaceInfo<reference::ArmLike>,
      .toBase = &castToBase<reference::GripperArm, reference::ArmLike>,
  };
  return kInfo;
}

// A function for each command of reference::GripperArm, so that a stack in a debugger names it.
struct Provided<reference::GripperArm>::Dispatch {
  static Errc execute_close(Contract& implementation, Scratch& scratch, const std::byte* arguments,
                            std::byte* result) {
    const auto& slot = slotIn<reference::GripperArmCloseArguments>(arguments);
    load(slot.width, scratch.close_width);
    auto& answer = newSlot<double>(result);
    return store(implementation.close(scratch.close_width), answer) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_opening(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<double>(result);
    return store(implementation.opening(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_release(Contract& implementation) {
    implementation.release();
    return Errc{};
  }

  static Errc execute_fits(Contract& implementation, Scratch& scratch, const std::byte* arguments,
                           std::byte* result) {
    const auto& slot = slotIn<reference::GripperArmFitsArguments>(arguments);
    load(slot.width, scratch.fits_width);
    auto& answer = newSlot<std::uint8_t>(result);
    return store(implementation.fits(scratch.fits_width), answer) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<reference::GripperArm>::execute(std::uint16_t command, const std::byte* arguments,
                                              std::byte* result) {
  using ::reference::GripperArmCommand;
  switch (command) {
    case GripperArmCommand::close:
      return Dispatch::execute_close(implementation_, scratch_, arguments, result);
    case GripperArmCommand::opening: return Dispatch::execute_opening(implementation_, result);
    case GripperArmCommand::release: return Dispatch::execute_release(implementation_);
    case GripperArmCommand::fits:
      return Dispatch::execute_fits(implementation_, scratch_, arguments, result);
  }
  return Provided<reference::ArmLike>::execute(command, arguments, result);
}

}  // namespace suture
