// Written by suturec from pedals/operator_presence.h. Do not edit.
#include "pedals/operator_presence.suture.h"

#include <suture/wire/codec.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "pedals/operator_presence.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
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
  slot.stamp = suture::rpc::shifted(slot.stamp, shift);
}

// --- between slots and Cap'n Proto

void toWire(const PresenceSlot& slot, wire::Presence::Builder out) {
  out.setPresent(slot.present != 0);
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::Presence::Reader in, PresenceSlot& slot, suture::Duration shift) {
  slot.present = in.getPresent();
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  return suture::Errc{};
}

bool isValid(const PresenceSlot&, suture::FieldPath*) {
  return true;
}

namespace {

// --- OperatorPresence as Cap'n Proto

void encodeOperatorPresencePresenceResult(const PresenceSlot& slot,
                                          wire::OperatorPresence::PresenceResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeOperatorPresencePresenceResult(
    wire::OperatorPresence::PresenceResults::Reader in, PresenceSlot& slot,
                                                  suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeOperatorPresenceOperatorPresentEvent(const std::uint8_t& slot,
                                                wire::OperatorPresenceEvents::OperatorPresentParams::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeOperatorPresenceOperatorPresentEvent(
    wire::OperatorPresenceEvents::OperatorPresentParams::Reader in, std::uint8_t& slot,
                                                        suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeOperatorPresencePresenceColumn(const PresenceSlot& slot,
                                          wire::OperatorPresenceStateRow::Builder out) {
  toWire(slot, out.initPresence());
}
suture::Errc decodeOperatorPresencePresenceColumn(wire::OperatorPresenceStateRow::Reader in,
                                                  PresenceSlot& slot, suture::Duration shift) {
  return in.hasPresence() ? fromWire(in.getPresence(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeOperatorPresenceColumn(unsigned column, const std::byte* memory,
                                  wire::OperatorPresenceStateRow::Builder out) {
  switch (static_cast<OperatorPresenceColumn>(column)) {
    case OperatorPresenceColumn::presence:
      return encodeOperatorPresencePresenceColumn(suture::slotIn<PresenceSlot>(memory), out);
  }
}
suture::Errc decodeOperatorPresenceColumn(wire::OperatorPresenceStateRow::Reader in,
                                          unsigned column, std::byte* memory,
                                          suture::Duration shift) {
  switch (static_cast<OperatorPresenceColumn>(column)) {
    case OperatorPresenceColumn::presence:
      return decodeOperatorPresencePresenceColumn(in, suture::newSlot<PresenceSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::rpc::CommandCodec kOperatorPresenceCommandCodecs[] = {
    {.interface = capnp::typeId<wire::OperatorPresence>(),
     .method = 1,
     .sent = suture::rpc::sentIn<wire::OperatorPresence::PresenceParams>,
     .result = suture::rpc::messageOf<wire::OperatorPresence::PresenceResults, PresenceSlot,
                                      encodeOperatorPresencePresenceResult,
                                      decodeOperatorPresencePresenceResult>,
     .stamp = suture::rpc::stampIn<wire::OperatorPresence::PresenceResults>},
};

constexpr suture::rpc::EventCodec kOperatorPresenceEventCodecs[] = {
    {.method = 1,
     .stamp = suture::rpc::stampIn<wire::OperatorPresenceEvents::OperatorPresentParams>,
     .payload = suture::rpc::messageOf<wire::OperatorPresenceEvents::OperatorPresentParams,
                                       std::uint8_t, encodeOperatorPresenceOperatorPresentEvent,
                                       decodeOperatorPresenceOperatorPresentEvent>},
};

const suture::rpc::Codec& operatorPresenceCodec() {
  static constexpr suture::rpc::Codec kCodec{
      .schema = suture::rpc::schemaOf<wire::OperatorPresence>,
      .contract = capnp::typeId<wire::OperatorPresence>(),
      .subscriber = capnp::typeId<wire::OperatorPresenceEvents>(),
      .commands = kOperatorPresenceCommandCodecs,
      .events = kOperatorPresenceEventCodecs,
      .row = suture::rpc::rowOf<wire::OperatorPresenceEvents::StateParams,
                                wire::OperatorPresenceStateRow, encodeOperatorPresenceColumn,
                                decodeOperatorPresenceColumn>,
  };
  return kCodec;
}

constexpr suture::CommandInfo kOperatorPresenceCommands[] = {
    {.name = "presence",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PresenceSlot>,
     .depth = 16,
     .column = static_cast<int>(OperatorPresenceColumn::presence),
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
"doc": "Is the cycle in which it was looked for.", "type": {"kind": "time", "clock": "steady"}}]}],
"wire": [{"id": "@0x8946bef4362e465d", "kind": "interface", "name": "OperatorPresence",
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
Result<std::vector<std::byte>> encode(const robots::Presence& value) {
  return rpc::encodeAs<robots::wire::Presence, robots::PresenceSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::Presence& value) {
  return rpc::decodeAs<robots::wire::Presence, robots::PresenceSlot>(bytes, value);
}

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
  switch (static_cast<OperatorPresenceCommand>(command)) {
    case OperatorPresenceCommand::presence:
      return Dispatch::execute_presence(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
