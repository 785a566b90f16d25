#include "experiment/room/operating_table.h"

#include <chrono>

#include "integration/teleoperation/scene/knot_scene.h"

namespace experiment {
namespace {

using namespace std::chrono_literals;
using robots::GuideParameters;

// Both masters are of one process.
constexpr Traffic kMasters{.stream = 1, .period = 1ms, .sharing = 2};

/// Returns parameters by which the guide acts on data of the masters as late as the link makes
/// them, and no later.
GuideParameters guideOf(const Trial& trial) {
  const Link& link = trial.link;
  GuideParameters parameters{
      .scale = kScale, .fixtures = trial.fixtures, .target = robots::test::kKnotTarget};
  const suture::ConnectionDelay late = delayOf(link, kMasters, 0);
  parameters.max_age += late.answers + late.faults.jitter;
  if (link.loss > 0) parameters.max_age += late.faults.delayLength;
  return parameters;
}

}  // namespace

OperatingTable::OperatingTable(const Trial& trial, const CameraModel& camera)
    : guide(guideOf(trial)),
      inputs_(trial.inputs),
      registration_(robots::test::knotScene()),
      camera_(camera) {}

void OperatingTable::addTo(suture::Manager& manager) {
  leftSlave.addTo(manager, "PSM2");
  rightSlave.addTo(manager, "PSM1");
  manager.add("Guide", guide);
  manager.add("Registration", registration_);
  manager.add("Strand", strand);
  manager.add("Camera", camera_);
  manager.connect("Guide/LeftSlave", "PSM2/Arm");
  manager.connect("Guide/RightSlave", "PSM1/Arm");
  manager.connect("Guide/Vision", "Camera/Vision");
  manager.connect("Guide/Registration", "Registration/Registration");
  manager.connect("Strand/Left", "PSM2/Arm");
  manager.connect("Strand/Right", "PSM1/Arm");
  manager.connect("Strand/Registration", "Registration/Registration");
  manager.connect("Camera/Strand", "Strand/Strand");
  manager.connect("Camera/Registration", "Registration/Registration");
}

void OperatingTable::connectMasters(const Crossing& cross) const {
  cross("Guide/LeftMaster", "MTML/Arm", kMasters);
  cross("Guide/RightMaster", inputs_ == Inputs::Two ? "MTMR/Arm" : "MTML/Arm", kMasters);
}

}  // namespace experiment
