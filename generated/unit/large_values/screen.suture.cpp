// Written by suturec from unit/large_values/screen.h. Do not edit.
#include "unit/large_values/screen.suture.h"

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
static_assert(std::is_same_v<decltype(Frame::number), std::uint32_t>);
static_assert(std::is_same_v<decltype(Frame::pixels), std::vector<std::uint8_t>>);
static_assert(std::is_same_v<decltype(FramePair::left), Frame>);
static_assert(std::is_same_v<decltype(FramePair::right), Frame>);

}  // namespace

bool store(const Frame& value, FrameSlot& slot) {
  bool fits = true;
  fits &= store(value.number, slot.number);
  fits &= store(value.pixels, slot.pixels);
  return fits;
}

void load(const FrameSlot& slot, Frame& value) {
  load(slot.number, value.number);
  load(slot.pixels, value.pixels);
}

void reserve(const FrameSlot*, Frame& value) {
  suture::reserveFor<decltype(FrameSlot::pixels)>(value.pixels);
}

bool store(const FramePair& value, FramePairSlot& slot) {
  bool fits = true;
  fits &= store(value.left, slot.left);
  fits &= store(value.right, slot.right);
  return fits;
}

void load(const FramePairSlot& slot, FramePair& value) {
  load(slot.left, value.left);
  load(slot.right, value.right);
}

void reserve(const FramePairSlot*, FramePair& value) {
  suture::reserveFor<decltype(FramePairSlot::left)>(value.left);
  suture::reserveFor<decltype(FramePairSlot::right)>(value.right);
}

bool store(const Frame& frame, ScreenShowArguments& slot) { return store(frame, slot.frame); }

bool store(const Frame& frame, ScreenReplaceArguments& slot) { return store(frame, slot.frame); }

bool store(const FramePair& frames, ScreenShowBothArguments& slot) {
  return store(frames, slot.frames);
}

bool isValid(const FrameSlot& slot, suture::FieldPath* path) {
  if (!suture::allOf(slot.pixels, path, [](const std::uint8_t& element) {
    return suture::inRange(element, 0, 200);
  })) {
    return suture::refusedAt(path, "pixels");
  }
  return true;
}

bool isValid(const FramePairSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.left, path)) return suture::refusedAt(path, "left");
  return isValid(slot.right, path) || suture::refusedAt(path, "right");
}

// Defined in unit/large_values/screen.wire.cpp.
const suture::codec::Codec& screenCodec();

namespace {

bool acceptsScreenShow(const ScreenShowArguments& slot, suture::FieldPath* path) {
  return isValid(slot.frame, path) || suture::refusedAt(path, "frame");
}

bool acceptsScreenReplace(const ScreenReplaceArguments& slot, suture::FieldPath* path) {
  return isValid(slot.frame, path) || suture::refusedAt(path, "frame");
}

bool acceptsScreenShowBoth(const ScreenShowBothArguments& slot, suture::FieldPath* path) {
  return isValid(slot.frames, path) || suture::refusedAt(path, "frames");
}

constexpr suture::BoundedLevel kScreenShowArgumentsLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 65536>>(offsetof(ScreenShowArguments,
                                                                       frame.pixels)),
};

constexpr suture::BoundedLevel kScreenReplaceArgumentsLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 65536>>(offsetof(ScreenReplaceArguments,
                                                                       frame.pixels)),
};

constexpr suture::BoundedLevel kScreenShowBothArgumentsLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 65536>>(offsetof(ScreenShowBothArguments,
                                                                       frames.left.pixels)),
    suture::levelAt<suture::BoundedList<std::uint8_t, 65536>>(offsetof(ScreenShowBothArguments,
                                                                       frames.right.pixels)),
};

