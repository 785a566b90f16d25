// Written by suturec from suture/standard/collecting.h. Do not edit.
#include "suture/standard/collecting.suture.h"

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
static_assert(std::is_same_v<decltype(CollectedCounts::collected), std::uint64_t>);
static_assert(std::is_same_v<decltype(CollectedCounts::passedOver), std::uint64_t>);
static_assert(std::is_same_v<decltype(CollectedCounts::missed), std::uint64_t>);
static_assert(std::is_same_v<decltype(CollectingInterval::every), std::uint32_t>);
static_assert(std::is_same_v<decltype(CollectingInterval::atLeast), std::chrono::nanoseconds>);

}  // namespace

bool store(const CollectedCounts& value, CollectedCountsSlot& slot) {
  bool fits = true;
  fits &= store(value.collected, slot.collected);
  fits &= store(value.passedOver, slot.passedOver);
  fits &= store(value.missed, slot.missed);
  return fits;
}

void load(const CollectedCountsSlot& slot, CollectedCounts& value) {
  load(slot.collected, value.collected);
  load(slot.passedOver, value.passedOver);
  load(slot.missed, value.missed);
}

bool store(const CollectingInterval& value, CollectingIntervalSlot& slot) {
  bool fits = true;
  fits &= store(value.every, slot.every);
  fits &= store(value.atLeast, slot.atLeast);
  return fits;
}

void load(const CollectingIntervalSlot& slot, CollectingInterval& value) {
  load(slot.every, value.every);
  load(slot.atLeast, value.atLeast);
}

bool store(const CollectingInterval& interval, CollectingSetIntervalArguments& slot) {
  return store(interval, slot.interval);
}

bool isValid(const CollectedCountsSlot&, suture::FieldPath*) {
  return true;
}

bool isValid(const CollectingIntervalSlot& slot, suture::FieldPath* path) {
  return suture::inRange(slot.every, 1, 4294967295) || suture::refusedAt(path, "every");
}

// Defined in suture/standard/collecting.wire.cpp.
const suture::codec::Codec& collectingCodec();

