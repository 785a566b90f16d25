#include "drives/psm_drives.h"

#include <memory>

#include "drives/davinci_joints.h"
#include "drives/joint_dynamics.h"
#include "drives/joints_and_tool.h"
#include "kinematics/davinci.h"

namespace robots {
namespace {

std::unique_ptr<SimulatedJoints<6>> joints(const PsmDrivesParameters& parameters) {
  using Joints = SimulatedJoints<6>::Joints;
  constexpr int kInsertion = 2;
  const Joints parked = Joints::Unit(kInsertion) * 0.1;
  Joints rates = Joints::Constant(parameters.angular_rate);
  rates[kInsertion] = parameters.insertion_rate;
  if (parameters.dynamics == DriveDynamics::RigidBody) {
    return std::make_unique<RigidBodyJoints<6>>(psmRigidBody(parked, rates, parameters.rigid_body));
  }
  const auto chain = kinematics::psm();
  return std::make_unique<JointDynamics<6>>(parameters.time_constant, rates, chain.lower(),
                                            chain.upper(), parked);
}

/// Returns the jaw, which has no mass, whatever simulates the other joints.
std::shared_ptr<SimulatedJoints<1>> jaw(const PsmDrivesParameters& parameters) {
  using Joint = SimulatedJoints<1>::Joints;
  return std::make_shared<JointDynamics<1>>(parameters.time_constant, Joint(parameters.jaw_rate),
                                            Joint(kinematics::kPsmJaw.lower),
                                            Joint(kinematics::kPsmJaw.upper), Joint(0));
}

}  // namespace

PsmDrives::PsmDrives(const PsmDrivesParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      SimulatedDrives(std::make_unique<JointsAndTool<6>>(joints(parameters), jaw(parameters)),
                      psmCoupling()),
      permit_(stop_, parameters.permit) {}

void PsmDrives::run() {
  permit(permit_.granted());
  step(suture::now());
  announce(drives_.emit());
}

}  // namespace robots
