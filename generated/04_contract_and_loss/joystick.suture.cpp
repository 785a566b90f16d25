// Written by suturec from 04_contract_and_loss/joystick.h. Do not edit.
#include "04_contract_and_loss/joystick.suture.h"

#include <suture/wire/codec.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "04_contract_and_loss/joystick.capnp.h"

namespace following {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

bool acceptsJoystickAngleResult(const double& slot, suture::FieldPath*) { return isValid(slot); }

// --- Joystick as Cap'n Proto

void encodeJoystickAngleResult(const double& slot, wire::Joystick::AngleResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeJoystickAngleResult(wire::Joystick::AngleResults::Reader in, double& slot,
                                       suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeJoystickAngleColumn(const double& slot, wire::JoystickStateRow::Builder out) {
  out.setAngle(slot);
}
suture::Errc decodeJoystickAngleColumn(wire::JoystickStateRow::Reader in, double& slot,
                                       suture::Duration) {
  slot = in.getAngle();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeJoystickColumn(unsigned column, const std::byte* memory,
                          wire::JoystickStateRow::Builder out) {
  switch (static_cast<JoystickColumn>(column)) {
    case JoystickColumn::angle:
      return encodeJoystickAngleColumn(suture::slotIn<double>(memory), out);
  }
}
suture::Errc decodeJoystickColumn(wire::JoystickStateRow::Reader in, unsigned column,
                                  std::byte* memory, suture::Duration shift) {
  switch (static_cast<JoystickColumn>(column)) {
    case JoystickColumn::angle:
      return decodeJoystickAngleColumn(in, suture::newSlot<double>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::rpc::CommandCodec kJoystickCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Joystick>(),
     .method = 1,
     .sent = suture::rpc::sentIn<wire::Joystick::AngleParams>,
     .result = suture::rpc::messageOf<wire::Joystick::AngleResults, double,
                                      encodeJoystickAngleResult, decodeJoystickAngleResult>,
     .stamp = suture::rpc::stampIn<wire::Joystick::AngleResults>},
};

const suture::rpc::Codec& joystickCodec() {
  static constexpr suture::rpc::Codec kCodec{
      .schema = suture::rpc::schemaOf<wire::Joystick>,
      .contract = capnp::typeId<wire::Joystick>(),
      .subscriber = capnp::typeId<wire::JoystickEvents>(),
      .commands = kJoystickCommandCodecs,
      .events = {},
      .row = suture::rpc::rowOf<wire::JoystickEvents::StateParams, wire::JoystickStateRow,
                                encodeJoystickColumn, decodeJoystickColumn>,
  };
  return kCodec;
}

constexpr suture::CommandInfo kJoystickCommands[] = {
    {.name = "angle",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .column = static_cast<int>(JoystickColumn::angle),
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
  switch (static_cast<JoystickCommand>(command)) {
    case JoystickCommand::angle: return Dispatch::execute_angle(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
