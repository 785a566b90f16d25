#pragma once
// This makes what jaw and gripper publish of their one joint.

#include <suture/base/time.h>

#include "robot_types/joint_commands.h"
#include "robot_types/joints.h"

namespace robots {

/// These allocate, so call them only in constructors.
inline JointState blankToolState(const char* name) {
  JointState state;
  state.name.assign(1, name);
  state.position.assign(1, 0);
  return state;
}

inline JointConfiguration toolConfiguration(const char* name, double lower, double upper) {
  JointConfiguration configuration;
  configuration.name.assign(1, name);
  configuration.type.assign(1, JointType::Revolute);
  configuration.position_min.assign(1, lower);
  configuration.position_max.assign(1, upper);
  configuration.valid = true;
  return configuration;
}

}  // namespace robots
