#pragma once
// The contract of the gripper of a master, which the surgeon's fingers squeeze.

#include <suture/annotate.h>

#include "robot_types/joint_commands.h"
#include "robot_types/joints.h"

namespace robots {

/// The master provides it as an interface of its own, "Gripper". Reads are from the end of its last
/// cycle. Joint vectors have one entry, the angle between the handles in rad: 0 is closed, and less
/// is squeezed harder. Nothing drives it, so it is measured whether the master has power or not.
class SUTURE_INTERFACE(crtk(), version(1)) Gripper {
 public:
  virtual ~Gripper() = default;

  /// What the joint is and may do.
  SUTURE_COMMAND() virtual const JointConfiguration& configuration_js() const = 0;
  /// Where it is. Stamp: the drives' cycle that measured it. Not valid before there was one.
  SUTURE_COMMAND() virtual const JointState& measured_js() const = 0;

  /// Whether it is closed, each time that changes, and the last one to whoever connects: dVRK's
  /// gripper/closed.
  SUTURE_EVENT(latched()) suture::EventOf<bool> closed;
};

}  // namespace robots
