// Written by suturec from unit/large_values/canvas.h. Do not edit.
#include "unit/large_values/canvas.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace large_values {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(Dot::shade), std::uint8_t>);
static_assert(std::is_same_v<decltype(Dots::dots), std::vector<large_values::Dot>>);

}  // namespace

bool store(const Dot& value, DotSlot& slot) {
  bool fits = true;
  fits &= store(value.shade, slot.shade);
  return fits;
}

void load(const DotSlot& slot, Dot& value) {
  load(slot.shade, value.shade);
}

bool store(const Dots& value, DotsSlot& slot) {
  bool fits = true;
  fits &= store(value.dots, slot.dots);
  return fits;
}

void load(const DotsSlot& slot, Dots& value) {
  load(slot.dots, value.dots);
}

void reserve(const DotsSlot*, Dots& value) {
  suture::reserveFor<decltype(DotsSlot::dots)>(value.dots);
}

bool store(const std::uint32_t& dots, CanvasResizeArguments& slot) {
  return store(dots, slot.dots);
}

bool store(const Dots& dots, CanvasPaintArguments& slot) { return store(dots, slot.dots); }

bool store(const std::uint32_t& dots, CanvasCopyArguments& slot) { return store(dots, slot.dots); }

bool isValid(const DotSlot&, suture::FieldPath*) {
  return true;
}

bool isValid(const DotsSlot& slot, suture::FieldPath* path) {
  if (!suture::allOf(slot.dots, path, [path](const DotSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "dots");
  }
  return true;
}

// Defined in unit/large_values/canvas.wire.cpp.
const suture::codec::Codec& canvasCodec();

namespace {

bool acceptsCanvasPaint(const CanvasPaintArguments& slot, suture::FieldPath* path) {
  return isValid(slot.dots, path) || suture::refusedAt(path, "dots");
}

constexpr suture::BoundedLevel kCanvasPaintArgumentsLevels[] = {
    suture::levelAt<suture::BoundedList<DotSlot, 2500000>>(offsetof(CanvasPaintArguments,
                                                                    dots.dots)),
};

constexpr suture::BoundedLevel kCanvasPaintingResultLevels[] = {
    suture::levelAt<suture::BoundedList<DotSlot, 2500000>>(offsetof(DotsSlot, dots)),
};

constexpr suture::BoundedLevel kCanvasCopyResultLevels[] = {
    suture::levelAt<suture::BoundedList<DotSlot, 2500000>>(offsetof(DotsSlot, dots)),
};

constexpr suture::CommandInfo kCanvasCommands[] = {
    {.name = "resize",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<CanvasResizeArguments>,
     .depth = 16},
    {.name = "paint",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<CanvasPaintArguments>,
     .depth = 2,
     .accepts = suture::checkSlot<CanvasPaintArguments, acceptsCanvasPaint>,
     .argumentsLevels = kCanvasPaintArgumentsLevels},
    {.name = "painting",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<DotsSlot>,
     .depth = 16,
     .column = CanvasColumn::painting,
     .acceptsResult = suture::checkSlot<DotsSlot, isValid>,
     .resultLevels = kCanvasPaintingResultLevels},
    {.name = "copy",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<CanvasCopyArguments>,
     .resultSize = suture::slotSize<DotsSlot>,
     .depth = 16,
     .acceptsResult = suture::checkSlot<DotsSlot, isValid>,
     .resultLevels = kCanvasCopyResultLevels},
};

constexpr suture::BoundedLevel kCanvasPaintedPayloadLevels[] = {
    suture::levelAt<suture::BoundedList<DotSlot, 2500000>>(offsetof(DotsSlot, dots)),
};

constexpr suture::EventInfo kCanvasEvents[] = {
    {.name = "painted",
     .payloadSize = suture::slotSize<DotsSlot>,
     .depth = 2,
     .accepts = suture::checkSlot<DotsSlot, isValid>,
     .payloadLevels = kCanvasPaintedPayloadLevels},
};

// The self-description, as in unit/large_values/canvas.suture.json.
constexpr char kCanvasDescription[] = R"json(
{"name": "large_values::Canvas", "hash": "9f84fdb8500654c697500618dc0f7c6e", "commands": [{
"name": "resize", "kind": "write", "ordinal": 1, "doc": "Makes a painting of so many dots.",
"parameters": [{"name": "dots", "type": {"kind": "UInt32"}}], "queue": 16}, {"name": "paint",
"kind": "write", "ordinal": 2, "parameters": [{"name": "dots", "type": {"kind": "struct",
"name": "large_values::Dots"}}], "queue": 2}, {"name": "painting", "kind": "read", "ordinal": 3,
"result": {"type": {"kind": "struct", "name": "large_values::Dots"}}, "queue": 16}, {
"name": "copy", "kind": "qualified read", "ordinal": 4, "parameters": [{"name": "dots", "type": {
"kind": "UInt32"}}], "result": {"type": {"kind": "struct", "name": "large_values::Dots"}},
"queue": 16}], "events": [{"name": "painted", "kind": "write", "ordinal": 1, "payload": {"type": {
"kind": "struct", "name": "large_values::Dots"}}, "queue": 2}], "enums": [], "structs": [{
"name": "large_values::Dot", "fields": [{"name": "shade", "type": {"kind": "UInt8"}, "default": 0}]
}, {"name": "large_values::Dots", "fields": [{"name": "dots", "type": {"kind": "list", "element": {
"kind": "struct", "name": "large_values::Dot"}, "capacity": 2500000}}]}], "wire": [{
"id": "@0xc159bcffb8adc514", "kind": "interface", "name": "Canvas", "cxx": "large_values::Canvas",
"members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0, "name": "events",
"is": "@0xce5d1a720715af93"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2,
"name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "resize", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "dots", "is": "UInt32"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "paint", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "dots", "is": "@0x965fb8c5e0caec3b"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 3, "name": "painting", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0x965fb8c5e0caec3b"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 4, "name": "copy", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "dots",
"is": "UInt32"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0x965fb8c5e0caec3b"}]}]}, {"id": "@0xce5d1a720715af93",
"kind": "interface", "name": "CanvasEvents", "members": [{"at": 0, "name": "state", "parameters": [
{"at": 0, "name": "row", "is": "@0xc0b6e93694d3278a"}]}, {"at": 1, "name": "painted",
"parameters": [{"at": 0, "name": "value", "is": "@0x965fb8c5e0caec3b"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}]}, {"id": "@0xc0b6e93694d3278a", "kind": "struct", "name": "CanvasStateRow",
"members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"
}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "painting",
"is": "@0x965fb8c5e0caec3b"}]}, {"id": "@0x965fb8c5e0caec3b", "kind": "struct", "name": "Dots",
"members": [{"at": 0, "name": "dots", "is": "List(@0xc7cc6c4fbf707416)"}]}, {
"id": "@0xc7cc6c4fbf707416", "kind": "struct", "name": "Dot", "members": [{"at": 0, "name": "shade",
"is": "UInt8"}]}]})json";

}  // namespace
}  // namespace large_values

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<large_values::Canvas>() {
  static constexpr InterfaceInfo kInfo{
      .name = "large_values::Canvas",
      .hash = "9f84fdb8500654c697500618dc0f7c6e",
      .description = large_values::kCanvasDescription,
      .commands = large_values::kCanvasCommands,
      .events = large_values::kCanvasEvents,
      .codec = &large_values::canvasCodec,
  };
  return kInfo;
}

