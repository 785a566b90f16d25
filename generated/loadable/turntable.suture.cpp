// Written by suturec from loadable/turntable.h. Do not edit.
#include "loadable/turntable.suture.h"

#include <suture/wire/codec.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "loadable/turntable.capnp.h"

namespace loadable {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

bool store(const double& angle, TurntableTurnArguments& slot) { return store(angle, slot.angle); }

namespace {

bool acceptsTurntableTurn(const TurntableTurnArguments& slot, suture::FieldPath* path) {
  return isValid(slot.angle) || suture::refusedAt(path, "angle");
}

bool acceptsTurntableAngleResult(const double& slot, suture::FieldPath*) { return isValid(slot); }

// --- Turntable as Cap'n Proto

void encodeTurntableTurn(const TurntableTurnArguments& slot,
                         wire::Turntable::TurnParams::Builder out) {
  out.setAngle(slot.angle);
}
suture::Errc decodeTurntableTurn(wire::Turntable::TurnParams::Reader in,
                                 TurntableTurnArguments& slot, suture::Duration) {
  slot.angle = in.getAngle();
  return suture::Errc{};
}

void encodeTurntableAngleResult(const double& slot, wire::Turntable::AngleResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeTurntableAngleResult(wire::Turntable::AngleResults::Reader in, double& slot,
                                        suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeTurntableAngleColumn(const double& slot, wire::TurntableStateRow::Builder out) {
  out.setAngle(slot);
}
suture::Errc decodeTurntableAngleColumn(wire::TurntableStateRow::Reader in, double& slot,
                                        suture::Duration) {
  slot = in.getAngle();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeTurntableColumn(unsigned column, const std::byte* memory,
                           wire::TurntableStateRow::Builder out) {
  switch (static_cast<TurntableColumn>(column)) {
    case TurntableColumn::angle:
      return encodeTurntableAngleColumn(suture::slotIn<double>(memory), out);
  }
}
suture::Errc decodeTurntableColumn(wire::TurntableStateRow::Reader in, unsigned column,
                                   std::byte* memory, suture::Duration shift) {
  switch (static_cast<TurntableColumn>(column)) {
    case TurntableColumn::angle:
      return decodeTurntableAngleColumn(in, suture::newSlot<double>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::rpc::CommandCodec kTurntableCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Turntable>(),
     .method = 1,
     .sent = suture::rpc::sentIn<wire::Turntable::TurnParams>,
     .arguments = suture::rpc::messageOf<wire::Turntable::TurnParams, TurntableTurnArguments,
                                         encodeTurntableTurn, decodeTurntableTurn>},
    {.interface = capnp::typeId<wire::Turntable>(),
     .method = 2,
     .sent = suture::rpc::sentIn<wire::Turntable::AngleParams>,
     .result = suture::rpc::messageOf<wire::Turntable::AngleResults, double,
                                      encodeTurntableAngleResult, decodeTurntableAngleResult>,
     .stamp = suture::rpc::stampIn<wire::Turntable::AngleResults>},
};

const suture::rpc::Codec& turntableCodec() {
  static constexpr suture::rpc::Codec kCodec{
      .schema = suture::rpc::schemaOf<wire::Turntable>,
      .contract = capnp::typeId<wire::Turntable>(),
      .subscriber = capnp::typeId<wire::TurntableEvents>(),
      .commands = kTurntableCommandCodecs,
      .events = {},
      .row = suture::rpc::rowOf<wire::TurntableEvents::StateParams, wire::TurntableStateRow,
                                encodeTurntableColumn, decodeTurntableColumn>,
  };
  return kCodec;
}

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
     .column = static_cast<int>(TurntableColumn::angle),
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
  switch (static_cast<TurntableCommand>(command)) {
    case TurntableCommand::turn:
      return Dispatch::execute_turn(implementation_, scratch_, arguments);
    case TurntableCommand::angle: return Dispatch::execute_angle(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
