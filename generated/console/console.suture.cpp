// Written by suturec from console/console.h. Do not edit.
#include "console/console.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<ConsoleState>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(ConsoleState::Down) == 0);
static_assert(static_cast<std::uint8_t>(ConsoleState::Enabling) == 1);
static_assert(static_cast<std::uint8_t>(ConsoleState::Homing) == 2);
static_assert(static_cast<std::uint8_t>(ConsoleState::Up) == 3);
static_assert(static_cast<std::uint8_t>(ConsoleState::Incomplete) == 4);
static_assert(static_cast<std::uint8_t>(ConsoleState::Leaving) == 5);
static_assert(std::is_same_v<std::underlying_type_t<SystemUse>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(SystemUse::Unknown) == 0);
static_assert(static_cast<std::uint8_t>(SystemUse::Unused) == 1);
static_assert(static_cast<std::uint8_t>(SystemUse::Used) == 2);

}  // namespace

bool isKnownConsoleState(std::uint8_t slot) {
  switch (static_cast<ConsoleState>(slot)) {
    case ConsoleState::Down:
    case ConsoleState::Enabling:
    case ConsoleState::Homing:
    case ConsoleState::Up:
    case ConsoleState::Incomplete:
    case ConsoleState::Leaving:
      return true;
  }
  return false;
}

bool isKnownSystemUse(std::uint8_t slot) {
  switch (static_cast<SystemUse>(slot)) {
    case SystemUse::Unknown:
    case SystemUse::Unused:
    case SystemUse::Used:
      return true;
  }
  return false;
}

// Defined in console/console.wire.cpp.
const suture::codec::Codec& consoleCodec();

