// Written by suturec from robot_types/pose.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

#include "robot_types/pose.h"

namespace robots {

/// A pose at a time: what CRTK's measured_cp, setpoint_cp and servo_cp carry.
struct PoseStampedSlot {
  std::array<double, 12> pose;  // Eigen::Isometry3d, m
  std::int64_t stamp;           // suture::Time, ns
  std::uint8_t valid;           // bool
};

inline bool store(const PoseStamped& value, PoseStampedSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.pose, slot.pose);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const PoseStampedSlot& slot, PoseStamped& value) {
  using suture::load;
  load(slot.pose, value.pose);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

/// The pose of the latency figures: 120 bytes and no strings.
struct PoseSampleSlot {
  std::array<double, 9> rotation;  // Eigen::Matrix3d
  std::array<double, 3> position;  // Eigen::Vector3d, m
  std::int64_t stamp;              // suture::Time, ns
  std::uint64_t sequence;
  std::uint64_t flags;
};

inline bool store(const PoseSample& value, PoseSampleSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.rotation, slot.rotation);
  fits &= store(value.position, slot.position);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.sequence, slot.sequence);
  fits &= store(value.flags, slot.flags);
  return fits;
}

inline void load(const PoseSampleSlot& slot, PoseSample& value) {
  using suture::load;
  load(slot.rotation, value.rotation);
  load(slot.position, value.position);
  load(slot.stamp, value.stamp);
  load(slot.sequence, value.sequence);
  load(slot.flags, value.flags);
}

/// The fields of the cisst libraries' prmPositionCartesianGet, the type of the paper's
/// measurements.
struct PosePrmSlot {
  std::int64_t timestamp;            // suture::Time, ns
  std::uint8_t automatic_timestamp;  // bool
  std::uint8_t valid;                // bool
  suture::BoundedText<15> moving_frame;
  suture::BoundedText<15> reference_frame;
  std::array<double, 12> position;  // Eigen::Isometry3d, m
};

inline bool store(const PosePrm& value, PosePrmSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.timestamp, slot.timestamp);
  fits &= store(value.automatic_timestamp, slot.automatic_timestamp);
  fits &= store(value.valid, slot.valid);
  fits &= store(value.moving_frame, slot.moving_frame);
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.position, slot.position);
  return fits;
}

inline void load(const PosePrmSlot& slot, PosePrm& value) {
  using suture::load;
  load(slot.timestamp, value.timestamp);
  load(slot.automatic_timestamp, value.automatic_timestamp);
  load(slot.valid, value.valid);
  load(slot.moving_frame, value.moving_frame);
  load(slot.reference_frame, value.reference_frame);
  load(slot.position, value.position);
}

}  // namespace robots
