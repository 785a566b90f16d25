#include "experiment/room/operating_room.h"

#include <chrono>

namespace experiment {
namespace {

Pair pairOf(const robots::test::DrivenMtm& master, const robots::test::DrivenPsm& slave) {
  return {master.arm.motion().measured_cp().pose, slave.arm.motion().measured_cp().pose,
          slave.arm.motion().setpoint_cp().pose};
}

}  // namespace

OperatingRoom::OperatingRoom(const Trial& trial, const CameraModel& camera)
    : trial_(trial),
      picturePeriod_(camera.period),
      table_(trial, camera),
      overLink_([this](const char* required, const char* provided, const Traffic& traffic) {
        manager_.connect(required, provided,
                         {.patience = std::chrono::seconds(1),
                          .delay = delayOf(trial_.link, traffic, trial_.seed)});
      }) {
  console_.addTo(manager_);
  table_.addTo(manager_);
  table_.connectMasters(overLink_);
}

Truth OperatingRoom::truth() const {
  const bool two = trial_.inputs == Inputs::Two;
  return {.knot = knot(),
          .guided = guiding(),
          .left = pairOf(console_.left, table_.leftSlave),
          .right = pairOf(two ? console_.right : console_.left, table_.rightSlave)};
}

}  // namespace experiment
