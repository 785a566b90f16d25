// Written by suturec from drives/gripper_hand.h. Do not edit.
#include "drives/gripper_hand.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const double& angle, GripperHandSqueezeArguments& slot) {
  return store(angle, slot.angle);
}

// Defined in drives/gripper_hand.wire.cpp.
const suture::codec::Codec& gripperHandCodec();

namespace {

bool acceptsGripperHandSqueeze(const GripperHandSqueezeArguments& slot, suture::FieldPath* path) {
  return isValid(slot.angle) || suture::refusedAt(path, "angle");
}

constexpr suture::CommandInfo kGripperHandCommands[] = {
    {.name = "squeeze",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<GripperHandSqueezeArguments>,
     .depth = 16,
     .latest = true,
     .ttl = suture::Duration(100'000'000),
     .accepts = suture::checkSlot<GripperHandSqueezeArguments, acceptsGripperHandSqueeze>},
};

// The self-description, as in drives/gripper_hand.suture.json.
constexpr char kGripperHandDescription[] = R"json(
{"name": "robots::GripperHand",
"doc": "Simulated drives of a master provide this as \"Hand\", because real ones have a surgeon's.\nCommands run in the drives' own thread before its next cycle.",
"hash": "2f170b4de6ff45ce5d5a523ed80fb21b", "commands": [{"name": "squeeze", "kind": "write",
"ordinal": 1,
"doc": "Makes the fingers press the handles to this angle, newest wins. It stays there until another\none comes. The gripper follows with the lag of the drives, and no further than its stops.",
"parameters": [{"name": "angle", "type": {"kind": "Float64"}, "unit": "rad"}], "queue": 16,
"latest": true, "ttl": 0.1}], "events": [], "enums": [], "structs": [], "wire": [{
"id": "@0xfdcd88fcdd8f3434", "kind": "interface", "name": "GripperHand",
"cxx": "robots::GripperHand", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xc0df5b70383bca9d"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "squeeze",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "angle", "is": "Float64 unit \"rad\""}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}]}, {"id": "@0xc0df5b70383bca9d",
"kind": "interface", "name": "GripperHandEvents", "members": [{"at": 0, "name": "state",
"parameters": [{"at": 0, "name": "row", "is": "@0xda979129fce1c077"}]}]}, {
"id": "@0xda979129fce1c077", "kind": "struct", "name": "GripperHandStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::GripperHand>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::GripperHand",
      .hash = "2f170b4de6ff45ce5d5a523ed80fb21b",
      .description = robots::kGripperHandDescription,
      .commands = robots::kGripperHandCommands,
      .events = {},
      .codec = &robots::gripperHandCodec,
  };
  return kInfo;
}

// A function for each command of robots::GripperHand, so that a stack in a debugger names it.
struct Provided<robots::GripperHand>::Dispatch {
  static Errc execute_squeeze(Contract& implementation, Scratch& scratch,
                              const std::byte* arguments) {
    const auto& slot = slotIn<robots::GripperHandSqueezeArguments>(arguments);
    load(slot.angle, scratch.squeeze_angle);
    implementation.squeeze(scratch.squeeze_angle);
    return Errc{};
  }
};

Errc Provided<robots::GripperHand>::execute(std::uint16_t command, const std::byte* arguments,
                                            std::byte* /*result*/) {
  using ::robots::GripperHandCommand;
  switch (command) {
    case GripperHandCommand::squeeze:
      return Dispatch::execute_squeeze(implementation_, scratch_, arguments);
  }
  return Errc::Invalid;
}

}  // namespace suture
