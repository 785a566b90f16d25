// Written by suturec from robot_types/joints.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

#include "robot_types/joints.h"

namespace robots {

/// The state of all joints of an arm, in chain order: CRTK's measured_js and setpoint_js. A list is
/// empty where its quantity is not known, and as long as `name` otherwise.
struct JointStateSlot {
  suture::BoundedList<suture::BoundedText<15>, 8> name;
  suture::BoundedList<double, 8> position;  // rad
  suture::BoundedList<double, 8> velocity;  // rad/s
  suture::BoundedList<double, 8> effort;    // N.m
  std::int64_t stamp;                       // suture::Time, ns
  std::uint8_t valid;                       // bool
};

inline bool store(const JointState& value, JointStateSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.name, slot.name);
  fits &= store(value.position, slot.position);
  fits &= store(value.velocity, slot.velocity);
  fits &= store(value.effort, slot.effort);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const JointStateSlot& slot, JointState& value) {
  using suture::load;
  load(slot.name, value.name);
  load(slot.position, value.position);
  load(slot.velocity, value.velocity);
  load(slot.effort, value.effort);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

/// Where joints shall go: CRTK's servo_jp and move_jp.
struct JointGoalSlot {
  suture::BoundedList<double, 8> position;  // rad
  std::int64_t stamp;                       // suture::Time, ns
};

inline bool store(const JointGoal& value, JointGoalSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.position, slot.position);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

inline void load(const JointGoalSlot& slot, JointGoal& value) {
  using suture::load;
  load(slot.position, value.position);
  load(slot.stamp, value.stamp);
}

/// A joint vector that an arm computed, without heap so that a control loop may return it.
struct JointSolutionSlot {
  std::array<double, 8> position;  // rad
  std::uint32_t joints;
  std::uint8_t found;  // bool
};

inline bool store(const JointSolution& value, JointSolutionSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.position, slot.position);
  fits &= store(value.joints, slot.joints);
  fits &= store(value.found, slot.found);
  return fits;
}

inline void load(const JointSolutionSlot& slot, JointSolution& value) {
  using suture::load;
  load(slot.position, value.position);
  load(slot.joints, value.joints);
  load(slot.found, value.found);
}

}  // namespace robots
