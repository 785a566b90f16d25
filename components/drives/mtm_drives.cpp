#include "drives/mtm_drives.h"

#include "kinematics/davinci.h"

namespace robots {
namespace {

DriveModel<7> model(const MtmDrivesParameters& parameters) {
  using Joints = DriveModel<7>::Joints;
  const auto chain =
      parameters.side == MasterSide::Left ? kinematics::mtmLeft() : kinematics::mtmRight();
  DriveModel<7> model{.lower = chain.lower(),
                      .upper = chain.upper(),
                      .parked = kinematics::mtmHome(),
                      .rate_limit = Joints::Constant(parameters.angular_rate),
                      .time_constant = parameters.time_constant};
  model.parked[1] = 0.3;
  return model;
}

}  // namespace

MtmDrives::MtmDrives(const MtmDrivesParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      SimulatedDrives(model(parameters)),
      permit_(stop_, parameters.permit) {}

void MtmDrives::run() {
  permit(permit_.granted());
  step(suture::now());
  announce(drives_.emit());
}

}  // namespace robots
