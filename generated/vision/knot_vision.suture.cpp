// Written by suturec from vision/knot_vision.h. Do not edit.
#include "vision/knot_vision.suture.h"

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
static_assert(std::is_same_v<decltype(KnotSighting::knot), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(KnotSighting::left_tip), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(KnotSighting::right_tip), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(KnotSighting::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(KnotSighting::valid), bool>);

}  // namespace

bool store(const KnotSighting& value, KnotSightingSlot& slot) {
  bool fits = true;
  fits &= store(value.knot, slot.knot);
  fits &= store(value.left_tip, slot.left_tip);
  fits &= store(value.right_tip, slot.right_tip);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const KnotSightingSlot& slot, KnotSighting& value) {
  load(slot.knot, value.knot);
  load(slot.left_tip, value.left_tip);
  load(slot.right_tip, value.right_tip);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(KnotSightingSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool isValid(const KnotSightingSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.knot, path)) return suture::refusedAt(path, "knot");
  if (!isValid(slot.left_tip, path)) return suture::refusedAt(path, "left_tip");
  return isValid(slot.right_tip, path) || suture::refusedAt(path, "right_tip");
}

// Defined in vision/knot_vision.wire.cpp.
const suture::codec::Codec& knotVisionCodec();

namespace {

constexpr suture::CommandInfo kKnotVisionCommands[] = {
    {.name = "sighting",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<KnotSightingSlot>,
     .depth = 16,
     .column = KnotVisionColumn::sighting,
     .acceptsResult = suture::checkSlot<KnotSightingSlot, isValid>,
     .shiftResult = suture::shiftSlot<KnotSightingSlot>},
};

// The self-description, as in vision/knot_vision.suture.json.
constexpr char kKnotVisionDescription[] = R"json(
{"name": "robots::KnotVision", "hash": "3501142906d2f97c6ee13fa414de1248", "commands": [{
"name": "sighting", "kind": "read", "ordinal": 1,
"doc": "Returns what the last pair of images showed.", "result": {"type": {"kind": "struct",
"name": "robots::KnotSighting"}}, "queue": 16}], "events": [], "enums": [], "structs": [{
"name": "robots::KnotSighting",
"doc": "Its points are in the frame of the left camera: x to the right and y downward in the image, z\nahead.",
"fields": [{"name": "knot", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1
}, "unit": "m"}, {"name": "left_tip", "wire": "leftTip", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}, "unit": "m"}, {"name": "right_tip",
"wire": "rightTip", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1},
"unit": "m"}, {"name": "stamp", "doc": "The images were exposed at this time.", "type": {
"kind": "time", "clock": "steady"}}, {"name": "valid",
"doc": "This is false unless both eyes see all three.", "type": {"kind": "Bool"}, "default": false}
]}], "wire": [{"id": "@0xd18623f4fbc55b4a", "kind": "interface", "name": "KnotVision",
"cxx": "robots::KnotVision", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xe0f71ba712630172"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "sighting",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0x952267eec9de3f8a"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}]}, {"id": "@0xe0f71ba712630172", "kind": "interface", "name": "KnotVisionEvents",
"members": [{"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row",
"is": "@0xfa13a8593a8dcb16"}]}]}, {"id": "@0xfa13a8593a8dcb16", "kind": "struct",
"name": "KnotVisionStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "sighting", "is": "@0x952267eec9de3f8a"}]}, {"id": "@0x952267eec9de3f8a", "kind": "struct",
"name": "KnotSighting", "members": [{"at": 0, "name": "knot",
"is": "/suture/types.capnp:Vec3 unit \"m\""}, {"at": 1, "name": "leftTip",
"is": "/suture/types.capnp:Vec3 unit \"m\""}, {"at": 2, "name": "rightTip",
"is": "/suture/types.capnp:Vec3 unit \"m\""}, {"at": 3, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 4, "name": "valid", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::KnotVision>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::KnotVision",
      .hash = "3501142906d2f97c6ee13fa414de1248",
      .description = robots::kKnotVisionDescription,
      .commands = robots::kKnotVisionCommands,
      .events = {},
      .codec = &robots::knotVisionCodec,
  };
  return kInfo;
}

// A function for each command of robots::KnotVision, so that a stack in a debugger names it.
struct Provided<robots::KnotVision>::Dispatch {
  static Errc execute_sighting(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::KnotSightingSlot>(result);
    return store(implementation.sighting(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::KnotVision>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                           std::byte* result) {
  using ::robots::KnotVisionCommand;
  switch (command) {
    case KnotVisionCommand::sighting: return Dispatch::execute_sighting(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
