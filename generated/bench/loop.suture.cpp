// Written by suturec from bench/loop.h. Do not edit.
#include "bench/loop.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace bench {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const robots::PosePrm& value, LoopServerPutArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(LoopServerPutArguments& slot, suture::Duration shift) {
  shiftStamps(slot.value, shift);
}

bool store(const robots::PosePrm& value, LoopServerBounceArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(LoopServerBounceArguments& slot, suture::Duration shift) {
  shiftStamps(slot.value, shift);
}

// Defined in bench/loop.wire.cpp.
const suture::codec::Codec& loopServerCodec();

namespace {

bool acceptsLoopServerPut(const LoopServerPutArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

bool acceptsLoopServerBounce(const LoopServerBounceArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

constexpr suture::CommandInfo kLoopServerCommands[] = {
    {.name = "put",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<LoopServerPutArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<LoopServerPutArguments, acceptsLoopServerPut>,
     .shiftArguments = suture::shiftSlot<LoopServerPutArguments>},
    {.name = "bounce",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<LoopServerBounceArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<LoopServerBounceArguments, acceptsLoopServerBounce>,
     .shiftArguments = suture::shiftSlot<LoopServerBounceArguments>},
    {.name = "value",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .column = LoopServerColumn::value,
     .acceptsResult = suture::checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftResult = suture::shiftSlot<robots::PosePrmSlot>},
};

constexpr suture::EventInfo kLoopServerEvents[] = {
    {.name = "echo",
     .payloadSize = suture::slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .accepts = suture::checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftPayload = suture::shiftSlot<robots::PosePrmSlot>},
};

// The self-description, as in bench/loop.suture.json.
constexpr char kLoopServerDescription[] = R"json(
{"name": "bench::LoopServer", "doc": "What the server of a loop offers.",
"hash": "49368c5f00c39f962328ec80c3a51adb", "commands": [{"name": "put", "kind": "write",
"ordinal": 1,
"doc": "Server, client, server: takes back what value() answered and measures how long it was away.",
"parameters": [{"name": "value", "type": {"kind": "struct", "name": "robots::PosePrm"}}],
"queue": 16}, {"name": "bounce", "kind": "write", "ordinal": 2,
"doc": "Client, server, client: sends the value back as the event echo.", "parameters": [{
"name": "value", "type": {"kind": "struct", "name": "robots::PosePrm"}}], "queue": 16}, {
"name": "value", "kind": "read", "ordinal": 3, "doc": "A pose, stamped when it is evaluated.",
"result": {"type": {"kind": "struct", "name": "robots::PosePrm"}}, "queue": 16}], "events": [{
"name": "echo", "kind": "write", "ordinal": 1, "doc": "The value that bounce() took.", "payload": {
"type": {"kind": "struct", "name": "robots::PosePrm"}}, "queue": 16}], "enums": [], "structs": [{
"name": "robots::PosePrm",
"doc": "A PosePrm has the fields of the cisst libraries' prmPositionCartesianGet, the type of the\npaper's measurements.",
"fields": [{"name": "timestamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "automatic_timestamp", "wire": "automaticTimestamp",
"doc": "This is true if the provider stamps the data itself.", "type": {"kind": "Bool"},
"default": true}, {"name": "valid", "type": {"kind": "Bool"}, "default": false}, {
"name": "moving_frame", "wire": "movingFrame", "type": {"kind": "text", "capacity": 15}}, {
"name": "reference_frame", "wire": "referenceFrame", "type": {"kind": "text", "capacity": 15}}, {
"name": "position", "doc": "The moving frame is here in the reference frame.", "type": {
"kind": "isometry", "scalar": "Float64"}, "unit": "m"}]}], "wire": [{"id": "@0xf31a590efb54d189",
"kind": "interface", "name": "LoopServer", "cxx": "bench::LoopServer", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0xa1763febd61d7208"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {
"at": 1, "name": "put", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "@0xedd17c97b8723561"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 2, "name": "bounce", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "@0xedd17c97b8723561"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 3, "name": "value", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xedd17c97b8723561"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xa1763febd61d7208", "kind": "interface",
"name": "LoopServerEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xcf8261ed0f1fe7b7"}]}, {"at": 1, "name": "echo", "parameters": [{"at": 0,
"name": "value", "is": "@0xedd17c97b8723561"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xcf8261ed0f1fe7b7", "kind": "struct", "name": "LoopServerStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "value", "is": "@0xedd17c97b8723561"}, {"at": 3, "name": "tooLarge", "is": "UInt64"}]}, {
"id": "@0xedd17c97b8723561", "kind": "struct", "name": "PosePrm", "members": [{"at": 0,
"name": "timestamp", "is": "Int64 clock \"steady\""}, {"at": 1, "name": "automaticTimestamp",
"is": "Bool = true"}, {"at": 2, "name": "valid", "is": "Bool"}, {"at": 3, "name": "movingFrame",
"is": "Text"}, {"at": 4, "name": "referenceFrame", "is": "Text"}, {"at": 5, "name": "position",
"is": "/suture/types.capnp:Pose unit \"m\""}]}]})json";

}  // namespace
}  // namespace bench

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<bench::LoopServer>() {
  static constexpr InterfaceInfo kInfo{
      .name = "bench::LoopServer",
      .hash = "49368c5f00c39f962328ec80c3a51adb",
      .description = bench::kLoopServerDescription,
      .commands = bench::kLoopServerCommands,
      .events = bench::kLoopServerEvents,
      .codec = &bench::loopServerCodec,
  };
  return kInfo;
}

auto Provided<bench::LoopServer>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(bench::LoopServerPutArguments::value)>(scratch.put_value);
  reserveFor<decltype(bench::LoopServerBounceArguments::value)>(scratch.bounce_value);
  return scratch;
}

// A function for each command of bench::LoopServer, so that a stack in a debugger names it.
struct Provided<bench::LoopServer>::Dispatch {
  static Errc execute_put(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<bench::LoopServerPutArguments>(arguments);
    load(slot.value, scratch.put_value);
    implementation.put(scratch.put_value);
    return Errc{};
  }

  static Errc execute_bounce(Contract& implementation, Scratch& scratch,
                             const std::byte* arguments) {
    const auto& slot = slotIn<bench::LoopServerBounceArguments>(arguments);
    load(slot.value, scratch.bounce_value);
    implementation.bounce(scratch.bounce_value);
    return Errc{};
  }

  static Errc execute_value(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PosePrmSlot>(result);
    return store(implementation.value(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<bench::LoopServer>::execute(std::uint16_t command, const std::byte* arguments,
                                          std::byte* result) {
  using ::bench::LoopServerCommand;
  switch (command) {
    case LoopServerCommand::put: return Dispatch::execute_put(implementation_, scratch_, arguments);
    case LoopServerCommand::bounce:
      return Dispatch::execute_bounce(implementation_, scratch_, arguments);
    case LoopServerCommand::value: return Dispatch::execute_value(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
