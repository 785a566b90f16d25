// Written by suturec from robot_types/pose.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "robot_types/pose.h"

namespace robots {

/// A PoseStamped is a pose at a time: what CRTK's measured_cp, setpoint_cp and servo_cp carry.
struct PoseStampedSlot {
  std::array<double, 12> pose;  // Eigen::Isometry3d, m
  std::int64_t stamp;           // suture::Time, ns
  std::uint8_t valid;           // bool
};

bool store(const PoseStamped& value, PoseStampedSlot& slot);
void load(const PoseStampedSlot& slot, PoseStamped& value);
void shiftStamps(PoseStampedSlot& slot, suture::Duration shift);

/// Says where one frame is in another, for a reader that cannot know from the interface which they
/// are.
struct TransformStampedSlot {
  std::array<double, 12> transform;  // Eigen::Isometry3d, m
  std::uint32_t reference_frame;
  std::uint32_t moving_frame;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

bool store(const TransformStamped& value, TransformStampedSlot& slot);
void load(const TransformStampedSlot& slot, TransformStamped& value);
void shiftStamps(TransformStampedSlot& slot, suture::Duration shift);

/// A PoseSample is the pose of the latency measurements: 120 bytes and no strings.
struct PoseSampleSlot {
  std::array<double, 9> rotation;  // Eigen::Matrix3d
  std::array<double, 3> position;  // Eigen::Vector3d, m
  std::int64_t stamp;              // suture::Time, ns
  std::uint64_t sequence;
  std::uint64_t flags;
};

bool store(const PoseSample& value, PoseSampleSlot& slot);
void load(const PoseSampleSlot& slot, PoseSample& value);
void shiftStamps(PoseSampleSlot& slot, suture::Duration shift);

/// A PosePrm has the fields of the cisst libraries' prmPositionCartesianGet, the type of the
/// paper's measurements.
struct PosePrmSlot {
  std::int64_t timestamp;            // suture::Time, ns
  std::uint8_t automatic_timestamp;  // bool
  std::uint8_t valid;                // bool
  suture::BoundedText<15> moving_frame;
  suture::BoundedText<15> reference_frame;
  std::array<double, 12> position;  // Eigen::Isometry3d, m
};

bool store(const PosePrm& value, PosePrmSlot& slot);
void load(const PosePrmSlot& slot, PosePrm& value);
void reserve(const PosePrmSlot*, PosePrm& value);
void shiftStamps(PosePrmSlot& slot, suture::Duration shift);

bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path);
bool isValid(const TransformStampedSlot& slot, suture::FieldPath* path);
bool isValid(const PoseSampleSlot& slot, suture::FieldPath* path);
bool isValid(const PosePrmSlot& slot, suture::FieldPath* path);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::PoseStamped& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::PoseStamped& value);

template <>
Result<std::vector<std::byte>> encode(const robots::TransformStamped& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::TransformStamped& value);

template <>
Result<std::vector<std::byte>> encode(const robots::PoseSample& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::PoseSample& value);

template <>
Result<std::vector<std::byte>> encode(const robots::PosePrm& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::PosePrm& value);

}  // namespace suture