auto Provided<large_values::Canvas>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(large_values::CanvasPaintArguments::dots)>(scratch.paint_dots);
  return scratch;
}

// A function for each command of large_values::Canvas, so that a stack in a debugger names it.
struct Provided<large_values::Canvas>::Dispatch {
  static Errc execute_resize(Contract& implementation, Scratch& scratch,
                             const std::byte* arguments) {
    const auto& slot = slotIn<large_values::CanvasResizeArguments>(arguments);
    load(slot.dots, scratch.resize_dots);
    implementation.resize(scratch.resize_dots);
    return Errc{};
  }

  static Errc execute_paint(Contract& implementation, Scratch& scratch,
                            const std::byte* arguments) {
    const auto& slot = slotIn<large_values::CanvasPaintArguments>(arguments);
    load(slot.dots, scratch.paint_dots);
    implementation.paint(scratch.paint_dots);
    return Errc{};
  }

  static Errc execute_painting(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<large_values::DotsSlot>(result);
    return store(implementation.painting(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_copy(Contract& implementation, Scratch& scratch, const std::byte* arguments,
                           std::byte* result) {
    const auto& slot = slotIn<large_values::CanvasCopyArguments>(arguments);
    load(slot.dots, scratch.copy_dots);
    auto& answer = newSlot<large_values::DotsSlot>(result);
    return store(implementation.copy(scratch.copy_dots), answer) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<large_values::Canvas>::execute(std::uint16_t command, const std::byte* arguments,
                                             std::byte* result) {
  using ::large_values::CanvasCommand;
  switch (command) {
    case CanvasCommand::resize:
      return Dispatch::execute_resize(implementation_, scratch_, arguments);
    case CanvasCommand::paint: return Dispatch::execute_paint(implementation_, scratch_, arguments);
    case CanvasCommand::painting: return Dispatch::execute_painting(implementation_, result);
    case CanvasCommand::copy:
      return Dispatch::execute_copy(implementation_, scratch_, arguments, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
