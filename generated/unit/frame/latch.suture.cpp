// Written by suturec from unit/frame/latch.h. Do not edit.
#include "unit/frame/latch.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace latches {

using suture::isValid;
using suture::load;
using suture::store;

// Defined in unit/frame/latch.wire.cpp.
const suture::codec::Codec& latchCodec();

namespace {

constexpr suture::CommandInfo kLatchCommands[] = {
    {.name = "close", .kind = suture::CommandKind::Void, .depth = 16},
};

constexpr suture::EventInfo kLatchEvents[] = {
    {.name = "closed", .depth = 16},
};

// The self-description, as in unit/frame/latch.suture.json.
constexpr char kLatchDescription[] = R"json(
{"name": "latches::Latch", "hash": "cdeff6e8dfee7b0a206467bc61282b54", "commands": [{
"name": "close", "kind": "void", "ordinal": 1, "queue": 16}], "events": [{"name": "closed",
"kind": "void", "ordinal": 1, "queue": 16}], "enums": [], "structs": [], "wire": [{
"id": "@0x9cd55911994c89d8", "kind": "interface", "name": "Latch", "cxx": "latches::Latch",
"members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0, "name": "events",
"is": "@0x8315f6094677df6b"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2,
"name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "close", "is": "kind \"void\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}]}, {
"id": "@0x8315f6094677df6b", "kind": "interface", "name": "LatchEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xd222b63a4b86bf21"}]}, {"at": 1,
"name": "closed", "parameters": [{"at": 0, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xd222b63a4b86bf21", "kind": "struct", "name": "LatchStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}]}]})json";

}  // namespace
}  // namespace latches

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<latches::Latch>() {
  static constexpr InterfaceInfo kInfo{
      .name = "latches::Latch",
      .hash = "cdeff6e8dfee7b0a206467bc61282b54",
      .description = latches::kLatchDescription,
      .commands = latches::kLatchCommands,
      .events = latches::kLatchEvents,
      .codec = &latches::latchCodec,
  };
  return kInfo;
}

// A function for each command of latches::Latch, so that a stack in a debugger names it.
struct Provided<latches::Latch>::Dispatch {
  static Errc execute_close(Contract& implementation) {
    implementation.close();
    return Errc{};
  }
};

Errc Provided<latches::Latch>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                       std::byte* /*result*/) {
  using ::latches::LatchCommand;
  switch (command) {
    case LatchCommand::close: return Dispatch::execute_close(implementation_);
  }
  return Errc::Invalid;
}

}  // namespace suture
