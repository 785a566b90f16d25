#pragma once
// This is the contract of the gripper of a master, which the surgeon's fingers squeeze.

#include <suture/annotate.h>

#include "robot_types/joint_commands.h"
#include "robot_types/joints.h"

namespace robots {

/// The master provides this as an interface of its own, "Gripper". Reads are from the end of its
/// last cycle. Joint vectors have one entry, the angle between the handles in rad: 0 is closed, and
/// a smaller angle is squeezed harder. Nothing drives the gripper, so it is measured with or
/// without power of the master.
class SUTURE_INTERFACE(crtk(), version(1)) Gripper {
 public:
  virtual ~Gripper() = default;

  /// Says what the joint is and what it may do.
  SUTURE_COMMAND() virtual const JointConfiguration& configuration_js() const = 0;
  /// Says where the joint is. The stamp is that of the drives' cycle that measured it. Before the
  /// first such cycle the value is not valid.
  SUTURE_COMMAND() virtual const JointState& measured_js() const = 0;

  /// Reports if the gripper is closed, each time that this changes, and the last one to a client
  /// that connects: dVRK's gripper/closed.
  SUTURE_EVENT(latched()) suture::EventOf<bool> closed;
};

}  // namespace robots
