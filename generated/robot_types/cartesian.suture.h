// Written by suturec from robot_types/cartesian.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "robot_types/cartesian.h"

namespace robots {

/// A Twist is a velocity, as CRTK's measured_cv says it. Corresponds to cisst's
/// prmVelocityCartesianGet.
struct TwistSlot {
  std::array<double, 3> linear;   // Eigen::Vector3d, m/s
  std::array<double, 3> angular;  // Eigen::Vector3d, rad/s
  std::uint32_t moving_frame;
  std::uint32_t reference_frame;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

bool store(const Twist& value, TwistSlot& slot);
void load(const TwistSlot& slot, Twist& value);
void shiftStamps(TwistSlot& slot, suture::Duration shift);

/// A TwistGoal is a velocity to follow, by CRTK's servo_cv. Corresponds to cisst's
/// prmVelocityCartesianSet.
struct TwistGoalSlot {
  std::array<double, 3> linear;                // Eigen::Vector3d, m/s
  std::array<double, 3> angular;               // Eigen::Vector3d, rad/s
  std::array<double, 3> linear_acceleration;   // Eigen::Vector3d, m/s2
  std::array<double, 3> angular_acceleration;  // Eigen::Vector3d, rad/s2
  std::array<std::uint8_t, 6> mask;
  std::int64_t stamp;  // suture::Time, ns
};

bool store(const TwistGoal& value, TwistGoalSlot& slot);
void load(const TwistGoalSlot& slot, TwistGoal& value);
void shiftStamps(TwistGoalSlot& slot, suture::Duration shift);

/// A Wrench is force and torque at the tool tip, as CRTK's measured_cf says it. Corresponds to
/// cisst's prmForceCartesianGet.
struct WrenchSlot {
  std::array<double, 3> force;   // Eigen::Vector3d, N
  std::array<double, 3> torque;  // Eigen::Vector3d, N.m
  std::array<std::uint8_t, 6> mask;
  std::uint32_t moving_frame;
  std::uint32_t reference_frame;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

bool store(const Wrench& value, WrenchSlot& slot);
void load(const WrenchSlot& slot, Wrench& value);
void shiftStamps(WrenchSlot& slot, suture::Duration shift);

/// A WrenchGoal is force and torque to apply, by CRTK's servo_cf. Corresponds to cisst's
/// prmForceCartesianSet.
struct WrenchGoalSlot {
  std::array<double, 3> force;   // Eigen::Vector3d, N
  std::array<double, 3> torque;  // Eigen::Vector3d, N.m
  std::array<std::uint8_t, 6> mask;
  std::int64_t stamp;  // suture::Time, ns
};

bool store(const WrenchGoal& value, WrenchGoalSlot& slot);
void load(const WrenchGoalSlot& slot, WrenchGoal& value);
void shiftStamps(WrenchGoalSlot& slot, suture::Duration shift);

/// A CartesianState is pose, velocity and force of one instant, as CRTK's measured_cs says it.
/// Corresponds to cisst's prmStateCartesian.
struct CartesianStateSlot {
  std::uint32_t moving_frame;
  std::uint32_t reference_frame;
  std::array<double, 12> position;         // Eigen::Isometry3d, m
  std::uint8_t position_is_valid;          // bool
  std::array<double, 3> linear_velocity;   // Eigen::Vector3d, m/s
  std::array<double, 3> angular_velocity;  // Eigen::Vector3d, rad/s
  std::uint8_t velocity_is_valid;          // bool
  std::array<double, 3> force;             // Eigen::Vector3d, N
  std::array<double, 3> torque;            // Eigen::Vector3d, N.m
  std::uint8_t force_is_valid;             // bool
  std::int64_t stamp;                      // suture::Time, ns
};

bool store(const CartesianState& value, CartesianStateSlot& slot);
void load(const CartesianStateSlot& slot, CartesianState& value);
void shiftStamps(CartesianStateSlot& slot, suture::Duration shift);

/// A CartesianGoal is a pose to reach, and how to get there. Corresponds to cisst's
/// prmPositionCartesianSet.
struct CartesianGoalSlot {
  std::array<double, 12> goal;                 // Eigen::Isometry3d, m
  std::array<double, 3> linear_velocity;       // Eigen::Vector3d, m/s
  std::array<double, 3> angular_velocity;      // Eigen::Vector3d, rad/s
  std::array<double, 3> linear_acceleration;   // Eigen::Vector3d, m/s2
  std::array<double, 3> angular_acceleration;  // Eigen::Vector3d, rad/s2
  std::array<std::uint8_t, 2> mask;
  std::uint32_t moving_frame;
  std::uint32_t reference_frame;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

bool store(const CartesianGoal& value, CartesianGoalSlot& slot);
void load(const CartesianGoalSlot& slot, CartesianGoal& value);
void shiftStamps(CartesianGoalSlot& slot, suture::Duration shift);

/// A ServoCartesian has position, velocity and effort in one servo command. Corresponds to cisst's
/// prmServoCartesian.
struct ServoCartesianSlot {
  std::array<double, 12> task_frame;       // Eigen::Isometry3d, m
  std::array<double, 12> position;         // Eigen::Isometry3d, m
  std::array<double, 3> linear_velocity;   // Eigen::Vector3d, m/s
  std::array<double, 3> angular_velocity;  // Eigen::Vector3d, rad/s
  std::array<double, 3> force;             // Eigen::Vector3d, N
  std::array<double, 3> torque;            // Eigen::Vector3d, N.m
  std::array<std::uint8_t, 6> axis_mode;
  std::int64_t stamp;  // suture::Time, ns
};

bool store(const ServoCartesian& value, ServoCartesianSlot& slot);
void load(const ServoCartesianSlot& slot, ServoCartesian& value);
void shiftStamps(ServoCartesianSlot& slot, suture::Duration shift);

/// Says how stiffly one side of an axis holds: force = p * distance + d * speed + bias beyond the
/// deadband.
struct HalfPlaneGainsSlot {
  std::array<double, 3> p;         // Eigen::Vector3d, N/m
  std::array<double, 3> d;         // Eigen::Vector3d, N.s/m
  std::array<double, 3> bias;      // Eigen::Vector3d, N
  std::array<double, 3> deadband;  // Eigen::Vector3d, m
};

bool store(const HalfPlaneGains& value, HalfPlaneGainsSlot& slot);
void load(const HalfPlaneGainsSlot& slot, HalfPlaneGains& value);

/// These gains hold about an axis in the same way.
struct AngularHalfPlaneGainsSlot {
  std::array<double, 3> p;         // Eigen::Vector3d, N.m/rad
  std::array<double, 3> d;         // Eigen::Vector3d, N.m.s/rad
  std::array<double, 3> bias;      // Eigen::Vector3d, N.m
  std::array<double, 3> deadband;  // Eigen::Vector3d, rad
};

bool store(const AngularHalfPlaneGains& value, AngularHalfPlaneGainsSlot& slot);
void load(const AngularHalfPlaneGainsSlot& slot, AngularHalfPlaneGains& value);

/// A CartesianImpedance is a spring that holds the tool tip, per axis and side. Corresponds to
/// cisst's prmCartesianImpedance.
struct CartesianImpedanceSlot {
  std::array<double, 9> force_orientation;   // Eigen::Matrix3d
  std::array<double, 3> force_position;      // Eigen::Vector3d, m
  std::array<double, 9> torque_orientation;  // Eigen::Matrix3d
  HalfPlaneGainsSlot position_positive;
  HalfPlaneGainsSlot position_negative;
  AngularHalfPlaneGainsSlot orientation_positive;
  AngularHalfPlaneGainsSlot orientation_negative;
  std::int64_t stamp;  // suture::Time, ns
};

bool store(const CartesianImpedance& value, CartesianImpedanceSlot& slot);
void load(const CartesianImpedanceSlot& slot, CartesianImpedance& value);
void shiftStamps(CartesianImpedanceSlot& slot, suture::Duration shift);

bool isKnownServoMode(std::uint8_t slot);
bool isValid(const TwistSlot& slot, suture::FieldPath* path);
bool isValid(const TwistGoalSlot& slot, suture::FieldPath* path);
bool isValid(const WrenchSlot& slot, suture::FieldPath* path);
bool isValid(const WrenchGoalSlot& slot, suture::FieldPath* path);
bool isValid(const CartesianStateSlot& slot, suture::FieldPath* path);
bool isValid(const CartesianGoalSlot& slot, suture::FieldPath* path);
bool isValid(const ServoCartesianSlot& slot, suture::FieldPath* path);
bool isValid(const HalfPlaneGainsSlot& slot, suture::FieldPath* path);
bool isValid(const AngularHalfPlaneGainsSlot& slot, suture::FieldPath* path);
bool isValid(const CartesianImpedanceSlot& slot, suture::FieldPath* path);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::Twist& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::Twist& value);

template <>
Result<std::vector<std::byte>> encode(const robots::TwistGoal& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::TwistGoal& value);

template <>
Result<std::vector<std::byte>> encode(const robots::Wrench& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::Wrench& value);

template <>
Result<std::vector<std::byte>> encode(const robots::WrenchGoal& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::WrenchGoal& value);

template <>
Result<std::vector<std::byte>> encode(const robots::CartesianState& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::CartesianState& value);

template <>
Result<std::vector<std::byte>> encode(const robots::CartesianGoal& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::CartesianGoal& value);

template <>
Result<std::vector<std::byte>> encode(const robots::ServoCartesian& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::ServoCartesian& value);

template <>
Result<std::vector<std::byte>> encode(const robots::HalfPlaneGains& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::HalfPlaneGains& value);

template <>
Result<std::vector<std::byte>> encode(const robots::AngularHalfPlaneGains& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::AngularHalfPlaneGains& value);

template <>
Result<std::vector<std::byte>> encode(const robots::CartesianImpedance& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::CartesianImpedance& value);

}  // namespace suture
