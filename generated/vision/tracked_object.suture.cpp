// Written by suturec from vision/tracked_object.h. Do not edit.
#include "vision/tracked_object.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

// Defined in vision/tracked_object.wire.cpp.
const suture::codec::Codec& trackedObjectCodec();

namespace {

constexpr suture::CommandInfo kTrackedObjectCommands[] = {
    {.name = "measured_cp",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = TrackedObjectColumn::measured_cp,
     .acceptsResult = suture::checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = suture::shiftSlot<PoseStampedSlot>},
    {.name = "measured_cv",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<TwistSlot>,
     .depth = 16,
     .column = TrackedObjectColumn::measured_cv,
     .acceptsResult = suture::checkSlot<TwistSlot, isValid>,
     .shiftResult = suture::shiftSlot<TwistSlot>},
};

// The self-description, as in vision/tracked_object.suture.json.
constexpr char kTrackedObjectDescription[] = R"json(
{"name": "robots::TrackedObject",
"doc": "A TrackedObject is a ball in the frame of the left camera: x to the right and y downward in the\nimage, z ahead. It has no orientation, so that of its pose is the camera's.",
"hash": "6bed34eb9aee4b7278b34e35020ef06a", "crtk": true, "commands": [{"name": "measured_cp",
"kind": "read", "ordinal": 1, "wire": "measuredCp",
"doc": "Says where it is at the stamp, which is that of the tracker's cycle: images are old when they\ncome, and this is what they showed, extrapolated by its velocity. It is not valid unless the\nlast pair of images showed it, and not long ago.",
"result": {"type": {"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {
"name": "measured_cv", "kind": "read", "ordinal": 2, "wire": "measuredCv",
"doc": "Says how fast it moves; it is valid when the pose is.", "result": {"type": {
"kind": "struct", "name": "robots::Twist"}}, "queue": 16}], "events": [], "enums": [], "structs": [
{"name": "robots::PoseStamped",
"doc": "A PoseStamped is a pose at a time: what CRTK's measured_cp, setpoint_cp and servo_cp carry.",
"fields": [{"name": "pose",
"doc": "The pose is that of the interface's moving frame in its reference frame.", "type": {
"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "stamp",
"doc": "The pose was true at this time; for a set-point it is the stamp of the data from which it was\nmade.",
"type": {"kind": "time", "clock": "steady"}}, {"name": "valid",
"doc": "If it is false, do not use it.", "type": {"kind": "Bool"}, "default": false}]}, {
"name": "robots::Twist",
"doc": "A Twist is a velocity, as CRTK's measured_cv says it. Corresponds to cisst's\nprmVelocityCartesianGet.",
"fields": [{"name": "linear", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "m/s"}, {"name": "angular", "type": {"kind": "matrix", "scalar": "Float64",
"rows": 3, "columns": 1}, "unit": "rad/s"}, {"name": "moving_frame", "wire": "movingFrame",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "reference_frame", "wire": "referenceFrame",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}, {"name": "valid", "doc": "If it is false, do not use it.", "type": {
"kind": "Bool"}, "default": false}]}], "wire": [{"id": "@0xcf966e39ebac7c24", "kind": "interface",
"name": "TrackedObject", "cxx": "robots::TrackedObject", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xaefa37f144e6fbd6"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "measuredCp", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xe84bc0a4b9a0c529"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "measuredCv",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xaa62fba3aef11562"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}]}, {"id": "@0xaefa37f144e6fbd6", "kind": "interface",
"name": "TrackedObjectEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xf542a4f122cd9459"}]}]}, {"id": "@0xf542a4f122cd9459", "kind": "struct",
"name": "TrackedObjectStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "measuredCp", "is": "@0xe84bc0a4b9a0c529"}, {"at": 4, "name": "measuredCv",
"is": "@0xaa62fba3aef11562"}]}, {"id": "@0xe84bc0a4b9a0c529", "kind": "struct",
"name": "PoseStamped", "members": [{"at": 0, "name": "pose",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 1, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 2, "name": "valid", "is": "Bool"}]}, {
"id": "@0xaa62fba3aef11562", "kind": "struct", "name": "Twist", "members": [{"at": 0,
"name": "linear", "is": "/suture/types.capnp:Vec3 unit \"m/s\""}, {"at": 1, "name": "angular",
"is": "/suture/types.capnp:Vec3 unit \"rad/s\""}, {"at": 2, "name": "movingFrame", "is": "UInt32"},
{"at": 3, "name": "referenceFrame", "is": "UInt32"}, {"at": 4, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 5, "name": "valid", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::TrackedObject>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::TrackedObject",
      .hash = "6bed34eb9aee4b7278b34e35020ef06a",
      .description = robots::kTrackedObjectDescription,
      .commands = robots::kTrackedObjectCommands,
      .events = {},
      .codec = &robots::trackedObjectCodec,
  };
  return kInfo;
}

// A function for each command of robots::TrackedObject, so that a stack in a debugger names it.
struct Provided<robots::TrackedObject>::Dispatch {
  static Errc execute_measured_cp(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PoseStampedSlot>(result);
    return store(implementation.measured_cp(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_measured_cv(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::TwistSlot>(result);
    return store(implementation.measured_cv(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::TrackedObject>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                              std::byte* result) {
  using ::robots::TrackedObjectCommand;
  switch (command) {
    case TrackedObjectCommand::measured_cp:
      return Dispatch::execute_measured_cp(implementation_, result);
    case TrackedObjectCommand::measured_cv:
      return Dispatch::execute_measured_cv(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
