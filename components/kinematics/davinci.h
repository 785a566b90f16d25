#pragma once
// These are the da Vinci Classic arms as published by the da Vinci Research Kit
// (jhu-dvrk/sawIntuitiveResearchKit, share/kinematic/PSM.json, MTML.json, MTMR.json and
// share/tool/LARGE_NEEDLE_DRIVER_400006.json). The published files round pi/2 to 1.5708; here it is
// exact. They are for simulation only, never for clinical use.

#include "kinematics/chain.h"

namespace robots::kinematics {

/// Returns a patient side manipulator with large needle driver: yaw, pitch, insertion, roll, wrist
/// pitch, wrist yaw. The base frame has its origin at the remote centre of motion. The tip frame is
/// the instrument's own convention (z along the closed jaws).
Chain<6> psm();

/// Returns the left master tool manipulator: outer yaw, shoulder pitch, elbow pitch, platform,
/// wrist pitch, wrist yaw, roll. The base frame is at the outer yaw axis.
Chain<7> mtmLeft();

/// Returns the right master tool manipulator: the left one's links with mirrored limits of yaw and
/// platform.
Chain<7> mtmRight();

/// Returns joints of either master that are well conditioned, and leave 0.1 m in all directions to
/// any limit.
Chain<7>::Joints mtmHome();

/// An AngleRange is the range of one joint, in rad.
struct AngleRange {
  double lower, upper;
};

/// The jaw of the large needle driver has this range: the angle between its blades, which press on
/// each other below 0.
constexpr AngleRange kPsmJaw{-0.698132, 1.39626};

/// The gripper of a master has this range: the angle between its handles. Published is 0 to 60
/// degrees (mtsIntuitiveResearchKitMTM.cpp: m_gripper_configuration_js); that it can be squeezed
/// harder, to less than 0, is our own.
constexpr AngleRange kMtmGripper{-0.2, 1.0471976};

}  // namespace robots::kinematics
