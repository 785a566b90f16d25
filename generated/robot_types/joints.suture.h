// Written by suturec from robot_types/joints.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "robot_types/joints.h"

namespace robots {

/// A JointState is the state of all joints of an arm, in chain order: CRTK's measured_js and
/// setpoint_js. A list is empty if its quantity is not known, and as long as `name` otherwise.
struct JointStateSlot {
  suture::BoundedList<suture::BoundedText<15>, 8> name;
  suture::BoundedList<double, 8> position;  // rad
  suture::BoundedList<double, 8> velocity;  // rad/s
  suture::BoundedList<double, 8> effort;    // N.m
  std::int64_t stamp;                       // suture::Time, ns
  std::uint8_t valid;                       // bool
};

bool store(const JointState& value, JointStateSlot& slot);
void load(const JointStateSlot& slot, JointState& value);
void reserve(const JointStateSlot*, JointState& value);
void shiftStamps(JointStateSlot& slot, suture::Duration shift);

/// Says where joints shall go: CRTK's servo_jp and move_jp.
struct JointGoalSlot {
  suture::BoundedList<double, 8> position;  // rad
  std::int64_t stamp;                       // suture::Time, ns
};

bool store(const JointGoal& value, JointGoalSlot& slot);
void load(const JointGoalSlot& slot, JointGoal& value);
void reserve(const JointGoalSlot*, JointGoal& value);
void shiftStamps(JointGoalSlot& slot, suture::Duration shift);

/// A JointSolution is a joint vector that an arm computed, without heap so that a control loop may
/// return it.
struct JointSolutionSlot {
  std::array<double, 8> position;  // rad
  std::uint32_t joints;
  std::uint8_t found;  // bool
};

bool store(const JointSolution& value, JointSolutionSlot& slot);
void load(const JointSolutionSlot& slot, JointSolution& value);

bool isValid(const JointStateSlot& slot, suture::FieldPath* path);
bool isValid(const JointGoalSlot& slot, suture::FieldPath* path);
bool isValid(const JointSolutionSlot& slot, suture::FieldPath* path);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::JointState& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointState& value);

template <>
Result<std::vector<std::byte>> encode(const robots::JointGoal& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointGoal& value);

template <>
Result<std::vector<std::byte>> encode(const robots::JointSolution& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointSolution& value);

}  // namespace suture
