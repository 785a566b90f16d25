// Written by suturec from vision/stereo_images.h. Do not edit.
#include "vision/stereo_images.suture.h"

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
static_assert(std::is_same_v<decltype(StereoPair::left), ImageFrame>);
static_assert(std::is_same_v<decltype(StereoPair::right), ImageFrame>);

}  // namespace

bool store(const StereoPair& value, StereoPairSlot& slot) {
  bool fits = true;
  fits &= store(value.left, slot.left);
  fits &= store(value.right, slot.right);
  return fits;
}

void load(const StereoPairSlot& slot, StereoPair& value) {
  load(slot.left, value.left);
  load(slot.right, value.right);
}

void reserve(const StereoPairSlot*, StereoPair& value) {
  suture::reserveFor<decltype(StereoPairSlot::left)>(value.left);
  suture::reserveFor<decltype(StereoPairSlot::right)>(value.right);
}

void shiftStamps(StereoPairSlot& slot, suture::Duration shift) {
  shiftStamps(slot.left, shift);
  shiftStamps(slot.right, shift);
}

bool isValid(const StereoPairSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.left, path)) return suture::refusedAt(path, "left");
  return isValid(slot.right, path) || suture::refusedAt(path, "right");
}

// Defined in vision/stereo_images.wire.cpp.
const suture::codec::Codec& stereoImagesCodec();

namespace {

constexpr suture::BoundedLevel kStereoImagesImagesResultLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 2097152>>(offsetof(StereoPairSlot,
                                                                         left.data)),
    suture::levelAt<suture::BoundedList<std::uint8_t, 2097152>>(offsetof(StereoPairSlot,
                                                                         right.data)),
};

void shiftStereoImagesExposedResult(std::int64_t& slot, suture::Duration shift) {
  slot = suture::codec::shifted(slot, shift);
}

constexpr suture::CommandInfo kStereoImagesCommands[] = {
    {.name = "images",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<StereoPairSlot>,
     .depth = 16,
     .column = StereoImagesColumn::images,
     .acceptsResult = suture::checkSlot<StereoPairSlot, isValid>,
     .shiftResult = suture::shiftSlot<StereoPairSlot>,
     .resultLevels = kStereoImagesImagesResultLevels},
    {.name = "exposed",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::int64_t>,
     .depth = 16,
     .column = StereoImagesColumn::exposed,
     .shiftResult = suture::shiftSlot<std::int64_t, shiftStereoImagesExposedResult>},
};

// The self-description, as in vision/stereo_images.suture.json.
constexpr char kStereoImagesDescription[] = R"json(
{"name": "robots::StereoImages", "hash": "afed174675115ccf925dea30a59e7bd5", "commands": [{
"name": "images", "kind": "read", "ordinal": 1,
"doc": "Returns the last pair; it is not valid while there is nothing to see.", "result": {
"type": {"kind": "struct", "name": "robots::StereoPair"}}, "queue": 16}, {"name": "exposed",
"kind": "read", "ordinal": 2,
"doc": "Returns the stamp of the last pair, and 0 while there is nothing to see. A client that asks\nthis first copies megabytes only if they are new.",
"result": {"type": {"kind": "time", "clock": "steady"}}, "queue": 16}], "events": [], "enums": [],
"structs": [{"name": "robots::ImageFrame", "doc": "Corresponds to cisst's prmImageFrame.",
"fields": [{"name": "width", "type": {"kind": "UInt32"}, "default": 0}, {"name": "height", "type": {
"kind": "UInt32"}, "default": 0}, {"name": "channels", "type": {"kind": "UInt32"}, "default": 0}, {
"name": "data", "doc": "Goes row by row, channels interleaved, 8 bits each.", "type": {
"kind": "list", "element": {"kind": "UInt8"}, "capacity": 2097152}}, {"name": "stamp", "type": {
"kind": "time", "clock": "steady"}}, {"name": "valid", "type": {"kind": "Bool"}, "default": false}]
}, {"name": "robots::StereoPair",
"doc": "Holds two rectified images of one moment; both stamps are that of the exposure.",
"fields": [{"name": "left", "type": {"kind": "struct", "name": "robots::ImageFrame"}}, {
"name": "right", "type": {"kind": "struct", "name": "robots::ImageFrame"}}]}], "wire": [{
"id": "@0xefa57eee714fcf37", "kind": "interface", "name": "StereoImages",
"cxx": "robots::StereoImages", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xed57a378bacd9ffb"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "images", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xc5ad7542a285d330"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 2, "name": "exposed", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Int64 clock \"steady\""}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xed57a378bacd9ffb", "kind": "interface", "name": "StereoImagesEvents", "members": [{
"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xe5a2d9c7d98a1e0c"}]}]},
{"id": "@0xe5a2d9c7d98a1e0c", "kind": "struct", "name": "StereoImagesStateRow", "members": [{
"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "images", "is": "@0xc5ad7542a285d330"}, {
"at": 4, "name": "exposed", "is": "Int64 clock \"steady\""}]}, {"id": "@0xc5ad7542a285d330",
"kind": "struct", "name": "StereoPair", "members": [{"at": 0, "name": "left",
"is": "@0xbc8f68d82913b3fb"}, {"at": 1, "name": "right", "is": "@0xbc8f68d82913b3fb"}]}, {
"id": "@0xbc8f68d82913b3fb", "kind": "struct", "name": "ImageFrame", "members": [{"at": 0,
"name": "width", "is": "UInt32"}, {"at": 1, "name": "height", "is": "UInt32"}, {"at": 2,
"name": "channels", "is": "UInt32"}, {"at": 3, "name": "data", "is": "Data"}, {"at": 4,
"name": "stamp", "is": "Int64 clock \"steady\""}, {"at": 5, "name": "valid", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::StereoImages>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::StereoImages",
      .hash = "afed174675115ccf925dea30a59e7bd5",
      .description = robots::kStereoImagesDescription,
      .commands = robots::kStereoImagesCommands,
      .events = {},
      .codec = &robots::stereoImagesCodec,
  };
  return kInfo;
}

// A function for each command of robots::StereoImages, so that a stack in a debugger names it.
struct Provided<robots::StereoImages>::Dispatch {
  static Errc execute_images(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::StereoPairSlot>(result);
    return store(implementation.images(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_exposed(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::int64_t>(result);
    return store(implementation.exposed(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::StereoImages>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                             std::byte* result) {
  using ::robots::StereoImagesCommand;
  switch (command) {
    case StereoImagesCommand::images: return Dispatch::execute_images(implementation_, result);
    case StereoImagesCommand::exposed: return Dispatch::execute_exposed(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
