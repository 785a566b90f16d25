#pragma once
// This is the patient's side of the link: two slaves, the guide with its fixtures, strand and
// camera.

#include <suture/manager/manager.h>

#include "experiment/room/camera.h"
#include "experiment/room/console.h"
#include "experiment/trial.h"
#include "guidance/knot_guide.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "registration/registration_table.h"
#include "strand/strand_simulation.h"

namespace experiment {

/// One thread uses it. It must outlive the manager's work.
class OperatingTable {
 public:
  OperatingTable(const Trial& trial, const CameraModel& camera);

  void addTo(suture::Manager& manager);
  /// The guide is at the table, so what crosses the link are the poses of the masters.
  void connectMasters(const Crossing& cross) const;

  robots::test::DrivenPsm leftSlave, rightSlave;
  robots::KnotGuide guide;
  robots::StrandSimulation strand{robots::StrandParameters{}};

 private:
  const Inputs inputs_;
  robots::RegistrationTable registration_;
  Camera camera_;
};

}  // namespace experiment
