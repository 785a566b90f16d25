// Written by suturec from registration/registration.h. Do not edit.
#include "registration/registration.suture.h"

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
static_assert(std::is_same_v<decltype(SceneFrames::left_base), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(SceneFrames::right_base), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(SceneFrames::camera), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(SceneFrames::tissue), double>);
static_assert(std::is_same_v<decltype(SceneFrames::left_master), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(SceneFrames::right_master), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(SceneFrames::display), Eigen::Isometry3d>);

}  // namespace

bool store(const SceneFrames& value, SceneFramesSlot& slot) {
  bool fits = true;
  fits &= store(value.left_base, slot.left_base);
  fits &= store(value.right_base, slot.right_base);
  fits &= store(value.camera, slot.camera);
  fits &= store(value.tissue, slot.tissue);
  fits &= store(value.left_master, slot.left_master);
  fits &= store(value.right_master, slot.right_master);
  fits &= store(value.display, slot.display);
  return fits;
}

void load(const SceneFramesSlot& slot, SceneFrames& value) {
  load(slot.left_base, value.left_base);
  load(slot.right_base, value.right_base);
  load(slot.camera, value.camera);
  load(slot.tissue, value.tissue);
  load(slot.left_master, value.left_master);
  load(slot.right_master, value.right_master);
  load(slot.display, value.display);
}

bool store(const Eigen::Isometry3d& camera, RegistrationSetCameraArguments& slot) {
  return store(camera, slot.camera);
}

bool isValid(const SceneFramesSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.left_base)) return suture::refusedAt(path, "left_base");
  if (!isValid(slot.right_base)) return suture::refusedAt(path, "right_base");
  if (!isValid(slot.camera)) return suture::refusedAt(path, "camera");
  if (!isValid(slot.tissue)) return suture::refusedAt(path, "tissue");
  if (!isValid(slot.left_master)) return suture::refusedAt(path, "left_master");
  if (!isValid(slot.right_master)) return suture::refusedAt(path, "right_master");
  return isValid(slot.display) || suture::refusedAt(path, "display");
}

// Defined in registration/registration.wire.cpp.
const suture::codec::Codec& registrationCodec();

namespace {

bool acceptsRegistrationSetCamera(const RegistrationSetCameraArguments& slot,
                                  suture::FieldPath* path) {
  return isValid(slot.camera) || suture::refusedAt(path, "camera");
}

constexpr suture::CommandInfo kRegistrationCommands[] = {
    {.name = "frames",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<SceneFramesSlot>,
     .depth = 16,
     .column = RegistrationColumn::frames,
     .acceptsResult = suture::checkSlot<SceneFramesSlot, isValid>},
    {.name = "set_camera",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<RegistrationSetCameraArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<RegistrationSetCameraArguments, acceptsRegistrationSetCamera>},
};

// The self-description, as in registration/registration.suture.json.
constexpr char kRegistrationDescription[] = R"json(
{"name": "robots::Registration", "doc": "Commands run in the registration's own thread.",
"hash": "ab7f70fec1652e961132ed089669aac1", "commands": [{"name": "frames", "kind": "read",
"ordinal": 1,
"doc": "Returns the frames as they were registered last; each rotation is one to 1e-6. Ask with\n`frames.at(stamp)` for those to which an image or a pose of that stamp belongs.",
"result": {"type": {"kind": "struct", "name": "robots::SceneFrames"}}, "queue": 16}, {
"name": "set_camera", "kind": "write", "ordinal": 2, "wire": "setCamera",
"doc": "Says that the left camera has been moved there. It is ignored, with a warning, unless its\nrotation is one.",
"parameters": [{"name": "camera", "type": {"kind": "isometry", "scalar": "Float64"}, "unit": "m"}],
"queue": 16}], "events": [], "enums": [], "structs": [{"name": "robots::SceneFrames",
"doc": "Says where things are: slaves and camera in the frame of the scene, whose z points away from the\ntissue; masters and display in that of the console. The place of an arm is that of the reference\nframe in which it gives its poses, which is its base unless set_base_frame() has moved it.",
"fields": [{"name": "left_base", "wire": "leftBase", "type": {"kind": "isometry",
"scalar": "Float64"}, "unit": "m"}, {"name": "right_base", "wire": "rightBase", "type": {
"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "camera",
"doc": "The left camera is here, with x to the right and y downward in the image, z ahead.",
"type": {"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "tissue",
"doc": "The tissue's surface has this z.", "type": {"kind": "Float64"}, "unit": "m",
"default": -0.16}, {"name": "left_master", "wire": "leftMaster", "type": {"kind": "isometry",
"scalar": "Float64"}, "unit": "m"}, {"name": "right_master", "wire": "rightMaster", "type": {
"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "display",
"doc": "The surgeon looks at a picture here, with the axes of the camera: x to the right and y\ndownward in it, z ahead.",
"type": {"kind": "isometry", "scalar": "Float64"}, "unit": "m"}]}], "wire": [{
"id": "@0xe9484f8fbd271c3f", "kind": "interface", "name": "Registration",
"cxx": "robots::Registration", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xead83c2c10b9a601"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "frames", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xe63e7e972f06e442"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 2, "name": "setCamera", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "camera",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}]}, {"id": "@0xead83c2c10b9a601", "kind": "interface",
"name": "RegistrationEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xf672b219e7b88cf8"}]}]}, {"id": "@0xf672b219e7b88cf8", "kind": "struct",
"name": "RegistrationStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "frames", "is": "@0xe63e7e972f06e442"}]}, {"id": "@0xe63e7e972f06e442", "kind": "struct",
"name": "SceneFrames", "members": [{"at": 0, "name": "leftBase",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 1, "name": "rightBase",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 2, "name": "camera",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 3, "name": "tissue",
"is": "Float64 unit \"m\" = -0.16"}, {"at": 4, "name": "leftMaster",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 5, "name": "rightMaster",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 6, "name": "display",
"is": "/suture/types.capnp:Pose unit \"m\""}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Registration>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::Registration",
      .hash = "ab7f70fec1652e961132ed089669aac1",
      .description = robots::kRegistrationDescription,
      .commands = robots::kRegistrationCommands,
      .events = {},
      .codec = &robots::registrationCodec,
  };
  return kInfo;
}

// A function for each command of robots::Registration, so that a stack in a debugger names it.
struct Provided<robots::Registration>::Dispatch {
  static Errc execute_frames(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::SceneFramesSlot>(result);
    return store(implementation.frames(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_set_camera(Contract& implementation, Scratch& scratch,
                                 const std::byte* arguments) {
    const auto& slot = slotIn<robots::RegistrationSetCameraArguments>(arguments);
    load(slot.camera, scratch.set_camera_camera);
    implementation.set_camera(scratch.set_camera_camera);
    return Errc{};
  }
};

Errc Provided<robots::Registration>::execute(std::uint16_t command, const std::byte* arguments,
                                             std::byte* result) {
  using ::robots::RegistrationCommand;
  switch (command) {
    case RegistrationCommand::frames: return Dispatch::execute_frames(implementation_, result);
    case RegistrationCommand::set_camera:
      return Dispatch::execute_set_camera(implementation_, scratch_, arguments);
  }
  return Errc::Invalid;
}

}  // namespace suture
