// Written by suturec from shapes/large.h. Do not edit.
#include "shapes/large.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace shapes {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(Trace::channel), std::uint32_t>);
static_assert(std::is_same_v<decltype(Trace::samples), std::vector<double>>);
static_assert(std::is_same_v<decltype(Trace::gain), double>);
static_assert(std::is_same_v<decltype(Large::first), double>);
static_assert(std::is_same_v<decltype(Large::text), std::string>);
static_assert(std::is_same_v<decltype(Large::name), std::string>);
static_assert(std::is_same_v<decltype(Large::traces), std::vector<shapes::Trace>>);
static_assert(std::is_same_v<decltype(Large::image),
                             Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic>>);
static_assert(std::is_same_v<decltype(Large::inner), Trace>);
static_assert(std::is_same_v<decltype(Large::maybe), std::optional<shapes::Trace>>);
static_assert(std::is_same_v<decltype(Large::both),
                             std::tuple<std::int8_t, shapes::Trace, std::vector<std::int64_t>>>);
static_assert(std::is_same_v<decltype(Large::gains), std::map<std::uint16_t, double>>);
static_assert(std::is_same_v<decltype(Large::pair), std::array<shapes::Trace, 2>>);
static_assert(std::is_same_v<decltype(Large::choice),
                             std::variant<std::monostate, shapes::Trace, std::vector<float>>>);
static_assert(std::is_same_v<decltype(Large::last), std::int64_t>);

}  // namespace

bool store(const Trace& value, TraceSlot& slot) {
  bool fits = true;
  fits &= store(value.channel, slot.channel);
  fits &= store(value.samples, slot.samples);
  fits &= store(value.gain, slot.gain);
  return fits;
}

void load(const TraceSlot& slot, Trace& value) {
  load(slot.channel, value.channel);
  load(slot.samples, value.samples);
  load(slot.gain, value.gain);
}

void reserve(const TraceSlot*, Trace& value) {
  suture::reserveFor<decltype(TraceSlot::samples)>(value.samples);
}

bool store(const Large& value, LargeSlot& slot) {
  bool fits = true;
  fits &= store(value.first, slot.first);
  fits &= store(value.text, slot.text);
  fits &= store(value.name, slot.name);
  fits &= store(value.traces, slot.traces);
  fits &= store(value.image, slot.image);
  fits &= store(value.inner, slot.inner);
  fits &= store(value.maybe, slot.maybe);
  fits &= store(value.both, slot.both);
  fits &= store(value.gains, slot.gains);
  fits &= store(value.pair, slot.pair);
  fits &= store(value.choice, slot.choice);
  fits &= store(value.last, slot.last);
  return fits;
}

void load(const LargeSlot& slot, Large& value) {
  load(slot.first, value.first);
  load(slot.text, value.text);
  load(slot.name, value.name);
  load(slot.traces, value.traces);
  load(slot.image, value.image);
  load(slot.inner, value.inner);
  load(slot.maybe, value.maybe);
  load(slot.both, value.both);
  load(slot.gains, value.gains);
  load(slot.pair, value.pair);
  load(slot.choice, value.choice);
  load(slot.last, value.last);
}

void reserve(const LargeSlot*, Large& value) {
  suture::reserveFor<decltype(LargeSlot::text)>(value.text);
  suture::reserveFor<decltype(LargeSlot::name)>(value.name);
  suture::reserveFor<decltype(LargeSlot::traces)>(value.traces);
  suture::reserveFor<decltype(LargeSlot::inner)>(value.inner);
  suture::reserveFor<decltype(LargeSlot::pair)>(value.pair);
}

bool store(const std::vector<double>& values, const Large& rest, RecorderKeepArguments& slot) {
  return store(values, slot.values) && store(rest, slot.rest);
}

bool store(const std::string& name, RecorderRenameArguments& slot) {
  return store(name, slot.name);
}

bool store(const std::int32_t& value, const Large& value2, RecorderSaidPayload& slot) {
  return store(value, slot.value) && store(value2, slot.value2);
}

void load(const RecorderSaidPayload& slot, std::int32_t& value, Large& value2) {
  load(slot.value, value);
  load(slot.value2, value2);
}

