// Written by suturec from 04_contract_and_loss/joystick.h. Do not edit.
#include "04_contract_and_loss/joystick.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace following {

using suture::isValid;
using suture::load;
using suture::store;

// Defined in 04_contract_and_loss/joystick.wire.cpp.
const suture::codec::Codec& joystickCodec();

namespace {

bool acceptsJoystickAngleResult(const double& slot, suture::FieldPath*) { return isValid(slot); }

constexpr suture::CommandInfo kJoystickCommands[] = {
    {.name = "angle",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .column = JoystickColumn::angle,
     .acceptsResult = suture::checkSlot<double, acceptsJoystickAngleResult>},
};

// The self-description, as in 04_contract_and_loss/joystick.suture.json.
constexpr char kJoystickDescription[] = R"json(
{"name": "following::Joystick", "hash": "fb0e421ba1ec8175508fc619a3be612c", "commands": [{
"name": "angle", "kind": "read", "ordinal": 1, "doc": "Says how far the stick is turned.",
"result": {"type": {"kind": "Float64"}, "unit": "rad"}, "queue": 16}], "events": [], "enums": [],
"structs": [], "wire": [{"id": "@0xba57d83dcf98cd85", "kind": "interface", "name": "Joystick",
"cxx": "following::Joystick", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xbca1b09e26acd380"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "angle", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Float64 unit \"rad\""}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xbca1b09e26acd380", "kind": "interface", "name": "JoystickEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xddcb191d942f6b5f"}]}]}, {
"id": "@0xddcb191d942f6b5f", "kind": "struct", "name": "JoystickStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "angle", "is": "Float64 unit \"rad\""}]}]})json";

}  // namespace
}  // namespace following

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<following::Joystick>() {
  static constexpr InterfaceInfo kInfo{
      .name = "following::Joystick",
      .hash = "fb0e421ba1ec8175508fc619a3be612c",
      .description = following::kJoystickDescription,
      .commands = following::kJoystickCommands,
      .events = {},
      .codec = &following::joystickCodec,
  };
  return kInfo;
}

// A function for each command of following::Joystick, so that a stack in a debugger names it.
struct Provided<following::Joystick>::Dispatch {
  static Errc execute_angle(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<double>(result);
    return store(implementation.angle(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<following::Joystick>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                            std::byte* result) {
  using ::following::JoystickCommand;
  switch (command) {
    case JoystickCommand::angle: return Dispatch::execute_angle(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
