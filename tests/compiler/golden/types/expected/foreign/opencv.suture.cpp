// Written by suturec from foreign/opencv.h. Do not edit.
#include "foreign/opencv.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace foreign {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(cv::Point3d::x), double>);
static_assert(std::is_same_v<decltype(cv::Point3d::y), double>);
static_assert(std::is_same_v<decltype(cv::Point3d::z), double>);
static_assert(std::is_same_v<decltype(cv::Matx33d::val), double[9]>);
static_assert(std::is_same_v<decltype(View::intrinsics), cv::Matx33d>);
static_assert(std::is_same_v<decltype(View::points), std::vector<cv::Point3d>>);

}  // namespace

bool store(const cv::Point3d& value, cvPoint3dSlot& slot) {
  bool fits = true;
  fits &= store(value.x, slot.x);
  fits &= store(value.y, slot.y);
  fits &= store(value.z, slot.z);
  return fits;
}

void load(const cvPoint3dSlot& slot, cv::Point3d& value) {
  load(slot.x, value.x);
  load(slot.y, value.y);
  load(slot.z, value.z);
}

bool store(const cv::Matx33d& value, cvMatx33dSlot& slot) {
  bool fits = true;
  fits &= store(value.val, slot.val);
  return fits;
}

void load(const cvMatx33dSlot& slot, cv::Matx33d& value) {
  load(slot.val, value.val);
}

bool store(const View& value, ViewSlot& slot) {
  bool fits = true;
  fits &= store(value.intrinsics, slot.intrinsics);
  fits &= store(value.points, slot.points);
  return fits;
}

void load(const ViewSlot& slot, View& value) {
  load(slot.intrinsics, value.intrinsics);
  load(slot.points, value.points);
}

void reserve(const ViewSlot*, View& value) {
  suture::reserveFor<decltype(ViewSlot::points)>(value.points);
}

bool store(const cv::Point3d& at, CameraAimArguments& slot) { return store(at, slot.at); }

bool isValid(const cvPoint3dSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.x)) return suture::refusedAt(path, "x");
  if (!isValid(slot.y)) return suture::refusedAt(path, "y");
  return isValid(slot.z) || suture::refusedAt(path, "z");
}

bool isValid(const cvMatx33dSlot& slot, suture::FieldPath* path) {
  return isValid(slot.val, path) || suture::refusedAt(path, "val");
}

bool isValid(const ViewSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.intrinsics, path)) return suture::refusedAt(path, "intrinsics");
  if (!suture::allOf(slot.points, path, [path](const cvPoint3dSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "points");
  }
  return true;
}

// Defined in foreign/opencv.wire.cpp.
const suture::codec::Codec& cameraCodec();

namespace {

bool acceptsCameraAim(const CameraAimArguments& slot, suture::FieldPath* path) {
  return isValid(slot.at, path) || suture::refusedAt(path, "at");
}

constexpr suture::CommandInfo kCameraCommands[] = {
    {.name = "aim",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<CameraAimArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<CameraAimArguments, acceptsCameraAim>},
    {.name = "view",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<ViewSlot>,
     .depth = 16,
     .column = CameraColumn::view,
     .acceptsResult = suture::checkSlot<ViewSlot, isValid>},
};

// The self-description, as in foreign/opencv.suture.json.
constexpr char kCameraDescription[] = R"json(
{"name": "foreign::Camera", "doc": "Both sides of it.", "hash": "bcb581c6a70161984896ecf6f6b5db2e",
"commands": [{"name": "aim", "kind": "write", "ordinal": 1, "parameters": [{"name": "at", "type": {
"kind": "struct", "name": "cv::Point3d"}}], "queue": 16}, {"name": "view", "kind": "read",
"ordinal": 2, "result": {"type": {"kind": "struct", "name": "foreign::View"}}, "queue": 16}],
"events": [], "enums": [], "structs": [{"name": "cv::Point3d", "fields": [{"name": "x", "type": {
"kind": "Float64"}}, {"name": "y", "type": {"kind": "Float64"}}, {"name": "z", "type": {
"kind": "Float64"}}]}, {"name": "cv::Matx33d", "fields": [{"name": "val", "type": {"kind": "array",
"element": {"kind": "Float64"}, "length": 9}}]}, {"name": "foreign::View",
"doc": "A camera and what it sees.", "fields": [{"name": "intrinsics", "type": {"kind": "struct",
"name": "cv::Matx33d"}}, {"name": "points", "type": {"kind": "list", "element": {"kind": "struct",
"name": "cv::Point3d"}, "capacity": 4}}]}], "wire": [{"id": "@0xe5bd0c82c54c1c8c",
"kind": "interface", "name": "Camera", "cxx": "foreign::Camera", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0x8cac637286976832"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {
"at": 1, "name": "aim", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "at",
"is": "@0xd72865b36936b2ff"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 2, "name": "view", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xc334e999633b131f"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0x8cac637286976832", "kind": "interface",
"name": "CameraEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xb20e8f123205e142"}]}]}, {"id": "@0xb20e8f123205e142", "kind": "struct",
"name": "CameraStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "view", "is": "@0xc334e999633b131f"}]}, {"id": "@0xc334e999633b131f", "kind": "struct",
"name": "View", "members": [{"at": 0, "name": "intrinsics", "is": "@0xdd860d932d3f8de3"}, {"at": 1,
"name": "points", "is": "List(@0xd72865b36936b2ff)"}]}, {"id": "@0xdd860d932d3f8de3",
"kind": "struct", "name": "Matx33d", "members": [{"at": 0, "name": "val",
"is": "List(Float64) shape \"9\""}]}, {"id": "@0xd72865b36936b2ff", "kind": "struct",
"name": "Point3d", "members": [{"at": 0, "name": "x", "is": "Float64"}, {"at": 1, "name": "y",
"is": "Float64"}, {"at": 2, "name": "z", "is": "Float64"}]}]})json";

}  // namespace
}  // namespace foreign

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<foreign::Camera>() {
  static constexpr InterfaceInfo kInfo{
      .name = "foreign::Camera",
      .hash = "bcb581c6a70161984896ecf6f6b5db2e",
      .description = foreign::kCameraDescription,
      .commands = foreign::kCameraCommands,
      .events = {},
      .codec = &foreign::cameraCodec,
  };
  return kInfo;
}

// A function for each command of foreign::Camera, so that a stack in a debugger names it.
struct Provided<foreign::Camera>::Dispatch {
  static Errc execute_aim(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<foreign::CameraAimArguments>(arguments);
    load(slot.at, scratch.aim_at);
    implementation.aim(scratch.aim_at);
    return Errc{};
  }

  static Errc execute_view(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<foreign::ViewSlot>(result);
    return store(implementation.view(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<foreign::Camera>::execute(std::uint16_t command, const std::byte* arguments,
                                        std::byte* result) {
  using ::foreign::CameraCommand;
  switch (command) {
    case CameraCommand::aim: return Dispatch::execute_aim(implementation_, scratch_, arguments);
    case CameraCommand::view: return Dispatch::execute_view(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
