// Written by suturec from shapes/moments.h. Do not edit.
#include "shapes/moments.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <limits>
#include <type_traits>

namespace shapes {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(Moment::steady), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(Moment::system), std::chrono::system_clock::time_point>);
static_assert(std::is_same_v<decltype(Moment::number), std::int64_t>);
static_assert(std::is_same_v<decltype(Moments::pair),
                             std::array<std::chrono::steady_clock::time_point, 2>>);
static_assert(std::is_same_v<decltype(Moments::list),
                             std::vector<std::chrono::steady_clock::time_point>>);
static_assert(std::is_same_v<decltype(Moments::moments), std::vector<shapes::Moment>>);
static_assert(std::is_same_v<decltype(Moments::nested),
                             std::vector<std::vector<std::chrono::steady_clock::time_point>>>);
static_assert(std::is_same_v<decltype(Moments::byNumber),
                             std::map<std::int32_t, std::chrono::steady_clock::time_point>>);
static_assert(std::is_same_v<decltype(Moments::perhaps),
                             std::optional<std::chrono::steady_clock::time_point>>);
static_assert(std::is_same_v<decltype(Moments::moment), std::optional<shapes::Moment>>);
static_assert(std::is_same_v<decltype(Moments::entry),
                             std::tuple<std::int64_t, std::chrono::steady_clock::time_point, shapes::Moment>>);
static_assert(std::is_same_v<decltype(Moments::either),
                             std::variant<std::int64_t, std::chrono::steady_clock::time_point, shapes::Moment>>);
static_assert(std::is_same_v<decltype(Spans::brief),
                             std::chrono::duration<float, std::ratio<1, 1000>>>);
static_assert(std::is_same_v<decltype(Spans::endless), std::chrono::duration<double>>);
static_assert(std::is_same_v<decltype(Spans::list), std::vector<std::chrono::duration<float>>>);

}  // namespace

bool store(const Moment& value, MomentSlot& slot) {
  bool fits = true;
  fits &= store(value.steady, slot.steady);
  fits &= store(value.system, slot.system);
  fits &= store(value.number, slot.number);
  return fits;
}

void load(const MomentSlot& slot, Moment& value) {
  load(slot.steady, value.steady);
  load(slot.system, value.system);
  load(slot.number, value.number);
}

void shiftStamps(MomentSlot& slot, suture::Duration shift) {
  slot.steady = suture::codec::shifted(slot.steady, shift);
}

bool store(const Moments& value, MomentsSlot& slot) {
  bool fits = true;
  fits &= store(value.pair, slot.pair);
  fits &= store(value.list, slot.list);
  fits &= store(value.moments, slot.moments);
  fits &= store(value.nested, slot.nested);
  fits &= store(value.byNumber, slot.byNumber);
  fits &= store(value.perhaps, slot.perhaps);
  fits &= store(value.moment, slot.moment);
  fits &= store(value.entry, slot.entry);
  fits &= store(value.either, slot.either);
  return fits;
}

void load(const MomentsSlot& slot, Moments& value) {
  load(slot.pair, value.pair);
  load(slot.list, value.list);
  load(slot.moments, value.moments);
  load(slot.nested, value.nested);
  load(slot.byNumber, value.byNumber);
  load(slot.perhaps, value.perhaps);
  load(slot.moment, value.moment);
  load(slot.entry, value.entry);
  load(slot.either, value.either);
}

void reserve(const MomentsSlot*, Moments& value) {
  suture::reserveFor<decltype(MomentsSlot::list)>(value.list);
  suture::reserveFor<decltype(MomentsSlot::moments)>(value.moments);
  suture::reserveFor<decltype(MomentsSlot::nested)>(value.nested);
}

