// This has the shape of libfranka's franka/log.h.
#pragma once

#include <franka/control_types.h>
#include <franka/robot_state.h>

namespace franka {

struct RobotCommand {
  CartesianPose cartesian_pose{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
  Torques torques{0, 0, 0, 0, 0, 0, 0};
};

struct Record {
  RobotState state;
  RobotCommand command;
};

}  // namespace franka
