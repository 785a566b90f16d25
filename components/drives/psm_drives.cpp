#include "drives/psm_drives.h"

#include "kinematics/davinci.h"

namespace robots {
namespace {

DriveModel<6> model(const PsmDrivesParameters& parameters) {
  using Joints = DriveModel<6>::Joints;
  constexpr int kInsertion = 2;
  const auto chain = kinematics::psm();
  DriveModel<6> model{.lower = chain.lower(),
                      .upper = chain.upper(),
                      .parked = Joints::Zero(),
                      .rate_limit = Joints::Constant(parameters.angular_rate),
                      .time_constant = parameters.time_constant};
  model.parked[kInsertion] = 0.1;
  model.rate_limit[kInsertion] = parameters.insertion_rate;
  return model;
}

}  // namespace

PsmDrives::PsmDrives(const PsmDrivesParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      SimulatedDrives(model(parameters)),
      permit_(stop_, parameters.permit) {}

void PsmDrives::run() {
  permit(permit_.granted());
  step(suture::now());
  announce(drives_.emit());
}

}  // namespace robots
