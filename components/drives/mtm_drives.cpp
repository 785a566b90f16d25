#include "drives/mtm_drives.h"

#include <memory>
#include <utility>

#include "drives/davinci_joints.h"
#include "drives/joint_dynamics.h"
#include "drives/joints_and_tool.h"
#include "kinematics/davinci.h"

namespace robots {
namespace {

std::unique_ptr<SimulatedJoints<7>> joints(const MtmDrivesParameters& parameters) {
  using Joints = SimulatedJoints<7>::Joints;
  const auto chain = parameters.side == Side::Left ? kinematics::mtmLeft() : kinematics::mtmRight();
  const Joints rates = Joints::Constant(parameters.angular_rate);
  Joints parked = kinematics::mtmHome();
  parked[1] = 0.3;
  if (parameters.dynamics == DriveDynamics::RigidBody) {
    return std::make_unique<RigidBodyJoints<7>>(
        mtmRigidBody(chain, parked, rates, parameters.rigid_body));
  }
  return std::make_unique<JointDynamics<7>>(parameters.time_constant, rates, chain.lower(),
                                            chain.upper(), parked);
}

}  // namespace

MtmDrives::MtmDrives(const MtmDrivesParameters& parameters)
    : MtmDrives(parameters, std::make_shared<HeldGripper>(parameters.time_constant)) {}

MtmDrives::MtmDrives(const MtmDrivesParameters& parameters, std::shared_ptr<HeldGripper> gripper)
    : PeriodicTask({.period = parameters.period}),
      SimulatedDrives(std::make_unique<JointsAndTool<7>>(joints(parameters), gripper),
                      withTool(mtmCoupling())),
      gripper_(std::move(gripper)),
      permit_(stop_, parameters.permit) {}

void MtmDrives::run() {
  permit(permit_.granted());
  step(suture::now());
  announce(drives_.emit());
}

}  // namespace robots
