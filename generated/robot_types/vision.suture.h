// Written by suturec from robot_types/vision.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "robot_types/vision.h"

namespace robots {

/// A PoseArray has the poses of several tools at once. Corresponds to cisst's
/// prmPositionCartesianArrayGet.
struct PoseArraySlot {
  suture::BoundedText<15> reference_frame;
  suture::BoundedList<suture::BoundedText<15>, 16> moving_frames;
  suture::BoundedList<std::array<double, 12>, 16> positions;  // m
  suture::BoundedList<std::uint8_t, 16> visible;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

bool store(const PoseArray& value, PoseArraySlot& slot);
void load(const PoseArraySlot& slot, PoseArray& value);
void reserve(const PoseArraySlot*, PoseArray& value);
void shiftStamps(PoseArraySlot& slot, suture::Duration shift);

/// Corresponds to cisst's prmImageFrame.
struct ImageFrameSlot {
  std::uint32_t width;
  std::uint32_t height;
  std::uint32_t channels;
  suture::BoundedList<std::uint8_t, 2097152> data;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

bool store(const ImageFrame& value, ImageFrameSlot& slot);
void load(const ImageFrameSlot& slot, ImageFrame& value);
void reserve(const ImageFrameSlot*, ImageFrame& value);
void shiftStamps(ImageFrameSlot& slot, suture::Duration shift);

/// A CameraInfo is a pinhole camera with its distortion. Corresponds to cisst's prmCameraInfo.
struct CameraInfoSlot {
  std::uint32_t width;
  std::uint32_t height;
  std::array<double, 5> distortion;
  std::array<double, 9> intrinsic;      // Eigen::Matrix3d, px
  std::array<double, 9> rectification;  // Eigen::Matrix3d
  std::array<double, 12> projection;    // Eigen::Matrix<double, 3, 4>
  std::int64_t stamp;                   // suture::Time, ns
  std::uint8_t valid;                   // bool
};

bool store(const CameraInfo& value, CameraInfoSlot& slot);
void load(const CameraInfoSlot& slot, CameraInfo& value);
void shiftStamps(CameraInfoSlot& slot, suture::Duration shift);

/// A DepthMap is a cloud of coloured points. Corresponds to cisst's prmDepthMap.
struct DepthMapSlot {
  suture::BoundedText<15> reference_frame;
  std::uint32_t width;
  std::uint32_t height;
  suture::BoundedList<float, 196608> points;  // m
  suture::BoundedList<std::uint8_t, 196608> color;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

bool store(const DepthMap& value, DepthMapSlot& slot);
void load(const DepthMapSlot& slot, DepthMap& value);
void reserve(const DepthMapSlot*, DepthMap& value);
void shiftStamps(DepthMapSlot& slot, suture::Duration shift);

bool isValid(const PoseArraySlot& slot, suture::FieldPath* path);
bool isValid(const ImageFrameSlot& slot, suture::FieldPath* path);
bool isValid(const CameraInfoSlot& slot, suture::FieldPath* path);
bool isValid(const DepthMapSlot& slot, suture::FieldPath* path);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::PoseArray& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::PoseArray& value);

template <>
Result<std::vector<std::byte>> encode(const robots::ImageFrame& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::ImageFrame& value);

template <>
Result<std::vector<std::byte>> encode(const robots::CameraInfo& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::CameraInfo& value);

template <>
Result<std::vector<std::byte>> encode(const robots::DepthMap& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::DepthMap& value);

}  // namespace suture
