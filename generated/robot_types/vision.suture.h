// Written by suturec from robot_types/vision.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

#include "robot_types/vision.h"

namespace robots {

/// The poses of several tools at once: prmPositionCartesianArrayGet.
struct PoseArraySlot {
  suture::BoundedText<15> reference_frame;
  suture::BoundedList<suture::BoundedText<15>, 16> moving_frames;
  suture::BoundedList<std::array<double, 12>, 16> positions;  // m
  suture::BoundedList<std::uint8_t, 16> visible;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

inline bool store(const PoseArray& value, PoseArraySlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.moving_frames, slot.moving_frames);
  fits &= store(value.positions, slot.positions);
  fits &= store(value.visible, slot.visible);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const PoseArraySlot& slot, PoseArray& value) {
  using suture::load;
  load(slot.reference_frame, value.reference_frame);
  load(slot.moving_frames, value.moving_frames);
  load(slot.positions, value.positions);
  load(slot.visible, value.visible);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

/// prmImageFrame.
struct ImageFrameSlot {
  std::uint32_t width;
  std::uint32_t height;
  std::uint32_t channels;
  suture::BoundedList<std::uint8_t, 2097152> data;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

inline bool store(const ImageFrame& value, ImageFrameSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.width, slot.width);
  fits &= store(value.height, slot.height);
  fits &= store(value.channels, slot.channels);
  fits &= store(value.data, slot.data);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const ImageFrameSlot& slot, ImageFrame& value) {
  using suture::load;
  load(slot.width, value.width);
  load(slot.height, value.height);
  load(slot.channels, value.channels);
  load(slot.data, value.data);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

/// prmCameraInfo: a pinhole with its distortion.
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

inline bool store(const CameraInfo& value, CameraInfoSlot& slot) {
  using suture::store;
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

inline void load(const CameraInfoSlot& slot, CameraInfo& value) {
  using suture::load;
  load(slot.width, value.width);
  load(slot.height, value.height);
  load(slot.distortion, value.distortion);
  load(slot.intrinsic, value.intrinsic);
  load(slot.rectification, value.rectification);
  load(slot.projection, value.projection);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

/// A cloud of coloured points: prmDepthMap.
struct DepthMapSlot {
  suture::BoundedText<15> reference_frame;
  std::uint32_t width;
  std::uint32_t height;
  suture::BoundedList<float, 196608> points;  // m
  suture::BoundedList<std::uint8_t, 196608> color;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

inline bool store(const DepthMap& value, DepthMapSlot& slot) {
  using suture::store;
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

inline void load(const DepthMapSlot& slot, DepthMap& value) {
  using suture::load;
  load(slot.reference_frame, value.reference_frame);
  load(slot.width, value.width);
  load(slot.height, value.height);
  load(slot.points, value.points);
  load(slot.color, value.color);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

}  // namespace robots
