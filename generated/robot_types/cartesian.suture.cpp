// Written by suturec from robot_types/cartesian.h. Do not edit.
#include "robot_types/cartesian.suture.h"

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
static_assert(std::is_same_v<std::underlying_type_t<ServoMode>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(ServoMode::None) == 0);
static_assert(static_cast<std::uint8_t>(ServoMode::Position) == 1);
static_assert(static_cast<std::uint8_t>(ServoMode::Velocity) == 2);
static_assert(static_cast<std::uint8_t>(ServoMode::PositionVelocity) == 3);
static_assert(static_cast<std::uint8_t>(ServoMode::Effort) == 4);
static_assert(static_cast<std::uint8_t>(ServoMode::PositionEffort) == 5);
static_assert(static_cast<std::uint8_t>(ServoMode::VelocityEffort) == 6);
static_assert(static_cast<std::uint8_t>(ServoMode::All) == 7);
static_assert(std::is_same_v<decltype(Twist::linear), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(Twist::angular), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(Twist::moving_frame), std::uint32_t>);
static_assert(std::is_same_v<decltype(Twist::reference_frame), std::uint32_t>);
static_assert(std::is_same_v<decltype(Twist::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(Twist::valid), bool>);
static_assert(std::is_same_v<decltype(TwistGoal::linear), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(TwistGoal::angular), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(TwistGoal::linear_acceleration), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(TwistGoal::angular_acceleration), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(TwistGoal::mask), std::array<bool, 6>>);
static_assert(std::is_same_v<decltype(TwistGoal::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(Wrench::force), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(Wrench::torque), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(Wrench::mask), std::array<bool, 6>>);
static_assert(std::is_same_v<decltype(Wrench::moving_frame), std::uint32_t>);
static_assert(std::is_same_v<decltype(Wrench::reference_frame), std::uint32_t>);
static_assert(std::is_same_v<decltype(Wrench::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(Wrench::valid), bool>);
static_assert(std::is_same_v<decltype(WrenchGoal::force), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(WrenchGoal::torque), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(WrenchGoal::mask), std::array<bool, 6>>);
static_assert(std::is_same_v<decltype(WrenchGoal::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(CartesianState::moving_frame), std::uint32_t>);
static_assert(std::is_same_v<decltype(CartesianState::reference_frame), std::uint32_t>);
static_assert(std::is_same_v<decltype(CartesianState::position), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(CartesianState::position_is_valid), bool>);
static_assert(std::is_same_v<decltype(CartesianState::linear_velocity), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(CartesianState::angular_velocity), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(CartesianState::velocity_is_valid), bool>);
static_assert(std::is_same_v<decltype(CartesianState::force), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(CartesianState::torque), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(CartesianState::force_is_valid), bool>);
static_assert(std::is_same_v<decltype(CartesianState::stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(CartesianGoal::goal), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(CartesianGoal::linear_velocity), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(CartesianGoal::angular_velocity), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(CartesianGoal::linear_acceleration), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(CartesianGoal::angular_acceleration), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(CartesianGoal::mask), std::array<bool, 2>>);
static_assert(std::is_same_v<decltype(CartesianGoal::moving_frame), std::uint32_t>);
static_assert(std::is_same_v<decltype(CartesianGoal::reference_frame), std::uint32_t>);
static_assert(std::is_same_v<decltype(CartesianGoal::stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(CartesianGoal::valid), bool>);
static_assert(std::is_same_v<decltype(ServoCartesian::task_frame), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(ServoCartesian::position), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(ServoCartesian::linear_velocity), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(ServoCartesian::angular_velocity), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(ServoCartesian::force), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(ServoCartesian::torque), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(ServoCartesian::axis_mode),
                             std::array<robots::ServoMode, 6>>);
static_assert(std::is_same_v<decltype(ServoCartesian::stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(HalfPlaneGains::p), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(HalfPlaneGains::d), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(HalfPlaneGains::bias), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(HalfPlaneGains::deadband), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(AngularHalfPlaneGains::p), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(AngularHalfPlaneGains::d), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(AngularHalfPlaneGains::bias), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(AngularHalfPlaneGains::deadband), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(CartesianImpedance::force_orientation), Eigen::Matrix3d>);
static_assert(std::is_same_v<decltype(CartesianImpedance::force_position), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(CartesianImpedance::torque_orientation), Eigen::Matrix3d>);
static_assert(std::is_same_v<decltype(CartesianImpedance::position_positive), HalfPlaneGains>);
static_assert(std::is_same_v<decltype(CartesianImpedance::position_negative), HalfPlaneGains>);
static_assert(std::is_same_v<decltype(CartesianImpedance::orientation_positive),
                             AngularHalfPlaneGains>);
static_assert(std::is_same_v<decltype(CartesianImpedance::orientation_negative),
                             AngularHalfPlaneGains>);
static_assert(std::is_same_v<decltype(CartesianImpedance::stamp),
                             std::chrono::steady_clock::time_point>);

}  // namespace

bool store(const Twist& value, TwistSlot& slot) {
  bool fits = true;
  fits &= store(value.linear, slot.linear);
  fits &= store(value.angular, slot.angular);
  fits &= store(value.moving_frame, slot.moving_frame);
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const TwistSlot& slot, Twist& value) {
  load(slot.linear, value.linear);
  load(slot.angular, value.angular);
  load(slot.moving_frame, value.moving_frame);
  load(slot.reference_frame, value.reference_frame);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(TwistSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const TwistGoal& value, TwistGoalSlot& slot) {
  bool fits = true;
  fits &= store(value.linear, slot.linear);
  fits &= store(value.angular, slot.angular);
  fits &= store(value.linear_acceleration, slot.linear_acceleration);
  fits &= store(value.angular_acceleration, slot.angular_acceleration);
  fits &= store(value.mask, slot.mask);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const TwistGoalSlot& slot, TwistGoal& value) {
  load(slot.linear, value.linear);
  load(slot.angular, value.angular);
  load(slot.linear_acceleration, value.linear_acceleration);
  load(slot.angular_acceleration, value.angular_acceleration);
  load(slot.mask, value.mask);
  load(slot.stamp, value.stamp);
}

void shiftStamps(TwistGoalSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const Wrench& value, WrenchSlot& slot) {
  bool fits = true;
  fits &= store(value.force, slot.force);
  fits &= store(value.torque, slot.torque);
  fits &= store(value.mask, slot.mask);
  fits &= store(value.moving_frame, slot.moving_frame);
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const WrenchSlot& slot, Wrench& value) {
  load(slot.force, value.force);
  load(slot.torque, value.torque);
  load(slot.mask, value.mask);
  load(slot.moving_frame, value.moving_frame);
  load(slot.reference_frame, value.reference_frame);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(WrenchSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const WrenchGoal& value, WrenchGoalSlot& slot) {
  bool fits = true;
  fits &= store(value.force, slot.force);
  fits &= store(value.torque, slot.torque);
  fits &= store(value.mask, slot.mask);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const WrenchGoalSlot& slot, WrenchGoal& value) {
  load(slot.force, value.force);
  load(slot.torque, value.torque);
  load(slot.mask, value.mask);
  load(slot.stamp, value.stamp);
}

void shiftStamps(WrenchGoalSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const CartesianState& value, CartesianStateSlot& slot) {
  bool fits = true;
  fits &= store(value.moving_frame, slot.moving_frame);
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.position, slot.position);
  fits &= store(value.position_is_valid, slot.position_is_valid);
  fits &= store(value.linear_velocity, slot.linear_velocity);
  fits &= store(value.angular_velocity, slot.angular_velocity);
  fits &= store(value.velocity_is_valid, slot.velocity_is_valid);
  fits &= store(value.force, slot.force);
  fits &= store(value.torque, slot.torque);
  fits &= store(value.force_is_valid, slot.force_is_valid);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const CartesianStateSlot& slot, CartesianState& value) {
  load(slot.moving_frame, value.moving_frame);
  load(slot.reference_frame, value.reference_frame);
  load(slot.position, value.position);
  load(slot.position_is_valid, value.position_is_valid);
  load(slot.linear_velocity, value.linear_velocity);
  load(slot.angular_velocity, value.angular_velocity);
  load(slot.velocity_is_valid, value.velocity_is_valid);
  load(slot.force, value.force);
  load(slot.torque, value.torque);
  load(slot.force_is_valid, value.force_is_valid);
  load(slot.stamp, value.stamp);
}

void shiftStamps(CartesianStateSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const CartesianGoal& value, CartesianGoalSlot& slot) {
  bool fits = true;
  fits &= store(value.goal, slot.goal);
  fits &= store(value.linear_velocity, slot.linear_velocity);
  fits &= store(value.angular_velocity, slot.angular_velocity);
  fits &= store(value.linear_acceleration, slot.linear_acceleration);
  fits &= store(value.angular_acceleration, slot.angular_acceleration);
  fits &= store(value.mask, slot.mask);
  fits &= store(value.moving_frame, slot.moving_frame);
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const CartesianGoalSlot& slot, CartesianGoal& value) {
  load(slot.goal, value.goal);
  load(slot.linear_velocity, value.linear_velocity);
  load(slot.angular_velocity, value.angular_velocity);
  load(slot.linear_acceleration, value.linear_acceleration);
  load(slot.angular_acceleration, value.angular_acceleration);
  load(slot.mask, value.mask);
  load(slot.moving_frame, value.moving_frame);
  load(slot.reference_frame, value.reference_frame);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(CartesianGoalSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const ServoCartesian& value, ServoCartesianSlot& slot) {
  bool fits = true;
  fits &= store(value.task_frame, slot.task_frame);
  fits &= store(value.position, slot.position);
  fits &= store(value.linear_velocity, slot.linear_velocity);
  fits &= store(value.angular_velocity, slot.angular_velocity);
  fits &= store(value.force, slot.force);
  fits &= store(value.torque, slot.torque);
  fits &= store(value.axis_mode, slot.axis_mode);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const ServoCartesianSlot& slot, ServoCartesian& value) {
  load(slot.task_frame, value.task_frame);
  load(slot.position, value.position);
  load(slot.linear_velocity, value.linear_velocity);
  load(slot.angular_velocity, value.angular_velocity);
  load(slot.force, value.force);
  load(slot.torque, value.torque);
  load(slot.axis_mode, value.axis_mode);
  load(slot.stamp, value.stamp);
}

void shiftStamps(ServoCartesianSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const HalfPlaneGains& value, HalfPlaneGainsSlot& slot) {
  bool fits = true;
  fits &= store(value.p, slot.p);
  fits &= store(value.d, slot.d);
  fits &= store(value.bias, slot.bias);
  fits &= store(value.deadband, slot.deadband);
  return fits;
}

void load(const HalfPlaneGainsSlot& slot, HalfPlaneGains& value) {
  load(slot.p, value.p);
  load(slot.d, value.d);
  load(slot.bias, value.bias);
  load(slot.deadband, value.deadband);
}

bool store(const AngularHalfPlaneGains& value, AngularHalfPlaneGainsSlot& slot) {
  bool fits = true;
  fits &= store(value.p, slot.p);
  fits &= store(value.d, slot.d);
  fits &= store(value.bias, slot.bias);
  fits &= store(value.deadband, slot.deadband);
  return fits;
}

void load(const AngularHalfPlaneGainsSlot& slot, AngularHalfPlaneGains& value) {
  load(slot.p, value.p);
  load(slot.d, value.d);
  load(slot.bias, value.bias);
  load(slot.deadband, value.deadband);
}

bool store(const CartesianImpedance& value, CartesianImpedanceSlot& slot) {
  bool fits = true;
  fits &= store(value.force_orientation, slot.force_orientation);
  fits &= store(value.force_position, slot.force_position);
  fits &= store(value.torque_orientation, slot.torque_orientation);
  fits &= store(value.position_positive, slot.position_positive);
  fits &= store(value.position_negative, slot.position_negative);
  fits &= store(value.orientation_positive, slot.orientation_positive);
  fits &= store(value.orientation_negative, slot.orientation_negative);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const CartesianImpedanceSlot& slot, CartesianImpedance& value) {
  load(slot.force_orientation, value.force_orientation);
  load(slot.force_position, value.force_position);
  load(slot.torque_orientation, value.torque_orientation);
  load(slot.position_positive, value.position_positive);
  load(slot.position_negative, value.position_negative);
  load(slot.orientation_positive, value.orientation_positive);
  load(slot.orientation_negative, value.orientation_negative);
  load(slot.stamp, value.stamp);
}

void shiftStamps(CartesianImpedanceSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool isKnownServoMode(std::uint8_t slot) {
  switch (static_cast<ServoMode>(slot)) {
    case ServoMode::None:
    case ServoMode::Position:
    case ServoMode::Velocity:
    case ServoMode::PositionVelocity:
    case ServoMode::Effort:
    case ServoMode::PositionEffort:
    case ServoMode::VelocityEffort:
    case ServoMode::All:
      return true;
  }
  return false;
}

bool isValid(const TwistSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.linear, path)) return suture::refusedAt(path, "linear");
  return isValid(slot.angular, path) || suture::refusedAt(path, "angular");
}

bool isValid(const TwistGoalSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.linear, path)) return suture::refusedAt(path, "linear");
  if (!isValid(slot.angular, path)) return suture::refusedAt(path, "angular");
  if (!isValid(slot.linear_acceleration, path)) {
    return suture::refusedAt(path, "linear_acceleration");
  }
  return isValid(slot.angular_acceleration, path) ||
      suture::refusedAt(path, "angular_acceleration");
}

bool isValid(const WrenchSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.force, path)) return suture::refusedAt(path, "force");
  return isValid(slot.torque, path) || suture::refusedAt(path, "torque");
}

bool isValid(const WrenchGoalSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.force, path)) return suture::refusedAt(path, "force");
  return isValid(slot.torque, path) || suture::refusedAt(path, "torque");
}

bool isValid(const CartesianStateSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.position)) return suture::refusedAt(path, "position");
  if (!isValid(slot.linear_velocity, path)) return suture::refusedAt(path, "linear_velocity");
  if (!isValid(slot.angular_velocity, path)) return suture::refusedAt(path, "angular_velocity");
  if (!isValid(slot.force, path)) return suture::refusedAt(path, "force");
  return isValid(slot.torque, path) || suture::refusedAt(path, "torque");
}

