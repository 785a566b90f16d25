// Written by suturec from coordinator/emergency_stop.h. Do not edit.
#include "coordinator/emergency_stop.suture.h"

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
static_assert(std::is_same_v<decltype(Permit::granted), bool>);
static_assert(std::is_same_v<decltype(Permit::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(Permit::press), std::uint64_t>);
static_assert(std::is_same_v<decltype(StopNews::pressed), bool>);
static_assert(std::is_same_v<decltype(StopNews::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(StopNews::is_start), bool>);
static_assert(std::is_same_v<decltype(StopNews::press), std::uint64_t>);

}  // namespace

bool store(const Permit& value, PermitSlot& slot) {
  bool fits = true;
  fits &= store(value.granted, slot.granted);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.press, slot.press);
  return fits;
}

void load(const PermitSlot& slot, Permit& value) {
  load(slot.granted, value.granted);
  load(slot.stamp, value.stamp);
  load(slot.press, value.press);
}

void shiftStamps(PermitSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const StopNews& value, StopNewsSlot& slot) {
  bool fits = true;
  fits &= store(value.pressed, slot.pressed);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.is_start, slot.is_start);
  fits &= store(value.press, slot.press);
  return fits;
}

void load(const StopNewsSlot& slot, StopNews& value) {
  load(slot.pressed, value.pressed);
  load(slot.stamp, value.stamp);
  load(slot.is_start, value.is_start);
  load(slot.press, value.press);
}

void shiftStamps(StopNewsSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const std::uint64_t& press, EmergencyStopReleaseArguments& slot) {
  return store(press, slot.press);
}

bool isValid(const PermitSlot&, suture::FieldPath*) {
  return true;
}

bool isValid(const StopNewsSlot&, suture::FieldPath*) {
  return true;
}

// Defined in coordinator/emergency_stop.wire.cpp.
const suture::codec::Codec& emergencyStopCodec();

