// Written by suturec from unit/contracts/lamp.h. Do not edit.
#include "unit/contracts/lamp.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace contracts {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const bool& on, LampLightArguments& slot) { return store(on, slot.on); }

// Defined in unit/contracts/lamp.wire.cpp.
const suture::codec::Codec& lampCodec();

namespace {

constexpr suture::CommandInfo kLampCommands[] = {
    {.name = "light",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<LampLightArguments>,
     .depth = 16},
    {.name = "lit",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .column = LampColumn::lit},
};

// The self-description, as in unit/contracts/lamp.suture.json.
constexpr char kLampDescription[] = R"json(
{"name": "contracts::Lamp", "hash": "6d9eb09eeffd19248376e3cef7415d78", "base": "suture::Messages",
"commands": [{"name": "light", "kind": "write", "ordinal": 1, "parameters": [{"name": "on",
"type": {"kind": "Bool"}}], "queue": 16}, {"name": "lit", "kind": "read", "ordinal": 2, "result": {
"type": {"kind": "Bool"}}, "queue": 16}], "events": [{"name": "status", "kind": "write",
"ordinal": 1, "doc": "Reports that something has been done, and nothing is wrong.", "payload": {
"type": {"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages"}, {"name": "warning", "kind": "write", "ordinal": 2,
"doc": "Reports that something was refused, or is not as it should be; the component goes on.",
"payload": {"type": {"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages"}, {"name": "error", "kind": "write", "ordinal": 3,
"doc": "Reports that something failed, and needs somebody's attention.", "payload": {"type": {
"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages"}], "enums": [], "structs": [{"name": "suture::Message", "fields": [{
"name": "text",
"doc": "The text is UTF-8, for people. A sender cuts a longer text, and ends it in \"...\" then.",
"type": {"kind": "text", "capacity": 255}}, {"name": "code",
"doc": "Says what it is about, by numbers that its sender documents; 0 means nothing in particular.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "counter",
"doc": "Counts the messages of its sender, of all three kinds together, from 1. A gap says that the\nlistener has missed some; a number seen before says that the last one was sent again.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}]}], "wire": [{"id": "@0xd4cb2344bc7abacc", "kind": "interface", "name": "Lamp",
"cxx": "contracts::Lamp", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xd29be22d5548c1be"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "light", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "on", "is": "Bool"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "lit", "is": "kind \"read\"", "parameters": [{
"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Bool"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xb16d80f0d2b50980",
"kind": "interface", "name": "Messages", "cxx": "suture::Messages", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0xa02813b154cdd1d8"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}]}, {
"id": "@0xa02813b154cdd1d8", "kind": "interface", "name": "MessagesEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0x814f9864e019fa96"}]}, {"at": 1,
"name": "status", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "warning", "parameters": [{"at": 0,
"name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 3, "name": "error", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0x814f9864e019fa96", "kind": "struct",
"name": "MessagesStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}]}, {
"id": "@0xbd6bc34f74980c5d", "kind": "struct", "name": "Message", "members": [{"at": 0,
"name": "text", "is": "Text"}, {"at": 1, "name": "code", "is": "UInt32"}, {"at": 2,
"name": "counter", "is": "UInt32"}, {"at": 3, "name": "stamp", "is": "Int64 clock \"steady\""}]}, {
"id": "@0xd29be22d5548c1be", "kind": "interface", "name": "LampEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xc60e3f090bda1270"}]}, {"at": 1,
"name": "status", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "warning", "parameters": [{"at": 0,
"name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 3, "name": "error", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xc60e3f090bda1270", "kind": "struct",
"name": "LampStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "lit", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace contracts

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<contracts::Lamp>() {
  static const InterfaceInfo kInfo{
      .name = "contracts::Lamp",
      .hash = "6d9eb09eeffd19248376e3cef7415d78",
      .description = contracts::kLampDescription,
      .commands = contracts::kLampCommands,
      .events = interfaceInfo<suture::Messages>().events,
      .codec = &contracts::lampCodec,
      .base = &interfaceInfo<suture::Messages>,
      .toBase = &castToBase<contracts::Lamp, suture::Messages>,
  };
  return kInfo;
}

// A function for each command of contracts::Lamp, so that a stack in a debugger names it.
struct Provided<contracts::Lamp>::Dispatch {
  static Errc execute_light(Contract& implementation, Scratch& scratch,
                            const std::byte* arguments) {
    const auto& slot = slotIn<contracts::LampLightArguments>(arguments);
    load(slot.on, scratch.light_on);
    implementation.light(scratch.light_on);
    return Errc{};
  }

  static Errc execute_lit(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::uint8_t>(result);
    return store(implementation.lit(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<contracts::Lamp>::execute(std::uint16_t command, const std::byte* arguments,
                                        std::byte* result) {
  using ::contracts::LampCommand;
  switch (command) {
    case LampCommand::light: return Dispatch::execute_light(implementation_, scratch_, arguments);
    case LampCommand::lit: return Dispatch::execute_lit(implementation_, result);
  }
  return Provided<suture::Messages>::execute(command, arguments, result);
}

}  // namespace suture
