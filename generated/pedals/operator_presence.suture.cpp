// Written by suturec from pedals/operator_presence.h. Do not edit.
#include "pedals/operator_presence.suture.h"

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
static_assert(std::is_same_v<decltype(Presence::present), bool>);
static_assert(std::is_same_v<decltype(Presence::stamp), std::chrono::steady_clock::time_point>);

}  // namespace

bool store(const Presence& value, PresenceSlot& slot) {
  bool fits = true;
  fits &= store(value.present, slot.present);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const PresenceSlot& slot, Presence& value) {
  load(slot.present, value.present);
  load(slot.stamp, value.stamp);
}

void shiftStamps(PresenceSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool isValid(const PresenceSlot&, suture::FieldPath*) {
  return true;
}

// Defined in pedals/operator_presence.wire.cpp.
const suture::codec::Codec& operatorPresenceCodec();

namespace {

constexpr suture::CommandInfo kOperatorPresenceCommands[] = {
    {.name = "presence",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PresenceSlot>,
     .depth = 16,
     .column = OperatorPresenceColumn::presence,
     .acceptsResult = suture::checkSlot<PresenceSlot, isValid>,
     .shiftResult = suture::shiftSlot<PresenceSlot>},
};

constexpr suture::EventInfo kOperatorPresenceEvents[] = {
    {.name = "operator_present",
     .payloadSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true},
};

// The self-description, as in pedals/operator_presence.suture.json.
constexpr char kOperatorPresenceDescription[] = R"json(
{"name": "robots::OperatorPresence", "hash": "e89a3d747ed71c64e84646e920105176", "commands": [{
"name": "presence", "kind": "read", "ordinal": 1, "result": {"type": {"kind": "struct",
"name": "robots::Presence"}}, "queue": 16}], "events": [{"name": "operator_present",
"kind": "write", "ordinal": 1, "wire": "operatorPresent",
"doc": "Reports each change, and the present state to a client that connects.", "payload": {
"type": {"kind": "Bool"}}, "queue": 16, "latched": true}], "enums": [], "structs": [{
"name": "robots::Presence",
"doc": "Says if a head is in the viewer. It counts only as long as it is fresh.", "fields": [{
"name": "present", "type": {"kind": "Bool"}, "default": false}, {"name": "stamp",
"doc": "The cycle in which the viewer was looked at.", "type": {"kind": "time", "clock": "steady"}}
]}], "wire": [{"id": "@0x8946bef4362e465d", "kind": "interface", "name": "OperatorPresence",
"cxx": "robots::OperatorPresence", "members": [{"at": 0, "name": "subscribe", "parameters": [{
"at": 0, "name": "events", "is": "@0xd9df1a4d2e881c27"}, {"at": 1, "name": "eventMask",
"is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "presence",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xa9429a655b83829a"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}]}, {"id": "@0xd9df1a4d2e881c27", "kind": "interface",
"name": "OperatorPresenceEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0x970403e5511b6372"}]}, {"at": 1, "name": "operatorPresent", "parameters": [
{"at": 0, "name": "value", "is": "Bool"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0x970403e5511b6372", "kind": "struct", "name": "OperatorPresenceStateRow", "members": [{
"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "presence", "is": "@0xa9429a655b83829a"}]}, {
"id": "@0xa9429a655b83829a", "kind": "struct", "name": "Presence", "members": [{"at": 0,
"name": "present", "is": "Bool"}, {"at": 1, "name": "stamp", "is": "Int64 clock \"steady\""}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::OperatorPresence>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::OperatorPresence",
      .hash = "e89a3d747ed71c64e84646e920105176",
      .description = robots::kOperatorPresenceDescription,
      .commands = robots::kOperatorPresenceCommands,
      .events = robots::kOperatorPresenceEvents,
      .codec = &robots::operatorPresenceCodec,
  };
  return kInfo;
}

// A function for each command of robots::OperatorPresence, so that a stack in a debugger names it.
struct Provided<robots::OperatorPresence>::Dispatch {
  static Errc execute_presence(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PresenceSlot>(result);
    return store(implementation.presence(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::OperatorPresence>::execute(std::uint16_t command,
                                                 const std::byte* /*arguments*/,
                                                 std::byte* result) {
  using ::robots::OperatorPresenceCommand;
  switch (command) {
    case OperatorPresenceCommand::presence:
      return Dispatch::execute_presence(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
