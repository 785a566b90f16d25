// Written by suturec from pedals/foot_pedals.h. Do not edit.
#include "pedals/foot_pedals.suture.h"

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
static_assert(std::is_same_v<decltype(PedalState::clutch), bool>);
static_assert(std::is_same_v<decltype(PedalState::camera), bool>);
static_assert(std::is_same_v<decltype(PedalState::coagulation), bool>);
static_assert(std::is_same_v<decltype(PedalState::stamp), std::chrono::steady_clock::time_point>);

}  // namespace

bool store(const PedalState& value, PedalStateSlot& slot) {
  bool fits = true;
  fits &= store(value.clutch, slot.clutch);
  fits &= store(value.camera, slot.camera);
  fits &= store(value.coagulation, slot.coagulation);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const PedalStateSlot& slot, PedalState& value) {
  load(slot.clutch, value.clutch);
  load(slot.camera, value.camera);
  load(slot.coagulation, value.coagulation);
  load(slot.stamp, value.stamp);
}

void shiftStamps(PedalStateSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool isValid(const PedalStateSlot&, suture::FieldPath*) {
  return true;
}

// Defined in pedals/foot_pedals.wire.cpp.
const suture::codec::Codec& footPedalsCodec();

namespace {

constexpr suture::CommandInfo kFootPedalsCommands[] = {
    {.name = "pedals",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PedalStateSlot>,
     .depth = 16,
     .column = FootPedalsColumn::pedals,
     .acceptsResult = suture::checkSlot<PedalStateSlot, isValid>,
     .shiftResult = suture::shiftSlot<PedalStateSlot>},
};

constexpr suture::EventInfo kFootPedalsEvents[] = {
    {.name = "clutch", .payloadSize = suture::slotSize<std::uint8_t>, .depth = 16, .latched = true},
    {.name = "camera", .payloadSize = suture::slotSize<std::uint8_t>, .depth = 16, .latched = true},
    {.name = "coagulation",
     .payloadSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true},
};

// The self-description, as in pedals/foot_pedals.suture.json.
constexpr char kFootPedalsDescription[] = R"json(
{"name": "robots::FootPedals", "doc": "The names are the da Vinci Research Kit's.",
"hash": "f2201b1981864fec0edf03f41c20c8c0", "commands": [{"name": "pedals", "kind": "read",
"ordinal": 1, "result": {"type": {"kind": "struct", "name": "robots::PedalState"}}, "queue": 16}],
"events": [{"name": "clutch", "kind": "write", "ordinal": 1,
"doc": "Reports each press and release, and the present state to a client that connects.",
"payload": {"type": {"kind": "Bool"}}, "queue": 16, "latched": true}, {"name": "camera",
"kind": "write", "ordinal": 2, "payload": {"type": {"kind": "Bool"}}, "queue": 16, "latched": true
}, {"name": "coagulation", "kind": "write", "ordinal": 3, "payload": {"type": {"kind": "Bool"}},
"queue": 16, "latched": true}], "enums": [], "structs": [{"name": "robots::PedalState",
"doc": "Says what the feet do. It counts only as long as it is fresh: a client that does not receive it\nany more must assume that all pedals are pressed.",
"fields": [{"name": "clutch", "doc": "If it is true, masters move without their slaves.", "type": {
"kind": "Bool"}, "default": false}, {"name": "camera",
"doc": "If it is true, masters move the camera instead of their slaves. The components here simulate\nno camera that masters move: slaves only hold.",
"type": {"kind": "Bool"}, "default": false}, {"name": "coagulation",
"doc": "If it is true, energy is applied to the tissue.", "type": {"kind": "Bool"}, "default": false
}, {"name": "stamp", "doc": "The stamp is that of the cycle in which they were looked at.",
"type": {"kind": "time", "clock": "steady"}}]}], "wire": [{"id": "@0xeef483a34001461c",
"kind": "interface", "name": "FootPedals", "cxx": "robots::FootPedals", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0xeb48eb818a9b108b"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {
"at": 1, "name": "pedals", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xcff309898affe286"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xeb48eb818a9b108b", "kind": "interface",
"name": "FootPedalsEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xec8fc265517e6c7c"}]}, {"at": 1, "name": "clutch", "parameters": [{"at": 0,
"name": "value", "is": "Bool"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 2,
"name": "camera", "parameters": [{"at": 0, "name": "value", "is": "Bool"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}, {"at": 3, "name": "coagulation", "parameters": [{"at": 0,
"name": "value", "is": "Bool"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xec8fc265517e6c7c", "kind": "struct", "name": "FootPedalsStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "pedals", "is": "@0xcff309898affe286"}]}, {
"id": "@0xcff309898affe286", "kind": "struct", "name": "PedalState", "members": [{"at": 0,
"name": "clutch", "is": "Bool"}, {"at": 1, "name": "camera", "is": "Bool"}, {"at": 2,
"name": "coagulation", "is": "Bool"}, {"at": 3, "name": "stamp", "is": "Int64 clock \"steady\""}]}]
})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::FootPedals>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::FootPedals",
      .hash = "f2201b1981864fec0edf03f41c20c8c0",
      .description = robots::kFootPedalsDescription,
      .commands = robots::kFootPedalsCommands,
      .events = robots::kFootPedalsEvents,
      .codec = &robots::footPedalsCodec,
  };
  return kInfo;
}

// A function for each command of robots::FootPedals, so that a stack in a debugger names it.
struct Provided<robots::FootPedals>::Dispatch {
  static Errc execute_pedals(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PedalStateSlot>(result);
    return store(implementation.pedals(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::FootPedals>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                           std::byte* result) {
  using ::robots::FootPedalsCommand;
  switch (command) {
    case FootPedalsCommand::pedals: return Dispatch::execute_pedals(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
