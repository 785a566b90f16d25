// Written by suturec from unit/large_values/picture.h. Do not edit.
#include "unit/large_values/picture.suture.h"

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
static_assert(std::is_same_v<decltype(Picture::pixels), std::vector<std::uint8_t>>);

}  // namespace

bool store(const Picture& value, PictureSlot& slot) {
  bool fits = true;
  fits &= store(value.pixels, slot.pixels);
  return fits;
}

void load(const PictureSlot& slot, Picture& value) {
  load(slot.pixels, value.pixels);
}

void reserve(const PictureSlot*, Picture& value) {
  suture::reserveFor<decltype(PictureSlot::pixels)>(value.pixels);
}

bool store(const Picture& picture, GalleryDimmedArguments& slot) {
  return store(picture, slot.picture);
}

bool store(const Picture& picture, GalleryHangArguments& slot) {
  return store(picture, slot.picture);
}

bool isValid(const PictureSlot&, suture::FieldPath*) {
  return true;
}

// Defined in unit/large_values/picture.wire.cpp.
const suture::codec::Codec& galleryCodec();

namespace {

bool acceptsGalleryDimmed(const GalleryDimmedArguments& slot, suture::FieldPath* path) {
  return isValid(slot.picture, path) || suture::refusedAt(path, "picture");
}

bool acceptsGalleryHang(const GalleryHangArguments& slot, suture::FieldPath* path) {
  return isValid(slot.picture, path) || suture::refusedAt(path, "picture");
}

constexpr suture::BoundedLevel kGalleryNewestResultLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 1048576>>(offsetof(PictureSlot, pixels)),
};

constexpr suture::BoundedLevel kGalleryOldestResultLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 1048576>>(offsetof(PictureSlot, pixels)),
};

constexpr suture::BoundedLevel kGalleryDimmedArgumentsLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 1048576>>(offsetof(GalleryDimmedArguments,
                                                                         picture.pixels)),
};

constexpr suture::BoundedLevel kGalleryDimmedResultLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 1048576>>(offsetof(PictureSlot, pixels)),
};

constexpr suture::BoundedLevel kGalleryHangArgumentsLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 1048576>>(offsetof(GalleryHangArguments,
                                                                         picture.pixels)),
};

constexpr suture::CommandInfo kGalleryCommands[] = {
    {.name = "newest",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PictureSlot>,
     .depth = 16,
     .column = GalleryColumn::newest,
     .acceptsResult = suture::checkSlot<PictureSlot, isValid>,
     .resultLevels = kGalleryNewestResultLevels},
    {.name = "oldest",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PictureSlot>,
     .depth = 16,
     .column = GalleryColumn::oldest,
     .acceptsResult = suture::checkSlot<PictureSlot, isValid>,
     .resultLevels = kGalleryOldestResultLevels},
    {.name = "dimmed",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<GalleryDimmedArguments>,
     .resultSize = suture::slotSize<PictureSlot>,
     .depth = 16,
     .accepts = suture::checkSlot<GalleryDimmedArguments, acceptsGalleryDimmed>,
     .acceptsResult = suture::checkSlot<PictureSlot, isValid>,
     .argumentsLevels = kGalleryDimmedArgumentsLevels,
     .resultLevels = kGalleryDimmedResultLevels},
    {.name = "hang",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<GalleryHangArguments>,
     .depth = 2,
     .accepts = suture::checkSlot<GalleryHangArguments, acceptsGalleryHang>,
     .argumentsLevels = kGalleryHangArgumentsLevels},
};

constexpr suture::BoundedLevel kGalleryHungPayloadLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 1048576>>(offsetof(PictureSlot, pixels)),
};

constexpr suture::EventInfo kGalleryEvents[] = {
    {.name = "hung",
     .payloadSize = suture::slotSize<PictureSlot>,
     .depth = 16,
     .latest = true,
     .accepts = suture::checkSlot<PictureSlot, isValid>,
     .payloadLevels = kGalleryHungPayloadLevels},
};

