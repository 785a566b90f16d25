// Written by suturec from robot_types/vision.h. Do not edit.
#include "robot_types/vision.suture.h"

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
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
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
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
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
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
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
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool isValid(const PoseArraySlot& slot, suture::FieldPath* path) {
  if (!suture::allOf(slot.positions, path, [](const std::array<double, 12>& element) {
    return isValid(element);
  })) {
    return suture::refusedAt(path, "positions");
  }
  return true;
}

bool isValid(const ImageFrameSlot&, suture::FieldPath*) {
  return true;
}

bool isValid(const CameraInfoSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.distortion, path)) return suture::refusedAt(path, "distortion");
  if (!isValid(slot.intrinsic)) return suture::refusedAt(path, "intrinsic");
  if (!isValid(slot.rectification)) return suture::refusedAt(path, "rectification");
  return isValid(slot.projection) || suture::refusedAt(path, "projection");
}

bool isValid(const DepthMapSlot& slot, suture::FieldPath* path) {
  return isValid(slot.points, path) || suture::refusedAt(path, "points");
}

}  // namespace robots