bool isValid(const CartesianGoalSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.goal)) return suture::refusedAt(path, "goal");
  if (!isValid(slot.linear_velocity, path)) return suture::refusedAt(path, "linear_velocity");
  if (!isValid(slot.angular_velocity, path)) return suture::refusedAt(path, "angular_velocity");
  if (!isValid(slot.linear_acceleration, path)) {
    return suture::refusedAt(path, "linear_acceleration");
  }
  return isValid(slot.angular_acceleration, path) ||
      suture::refusedAt(path, "angular_acceleration");
}

bool isValid(const ServoCartesianSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.task_frame)) return suture::refusedAt(path, "task_frame");
  if (!isValid(slot.position)) return suture::refusedAt(path, "position");
  if (!isValid(slot.linear_velocity, path)) return suture::refusedAt(path, "linear_velocity");
  if (!isValid(slot.angular_velocity, path)) return suture::refusedAt(path, "angular_velocity");
  if (!isValid(slot.force, path)) return suture::refusedAt(path, "force");
  if (!isValid(slot.torque, path)) return suture::refusedAt(path, "torque");
  if (!suture::allOf(slot.axis_mode, path, [](const std::uint8_t& element) {
    return isKnownServoMode(element);
  })) {
    return suture::refusedAt(path, "axis_mode");
  }
  return true;
}