void shiftStamps(MomentsSlot& slot, suture::Duration shift) {
  for (auto& element : slot.pair) {
    element = suture::codec::shifted(element, shift);
  }
  for (auto& element : suture::elementsIn(slot.list)) {
    element = suture::codec::shifted(element, shift);
  }
  for (auto& element : suture::elementsIn(slot.moments)) {
    shiftStamps(element, shift);
  }
  for (auto& element : suture::elementsIn(slot.nested)) {
    for (auto& element2 : suture::elementsIn(element)) {
      element2 = suture::codec::shifted(element2, shift);
    }
  }
  for (auto& element : suture::elementsIn(slot.byNumber)) {
    element.value = suture::codec::shifted(element.value, shift);
  }
  if (slot.perhaps.present != 0) {
    slot.perhaps.value = suture::codec::shifted(slot.perhaps.value, shift);
  }
  if (slot.moment.present != 0) {
    shiftStamps(slot.moment.value, shift);
  }
  suture::item<1>(slot.entry) = suture::codec::shifted(suture::item<1>(slot.entry), shift);
  shiftStamps(suture::item<2>(slot.entry), shift);
  if (slot.either.index == 1) {
    suture::alternative<1>(slot.either) = suture::codec::shifted(suture::alternative<1>(slot.either), shift);
  }
  if (slot.either.index == 2) {
    shiftStamps(suture::alternative<2>(slot.either), shift);
  }
}

bool store(const Spans& value, SpansSlot& slot) {
  bool fits = true;
  fits &= store(value.brief, slot.brief);
  fits &= store(value.endless, slot.endless);
  fits &= store(value.list, slot.list);
  return fits;
}

void load(const SpansSlot& slot, Spans& value) {
  load(slot.brief, value.brief);
  load(slot.endless, value.endless);
  load(slot.list, value.list);
}

void reserve(const SpansSlot*, Spans& value) {
  suture::reserveFor<decltype(SpansSlot::list)>(value.list);
}

bool store(const std::chrono::steady_clock::time_point& from, const std::int64_t& number,
           JournalPutArguments& slot) {
  return store(from, slot.from) && store(number, slot.number);
}

void shiftStamps(JournalPutArguments& slot, suture::Duration shift) {
  slot.from = suture::codec::shifted(slot.from, shift);
}

bool store(const std::int64_t& number, JournalCountArguments& slot) {
  return store(number, slot.number);
}

bool store(const std::int64_t& number, JournalFindArguments& slot) {
  return store(number, slot.number);
}

bool store(const Moment& value, const std::int64_t& value2, JournalChangedPayload& slot) {
  return store(value, slot.value) && store(value2, slot.value2);
}

void load(const JournalChangedPayload& slot, Moment& value, std::int64_t& value2) {
  load(slot.value, value);
  load(slot.value2, value2);
}

void shiftStamps(JournalChangedPayload& slot, suture::Duration shift) {
  shiftStamps(slot.value, shift);
}

bool isValid(const MomentSlot&, suture::FieldPath*) {
  return true;
}

bool isValid(const MomentsSlot& slot, suture::FieldPath* path) {
  if (!suture::allOf(slot.moments, path, [path](const MomentSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "moments");
  }
  if (!isValid(slot.moment, path)) return suture::refusedAt(path, "moment");
  if (!isValid(slot.entry, path)) return suture::refusedAt(path, "entry");
  return isValid(slot.either, path) || suture::refusedAt(path, "either");
}

bool isValid(const SpansSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.brief, -3.4028234663852886e+38, 3.4028234663852886e+38)) {
    return suture::refusedAt(path, "brief");
  }
  if (!suture::inRange(slot.endless, -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity())) {
    return suture::refusedAt(path, "endless");
  }
  if (!suture::allOf(slot.list, path, [](const double& element) {
    return suture::inRange(element, -3.4028234663852886e+38, 3.4028234663852886e+38);
  })) {
    return suture::refusedAt(path, "list");
  }
  return true;
}

// Defined in shapes/moments.wire.cpp.
const suture::codec::Codec& journalCodec();

