#include "experiment/operating_room.h"

#include <chrono>

#include "integration/teleoperation/knot_scene.h"

namespace experiment {
namespace {

using namespace std::chrono_literals;
using robots::GuideParameters;
using suture::Duration;

constexpr Duration kMasterPeriod = 1ms;

/// The guide acts on data of the masters as late as the link makes them, and no later.
GuideParameters guideOf(const Trial& trial) {
  const Link& link = trial.link;
  GuideParameters parameters{.scale = OperatingRoom::kScale,
                             .fixtures = trial.fixtures,
                             .target = robots::test::kKnotTarget};
  const suture::ConnectionDelay late = delayOf(link, kMasterPeriod, 0, 0);
  parameters.max_age += late.answers + late.faults.jitter;
  if (link.loss > 0) parameters.max_age += late.faults.delayLength;
  return parameters;
}

}  // namespace

OperatingRoom::OperatingRoom(const Trial& trial, const CameraModel& camera)
    : trial_(trial),
      picturePeriod_(camera.period),
      rightLead_(trial.inputs == Inputs::Two ? &rightMaster_ : &leftMaster_),
      guide_(guideOf(trial)),
      registration_(robots::test::knotScene()),
      camera_(camera) {
  leftMaster_.addTo(manager_, "MTML");
  rightMaster_.addTo(manager_, "MTMR");
  leftSlave_.addTo(manager_, "PSM2");
  rightSlave_.addTo(manager_, "PSM1");
  manager_.add("Guide", guide_);
  manager_.add("Registration", registration_);
  manager_.add("Strand", strand_);
  manager_.add("Camera", camera_);
  manager_.add("Readier", readier_);
  connectTable();
  connectMasters();
}

suture::ConnectionDelay OperatingRoom::overLink(Duration period) {
  return delayOf(trial_.link, period, trial_.seed, ++crossings_);
}

void OperatingRoom::connectTable() {
  manager_.connect("Guide/LeftSlave", "PSM2/Arm");
  manager_.connect("Guide/RightSlave", "PSM1/Arm");
  manager_.connect("Guide/Vision", "Camera/Vision");
  manager_.connect("Guide/Registration", "Registration/Registration");
  manager_.connect("Strand/Left", "PSM2/Arm");
  manager_.connect("Strand/Right", "PSM1/Arm");
  manager_.connect("Strand/Registration", "Registration/Registration");
  manager_.connect("Camera/Strand", "Strand/Strand");
  manager_.connect("Camera/Registration", "Registration/Registration");
}

/// The hand that leads nothing holds a master all the same.
void OperatingRoom::connectMasters() {
  const auto lead = [this](const char* required, const char* provided) {
    manager_.connect(required, provided, suture::Lane::Auto, 1s, overLink(kMasterPeriod));
  };
  lead("Guide/LeftMaster", "MTML/Arm");
  lead("Guide/RightMaster", trial_.inputs == Inputs::Two ? "MTMR/Arm" : "MTML/Arm");
  manager_.connect("Readier/Arm", "MTMR/Arm");
}

void OperatingRoom::seat(suture::Task& surgeon) {
  manager_.add("Surgeon", surgeon);
  manager_.connect("Surgeon/Left", "MTML/Arm");
  manager_.connect("Surgeon/Right", "MTMR/Arm");
  manager_.connect("Surgeon/Vision", "Camera/Vision", suture::Lane::Auto, 1s,
                   overLink(picturePeriod_));
}

/// Where things stand both sides know beforehand.
void OperatingRoom::connectOperator() {
  manager_.connect("Surgeon/Guidance", "Guide/Guidance", suture::Lane::Auto, 1s,
                   overLink(picturePeriod_));
  manager_.connect("Surgeon/Registration", "Registration/Registration");
}

OperatingRoom::Pair OperatingRoom::pairOf(const robots::test::DrivenMtm& master,
                                          const robots::test::DrivenPsm& slave) {
  return {master.arm.measured_cp().pose, slave.arm.measured_cp().pose,
          slave.arm.setpoint_cp().pose};
}

}  // namespace experiment
