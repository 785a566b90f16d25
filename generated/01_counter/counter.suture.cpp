// Written by suturec from 01_counter/counter.h. Do not edit.
#include "01_counter/counter.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace counting {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const std::int32_t& amount, CounterAddArguments& slot) {
  return store(amount, slot.amount);
}

// Defined in 01_counter/counter.wire.cpp.
const suture::codec::Codec& counterCodec();

namespace {

constexpr suture::CommandInfo kCounterCommands[] = {
    {.name = "add",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<CounterAddArguments>,
     .depth = 8},
    {.name = "value",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::int64_t>,
     .depth = 16,
     .column = CounterColumn::value},
};

constexpr suture::EventInfo kCounterEvents[] = {
    {.name = "ten_more", .payloadSize = suture::slotSize<std::int64_t>, .depth = 16},
};

// The self-description, as in 01_counter/counter.suture.json.
constexpr char kCounterDescription[] = R"json(
{"name": "counting::Counter", "hash": "d0b9cec53f4001af7aba4e29b891fbe9", "commands": [{
"name": "add", "kind": "write", "ordinal": 1, "doc": "Adds to the count, in the provider's thread.",
"parameters": [{"name": "amount", "type": {"kind": "Int32"}}], "queue": 8}, {"name": "value",
"kind": "read", "ordinal": 2, "doc": "Returns the newest count; never waits for anyone.",
"result": {"type": {"kind": "Int64"}}, "queue": 16}], "events": [{"name": "ten_more",
"kind": "write", "ordinal": 1, "wire": "tenMore",
"doc": "Reports that the count has passed a multiple of ten.", "payload": {"type": {"kind": "Int64"
}}, "queue": 16}], "enums": [], "structs": [], "wire": [{"id": "@0xd6d42f0aed709948",
"kind": "interface", "name": "Counter", "cxx": "counting::Counter", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0xab8aa54e33362c79"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {
"at": 1, "name": "add", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "amount",
"is": "Int32"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 2,
"name": "value", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Int64"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}]}, {"id": "@0xab8aa54e33362c79", "kind": "interface",
"name": "CounterEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xbfec877b65b98c5c"}]}, {"at": 1, "name": "tenMore", "parameters": [{
"at": 0, "name": "value", "is": "Int64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xbfec877b65b98c5c", "kind": "struct", "name": "CounterStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "value", "is": "Int64"}, {"at": 3, "name": "tooLarge", "is": "UInt64"}]}]})json";

}  // namespace
}  // namespace counting

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<counting::Counter>() {
  static constexpr InterfaceInfo kInfo{
      .name = "counting::Counter",
      .hash = "d0b9cec53f4001af7aba4e29b891fbe9",
      .description = counting::kCounterDescription,
      .commands = counting::kCounterCommands,
      .events = counting::kCounterEvents,
      .codec = &counting::counterCodec,
  };
  return kInfo;
}

// A function for each command of counting::Counter, so that a stack in a debugger names it.
struct Provided<counting::Counter>::Dispatch {
  static Errc execute_add(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<counting::CounterAddArguments>(arguments);
    load(slot.amount, scratch.add_amount);
    implementation.add(scratch.add_amount);
    return Errc{};
  }

  static Errc execute_value(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::int64_t>(result);
    return store(implementation.value(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<counting::Counter>::execute(std::uint16_t command, const std::byte* arguments,
                                          std::byte* result) {
  using ::counting::CounterCommand;
  switch (command) {
    case CounterCommand::add: return Dispatch::execute_add(implementation_, scratch_, arguments);
    case CounterCommand::value: return Dispatch::execute_value(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