namespace {

bool acceptsJournalFindResult(const suture::SlotOptional<MomentSlot>& slot,
                              suture::FieldPath* path) {
  return isValid(slot, path);
}

bool acceptsJournalChangedEvent(const JournalChangedPayload& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

void shiftJournalLatestResult(std::int64_t& slot, suture::Duration shift) {
  slot = suture::codec::shifted(slot, shift);
}

void shiftJournalFindResult(suture::SlotOptional<MomentSlot>& slot, suture::Duration shift) {
  if (slot.present != 0) {
    shiftStamps(slot.value, shift);
  }
}

constexpr suture::CommandInfo kJournalCommands[] = {
    {.name = "put",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<JournalPutArguments>,
     .depth = 16,
     .shiftArguments = suture::shiftSlot<JournalPutArguments>},
    {.name = "count",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<JournalCountArguments>,
     .depth = 16},
    {.name = "latest",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::int64_t>,
     .depth = 16,
     .column = JournalColumn::latest,
     .shiftResult = suture::shiftSlot<std::int64_t, shiftJournalLatestResult>},
    {.name = "moments",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<MomentsSlot>,
     .depth = 16,
     .column = JournalColumn::moments,
     .acceptsResult = suture::checkSlot<MomentsSlot, isValid>,
     .shiftResult = suture::shiftSlot<MomentsSlot>},
    {.name = "find",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<JournalFindArguments>,
     .resultSize = suture::slotSize<suture::SlotOptional<MomentSlot>>,
     .depth = 16,
     .acceptsResult = suture::checkSlot<suture::SlotOptional<MomentSlot>, acceptsJournalFindResult>,
     .shiftResult = suture::shiftSlot<suture::SlotOptional<MomentSlot>, shiftJournalFindResult>},
};

void shiftJournalAddedPayload(std::int64_t& slot, suture::Duration shift) {
  slot = suture::codec::shifted(slot, shift);
}

constexpr suture::EventInfo kJournalEvents[] = {
    {.name = "added",
     .payloadSize = suture::slotSize<std::int64_t>,
     .depth = 16,
     .shiftPayload = suture::shiftSlot<std::int64_t, shiftJournalAddedPayload>},
    {.name = "changed",
     .payloadSize = suture::slotSize<JournalChangedPayload>,
     .depth = 16,
     .accepts = suture::checkSlot<JournalChangedPayload, acceptsJournalChangedEvent>,
     .shiftPayload = suture::shiftSlot<JournalChangedPayload>},
    {.name = "counted", .payloadSize = suture::slotSize<std::int64_t>, .depth = 16},
};

// The self-description, as in shapes/moments.suture.json.
constexpr char kJournalDescription[] = R"json(
{"name": "shapes::Journal",
"doc": "Right in a contract: the arguments, the results and the payloads.",
"hash": "215bbbc1b0ac4ca4c44de637ee1c347e", "commands": [{"name": "put", "kind": "write",
"ordinal": 1, "parameters": [{"name": "from", "type": {"kind": "time", "clock": "steady"}}, {
"name": "number", "type": {"kind": "Int64"}}], "queue": 16}, {"name": "count", "kind": "write",
"ordinal": 2, "parameters": [{"name": "number", "type": {"kind": "Int64"}}], "queue": 16}, {
"name": "latest", "kind": "read", "ordinal": 3, "result": {"type": {"kind": "time",
"clock": "steady"}}, "queue": 16}, {"name": "moments", "kind": "read", "ordinal": 4, "result": {
"type": {"kind": "struct", "name": "shapes::Moments"}}, "queue": 16}, {"name": "find",
"kind": "qualified read", "ordinal": 5, "parameters": [{"name": "number", "type": {"kind": "Int64"}
}], "result": {"type": {"kind": "optional", "element": {"kind": "struct", "name": "shapes::Moment"}
}}, "queue": 16}], "events": [{"name": "added", "kind": "write", "ordinal": 1, "payload": {
"type": {"kind": "time", "clock": "steady"}}, "queue": 16}, {"name": "changed", "kind": "write",
"ordinal": 2, "payload": [{"name": "value", "type": {"kind": "struct", "name": "shapes::Moment"}}, {
"name": "value2", "type": {"kind": "Int64"}}], "queue": 16}, {"name": "counted", "kind": "write",
"ordinal": 3, "payload": {"type": {"kind": "Int64"}}, "queue": 16}], "enums": [], "structs": [{
"name": "shapes::Moment", "doc": "It has a time of each clock, of which only one is shifted.",
"fields": [{"name": "steady", "type": {"kind": "time", "clock": "steady"}}, {"name": "system",
"type": {"kind": "time", "clock": "system"}}, {"name": "number", "type": {"kind": "Int64"},
"default": 0}]}, {"name": "shapes::Moments", "doc": "One in each container.", "fields": [{
"name": "pair", "type": {"kind": "array", "element": {"kind": "time", "clock": "steady"},
"length": 2}}, {"name": "list", "type": {"kind": "list", "element": {"kind": "time",
"clock": "steady"}, "capacity": 3}}, {"name": "moments", "type": {"kind": "list", "element": {
"kind": "struct", "name": "shapes::Moment"}, "capacity": 2}}, {"name": "nested", "type": {
"kind": "list", "element": {"kind": "list", "element": {"kind": "time", "clock": "steady"},
"capacity": 2}, "capacity": 2}}, {"name": "byNumber", "type": {"kind": "map", "key": {
"kind": "Int32"}, "value": {"kind": "time", "clock": "steady"}, "capacity": 2}}, {
"name": "perhaps", "type": {"kind": "optional", "element": {"kind": "time", "clock": "steady"}}}, {
"name": "moment", "type": {"kind": "optional", "element": {"kind": "struct",
"name": "shapes::Moment"}}}, {"name": "entry", "type": {"kind": "tuple", "elements": [{
"kind": "Int64"}, {"kind": "time", "clock": "steady"}, {"kind": "struct", "name": "shapes::Moment"}
]}}, {"name": "either", "type": {"kind": "variant", "alternatives": [{"kind": "Int64"}, {
"kind": "time", "clock": "steady"}, {"kind": "struct", "name": "shapes::Moment"}]}}]}], "wire": [{
"id": "@0xc3053cb224b0c85f", "kind": "interface", "name": "Journal", "cxx": "shapes::Journal",
"members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0, "name": "events",
"is": "@0xf44a38be83c21076"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2,
"name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "put", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "from", "is": "Int64 clock \"steady\""}, {"at": 1,
"name": "number", "is": "Int64"}, {"at": 2, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 2, "name": "count", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "number",
"is": "Int64"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 3,
"name": "latest", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Int64 clock \"steady\""}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 4,
"name": "moments", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xea2eb3c4e250494c"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 5, "name": "find",
"is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "number", "is": "Int64"}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "@0x808a81b58e533e44"}]}]}, {"id": "@0xf44a38be83c21076", "kind": "interface",
"name": "JournalEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xb5363f8a2843600b"}]}, {"at": 1, "name": "added", "parameters": [{"at": 0,
"name": "value", "is": "Int64 clock \"steady\""}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 2, "name": "changed", "parameters": [{"at": 0, "name": "value", "is": "@0xde2753d08ad0e07b"},
{"at": 1, "name": "value2", "is": "Int64"}, {"at": 2, "name": "stamp", "is": "Int64"}]}, {"at": 3,
"name": "counted", "parameters": [{"at": 0, "name": "value", "is": "Int64"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}]}, {"id": "@0xb5363f8a2843600b", "kind": "struct",
"name": "JournalStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "latest", "is": "Int64 clock \"steady\""}, {"at": 4, "name": "moments",
"is": "@0xea2eb3c4e250494c"}]}, {"id": "@0xea2eb3c4e250494c", "kind": "struct", "name": "Moments",
"members": [{"at": 0, "name": "pair", "is": "List(Int64) clock \"steady\" shape \"2\""}, {"at": 1,
"name": "list", "is": "List(Int64) clock \"steady\""}, {"at": 2, "name": "moments",
"is": "List(@0xde2753d08ad0e07b)"}, {"at": 3, "name": "nested",
"is": "List(List(Int64)) clock \"steady\""}, {"at": 4, "name": "byNumber",
"is": "List(@0xef7b71232d559ed6)"}, {"at": 5, "name": "perhaps", "is": "@0x86ffd776cef10d3b"}, {
"at": 6, "name": "moment", "is": "@0x808a81b58e533e44"}, {"at": 7, "name": "entry",
"is": "@0xff5b5cd02a32aa90"}, {"at": 8, "name": "either", "is": "@0xed7215ce608528ed"}]}, {
"id": "@0xde2753d08ad0e07b", "kind": "struct", "name": "Moment", "members": [{"at": 0,
"name": "steady", "is": "Int64 clock \"steady\""}, {"at": 1, "name": "system",
"is": "Int64 clock \"system\""}, {"at": 2, "name": "number", "is": "Int64"}]}, {
"id": "@0xef7b71232d559ed6", "kind": "struct", "name": "ShapesMomentsEntryOfInt32ToSteadyTime",
"members": [{"at": 0, "name": "key", "is": "Int32"}, {"at": 1, "name": "value",
"is": "Int64 clock \"steady\""}]}, {"id": "@0x86ffd776cef10d3b", "kind": "union",
"name": "ShapesMomentsOptionalSteadyTime", "members": [{"at": 0, "name": "none", "is": "Void"}, {
"at": 1, "name": "some", "is": "Int64 clock \"steady\""}]}, {"id": "@0x808a81b58e533e44",
"kind": "union", "name": "ShapesMomentsOptionalMoment", "members": [{"at": 0, "name": "none",
"is": "Void"}, {"at": 1, "name": "some", "is": "@0xde2753d08ad0e07b"}]}, {
"id": "@0xff5b5cd02a32aa90", "kind": "struct",
"name": "ShapesMomentsTupleOfInt64AndSteadyTimeAndMoment", "members": [{"at": 0, "name": "item0",
"is": "Int64"}, {"at": 1, "name": "item1", "is": "Int64 clock \"steady\""}, {"at": 2,
"name": "item2", "is": "@0xde2753d08ad0e07b"}]}, {"id": "@0xed7215ce608528ed", "kind": "union",
"name": "ShapesMomentsEitherOfInt64OrSteadyTimeOrMoment", "members": [{"at": 0, "name": "int64",
"is": "Int64"}, {"at": 1, "name": "steadyTime", "is": "Int64 clock \"steady\""}, {"at": 2,
"name": "moment", "is": "@0xde2753d08ad0e07b"}]}]})json";

}  // namespace
}  // namespace shapes

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<shapes::Journal>() {
  static constexpr InterfaceInfo kInfo{
      .name = "shapes::Journal",
      .hash = "215bbbc1b0ac4ca4c44de637ee1c347e",
      .description = shapes::kJournalDescription,
      .commands = shapes::kJournalCommands,
      .events = shapes::kJournalEvents,
      .codec = &shapes::journalCodec,
  };
  return kInfo;
}