bool isValid(const HalfPlaneGainsSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.p, path)) return suture::refusedAt(path, "p");
  if (!isValid(slot.d, path)) return suture::refusedAt(path, "d");
  if (!isValid(slot.bias, path)) return suture::refusedAt(path, "bias");
  return isValid(slot.deadband, path) || suture::refusedAt(path, "deadband");
}

bool isValid(const AngularHalfPlaneGainsSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.p, path)) return suture::refusedAt(path, "p");
  if (!isValid(slot.d, path)) return suture::refusedAt(path, "d");
  if (!isValid(slot.bias, path)) return suture::refusedAt(path, "bias");
  return isValid(slot.deadband, path) || suture::refusedAt(path, "deadband");
}

bool isValid(const CartesianImpedanceSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.force_orientation)) return suture::refusedAt(path, "force_orientation");
  if (!isValid(slot.force_position, path)) return suture::refusedAt(path, "force_position");
  if (!isValid(slot.torque_orientation)) return suture::refusedAt(path, "torque_orientation");
  if (!isValid(slot.position_positive, path)) return suture::refusedAt(path, "position_positive");
  if (!isValid(slot.position_negative, path)) return suture::refusedAt(path, "position_negative");
  if (!isValid(slot.orientation_positive, path)) {
    return suture::refusedAt(path, "orientation_positive");
  }
  return isValid(slot.orientation_negative, path) ||
      suture::refusedAt(path, "orientation_negative");
}

}  // namespace robots