namespace {

bool acceptsConsoleConsoleStateResult(const std::uint8_t& slot, suture::FieldPath*) {
  return isKnownConsoleState(slot);
}

bool acceptsConsoleConsoleStateEvent(const std::uint8_t& slot, suture::FieldPath*) {
  return isKnownConsoleState(slot);
}

bool acceptsConsoleSystemUseEvent(const std::uint8_t& slot, suture::FieldPath*) {
  return isKnownSystemUse(slot);
}

constexpr suture::CommandInfo kConsoleCommands[] = {
    {.name = "bring_up", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "bring_down", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "console_state",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .column = ConsoleColumn::console_state,
     .acceptsResult = suture::checkSlot<std::uint8_t, acceptsConsoleConsoleStateResult>},
};

constexpr suture::EventInfo kConsoleEvents[] = {
    {.name = "console_state",
     .payloadSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<std::uint8_t, acceptsConsoleConsoleStateEvent>},
    {.name = "system_use",
     .payloadSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<std::uint8_t, acceptsConsoleSystemUseEvent>},
};

// The self-description, as in console/console.suture.json.
constexpr char kConsoleDescription[] = R"json(
{"name": "robots::Console",
"doc": "Commands run in the console's own thread before its next cycle. Status, warning and error are\nthe standard messages: they say what is missing, and which part did not do what it was asked. A\nwarning with the code of ArmWarning::PowerLost (arm/arm_warning.h) names an arm whose drives\nhave lost their power, or may not have it.",
"hash": "3b681b6035d50f206d1cfcd269c5e926", "base": "suture::Messages", "commands": [{
"name": "bring_up", "kind": "void", "ordinal": 1, "wire": "bringUp",
"doc": "Brings the system up. It is refused, with an error that names each reason, unless the console\nis down, every part of the system is there, no arm is in FAULT, and the emergency stop is\nreleased.",
"queue": 16}, {"name": "bring_down", "kind": "void", "ordinal": 2, "wire": "bringDown",
"doc": "Disables everything in the opposite order, even while the system is being brought up, and\nalso what others have enabled. An arm in FAULT has no power, and stays in FAULT until somebody\nenables or disables it.",
"queue": 16}, {"name": "console_state", "kind": "read", "ordinal": 3, "wire": "consoleState",
"result": {"type": {"kind": "enum", "name": "robots::ConsoleState"}}, "queue": 16}], "events": [{
"name": "status", "kind": "write", "ordinal": 1,
"doc": "Reports that something has been done, and nothing is wrong.", "payload": {"type": {
"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages"}, {"name": "warning", "kind": "write", "ordinal": 2,
"doc": "Reports that something was refused, or is not as it should be; the component goes on.",
"payload": {"type": {"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages"}, {"name": "error", "kind": "write", "ordinal": 3,
"doc": "Reports that something failed, and needs somebody's attention.", "payload": {"type": {
"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages"}, {"name": "console_state", "kind": "write", "ordinal": 4,
"wire": "consoleState", "doc": "Reports each change, and the last one to a client that connects.",
"payload": {"type": {"kind": "enum", "name": "robots::ConsoleState"}}, "queue": 16, "latched": true
}, {"name": "system_use", "kind": "write", "ordinal": 5, "wire": "systemUse",
"doc": "Reports each change, and the present one to a client that connects.", "payload": {"type": {
"kind": "enum", "name": "robots::SystemUse"}}, "queue": 16, "latched": true}], "enums": [{
"name": "robots::ConsoleState", "underlying": "UInt8", "enumerators": [{"name": "Down", "value": 0,
"wire": "down", "doc": "until bring_up()"}, {"name": "Enabling", "value": 1, "wire": "enabling",
"doc": "the arms get power, one after the other"}, {"name": "Homing", "value": 2, "wire": "homing",
"doc": "they move to their home positions"}, {"name": "Up", "value": 3, "wire": "up",
"doc": "the arms are ready, and what moves them is enabled"}, {"name": "Incomplete", "value": 4,
"wire": "incomplete", "doc": "it was up, and a part is missing or not ready; up again when all are"
}, {"name": "Leaving", "value": 5, "wire": "leaving",
"doc": "bring_down() is under way, or a bring-up that failed is taken back"}]}, {
"name": "robots::SystemUse",
"doc": "Says if the arms of a system have had power since their processes began. Then somebody may have\npressed the emergency stop before its coordinator began, which does not know of it.",
"underlying": "UInt8", "enumerators": [{"name": "Unknown", "value": 0, "wire": "unknown",
"doc": "some arm has not said it"}, {"name": "Unused", "value": 1, "wire": "unused",
"doc": "none has been permitted power"}, {"name": "Used", "value": 2, "wire": "used"}]}],
"structs": [{"name": "suture::Message", "fields": [{"name": "text",
"doc": "The text is UTF-8, for people. A sender cuts a longer text, and ends it in \"...\" then.",
"type": {"kind": "text", "capacity": 255}}, {"name": "code",
"doc": "Says what it is about, by numbers that its sender documents; 0 means nothing in particular.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "counter",
"doc": "Counts the messages of its sender, of all three kinds together, from 1. A gap says that the\nlistener has missed some; a number seen before says that the last one was sent again.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}]}], "wire": [{"id": "@0xdf92213fbec2997e", "kind": "interface",
"name": "Console", "cxx": "robots::Console", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0x84a81ff77b719ad6"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "bringUp", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "bringDown", "is": "kind \"void\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 3,
"name": "consoleState", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xe5858b1b3b511bbf"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xb16d80f0d2b50980", "kind": "interface",
"name": "Messages", "cxx": "suture::Messages", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xa02813b154cdd1d8"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}]}, {
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
"id": "@0x84a81ff77b719ad6", "kind": "interface", "name": "ConsoleEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xc2af8ce57e1b558c"}]}, {"at": 1,
"name": "status", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "warning", "parameters": [{"at": 0,
"name": "value", "is": "@0xbd6bc34f74980c5d"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 3, "name": "error", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 4, "name": "consoleState", "parameters": [{
"at": 0, "name": "value", "is": "@0xe5858b1b3b511bbf"}, {"at": 1, "name": "stamp", "is": "Int64"}]
}, {"at": 5, "name": "systemUse", "parameters": [{"at": 0, "name": "value",
"is": "@0xc3ffdfe7b8f7c55c"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xc2af8ce57e1b558c", "kind": "struct", "name": "ConsoleStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "consoleState", "is": "@0xe5858b1b3b511bbf"}
]}, {"id": "@0xe5858b1b3b511bbf", "kind": "enum", "name": "ConsoleState", "members": [{"at": 0,
"name": "down"}, {"at": 1, "name": "enabling"}, {"at": 2, "name": "homing"}, {"at": 3, "name": "up"
}, {"at": 4, "name": "incomplete"}, {"at": 5, "name": "leaving"}]}, {"id": "@0xc3ffdfe7b8f7c55c",
"kind": "enum", "name": "SystemUse", "members": [{"at": 0, "name": "unknown"}, {"at": 1,
"name": "unused"}, {"at": 2, "name": "used"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Console>() {
  static const auto kEvents = extended<5>(interfaceInfo<suture::Messages>().events,
                                          robots::kConsoleEvents);
  static const InterfaceInfo kInfo{
      .name = "robots::Console",
      .hash = "3b681b6035d50f206d1cfcd269c5e926",
      .description = robots::kConsoleDescription,
      .commands = robots::kConsoleCommands,
      .events = kEvents,
      .codec = &robots::consoleCodec,
      .base = &interfaceInfo<suture::Messages>,
      .toBase = &castToBase<robots::Console, suture::Messages>,
  };
  return kInfo;
}

// A function for each command of robots::Console, so that a stack in a debugger names it.
struct Provided<robots::Console>::Dispatch {
  static Errc execute_bring_up(Contract& implementation) {
    implementation.bring_up();
    return Errc{};
  }

  static Errc execute_bring_down(Contract& implementation) {
    implementation.bring_down();
    return Errc{};
  }

  static Errc execute_console_state(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::uint8_t>(result);
    return store(implementation.console_state(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::Console>::execute(std::uint16_t command, const std::byte* arguments,
                                        std::byte* result) {
  using ::robots::ConsoleCommand;
  switch (command) {
    case ConsoleCommand::bring_up: return Dispatch::execute_bring_up(implementation_);
    case ConsoleCommand::bring_down: return Dispatch::execute_bring_down(implementation_);
    case ConsoleCommand::console_state:
      return Dispatch::execute_console_state(implementation_, result);
  }
  return Provided<suture::Messages>::execute(command, arguments, result);
}

}  // namespace suture
