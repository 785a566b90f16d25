// Written by suturec from loadable/turntable.h. Do not edit.
#include "loadable/turntable.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace loadable {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const double& angle, TurntableTurnArguments& slot) { return store(angle, slot.angle); }

// Defined in loadable/turntable.wire.cpp.
const suture::codec::Codec& turntableCodec();

namespace {

bool acceptsTurntableTurn(const TurntableTurnArguments& slot, suture::FieldPath* path) {
  return isValid(slot.angle) || suture::refusedAt(path, "angle");
}

bool acceptsTurntableAngleResult(const double& slot, suture::FieldPath*) { return isValid(slot); }

constexpr suture::CommandInfo kTurntableCommands[] = {
    {.name = "turn",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<TurntableTurnArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<TurntableTurnArguments, acceptsTurntableTurn>},
    {.name = "angle",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .column = TurntableColumn::angle,
     .acceptsResult = suture::checkSlot<double, acceptsTurntableAngleResult>},
};

// The self-description, as in loadable/turntable.suture.json.
constexpr char kTurntableDescription[] = R"json(
{"name": "loadable::Turntable", "hash": "1c89821b895e377a0e23c36f654949b9", "commands": [{
"name": "turn", "kind": "write", "ordinal": 1, "parameters": [{"name": "angle", "type": {
"kind": "Float64"}, "unit": "rad"}], "queue": 16}, {"name": "angle", "kind": "read", "ordinal": 2,
"result": {"type": {"kind": "Float64"}}, "queue": 16}], "events": [], "enums": [], "structs": [],
"wire": [{"id": "@0xcb8648112327d0b9", "kind": "interface", "name": "Turntable",
"cxx": "loadable::Turntable", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xbe9023e02a0b50c9"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "turn", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "angle", "is": "Float64 unit \"rad\""}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "angle", "is": "kind \"read\"", "parameters": [
{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xbe9023e02a0b50c9",
"kind": "interface", "name": "TurntableEvents", "members": [{"at": 0, "name": "state",
"parameters": [{"at": 0, "name": "row", "is": "@0xce3772f691497d20"}]}]}, {
"id": "@0xce3772f691497d20", "kind": "struct", "name": "TurntableStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "angle", "is": "Float64"}]}]})json";

}  // namespace
}  // namespace loadable

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<loadable::Turntable>() {
  static constexpr InterfaceInfo kInfo{
      .name = "loadable::Turntable",
      .hash = "1c89821b895e377a0e23c36f654949b9",
      .description = loadable::kTurntableDescription,
      .commands = loadable::kTurntableCommands,
      .events = {},
      .codec = &loadable::turntableCodec,
  };
  return kInfo;
}

// A function for each command of loadable::Turntable, so that a stack in a debugger names it.
struct Provided<loadable::Turntable>::Dispatch {
  static Errc execute_turn(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<loadable::TurntableTurnArguments>(arguments);
    load(slot.angle, scratch.turn_angle);
    implementation.turn(scratch.turn_angle);
    return Errc{};
  }

  static Errc execute_angle(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<double>(result);
    return store(implementation.angle(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<loadable::Turntable>::execute(std::uint16_t command, const std::byte* arguments,
                                            std::byte* result) {
  using ::loadable::TurntableCommand;
  switch (command) {
    case TurntableCommand::turn:
      return Dispatch::execute_turn(implementation_, scratch_, arguments);
    case TurntableCommand::angle: return Dispatch::execute_angle(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
