// Written by suturec from unit/shm/logbook.h. Do not edit.
#include "unit/shm/logbook.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace logs {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const std::int32_t& entries, CounterCountArguments& slot) {
  return store(entries, slot.entries);
}

// Defined in unit/shm/logbook.wire.cpp.
const suture::codec::Codec& counterCodec();
const suture::codec::Codec& logbookCodec();

namespace {

constexpr suture::CommandInfo kCounterCommands[] = {
    {.name = "count",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<CounterCountArguments>,
     .depth = 16},
    {.name = "entries",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::int32_t>,
     .depth = 16,
     .column = CounterColumn::entries},
};

// The self-description, as in unit/shm/logbook.suture.json.
constexpr char kCounterDescription[] = R"json(
{"name": "logs::Counter", "hash": "ec79d85077ea7bad61944e6e871b74ad", "commands": [{
"name": "count", "kind": "write", "ordinal": 1, "parameters": [{"name": "entries", "type": {
"kind": "Int32"}}], "queue": 16}, {"name": "entries", "kind": "read", "ordinal": 2, "result": {
"type": {"kind": "Int32"}}, "queue": 16}], "events": [], "enums": [], "structs": [], "wire": [{
"id": "@0x8d109f3c32c4390e", "kind": "interface", "name": "Counter", "cxx": "logs::Counter",
"members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0, "name": "events",
"is": "@0xd85e1e5b50573220"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2,
"name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "count", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "entries", "is": "Int32"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "entries", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Int32"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xd85e1e5b50573220", "kind": "interface", "name": "CounterEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xa143e04b1800f012"}]}]}, {
"id": "@0xa143e04b1800f012", "kind": "struct", "name": "CounterStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "entries", "is": "Int32"}]}]})json";

constexpr suture::CommandInfo kLogbookCommands[] = {
    {.name = "text",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<suture::OpenText>,
     .depth = 16,
     .column = LogbookColumn::text,
     .sharedResult = true},
};

// The self-description, as in unit/shm/logbook.suture.json.
constexpr char kLogbookDescription[] = R"json(
{"name": "logs::Logbook", "doc": "May be provided by a device only, because its text has no bound.",
"hash": "9bc638b38cc895aadfc3bc24f4bcd185", "base": "logs::Counter", "commands": [{"name": "count",
"kind": "write", "ordinal": 1, "parameters": [{"name": "entries", "type": {"kind": "Int32"}}],
"queue": 16, "from": "logs::Counter"}, {"name": "entries", "kind": "read", "ordinal": 2, "result": {
"type": {"kind": "Int32"}}, "queue": 16, "from": "logs::Counter"}, {"name": "text", "kind": "read",
"ordinal": 1, "result": {"type": {"kind": "text"}}, "queue": 16}], "events": [], "enums": [],
"structs": [], "wire": [{"id": "@0xad2e8c9564bbd4b7", "kind": "interface", "name": "Logbook",
"cxx": "logs::Logbook", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0x9862db22da862506"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "text", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Text"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0x8d109f3c32c4390e", "kind": "interface", "name": "Counter", "cxx": "logs::Counter",
"members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0, "name": "events",
"is": "@0xd85e1e5b50573220"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2,
"name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "count", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "entries", "is": "Int32"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "entries", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Int32"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xd85e1e5b50573220", "kind": "interface", "name": "CounterEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xa143e04b1800f012"}]}]}, {
"id": "@0xa143e04b1800f012", "kind": "struct", "name": "CounterStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "entries", "is": "Int32"}]}, {
"id": "@0x9862db22da862506", "kind": "interface", "name": "LogbookEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0x965fbc2e54d0d858"}]}]}, {
"id": "@0x965fbc2e54d0d858", "kind": "struct", "name": "LogbookStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "entries", "is": "Int32"}, {"at": 4,
"name": "text", "is": "Text"}]}]})json";

}  // namespace
}  // namespace logs

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<logs::Counter>() {
  static constexpr InterfaceInfo kInfo{
      .name = "logs::Counter",
      .hash = "ec79d85077ea7bad61944e6e871b74ad",
      .description = logs::kCounterDescription,
      .commands = logs::kCounterCommands,
      .events = {},
      .codec = &logs::counterCodec,
  };
  return kInfo;
}

template <>
const InterfaceInfo& interfaceInfo<logs::Logbook>() {
  static const auto kCommands = extended<3>(interfaceInfo<logs::Counter>().commands,
                                            logs::kLogbookCommands);
  static const InterfaceInfo kInfo{
      .name = "logs::Logbook",
      .hash = "9bc638b38cc895aadfc3bc24f4bcd185",
      .description = logs::kLogbookDescription,
      .commands = kCommands,
      .events = {},
      .codec = &logs::logbookCodec,
      .base = &interfaceInfo<logs::Counter>,
      .toBase = &castToBase<logs::Logbook, logs::Counter>,
  };
  return kInfo;
}

// A function for each command of logs::Counter, so that a stack in a debugger names it.
struct Provided<logs::Counter>::Dispatch {
  static Errc execute_count(Contract& implementation, Scratch& scratch,
                            const std::byte* arguments) {
    const auto& slot = slotIn<logs::CounterCountArguments>(arguments);
    load(slot.entries, scratch.count_entries);
    implementation.count(scratch.count_entries);
    return Errc{};
  }

  static Errc execute_entries(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::int32_t>(result);
    return store(implementation.entries(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<logs::Counter>::execute(std::uint16_t command, const std::byte* arguments,
                                      std::byte* result) {
  using ::logs::CounterCommand;
  switch (command) {
    case CounterCommand::count:
      return Dispatch::execute_count(implementation_, scratch_, arguments);
    case CounterCommand::entries: return Dispatch::execute_entries(implementation_, result);
  }
  return Errc::Invalid;
}

// A function for each command of logs::Logbook, so that a stack in a debugger names it.
struct Provided<logs::Logbook>::Dispatch {
  static Errc execute_text(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<suture::OpenText>(result);
    return store(implementation.text(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<logs::Logbook>::execute(std::uint16_t command, const std::byte* arguments,
                                      std::byte* result) {
  using ::logs::LogbookCommand;
  switch (command) {
    case LogbookCommand::text: return Dispatch::execute_text(implementation_, result);
  }
  return Provided<logs::Counter>::execute(command, arguments, result);
}

}  // namespace suture