void reserve(const RecorderSaidPayload*, std::int32_t& /*value*/, Large& value2) {
  suture::reserveFor<decltype(RecorderSaidPayload::value2)>(value2);
}

bool isValid(const TraceSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.samples, path)) return suture::refusedAt(path, "samples");
  return isValid(slot.gain) || suture::refusedAt(path, "gain");
}

bool isValid(const LargeSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.first)) return suture::refusedAt(path, "first");
  if (!suture::allOf(slot.traces, path, [path](const TraceSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "traces");
  }
  if (!isValid(slot.image)) return suture::refusedAt(path, "image");
  if (!isValid(slot.inner, path)) return suture::refusedAt(path, "inner");
  if (!isValid(slot.maybe, path)) return suture::refusedAt(path, "maybe");
  if (!isValid(slot.both, path)) return suture::refusedAt(path, "both");
  if (!isValid(slot.gains, path)) return suture::refusedAt(path, "gains");
  if (!suture::allOf(slot.pair, path, [path](const TraceSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "pair");
  }
  return isValid(slot.choice, path) || suture::refusedAt(path, "choice");
}

// Defined in shapes/large.wire.cpp.
const suture::codec::Codec& recorderCodec();

namespace {

bool acceptsRecorderKeep(const RecorderKeepArguments& slot, suture::FieldPath* path) {
  if (!isValid(slot.values, path)) return suture::refusedAt(path, "values");
  return isValid(slot.rest, path) || suture::refusedAt(path, "rest");
}

bool acceptsRecorderSaidEvent(const RecorderSaidPayload& slot, suture::FieldPath* path) {
  return isValid(slot.value2, path) || suture::refusedAt(path, "value2");
}

constexpr suture::BoundedLevel kRecorderKeepArgumentsLevels[] = {
    suture::levelAt<suture::BoundedList<double, 64>>(offsetof(RecorderKeepArguments, values)),
    suture::levelAt<suture::BoundedText<300>>(offsetof(RecorderKeepArguments, rest.text)),
    suture::levelAt<suture::BoundedList<TraceSlot, 5>>(offsetof(RecorderKeepArguments,
                                                                rest.traces)),
    suture::levelAt<suture::BoundedMatrix<float, 20, 30>>(offsetof(RecorderKeepArguments,
                                                                   rest.image)),
    suture::levelAt<suture::BoundedList<double, 100>>(offsetof(RecorderKeepArguments,
                                                               rest.inner.samples)),
    suture::levelAt<suture::BoundedList<double, 100>>(offsetof(RecorderKeepArguments,
                                                               rest.maybe.value.samples)),
    suture::levelAt<suture::BoundedList<double, 100>>(offsetof(RecorderKeepArguments,
                                                               rest.both.tail.head.samples)),
    suture::levelAt<suture::BoundedList<std::int64_t, 40>>(offsetof(RecorderKeepArguments,
                                                                    rest.both.tail.tail.head)),
    suture::levelAt<suture::BoundedList<suture::SlotEntry<std::uint16_t, double>, 50>>(
        offsetof(RecorderKeepArguments, rest.gains)),
};

constexpr suture::BoundedLevel kRecorderKeptResultLevels[] = {
    suture::levelAt<suture::BoundedText<300>>(offsetof(LargeSlot, text)),
    suture::levelAt<suture::BoundedList<TraceSlot, 5>>(offsetof(LargeSlot, traces)),
    suture::levelAt<suture::BoundedMatrix<float, 20, 30>>(offsetof(LargeSlot, image)),
    suture::levelAt<suture::BoundedList<double, 100>>(offsetof(LargeSlot, inner.samples)),
    suture::levelAt<suture::BoundedList<double, 100>>(offsetof(LargeSlot, maybe.value.samples)),
    suture::levelAt<suture::BoundedList<double, 100>>(offsetof(LargeSlot, both.tail.head.samples)),
    suture::levelAt<suture::BoundedList<std::int64_t, 40>>(offsetof(LargeSlot,
                                                                    both.tail.tail.head)),
    suture::levelAt<suture::BoundedList<suture::SlotEntry<std::uint16_t, double>, 50>>(
        offsetof(LargeSlot, gains)),
};

constexpr suture::CommandInfo kRecorderCommands[] = {
    {.name = "keep",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<RecorderKeepArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<RecorderKeepArguments, acceptsRecorderKeep>,
     .argumentsLevels = kRecorderKeepArgumentsLevels},
    {.name = "rename",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<RecorderRenameArguments>,
     .depth = 16},
    {.name = "kept",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<LargeSlot>,
     .depth = 16,
     .column = RecorderColumn::kept,
     .acceptsResult = suture::checkSlot<LargeSlot, isValid>,
     .resultLevels = kRecorderKeptResultLevels},
};

constexpr suture::BoundedLevel kRecorderHeardPayloadLevels[] = {
    suture::levelAt<suture::BoundedList<double, 100>>(offsetof(TraceSlot, samples)),
};

constexpr suture::BoundedLevel kRecorderSaidPayloadLevels[] = {
    suture::levelAt<suture::BoundedText<300>>(offsetof(RecorderSaidPayload, value2.text)),
    suture::levelAt<suture::BoundedList<TraceSlot, 5>>(offsetof(RecorderSaidPayload,
                                                                value2.traces)),
    suture::levelAt<suture::BoundedMatrix<float, 20, 30>>(offsetof(RecorderSaidPayload,
                                                                   value2.image)),
    suture::levelAt<suture::BoundedList<double, 100>>(offsetof(RecorderSaidPayload,
                                                               value2.inner.samples)),
    suture::levelAt<suture::BoundedList<double, 100>>(offsetof(RecorderSaidPayload,
                                                               value2.maybe.value.samples)),
    suture::levelAt<suture::BoundedList<double, 100>>(offsetof(RecorderSaidPayload,
                                                               value2.both.tail.head.samples)),
    suture::levelAt<suture::BoundedList<std::int64_t, 40>>(offsetof(RecorderSaidPayload,
                                                                    value2.both.tail.tail.head)),
    suture::levelAt<suture::BoundedList<suture::SlotEntry<std::uint16_t, double>, 50>>(
        offsetof(RecorderSaidPayload, value2.gains)),
};

constexpr suture::EventInfo kRecorderEvents[] = {
    {.name = "heard",
     .payloadSize = suture::slotSize<TraceSlot>,
     .depth = 16,
     .accepts = suture::checkSlot<TraceSlot, isValid>,
     .payloadLevels = kRecorderHeardPayloadLevels},
    {.name = "said",
     .payloadSize = suture::slotSize<RecorderSaidPayload>,
     .depth = 16,
     .accepts = suture::checkSlot<RecorderSaidPayload, acceptsRecorderSaidEvent>,
     .payloadLevels = kRecorderSaidPayloadLevels},
};

// The self-description, as in shapes/large.suture.json.
constexpr char kRecorderDescription[] = R"json(
{"name": "shapes::Recorder", "doc": "Carries them as arguments, results and payloads.",
"hash": "f8caf1e8950625d22fbfe8116cc50ebc", "commands": [{"name": "keep", "kind": "write",
"ordinal": 1, "parameters": [{"name": "values", "type": {"kind": "list", "element": {
"kind": "Float64"}, "capacity": 64}}, {"name": "rest", "type": {"kind": "struct",
"name": "shapes::Large"}}], "queue": 16}, {"name": "rename", "kind": "write", "ordinal": 2,
"parameters": [{"name": "name", "type": {"kind": "text", "capacity": 8}}], "queue": 16}, {
"name": "kept", "kind": "read", "ordinal": 3, "result": {"type": {"kind": "struct",
"name": "shapes::Large"}}, "queue": 16}], "events": [{"name": "heard", "kind": "write",
"ordinal": 1, "payload": {"type": {"kind": "struct", "name": "shapes::Trace"}}, "queue": 16}, {
"name": "said", "kind": "write", "ordinal": 2, "payload": [{"name": "value", "type": {
"kind": "Int32"}}, {"name": "value2", "type": {"kind": "struct", "name": "shapes::Large"}}],
"queue": 16}], "enums": [], "structs": [{"name": "shapes::Trace",
"doc": "A list within whatever holds this.", "fields": [{"name": "channel", "type": {
"kind": "UInt32"}, "default": 0}, {"name": "samples", "type": {"kind": "list", "element": {
"kind": "Float64"}, "capacity": 100}}, {"name": "gain", "type": {"kind": "Float64"}, "default": 1.0
}]}, {"name": "shapes::Large", "doc": "A large level in each place where one can be.", "fields": [{
"name": "first", "type": {"kind": "Float64"}, "default": 0.0}, {"name": "text", "type": {
"kind": "text", "capacity": 300}}, {"name": "name", "doc": "too small to tell what is used of it",
"type": {"kind": "text", "capacity": 8}}, {"name": "traces", "type": {"kind": "list", "element": {
"kind": "struct", "name": "shapes::Trace"}, "capacity": 5}}, {"name": "image", "type": {
"kind": "any matrix", "scalar": "Float32", "capacity": [20, 30]}}, {"name": "inner", "type": {
"kind": "struct", "name": "shapes::Trace"}}, {"name": "maybe", "type": {"kind": "optional",
"element": {"kind": "struct", "name": "shapes::Trace"}}}, {"name": "both", "type": {
"kind": "tuple", "elements": [{"kind": "Int8"}, {"kind": "struct", "name": "shapes::Trace"}, {
"kind": "list", "element": {"kind": "Int64"}, "capacity": 40}]}}, {"name": "gains", "type": {
"kind": "map", "key": {"kind": "UInt16"}, "value": {"kind": "Float64"}, "capacity": 50}}, {
"name": "pair", "doc": "travels whole", "type": {"kind": "array", "element": {"kind": "struct",
"name": "shapes::Trace"}, "length": 2}}, {"name": "choice", "doc": "travels whole", "type": {
"kind": "variant", "alternatives": [{"kind": "nothing"}, {"kind": "struct", "name": "shapes::Trace"
}, {"kind": "list", "element": {"kind": "Float32"}, "capacity": 70}]}}, {"name": "last", "type": {
"kind": "Int64"}, "default": 0}]}], "wire": [{"id": "@0xedaff88b9a8c5a49", "kind": "interface",
"name": "Recorder", "cxx": "shapes::Recorder", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xb2575c70bf6c42b1"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "keep", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "values",
"is": "List(Float64)"}, {"at": 1, "name": "rest", "is": "@0x873542a36beeb5ba"}, {"at": 2,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "rename",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "name", "is": "Text"}, {"at": 1,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 3, "name": "kept", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0x873542a36beeb5ba"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xb2575c70bf6c42b1", "kind": "interface", "name": "RecorderEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xbc917f42f869eb04"}]}, {"at": 1,
"name": "heard", "parameters": [{"at": 0, "name": "value", "is": "@0xc0c3f1634ee6c87a"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "said", "parameters": [{"at": 0,
"name": "value", "is": "Int32"}, {"at": 1, "name": "value2", "is": "@0x873542a36beeb5ba"}, {
"at": 2, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xbc917f42f869eb04", "kind": "struct",
"name": "RecorderStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "kept", "is": "@0x873542a36beeb5ba"}]}, {"id": "@0x873542a36beeb5ba", "kind": "struct",
"name": "Large", "members": [{"at": 0, "name": "first", "is": "Float64"}, {"at": 1, "name": "text",
"is": "Text"}, {"at": 2, "name": "name", "is": "Text"}, {"at": 3, "name": "traces",
"is": "List(@0xc0c3f1634ee6c87a)"}, {"at": 4, "name": "image", "is": "@0xca1e0a0ee662b822"}, {
"at": 5, "name": "inner", "is": "@0xc0c3f1634ee6c87a"}, {"at": 6, "name": "maybe",
"is": "@0xc87395fec67d1a0c"}, {"at": 7, "name": "both", "is": "@0xc7ad720f0b29a7d8"}, {"at": 8,
"name": "gains", "is": "List(@0xf5be256905eaa78a)"}, {"at": 9, "name": "pair",
"is": "List(@0xc0c3f1634ee6c87a) shape \"2\""}, {"at": 10, "name": "choice",
"is": "@0xa253bae889c69fa2"}, {"at": 11, "name": "last", "is": "Int64"}]}, {
"id": "@0xc0c3f1634ee6c87a", "kind": "struct", "name": "Trace", "members": [{"at": 0,
"name": "channel", "is": "UInt32"}, {"at": 1, "name": "samples", "is": "List(Float64)"}, {"at": 2,
"name": "gain", "is": "Float64 = 1.0"}]}, {"id": "@0xca1e0a0ee662b822", "kind": "struct",
"name": "ShapesLargeAnyMatrixOfFloat32", "members": [{"at": 0, "name": "rows", "is": "UInt32"}, {
"at": 1, "name": "columns", "is": "UInt32"}, {"at": 2, "name": "data", "is": "List(Float32)"}]}, {
"id": "@0xc87395fec67d1a0c", "kind": "union", "name": "ShapesLargeOptionalTrace", "members": [{
"at": 0, "name": "none", "is": "Void"}, {"at": 1, "name": "some", "is": "@0xc0c3f1634ee6c87a"}]}, {
"id": "@0xc7ad720f0b29a7d8", "kind": "struct",
"name": "ShapesLargeTupleOfInt8AndTraceAndListOfInt64", "members": [{"at": 0, "name": "item0",
"is": "Int8"}, {"at": 1, "name": "item1", "is": "@0xc0c3f1634ee6c87a"}, {"at": 2, "name": "item2",
"is": "List(Int64)"}]}, {"id": "@0xf5be256905eaa78a", "kind": "struct",
"name": "ShapesLargeEntryOfUInt16ToFloat64", "members": [{"at": 0, "name": "key", "is": "UInt16"}, {
"at": 1, "name": "value", "is": "Float64"}]}, {"id": "@0xa253bae889c69fa2", "kind": "union",
"name": "ShapesLargeEitherOfNothingOrTraceOrListOfFloat32", "members": [{"at": 0, "name": "nothing",
"is": "Void"}, {"at": 1, "name": "trace", "is": "@0xc0c3f1634ee6c87a"}, {"at": 2,
"name": "listOfFloat32", "is": "List(Float32)"}]}]})json";

}  // namespace
}  // namespace shapes

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<shapes::Recorder>() {
  static constexpr InterfaceInfo kInfo{
      .name = "shapes::Recorder",
      .hash = "f8caf1e8950625d22fbfe8116cc50ebc",
      .description = shapes::kRecorderDescription,
      .commands = shapes::kRecorderCommands,
      .events = shapes::kRecorderEvents,
      .codec = &shapes::recorderCodec,
  };
  return kInfo;
}

auto Provided<shapes::Recorder>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(shapes::RecorderKeepArguments::values)>(scratch.keep_values);
  reserveFor<decltype(shapes::RecorderKeepArguments::rest)>(scratch.keep_rest);
  reserveFor<decltype(shapes::RecorderRenameArguments::name)>(scratch.rename_name);
  return scratch;
}

// A function for each command of shapes::Recorder, so that a stack in a debugger names it.
struct Provided<shapes::Recorder>::Dispatch {
  static Errc execute_keep(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<shapes::RecorderKeepArguments>(arguments);
    load(slot.values, scratch.keep_values);
    load(slot.rest, scratch.keep_rest);
    implementation.keep(scratch.keep_values, scratch.keep_rest);
    return Errc{};
  }

  static Errc execute_rename(Contract& implementation, Scratch& scratch,
                             const std::byte* arguments) {
    const auto& slot = slotIn<shapes::RecorderRenameArguments>(arguments);
    load(slot.name, scratch.rename_name);
    implementation.rename(scratch.rename_name);
    return Errc{};
  }

  static Errc execute_kept(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<shapes::LargeSlot>(result);
    return store(implementation.kept(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<shapes::Recorder>::execute(std::uint16_t command, const std::byte* arguments,
                                         std::byte* result) {
  using ::shapes::RecorderCommand;
  switch (command) {
    case RecorderCommand::keep: return Dispatch::execute_keep(implementation_, scratch_, arguments);
    case RecorderCommand::rename:
      return Dispatch::execute_rename(implementation_, scratch_, arguments);
    case RecorderCommand::kept: return Dispatch::execute_kept(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
