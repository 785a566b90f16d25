// Written by suturec from robot_types/vision.h. Do not edit.
#include "robot_types/vision.suture.h"

#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "robot_types/vision.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(PoseArray::reference_frame), std::string>);
static_assert(std::is_same_v<decltype(PoseArray::moving_frames), std::vector<std::string>>);
static_assert(std::is_same_v<decltype(PoseArray::positions), std::vector<Eigen::Isometry3d>>);
static_assert(std::is_same_v<decltype(PoseArray::visible), std::vector<bool>>);
static_assert(std::is_same_v<decltype(PoseArray::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(PoseArray::valid), bool>);
static_assert(std::is_same_v<decltype(ImageFrame::width), std::uint32_t>);
static_assert(std::is_same_v<decltype(ImageFrame::height), std::uint32_t>);
static_assert(std::is_same_v<decltype(ImageFrame::channels), std::uint32_t>);
static_assert(std::is_same_v<decltype(ImageFrame::data), std::vector<std::uint8_t>>);
static_assert(std::is_same_v<decltype(ImageFrame::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(ImageFrame::valid), bool>);
static_assert(std::is_same_v<decltype(CameraInfo::width), std::uint32_t>);
static_assert(std::is_same_v<decltype(CameraInfo::height), std::uint32_t>);
static_assert(std::is_same_v<decltype(CameraInfo::distortion), std::array<double, 5>>);
static_assert(std::is_same_v<decltype(CameraInfo::intrinsic), Eigen::Matrix3d>);
static_assert(std::is_same_v<decltype(CameraInfo::rectification), Eigen::Matrix3d>);
static_assert(std::is_same_v<decltype(CameraInfo::projection), Eigen::Matrix<double, 3, 4>>);
static_assert(std::is_same_v<decltype(CameraInfo::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(CameraInfo::valid), bool>);
static_assert(std::is_same_v<decltype(DepthMap::reference_frame), std::string>);
static_assert(std::is_same_v<decltype(DepthMap::width), std::uint32_t>);
static_assert(std::is_same_v<decltype(DepthMap::height), std::uint32_t>);
static_assert(std::is_same_v<decltype(DepthMap::points), std::vector<float>>);
static_assert(std::is_same_v<decltype(DepthMap::color), std::vector<std::uint8_t>>);
static_assert(std::is_same_v<decltype(DepthMap::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(DepthMap::valid), bool>);

}  // namespace

bool store(const PoseArray& value, PoseArraySlot& slot) {
  bool fits = true;
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.moving_frames, slot.moving_frames);
  fits &= store(value.positions, slot.positions);
  fits &= store(value.visible, slot.visible);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const PoseArraySlot& slot, PoseArray& value) {
  load(slot.reference_frame, value.reference_frame);
  load(slot.moving_frames, value.moving_frames);
  load(slot.positions, value.positions);
  load(slot.visible, value.visible);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void reserve(const PoseArraySlot*, PoseArray& value) {
  suture::reserveFor<decltype(PoseArraySlot::reference_frame)>(value.reference_frame);
  suture::reserveFor<decltype(PoseArraySlot::moving_frames)>(value.moving_frames);
  suture::reserveFor<decltype(PoseArraySlot::positions)>(value.positions);
  suture::reserveFor<decltype(PoseArraySlot::visible)>(value.visible);
}

void shiftStamps(PoseArraySlot& slot, suture::Duration shift) {
  slot.stamp = suture::rpc::shifted(slot.stamp, shift);
}

bool store(const ImageFrame& value, ImageFrameSlot& slot) {
  bool fits = true;
  fits &= store(value.width, slot.width);
  fits &= store(value.height, slot.height);
  fits &= store(value.channels, slot.channels);
  fits &= store(value.data, slot.data);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const ImageFrameSlot& slot, ImageFrame& value) {
  load(slot.width, value.width);
  load(slot.height, value.height);
  load(slot.channels, value.channels);
  load(slot.data, value.data);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void reserve(const ImageFrameSlot*, ImageFrame& value) {
  suture::reserveFor<decltype(ImageFrameSlot::data)>(value.data);
}

void shiftStamps(ImageFrameSlot& slot, suture::Duration shift) {
  slot.stamp = suture::rpc::shifted(slot.stamp, shift);
}

bool store(const CameraInfo& value, CameraInfoSlot& slot) {
  bool fits = true;
  fits &= store(value.width, slot.width);
  fits &= store(value.height, slot.height);
  fits &= store(value.distortion, slot.distortion);
  fits &= store(value.intrinsic, slot.intrinsic);
  fits &= store(value.rectification, slot.rectification);
  fits &= store(value.projection, slot.projection);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const CameraInfoSlot& slot, CameraInfo& value) {
  load(slot.width, value.width);
  load(slot.height, value.height);
  load(slot.distortion, value.distortion);
  load(slot.intrinsic, value.intrinsic);
  load(slot.rectification, value.rectification);
  load(slot.projection, value.projection);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(CameraInfoSlot& slot, suture::Duration shift) {
  slot.stamp = suture::rpc::shifted(slot.stamp, shift);
}

bool store(const DepthMap& value, DepthMapSlot& slot) {
  bool fits = true;
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.width, slot.width);
  fits &= store(value.height, slot.height);
  fits &= store(value.points, slot.points);
  fits &= store(value.color, slot.color);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const DepthMapSlot& slot, DepthMap& value) {
  load(slot.reference_frame, value.reference_frame);
  load(slot.width, value.width);
  load(slot.height, value.height);
  load(slot.points, value.points);
  load(slot.color, value.color);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void reserve(const DepthMapSlot*, DepthMap& value) {
  suture::reserveFor<decltype(DepthMapSlot::reference_frame)>(value.reference_frame);
  suture::reserveFor<decltype(DepthMapSlot::points)>(value.points);
  suture::reserveFor<decltype(DepthMapSlot::color)>(value.color);
}

void shiftStamps(DepthMapSlot& slot, suture::Duration shift) {
  slot.stamp = suture::rpc::shifted(slot.stamp, shift);
}

// --- between slots and Cap'n Proto

void toWire(const PoseArraySlot& slot, wire::PoseArray::Builder out) {
  toWire(slot.reference_frame, out.initReferenceFrame(sizeOf(slot.reference_frame)));
  toWire(slot.moving_frames, out.initMovingFrames(sizeOf(slot.moving_frames)));
  suture::rpc::toWireList(slot.positions, out.initPositions(sizeOf(slot.positions)),
                          [](const std::array<double, 12>& element, auto list, std::uint32_t i) {
                            toWire(element, list[i]);
                          });
  toWire(slot.visible, out.initVisible(sizeOf(slot.visible)));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::PoseArray::Reader in, PoseArraySlot& slot, suture::Duration shift) {
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::rpc::firstError({
      fromWire(in.getReferenceFrame(), slot.reference_frame),
      fromWire(in.getMovingFrames(), slot.moving_frames),
      suture::rpc::fromWireList(in.getPositions(), slot.positions,
                                [](auto item, std::array<double, 12>& target) {
                                  return fromWire(item, target);
                                }),
      fromWire(in.getVisible(), slot.visible),
  });
}

bool isValid(const PoseArraySlot& slot, suture::FieldPath* path) {
  if (!suture::rpc::allOf(slot.positions, path, [](const std::array<double, 12>& element) {
    return isValid(element);
  })) {
    return suture::refusedAt(path, "positions");
  }
  return true;
}

void toWire(const ImageFrameSlot& slot, wire::ImageFrame::Builder out) {
  out.setWidth(slot.width);
  out.setHeight(slot.height);
  out.setChannels(slot.channels);
  toWire(slot.data, out.initData(sizeOf(slot.data)));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::ImageFrame::Reader in, ImageFrameSlot& slot, suture::Duration shift) {
  slot.width = in.getWidth();
  slot.height = in.getHeight();
  slot.channels = in.getChannels();
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return fromWire(in.getData(), slot.data);
}

bool isValid(const ImageFrameSlot&, suture::FieldPath*) {
  return true;
}

void toWire(const CameraInfoSlot& slot, wire::CameraInfo::Builder out) {
  out.setWidth(slot.width);
  out.setHeight(slot.height);
  toWire(slot.distortion, out.initDistortion(5));
  toWire(slot.intrinsic, out.initIntrinsic());
  toWire(slot.rectification, out.initRectification());
  toWire(slot.projection, out.initProjection(12));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::CameraInfo::Reader in, CameraInfoSlot& slot, suture::Duration shift) {
  slot.width = in.getWidth();
  slot.height = in.getHeight();
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::rpc::firstError({
      fromWire(in.getDistortion(), slot.distortion),
      in.hasIntrinsic() ? fromWire(in.getIntrinsic(), slot.intrinsic)
          : suture::rpc::fromDefault(CameraInfo().intrinsic, slot.intrinsic),
      in.hasRectification() ? fromWire(in.getRectification(), slot.rectification)
          : suture::rpc::fromDefault(CameraInfo().rectification, slot.rectification),
      in.getProjection().size() != 0 ? fromWire(in.getProjection(), slot.projection)
          : suture::rpc::fromDefault(CameraInfo().projection, slot.projection),
  });
}

bool isValid(const CameraInfoSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.distortion, path)) return suture::refusedAt(path, "distortion");
  if (!isValid(slot.intrinsic)) return suture::refusedAt(path, "intrinsic");
  if (!isValid(slot.rectification)) return suture::refusedAt(path, "rectification");
  return isValid(slot.projection) || suture::refusedAt(path, "projection");
}

void toWire(const DepthMapSlot& slot, wire::DepthMap::Builder out) {
  toWire(slot.reference_frame, out.initReferenceFrame(sizeOf(slot.reference_frame)));
  out.setWidth(slot.width);
  out.setHeight(slot.height);
  toWire(slot.points, out.initPoints(sizeOf(slot.points)));
  toWire(slot.color, out.initColor(sizeOf(slot.color)));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::DepthMap::Reader in, DepthMapSlot& slot, suture::Duration shift) {
  slot.width = in.getWidth();
  slot.height = in.getHeight();
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::rpc::firstError({
      fromWire(in.getReferenceFrame(), slot.reference_frame),
      fromWire(in.getPoints(), slot.points),
      fromWire(in.getColor(), slot.color),
  });
}

bool isValid(const DepthMapSlot& slot, suture::FieldPath* path) {
  return isValid(slot.points, path) || suture::refusedAt(path, "points");
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::PoseArray& value) {
  return rpc::encodeAs<robots::wire::PoseArray, robots::PoseArraySlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::PoseArray& value) {
  return rpc::decodeAs<robots::wire::PoseArray, robots::PoseArraySlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::ImageFrame& value) {
  return rpc::encodeAs<robots::wire::ImageFrame, robots::ImageFrameSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ImageFrame& value) {
  return rpc::decodeAs<robots::wire::ImageFrame, robots::ImageFrameSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::CameraInfo& value) {
  return rpc::encodeAs<robots::wire::CameraInfo, robots::CameraInfoSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::CameraInfo& value) {
  return rpc::decodeAs<robots::wire::CameraInfo, robots::CameraInfoSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::DepthMap& value) {
  return rpc::encodeAs<robots::wire::DepthMap, robots::DepthMapSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::DepthMap& value) {
  return rpc::decodeAs<robots::wire::DepthMap, robots::DepthMapSlot>(bytes, value);
}

}  // namespace suture