// The self-description, as in unit/large_values/picture.suture.json.
constexpr char kGalleryDescription[] = R"json(
{"name": "large_values::Gallery", "hash": "a771e30828cbea86cffdd8ee6844256a", "commands": [{
"name": "newest", "kind": "read", "ordinal": 1, "result": {"type": {"kind": "struct",
"name": "large_values::Picture"}}, "queue": 16}, {"name": "oldest", "kind": "read", "ordinal": 2,
"result": {"type": {"kind": "struct", "name": "large_values::Picture"}}, "queue": 16}, {
"name": "dimmed", "kind": "qualified read", "ordinal": 3, "parameters": [{"name": "picture",
"type": {"kind": "struct", "name": "large_values::Picture"}}], "result": {"type": {
"kind": "struct", "name": "large_values::Picture"}}, "queue": 16}, {"name": "hang", "kind": "write",
"ordinal": 4, "parameters": [{"name": "picture", "type": {"kind": "struct",
"name": "large_values::Picture"}}], "queue": 2}], "events": [{"name": "hung", "kind": "write",
"ordinal": 1, "payload": {"type": {"kind": "struct", "name": "large_values::Picture"}}, "queue": 16,
"latest": true}], "enums": [], "structs": [{"name": "large_values::Picture", "fields": [{
"name": "pixels", "type": {"kind": "list", "element": {"kind": "UInt8"}, "capacity": 1048576}}]}],
"wire": [{"id": "@0x8fb9bfa9541b2aa5", "kind": "interface", "name": "Gallery",
"cxx": "large_values::Gallery", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xc01f74a8ea49ad06"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "newest", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xe2f1b542ae737d95"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 2, "name": "oldest", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xe2f1b542ae737d95"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 3, "name": "dimmed",
"is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "picture",
"is": "@0xe2f1b542ae737d95"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xe2f1b542ae737d95"}]}, {"at": 4, "name": "hang",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "picture", "is": "@0xe2f1b542ae737d95"}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}]}, {"id": "@0xc01f74a8ea49ad06",
"kind": "interface", "name": "GalleryEvents", "members": [{"at": 0, "name": "state", "parameters": [
{"at": 0, "name": "row", "is": "@0xca1846eae9ffa1ee"}]}, {"at": 1, "name": "hung", "parameters": [{
"at": 0, "name": "value", "is": "@0xe2f1b542ae737d95"}, {"at": 1, "name": "stamp", "is": "Int64"}]}
]}, {"id": "@0xca1846eae9ffa1ee", "kind": "struct", "name": "GalleryStateRow", "members": [{
"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "newest", "is": "@0xe2f1b542ae737d95"}, {
"at": 4, "name": "oldest", "is": "@0xe2f1b542ae737d95"}]}, {"id": "@0xe2f1b542ae737d95",
"kind": "struct", "name": "Picture", "members": [{"at": 0, "name": "pixels", "is": "Data"}]}]})json";

}  // namespace
}  // namespace large_values

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<large_values::Gallery>() {
  static constexpr InterfaceInfo kInfo{
      .name = "large_values::Gallery",
      .hash = "a771e30828cbea86cffdd8ee6844256a",
      .description = large_values::kGalleryDescription,
      .commands = large_values::kGalleryCommands,
      .events = large_values::kGalleryEvents,
      .codec = &large_values::galleryCodec,
  };
  return kInfo;
}

auto Provided<large_values::Gallery>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(large_values::GalleryDimmedArguments::picture)>(scratch.dimmed_picture);
  reserveFor<decltype(large_values::GalleryHangArguments::picture)>(scratch.hang_picture);
  return scratch;
}

// A function for each command of large_values::Gallery, so that a stack in a debugger names it.
struct Provided<large_values::Gallery>::Dispatch {
  static Errc execute_newest(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<large_values::PictureSlot>(result);
    return store(implementation.newest(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_oldest(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<large_values::PictureSlot>(result);
    return store(implementation.oldest(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_dimmed(Contract& implementation, Scratch& scratch, const std::byte* arguments,
                             std::byte* result) {
    const auto& slot = slotIn<large_values::GalleryDimmedArguments>(arguments);
    load(slot.picture, scratch.dimmed_picture);
    auto& answer = newSlot<large_values::PictureSlot>(result);
    return store(implementation.dimmed(scratch.dimmed_picture), answer) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_hang(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<large_values::GalleryHangArguments>(arguments);
    load(slot.picture, scratch.hang_picture);
    implementation.hang(scratch.hang_picture);
    return Errc{};
  }
};

Errc Provided<large_values::Gallery>::execute(std::uint16_t command, const std::byte* arguments,
                                              std::byte* result) {
  using ::large_values::GalleryCommand;
  switch (command) {
    case GalleryCommand::newest: return Dispatch::execute_newest(implementation_, result);
    case GalleryCommand::oldest: return Dispatch::execute_oldest(implementation_, result);
    case GalleryCommand::dimmed:
      return Dispatch::execute_dimmed(implementation_, scratch_, arguments, result);
    case GalleryCommand::hang: return Dispatch::execute_hang(implementation_, scratch_, arguments);
  }
  return Errc::Invalid;
}

}  // namespace suture