constexpr suture::CommandInfo kScreenCommands[] = {
    {.name = "show",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ScreenShowArguments>,
     .depth = 3,
     .accepts = suture::checkSlot<ScreenShowArguments, acceptsScreenShow>,
     .argumentsLevels = kScreenShowArgumentsLevels},
    {.name = "replace",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ScreenReplaceArguments>,
     .depth = 16,
     .latest = true,
     .accepts = suture::checkSlot<ScreenReplaceArguments, acceptsScreenReplace>,
     .argumentsLevels = kScreenReplaceArgumentsLevels},
    {.name = "show_both",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ScreenShowBothArguments>,
     .depth = 3,
     .accepts = suture::checkSlot<ScreenShowBothArguments, acceptsScreenShowBoth>,
     .argumentsLevels = kScreenShowBothArgumentsLevels},
};

constexpr suture::BoundedLevel kScreenShownPayloadLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 65536>>(offsetof(FrameSlot, pixels)),
};

constexpr suture::BoundedLevel kScreenNewestPayloadLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 65536>>(offsetof(FrameSlot, pixels)),
};

constexpr suture::BoundedLevel kScreenBothPayloadLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 65536>>(offsetof(FramePairSlot, left.pixels)),
    suture::levelAt<suture::BoundedList<std::uint8_t, 65536>>(offsetof(FramePairSlot,
                                                                       right.pixels)),
};

constexpr suture::EventInfo kScreenEvents[] = {
    {.name = "shown",
     .payloadSize = suture::slotSize<FrameSlot>,
     .depth = 3,
     .accepts = suture::checkSlot<FrameSlot, isValid>,
     .payloadLevels = kScreenShownPayloadLevels},
    {.name = "newest",
     .payloadSize = suture::slotSize<FrameSlot>,
     .depth = 16,
     .latest = true,
     .accepts = suture::checkSlot<FrameSlot, isValid>,
     .payloadLevels = kScreenNewestPayloadLevels},
    {.name = "both",
     .payloadSize = suture::slotSize<FramePairSlot>,
     .depth = 3,
     .accepts = suture::checkSlot<FramePairSlot, isValid>,
     .payloadLevels = kScreenBothPayloadLevels},
};

