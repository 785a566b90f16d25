// Written by suturec from 05_events/gripper.h. Do not edit.
#include "05_events/gripper.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace gripping {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<Jaws>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(Jaws::Open) == 0);
static_assert(static_cast<std::uint8_t>(Jaws::Closing) == 1);
static_assert(static_cast<std::uint8_t>(Jaws::Holding) == 2);

}  // namespace

bool isKnownJaws(std::uint8_t slot) {
  switch (static_cast<Jaws>(slot)) {
    case Jaws::Open:
    case Jaws::Closing:
    case Jaws::Holding:
      return true;
  }
  return false;
}

// Defined in 05_events/gripper.wire.cpp.
const suture::codec::Codec& gripperCodec();

namespace {

bool acceptsGripperJawsChangedEvent(const std::uint8_t& slot, suture::FieldPath*) {
  return isKnownJaws(slot);
}

bool acceptsGripperTouchedEvent(const double& slot, suture::FieldPath*) { return isValid(slot); }

constexpr suture::CommandInfo kGripperCommands[] = {
    {.name = "grasp", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "release",
     .kind = suture::CommandKind::VoidReturn,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16},
};

constexpr suture::EventInfo kGripperEvents[] = {
    {.name = "jaws_changed",
     .payloadSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<std::uint8_t, acceptsGripperJawsChangedEvent>},
    {.name = "touched",
     .payloadSize = suture::slotSize<double>,
     .depth = 16,
     .accepts = suture::checkSlot<double, acceptsGripperTouchedEvent>},
};

// The self-description, as in 05_events/gripper.suture.json.
constexpr char kGripperDescription[] = R"json(
{"name": "gripping::Gripper", "hash": "791e1a2dbf149a553e5da3c7a37ae448", "commands": [{
"name": "grasp", "kind": "void", "ordinal": 1, "doc": "Begins to close the jaws.", "queue": 16}, {
"name": "release", "kind": "void with return", "ordinal": 2,
"doc": "Opens the jaws. Returns true if they held something.", "result": {"type": {"kind": "Bool"}
}, "queue": 16}], "events": [{"name": "jaws_changed", "kind": "write", "ordinal": 1,
"wire": "jawsChanged",
"doc": "Reports a state: a client that subscribes late receives the last one at once.", "payload": {
"type": {"kind": "enum", "name": "gripping::Jaws"}}, "queue": 16, "latched": true}, {
"name": "touched", "kind": "write", "ordinal": 2,
"doc": "Reports something that happens. Each touch counts, so up to 16 wait for a busy subscriber.",
"payload": {"type": {"kind": "Float64"}, "unit": "N"}, "queue": 16}], "enums": [{
"name": "gripping::Jaws", "underlying": "UInt8", "enumerators": [{"name": "Open", "value": 0,
"wire": "open"}, {"name": "Closing", "value": 1, "wire": "closing"}, {"name": "Holding", "value": 2,
"wire": "holding"}]}], "structs": [], "wire": [{"id": "@0x94d688a82ce7d169", "kind": "interface",
"name": "Gripper", "cxx": "gripping::Gripper", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xb6c3be53b63b21bb"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "grasp", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "release", "is": "kind \"voidReturn\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Bool"}]}]}, {"id": "@0xb6c3be53b63b21bb", "kind": "interface",
"name": "GripperEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0x996aaf9b482d97d6"}]}, {"at": 1, "name": "jawsChanged", "parameters": [{
"at": 0, "name": "value", "is": "@0xf21766ccd2556dea"}, {"at": 1, "name": "stamp", "is": "Int64"}]
}, {"at": 2, "name": "touched", "parameters": [{"at": 0, "name": "value", "is": "Float64 unit \"N\""
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0x996aaf9b482d97d6", "kind": "struct",
"name": "GripperStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}]}, {
"id": "@0xf21766ccd2556dea", "kind": "enum", "name": "Jaws", "members": [{"at": 0, "name": "open"},
{"at": 1, "name": "closing"}, {"at": 2, "name": "holding"}]}]})json";

}  // namespace
}  // namespace gripping

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<gripping::Gripper>() {
  static constexpr InterfaceInfo kInfo{
      .name = "gripping::Gripper",
      .hash = "791e1a2dbf149a553e5da3c7a37ae448",
      .description = gripping::kGripperDescription,
      .commands = gripping::kGripperCommands,
      .events = gripping::kGripperEvents,
      .codec = &gripping::gripperCodec,
  };
  return kInfo;
}

// A function for each command of gripping::Gripper, so that a stack in a debugger names it.
struct Provided<gripping::Gripper>::Dispatch {
  static Errc execute_grasp(Contract& implementation) {
    implementation.grasp();
    return Errc{};
  }

  static Errc execute_release(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::uint8_t>(result);
    return store(implementation.release(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<gripping::Gripper>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                          std::byte* result) {
  using ::gripping::GripperCommand;
  switch (command) {
    case GripperCommand::grasp: return Dispatch::execute_grasp(implementation_);
    case GripperCommand::release: return Dispatch::execute_release(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
