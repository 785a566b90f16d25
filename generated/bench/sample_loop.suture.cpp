// Written by suturec from bench/sample_loop.h. Do not edit.
#include "bench/sample_loop.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace bench {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const robots::PoseSample& value, SampleServerPutArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(SampleServerPutArguments& slot, suture::Duration shift) {
  shiftStamps(slot.value, shift);
}

bool store(const robots::PoseSample& value, SampleServerBounceArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(SampleServerBounceArguments& slot, suture::Duration shift) {
  shiftStamps(slot.value, shift);
}

// Defined in bench/sample_loop.wire.cpp.
const suture::codec::Codec& sampleServerCodec();

namespace {

bool acceptsSampleServerPut(const SampleServerPutArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

bool acceptsSampleServerBounce(const SampleServerBounceArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

constexpr suture::CommandInfo kSampleServerCommands[] = {
    {.name = "put",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<SampleServerPutArguments>,
     .depth = 4096,
     .accepts = suture::checkSlot<SampleServerPutArguments, acceptsSampleServerPut>,
     .shiftArguments = suture::shiftSlot<SampleServerPutArguments>},
    {.name = "bounce",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<SampleServerBounceArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<SampleServerBounceArguments, acceptsSampleServerBounce>,
     .shiftArguments = suture::shiftSlot<SampleServerBounceArguments>},
    {.name = "value",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<robots::PoseSampleSlot>,
     .depth = 16,
     .column = SampleServerColumn::value,
     .acceptsResult = suture::checkSlot<robots::PoseSampleSlot, robots::isValid>,
     .shiftResult = suture::shiftSlot<robots::PoseSampleSlot>},
};

constexpr suture::EventInfo kSampleServerEvents[] = {
    {.name = "echo",
     .payloadSize = suture::slotSize<robots::PoseSampleSlot>,
     .depth = 16,
     .accepts = suture::checkSlot<robots::PoseSampleSlot, robots::isValid>,
     .shiftPayload = suture::shiftSlot<robots::PoseSampleSlot>},
};

// The self-description, as in bench/sample_loop.suture.json.
constexpr char kSampleServerDescription[] = R"json(
{"name": "bench::SampleServer", "hash": "22612a40a9732e358268e106fe36141b", "commands": [{
"name": "put", "kind": "write", "ordinal": 1, "doc": "Counted by the provider.", "parameters": [{
"name": "value", "type": {"kind": "struct", "name": "robots::PoseSample"}}], "queue": 4096}, {
"name": "bounce", "kind": "write", "ordinal": 2,
"doc": "Client, server, client: sends the value back as the event echo.", "parameters": [{
"name": "value", "type": {"kind": "struct", "name": "robots::PoseSample"}}], "queue": 16}, {
"name": "value", "kind": "read", "ordinal": 3, "result": {"type": {"kind": "struct",
"name": "robots::PoseSample"}}, "queue": 16}], "events": [{"name": "echo", "kind": "write",
"ordinal": 1, "doc": "The value that bounce() took.", "payload": {"type": {"kind": "struct",
"name": "robots::PoseSample"}}, "queue": 16}], "enums": [], "structs": [{
"name": "robots::PoseSample",
"doc": "A PoseSample is the pose of the latency measurements: 120 bytes and no strings.",
"fields": [{"name": "rotation", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 3}}, {"name": "position", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "m"}, {"name": "stamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "sequence", "type": {"kind": "UInt64"}, "default": 0}, {"name": "flags", "type": {
"kind": "UInt64"}, "default": 0}]}], "wire": [{"id": "@0xa9d747a8e40c3d30", "kind": "interface",
"name": "SampleServer", "cxx": "bench::SampleServer", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xc71bdb510deae77a"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "put", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "@0x9dcf31510b46998d"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 2, "name": "bounce", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "@0x9dcf31510b46998d"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 3, "name": "value", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0x9dcf31510b46998d"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xc71bdb510deae77a", "kind": "interface",
"name": "SampleServerEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xb757a2bfdbcd1cf8"}]}, {"at": 1, "name": "echo", "parameters": [{"at": 0,
"name": "value", "is": "@0x9dcf31510b46998d"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xb757a2bfdbcd1cf8", "kind": "struct", "name": "SampleServerStateRow", "members": [{
"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "value", "is": "@0x9dcf31510b46998d"}]}, {
"id": "@0x9dcf31510b46998d", "kind": "struct", "name": "PoseSample", "members": [{"at": 0,
"name": "rotation", "is": "/suture/types.capnp:Mat3"}, {"at": 1, "name": "position",
"is": "/suture/types.capnp:Vec3 unit \"m\""}, {"at": 2, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 3, "name": "sequence", "is": "UInt64"}, {"at": 4,
"name": "flags", "is": "UInt64"}]}]})json";

}  // namespace
}  // namespace bench

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<bench::SampleServer>() {
  static constexpr InterfaceInfo kInfo{
      .name = "bench::SampleServer",
      .hash = "22612a40a9732e358268e106fe36141b",
      .description = bench::kSampleServerDescription,
      .commands = bench::kSampleServerCommands,
      .events = bench::kSampleServerEvents,
      .codec = &bench::sampleServerCodec,
  };
  return kInfo;
}

// A function for each command of bench::SampleServer, so that a stack in a debugger names it.
struct Provided<bench::SampleServer>::Dispatch {
  static Errc execute_put(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<bench::SampleServerPutArguments>(arguments);
    load(slot.value, scratch.put_value);
    implementation.put(scratch.put_value);
    return Errc{};
  }

  static Errc execute_bounce(Contract& implementation, Scratch& scratch,
                             const std::byte* arguments) {
    const auto& slot = slotIn<bench::SampleServerBounceArguments>(arguments);
    load(slot.value, scratch.bounce_value);
    implementation.bounce(scratch.bounce_value);
    return Errc{};
  }

  static Errc execute_value(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PoseSampleSlot>(result);
    return store(implementation.value(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<bench::SampleServer>::execute(std::uint16_t command, const std::byte* arguments,
                                            std::byte* result) {
  using ::bench::SampleServerCommand;
  switch (command) {
    case SampleServerCommand::put:
      return Dispatch::execute_put(implementation_, scratch_, arguments);
    case SampleServerCommand::bounce:
      return Dispatch::execute_bounce(implementation_, scratch_, arguments);
    case SampleServerCommand::value: return Dispatch::execute_value(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
