#pragma once
// This is what each of the arms does in a cycle of its task.

#include <suture/base/time.h>

#include "arm_control/arm_controller.h"
#include "arm_control/crtk_arm.h"
#include "arm_control/drive_link.h"

namespace robots {

/// Belongs to the arm's task; never allocates. Executes one cycle, after the commands that arrived
/// for it and before `contract` is announced. `tool` is what the arm holds: it is stepped with what
/// the drives measured of it, if they did, and says where it shall be.
template <int N, class Tool>
void cycleOf(ArmController<N>& arm, CrtkArm<N>& contract, DriveLink<N>& link, Tool& tool) {
  const suture::Time now = suture::now();
  contract.advance(now);
  const auto reading = link.read();
  arm.step(now, reading);
  tool.step(now, reading);
  link.command(arm.powered(), arm.setpoint(), contract.motorOrder(), tool.setpoint());
  contract.publish(now);
}

}  // namespace robots
