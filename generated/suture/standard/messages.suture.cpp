// Written by suturec from suture/standard/messages.h. Do not edit.
#include "suture/standard/messages.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace suture {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(Message::text), std::string>);
static_assert(std::is_same_v<decltype(Message::code), std::uint32_t>);
static_assert(std::is_same_v<decltype(Message::counter), std::uint32_t>);
static_assert(std::is_same_v<decltype(Message::stamp), std::chrono::steady_clock::time_point>);

}  // namespace

bool store(const Message& value, MessageSlot& slot) {
  bool fits = true;
  fits &= store(value.text, slot.text);
  fits &= store(value.code, slot.code);
  fits &= store(value.counter, slot.counter);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const MessageSlot& slot, Message& value) {
  load(slot.text, value.text);
  load(slot.code, value.code);
  load(slot.counter, value.counter);
  load(slot.stamp, value.stamp);
}

void reserve(const MessageSlot*, Message& value) {
  suture::reserveFor<decltype(MessageSlot::text)>(value.text);
}

void shiftStamps(MessageSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool isValid(const MessageSlot&, suture::FieldPath*) {
  return true;
}

// Defined in suture/standard/messages.wire.cpp.
const suture::codec::Codec& messagesCodec();

namespace {

constexpr suture::BoundedLevel kMessagesStatusPayloadLevels[] = {
    suture::levelAt<suture::BoundedText<255>>(offsetof(MessageSlot, text)),
};

constexpr suture::BoundedLevel kMessagesWarningPayloadLevels[] = {
    suture::levelAt<suture::BoundedText<255>>(offsetof(MessageSlot, text)),
};

constexpr suture::BoundedLevel kMessagesErrorPayloadLevels[] = {
    suture::levelAt<suture::BoundedText<255>>(offsetof(MessageSlot, text)),
};

constexpr suture::EventInfo kMessagesEvents[] = {
    {.name = "status",
     .payloadSize = suture::slotSize<MessageSlot>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<MessageSlot, isValid>,
     .shiftPayload = suture::shiftSlot<MessageSlot>,
     .payloadLevels = kMessagesStatusPayloadLevels},
    {.name = "warning",
     .payloadSize = suture::slotSize<MessageSlot>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<MessageSlot, isValid>,
     .shiftPayload = suture::shiftSlot<MessageSlot>,
     .payloadLevels = kMessagesWarningPayloadLevels},
    {.name = "error",
     .payloadSize = suture::slotSize<MessageSlot>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<MessageSlot, isValid>,
     .shiftPayload = suture::shiftSlot<MessageSlot>,
     .payloadLevels = kMessagesErrorPayloadLevels},
};

// The self-description, as in suture/standard/messages.suture.json.
constexpr char kMessagesDescription[] = R"json(
{"name": "suture::Messages",
"doc": "Any component may provide this (message_port.h), and any contract may derive from it (then\nmessage_sender.h sends); a client that listens to messages can connect to both. Each client\nkeeps up to 16 of a kind that it has not handled; more are dropped and counted. A client that\ncomes late gets the last of each kind.",
"hash": "3292aca5ba841eeeaadd64f9f3ca3d09", "commands": [], "events": [{"name": "status",
"kind": "write", "ordinal": 1, "doc": "Reports that something has been done, and nothing is wrong.",
"payload": {"type": {"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true}, {
"name": "warning", "kind": "write", "ordinal": 2,
"doc": "Reports that something was refused, or is not as it should be; the component goes on.",
"payload": {"type": {"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true}, {
"name": "error", "kind": "write", "ordinal": 3,
"doc": "Reports that something failed, and needs somebody's attention.", "payload": {"type": {
"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true}], "enums": [],
"structs": [{"name": "suture::Message", "fields": [{"name": "text",
"doc": "The text is UTF-8, for people. A sender cuts a longer text, and ends it in \"...\" then.",
"type": {"kind": "text", "capacity": 255}}, {"name": "code",
"doc": "Says what it is about, by numbers that its sender documents; 0 means nothing in particular.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "counter",
"doc": "Counts the messages of its sender, of all three kinds together, from 1. A gap says that the\nlistener has missed some; a number seen before says that the last one was sent again.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}]}], "wire": [{"id": "@0xb16d80f0d2b50980", "kind": "interface",
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
"name": "counter", "is": "UInt32"}, {"at": 3, "name": "stamp", "is": "Int64 clock \"steady\""}]}]})json";

}  // namespace
}  // namespace suture

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<suture::Messages>() {
  static constexpr InterfaceInfo kInfo{
      .name = "suture::Messages",
      .hash = "3292aca5ba841eeeaadd64f9f3ca3d09",
      .description = suture::kMessagesDescription,
      .commands = {},
      .events = suture::kMessagesEvents,
      .codec = &suture::messagesCodec,
  };
  return kInfo;
}

Errc Provided<suture::Messages>::execute(std::uint16_t /*command*/, const std::byte* /*arguments*/,
                                         std::byte* /*result*/) {
  return Errc::Invalid;
}

}  // namespace suture