namespace {

bool acceptsCollectingSetInterval(const CollectingSetIntervalArguments& slot,
                                  suture::FieldPath* path) {
  return isValid(slot.interval, path) || suture::refusedAt(path, "interval");
}

constexpr suture::CommandInfo kCollectingCommands[] = {
    {.name = "start_collecting", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "stop_collecting", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "set_interval",
     .kind = suture::CommandKind::WriteReturn,
     .argumentsSize = suture::slotSize<CollectingSetIntervalArguments>,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .accepts = suture::checkSlot<CollectingSetIntervalArguments, acceptsCollectingSetInterval>},
    {.name = "interval",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<CollectingIntervalSlot>,
     .depth = 16,
     .column = CollectingColumn::interval,
     .acceptsResult = suture::checkSlot<CollectingIntervalSlot, isValid>},
    {.name = "collecting",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .column = CollectingColumn::collecting},
    {.name = "counts",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<CollectedCountsSlot>,
     .depth = 16,
     .column = CollectingColumn::counts,
     .acceptsResult = suture::checkSlot<CollectedCountsSlot, isValid>},
};

// The self-description, as in suture/standard/collecting.suture.json.
constexpr char kCollectingDescription[] = R"json(
{"name": "suture::Collecting",
"doc": "Collecting is the provided interface of that name of every collector (record/state_collector.h,\nrecord/event_collector.h). Its commands run in the collector's own thread; the task that is\nobserved has no part in them.",
"hash": "7d0a0ee41d0e6b9b9423123184f2f5b4", "commands": [{"name": "start_collecting",
"kind": "void", "ordinal": 1, "wire": "startCollecting",
"doc": "Begins to record what is produced from now on. Counts begin anew, unless it is collecting\nalready.",
"queue": 16}, {"name": "stop_collecting", "kind": "void", "ordinal": 2, "wire": "stopCollecting",
"doc": "Stops recording: what is produced from now on is discarded without being counted.",
"queue": 16}, {"name": "set_interval", "kind": "write with return", "ordinal": 3,
"wire": "setInterval",
"doc": "Sets the interval from the next row or event on. Returns false, and changes nothing, for every\n0th one or a negative time.",
"parameters": [{"name": "interval", "type": {"kind": "struct", "name": "suture::CollectingInterval"
}}], "result": {"type": {"kind": "Bool"}}, "queue": 16}, {"name": "interval", "kind": "read",
"ordinal": 4, "result": {"type": {"kind": "struct", "name": "suture::CollectingInterval"}},
"queue": 16}, {"name": "collecting", "kind": "read", "ordinal": 5, "result": {"type": {
"kind": "Bool"}}, "queue": 16}, {"name": "counts", "kind": "read", "ordinal": 6,
"doc": "Counts what the present time of collecting has written, or the last one.", "result": {
"type": {"kind": "struct", "name": "suture::CollectedCounts"}}, "queue": 16}], "events": [],
"enums": [], "structs": [{"name": "suture::CollectingInterval",
"doc": "Says how much is collected.", "fields": [{"name": "every", "doc": "every n-th row or event",
"type": {"kind": "UInt32"}, "range": [1.0, 4294967295.0], "default": 1}, {"name": "atLeast",
"doc": "between the stamps of two", "type": {"kind": "duration", "period": "1/1000000000"},
"default": 0.0}]}, {"name": "suture::CollectedCounts",
"doc": "Says what became of the rows or events of a time of collecting. Once the collector has caught up\nwith its provider, the three add up to what was produced.",
"fields": [{"name": "collected", "doc": "passed to the sink, and kept", "type": {"kind": "UInt64"},
"default": 0}, {"name": "passedOver",
"doc": "left out on purpose, between two that the interval asks for", "type": {"kind": "UInt64"},
"default": 0}, {"name": "missed", "doc": "lost: overwritten before the collector came, or not kept",
"type": {"kind": "UInt64"}, "default": 0}]}], "wire": [{"id": "@0xe3eaf7ddf2538295",
"kind": "interface", "name": "Collecting", "cxx": "suture::Collecting", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0xe8cbe73a9ddc44ad"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {
"at": 1, "name": "startCollecting", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "stopCollecting", "is": "kind \"void\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 3,
"name": "setInterval", "is": "kind \"writeReturn\"", "parameters": [{"at": 0, "name": "interval",
"is": "@0xc55fb930b38c9647"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "Bool"}]}, {"at": 4, "name": "interval",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xc55fb930b38c9647"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 5, "name": "collecting", "is": "kind \"read\"", "parameters": [{"at": 0,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Bool"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 6, "name": "counts",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0x8130e847fbf0eac6"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}]}, {"id": "@0xe8cbe73a9ddc44ad", "kind": "interface", "name": "CollectingEvents",
"members": [{"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row",
"is": "@0xdf1d86976a49db70"}]}]}, {"id": "@0xdf1d86976a49db70", "kind": "struct",
"name": "CollectingStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "interval", "is": "@0xc55fb930b38c9647"}, {"at": 4, "name": "collecting", "is": "Bool"}, {
"at": 5, "name": "counts", "is": "@0x8130e847fbf0eac6"}]}, {"id": "@0xc55fb930b38c9647",
"kind": "struct", "name": "CollectingInterval", "members": [{"at": 0, "name": "every",
"is": "UInt32 = 1"}, {"at": 1, "name": "atLeast", "is": "Int64 period \"1/1000000000\""}]}, {
"id": "@0x8130e847fbf0eac6", "kind": "struct", "name": "CollectedCounts", "members": [{"at": 0,
"name": "collected", "is": "UInt64"}, {"at": 1, "name": "passedOver", "is": "UInt64"}, {"at": 2,
"name": "missed", "is": "UInt64"}]}]})json";

}  // namespace
}  // namespace suture

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<suture::Collecting>() {
  static constexpr InterfaceInfo kInfo{
      .name = "suture::Collecting",
      .hash = "7d0a0ee41d0e6b9b9423123184f2f5b4",
      .description = suture::kCollectingDescription,
      .commands = suture::kCollectingCommands,
      .events = {},
      .codec = &suture::collectingCodec,
  };
  return kInfo;
}

// A function for each command of suture::Collecting, so that a stack in a debugger names it.
struct Provided<suture::Collecting>::Dispatch {
  static Errc execute_start_collecting(Contract& implementation) {
    implementation.start_collecting();
    return Errc{};
  }

  static Errc execute_stop_collecting(Contract& implementation) {
    implementation.stop_collecting();
    return Errc{};
  }

  static Errc execute_set_interval(Contract& implementation, Scratch& scratch,
                                   const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<suture::CollectingSetIntervalArguments>(arguments);
    load(slot.interval, scratch.set_interval_interval);
    auto& answer = newSlot<std::uint8_t>(result);
    return store(implementation.set_interval(scratch.set_interval_interval), answer)
        ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_interval(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<CollectingIntervalSlot>(result);
    return store(implementation.interval(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_collecting(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::uint8_t>(result);
    return store(implementation.collecting(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_counts(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<CollectedCountsSlot>(result);
    return store(implementation.counts(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<suture::Collecting>::execute(std::uint16_t command, const std::byte* arguments,
                                           std::byte* result) {
  using ::suture::CollectingCommand;
  switch (command) {
    case CollectingCommand::start_collecting:
      return Dispatch::execute_start_collecting(implementation_);
    case CollectingCommand::stop_collecting:
      return Dispatch::execute_stop_collecting(implementation_);
    case CollectingCommand::set_interval:
      return Dispatch::execute_set_interval(implementation_, scratch_, arguments, result);
    case CollectingCommand::interval: return Dispatch::execute_interval(implementation_, result);
    case CollectingCommand::collecting:
      return Dispatch::execute_collecting(implementation_, result);
    case CollectingCommand::counts: return Dispatch::execute_counts(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