namespace {

constexpr suture::CommandInfo kEmergencyStopCommands[] = {
    {.name = "press", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "release",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<EmergencyStopReleaseArguments>,
     .depth = 16},
    {.name = "permit",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PermitSlot>,
     .depth = 16,
     .column = EmergencyStopColumn::permit,
     .acceptsResult = suture::checkSlot<PermitSlot, isValid>,
     .shiftResult = suture::shiftSlot<PermitSlot>},
};

constexpr suture::EventInfo kEmergencyStopEvents[] = {
    {.name = "stop",
     .payloadSize = suture::slotSize<StopNewsSlot>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<StopNewsSlot, isValid>,
     .shiftPayload = suture::shiftSlot<StopNewsSlot>},
};

// The self-description, as in coordinator/emergency_stop.suture.json.
constexpr char kEmergencyStopDescription[] = R"json(
{"name": "robots::EmergencyStop",
"doc": "Commands run in the coordinator's thread before its next cycle.",
"hash": "176c86b38f8c6959301d1b2b71a120e7", "version": 2, "major": 2, "commands": [{
"name": "press", "kind": "void", "ordinal": 1,
"doc": "Stops all drives. None has power until release().", "queue": 16}, {"name": "release",
"kind": "write", "ordinal": 2,
"doc": "Lets drives have power again, which an operator must have decided. `press` is that of the news\nthat this answers: it does nothing if somebody has pressed since. Arms stay disabled until\nsomebody enables them, such as a console that brings its system up by itself.",
"parameters": [{"name": "press", "type": {"kind": "UInt64"}}], "queue": 16}, {"name": "permit",
"kind": "read", "ordinal": 3, "doc": "The coordinator renews the permit in each cycle.", "result": {
"type": {"kind": "struct", "name": "robots::Permit"}}, "queue": 16}], "events": [{"name": "stop",
"kind": "write", "ordinal": 1,
"doc": "Reports each press and each release, and the last one to a client that connects.",
"payload": {"type": {"kind": "struct", "name": "robots::StopNews"}}, "queue": 16, "latched": true}
], "enums": [], "structs": [{"name": "robots::Permit",
"doc": "Lets drives have power. It counts only as long as it is fresh, so that drives that do not\nreceive it any more stop too.",
"fields": [{"name": "granted", "type": {"kind": "Bool"}, "default": false}, {"name": "stamp",
"doc": "The coordinator renewed it in the cycle of this stamp.", "type": {"kind": "time",
"clock": "steady"}}, {"name": "press",
"doc": "The number of the last press is also in StopNews::press.", "type": {"kind": "UInt64"},
"default": 0}]}, {"name": "robots::StopNews",
"doc": "Says that the emergency stop was pressed, or released.", "fields": [{"name": "pressed",
"type": {"kind": "Bool"}, "default": false}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}, {"name": "is_start", "wire": "isStart",
"doc": "This is true if nobody has pressed it: the coordinator has just started, and starts pressed.",
"type": {"kind": "Bool"}, "default": false}, {"name": "press",
"doc": "Identifies the last press, and so does release(). No two presses have the same one, nor has\none of a coordinator that ran before.",
"type": {"kind": "UInt64"}, "default": 0}]}], "wire": [{"id": "@0x85a101cfc49eccfc",
"kind": "interface", "name": "EmergencyStop", "cxx": "robots::EmergencyStop", "major": 2,
"version": 2, "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0, "name": "events",
"is": "@0xd5baa187cf46a24d"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2,
"name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "press", "is": "kind \"void\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 2,
"name": "release", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}, {"at": 1, "name": "press", "is": "UInt64"}]}, {"at": 3,
"name": "permit", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xd02fe436dab69cbc"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xd5baa187cf46a24d", "kind": "interface",
"name": "EmergencyStopEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xf44715265e64d420"}]}, {"at": 1, "name": "stop", "parameters": [{"at": 0,
"name": "value", "is": "@0xcd5512b8a090183f"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xf44715265e64d420", "kind": "struct", "name": "EmergencyStopStateRow", "members": [{
"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "permit", "is": "@0xd02fe436dab69cbc"}]}, {
"id": "@0xd02fe436dab69cbc", "kind": "struct", "name": "Permit", "members": [{"at": 0,
"name": "granted", "is": "Bool"}, {"at": 1, "name": "stamp", "is": "Int64 clock \"steady\""}, {
"at": 2, "name": "press", "is": "UInt64"}]}, {"id": "@0xcd5512b8a090183f", "kind": "struct",
"name": "StopNews", "members": [{"at": 0, "name": "pressed", "is": "Bool"}, {"at": 1,
"name": "stamp", "is": "Int64 clock \"steady\""}, {"at": 2, "name": "isStart", "is": "Bool"}, {
"at": 3, "name": "press", "is": "UInt64"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::EmergencyStop>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::EmergencyStop",
      .hash = "176c86b38f8c6959301d1b2b71a120e7",
      .description = robots::kEmergencyStopDescription,
      .commands = robots::kEmergencyStopCommands,
      .events = robots::kEmergencyStopEvents,
      .codec = &robots::emergencyStopCodec,
  };
  return kInfo;
}

// A function for each command of robots::EmergencyStop, so that a stack in a debugger names it.
struct Provided<robots::EmergencyStop>::Dispatch {
  static Errc execute_press(Contract& implementation) {
    implementation.press();
    return Errc{};
  }

  static Errc execute_release(Contract& implementation, Scratch& scratch,
                              const std::byte* arguments) {
    const auto& slot = slotIn<robots::EmergencyStopReleaseArguments>(arguments);
    load(slot.press, scratch.release_press);
    implementation.release(scratch.release_press);
    return Errc{};
  }

  static Errc execute_permit(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PermitSlot>(result);
    return store(implementation.permit(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::EmergencyStop>::execute(std::uint16_t command, const std::byte* arguments,
                                              std::byte* result) {
  using ::robots::EmergencyStopCommand;
  switch (command) {
    case EmergencyStopCommand::press: return Dispatch::execute_press(implementation_);
    case EmergencyStopCommand::release:
      return Dispatch::execute_release(implementation_, scratch_, arguments);
    case EmergencyStopCommand::permit: return Dispatch::execute_permit(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
