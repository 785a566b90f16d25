// Written by suturec from unit/large_values/hall.h. Do not edit.
#include "unit/large_values/hall.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace large_values {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const Picture& picture, HallFillArguments& slot) { return store(picture, slot.picture); }

// Defined in unit/large_values/hall.wire.cpp.
const suture::codec::Codec& hallCodec();

namespace {

bool acceptsHallFill(const HallFillArguments& slot, suture::FieldPath* path) {
  return isValid(slot.picture, path) || suture::refusedAt(path, "picture");
}

constexpr suture::BoundedLevel kHallFillArgumentsLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 1048576>>(offsetof(HallFillArguments,
                                                                         picture.pixels)),
};

constexpr suture::CommandInfo kHallCommands[] = {
    {.name = "fill",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<HallFillArguments>,
     .depth = 2000,
     .accepts = suture::checkSlot<HallFillArguments, acceptsHallFill>,
     .argumentsLevels = kHallFillArgumentsLevels},
};

// The self-description, as in unit/large_values/hall.suture.json.
constexpr char kHallDescription[] = R"json(
{"name": "large_values::Hall", "hash": "090264ebb46971b75f0626cfd944fb87", "commands": [{
"name": "fill", "kind": "write", "ordinal": 1, "parameters": [{"name": "picture", "type": {
"kind": "struct", "name": "large_values::Picture"}}], "queue": 2000}], "events": [], "enums": [],
"structs": [{"name": "large_values::Picture", "fields": [{"name": "pixels", "type": {
"kind": "list", "element": {"kind": "UInt8"}, "capacity": 1048576}}]}], "wire": [{
"id": "@0xe68070b1d5e11ac8", "kind": "interface", "name": "Hall", "cxx": "large_values::Hall",
"members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0, "name": "events",
"is": "@0x98f03f3ca3726066"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2,
"name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "fill", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "picture", "is": "@0xe2f1b542ae737d95"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}]}, {"id": "@0x98f03f3ca3726066", "kind": "interface",
"name": "HallEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row",
"is": "@0xea33b916749bc050"}]}]}, {"id": "@0xea33b916749bc050", "kind": "struct",
"name": "HallStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}]}, {
"id": "@0xe2f1b542ae737d95", "kind": "struct", "name": "Picture", "members": [{"at": 0,
"name": "pixels", "is": "Data"}]}]})json";

}  // namespace
}  // namespace large_values

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<large_values::Hall>() {
  static constexpr InterfaceInfo kInfo{
      .name = "large_values::Hall",
      .hash = "090264ebb46971b75f0626cfd944fb87",
      .description = large_values::kHallDescription,
      .commands = large_values::kHallCommands,
      .events = {},
      .codec = &large_values::hallCodec,
  };
  return kInfo;
}

auto Provided<large_values::Hall>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(large_values::HallFillArguments::picture)>(scratch.fill_picture);
  return scratch;
}

// A function for each command of large_values::Hall, so that a stack in a debugger names it.
struct Provided<large_values::Hall>::Dispatch {
  static Errc execute_fill(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<large_values::HallFillArguments>(arguments);
    load(slot.picture, scratch.fill_picture);
    implementation.fill(scratch.fill_picture);
    return Errc{};
  }
};

Errc Provided<large_values::Hall>::execute(std::uint16_t command, const std::byte* arguments,
                                           std::byte* /*result*/) {
  using ::large_values::HallCommand;
  switch (command) {
    case HallCommand::fill: return Dispatch::execute_fill(implementation_, scratch_, arguments);
  }
  return Errc::Invalid;
}

}  // namespace suture