// The self-description, as in unit/large_values/screen.suture.json.
constexpr char kScreenDescription[] = R"json(
{"name": "large_values::Screen", "hash": "5df8f2edd6a89bfba20acc1de5b9dfd1", "commands": [{
"name": "show", "kind": "write", "ordinal": 1, "parameters": [{"name": "frame", "type": {
"kind": "struct", "name": "large_values::Frame"}}], "queue": 3}, {"name": "replace",
"kind": "write", "ordinal": 2, "parameters": [{"name": "frame", "type": {"kind": "struct",
"name": "large_values::Frame"}}], "queue": 16, "latest": true}, {"name": "show_both",
"kind": "write", "ordinal": 3, "wire": "showBoth", "parameters": [{"name": "frames", "type": {
"kind": "struct", "name": "large_values::FramePair"}}], "queue": 3}], "events": [{"name": "shown",
"kind": "write", "ordinal": 1, "payload": {"type": {"kind": "struct", "name": "large_values::Frame"
}}, "queue": 3}, {"name": "newest", "kind": "write", "ordinal": 2, "payload": {"type": {
"kind": "struct", "name": "large_values::Frame"}}, "queue": 16, "latest": true}, {"name": "both",
"kind": "write", "ordinal": 3, "payload": {"type": {"kind": "struct",
"name": "large_values::FramePair"}}, "queue": 3}], "enums": [], "structs": [{
"name": "large_values::Frame", "fields": [{"name": "number", "type": {"kind": "UInt32"},
"default": 0}, {"name": "pixels", "type": {"kind": "list", "element": {"kind": "UInt8"},
"capacity": 65536}, "range": [0.0, 200.0]}]}, {"name": "large_values::FramePair", "fields": [{
"name": "left", "type": {"kind": "struct", "name": "large_values::Frame"}}, {"name": "right",
"type": {"kind": "struct", "name": "large_values::Frame"}}]}], "wire": [{
"id": "@0xc6cf87c524457ca0", "kind": "interface", "name": "Screen", "cxx": "large_values::Screen",
"members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0, "name": "events",
"is": "@0xdb6f463c88c3a4fb"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2,
"name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "show", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "frame", "is": "@0xc35c3807be9e6ef2"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "replace", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "frame", "is": "@0xc35c3807be9e6ef2"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 3, "name": "showBoth", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "frames", "is": "@0xc85bb3e3872ae443"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}]}, {"id": "@0xdb6f463c88c3a4fb", "kind": "interface",
"name": "ScreenEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0x9c4e37e1739c0304"}]}, {"at": 1, "name": "shown", "parameters": [{"at": 0,
"name": "value", "is": "@0xc35c3807be9e6ef2"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 2, "name": "newest", "parameters": [{"at": 0, "name": "value", "is": "@0xc35c3807be9e6ef2"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 3, "name": "both", "parameters": [{"at": 0,
"name": "value", "is": "@0xc85bb3e3872ae443"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0x9c4e37e1739c0304", "kind": "struct", "name": "ScreenStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}]}, {"id": "@0xc35c3807be9e6ef2", "kind": "struct",
"name": "Frame", "members": [{"at": 0, "name": "number", "is": "UInt32"}, {"at": 1,
"name": "pixels", "is": "Data"}]}, {"id": "@0xc85bb3e3872ae443", "kind": "struct",
"name": "FramePair", "members": [{"at": 0, "name": "left", "is": "@0xc35c3807be9e6ef2"}, {"at": 1,
"name": "right", "is": "@0xc35c3807be9e6ef2"}]}]})json";

}  // namespace
}  // namespace large_values

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<large_values::Screen>() {
  static constexpr InterfaceInfo kInfo{
      .name = "large_values::Screen",
      .hash = "5df8f2edd6a89bfba20acc1de5b9dfd1",
      .description = large_values::kScreenDescription,
      .commands = large_values::kScreenCommands,
      .events = large_values::kScreenEvents,
      .codec = &large_values::screenCodec,
  };
  return kInfo;
}

auto Provided<large_values::Screen>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(large_values::ScreenShowArguments::frame)>(scratch.show_frame);
  reserveFor<decltype(large_values::ScreenReplaceArguments::frame)>(scratch.replace_frame);
  reserveFor<decltype(large_values::ScreenShowBothArguments::frames)>(scratch.show_both_frames);
  return scratch;
}

// A function for each command of large_values::Screen, so that a stack in a debugger names it.
struct Provided<large_values::Screen>::Dispatch {
  static Errc execute_show(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<large_values::ScreenShowArguments>(arguments);
    load(slot.frame, scratch.show_frame);
    implementation.show(scratch.show_frame);
    return Errc{};
  }

  static Errc execute_replace(Contract& implementation, Scratch& scratch,
                              const std::byte* arguments) {
    const auto& slot = slotIn<large_values::ScreenReplaceArguments>(arguments);
    load(slot.frame, scratch.replace_frame);
    implementation.replace(scratch.replace_frame);
    return Errc{};
  }

  static Errc execute_show_both(Contract& implementation, Scratch& scratch,
                                const std::byte* arguments) {
    const auto& slot = slotIn<large_values::ScreenShowBothArguments>(arguments);
    load(slot.frames, scratch.show_both_frames);
    implementation.show_both(scratch.show_both_frames);
    return Errc{};
  }
};

Errc Provided<large_values::Screen>::execute(std::uint16_t command, const std::byte* arguments,
                                             std::byte* /*result*/) {
  using ::large_values::ScreenCommand;
  switch (command) {
    case ScreenCommand::show: return Dispatch::execute_show(implementation_, scratch_, arguments);
    case ScreenCommand::replace:
      return Dispatch::execute_replace(implementation_, scratch_, arguments);
    case ScreenCommand::show_both:
      return Dispatch::execute_show_both(implementation_, scratch_, arguments);
  }
  return Errc::Invalid;
}

}  // namespace suture