// A function for each command of shapes::Journal, so that a stack in a debugger names it.
struct Provided<shapes::Journal>::Dispatch {
  static Errc execute_put(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<shapes::JournalPutArguments>(arguments);
    load(slot.from, scratch.put_from);
    load(slot.number, scratch.put_number);
    implementation.put(scratch.put_from, scratch.put_number);
    return Errc{};
  }

  static Errc execute_count(Contract& implementation, Scratch& scratch,
                            const std::byte* arguments) {
    const auto& slot = slotIn<shapes::JournalCountArguments>(arguments);
    load(slot.number, scratch.count_number);
    implementation.count(scratch.count_number);
    return Errc{};
  }

  static Errc execute_latest(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::int64_t>(result);
    return store(implementation.latest(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_moments(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<shapes::MomentsSlot>(result);
    return store(implementation.moments(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_find(Contract& implementation, Scratch& scratch, const std::byte* arguments,
                           std::byte* result) {
    const auto& slot = slotIn<shapes::JournalFindArguments>(arguments);
    load(slot.number, scratch.find_number);
    auto& answer = newSlot<suture::SlotOptional<shapes::MomentSlot>>(result);
    return store(implementation.find(scratch.find_number), answer) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<shapes::Journal>::execute(std::uint16_t command, const std::byte* arguments,
                                        std::byte* result) {
  using ::shapes::JournalCommand;
  switch (command) {
    case JournalCommand::put: return Dispatch::execute_put(implementation_, scratch_, arguments);
    case JournalCommand::count:
      return Dispatch::execute_count(implementation_, scratch_, arguments);
    case JournalCommand::latest: return Dispatch::execute_latest(implementation_, result);
    case JournalCommand::moments: return Dispatch::execute_moments(implementation_, result);
    case JournalCommand::find:
      return Dispatch::execute_find(implementation_, scratch_, arguments, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
