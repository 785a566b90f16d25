// This runs deployment.json: two hands, two arms, two cameras and a guide.

#include <suture/deploy/workstation.h>

#include <array>

#include "08_bimanual_knot/knot_display.suture.h"
#include "arm_control/mtm.suture.h"
#include "arm_control/psm.suture.h"
#include "drives/mtm_drives.suture.h"
#include "drives/psm_drives.suture.h"
#include "guidance/knot_guide.suture.h"
#include "registration/registration_table.suture.h"
#include "strand/strand_simulation.suture.h"
#include "surgeon/knot_surgeon.suture.h"
#include "vision/knot_tracker.suture.h"
#include "vision/synthetic_endoscope.suture.h"

int main(int argc, char** argv) {
  const std::array classes{
      suture::componentClass<robots::Mtm>(),
      suture::componentClass<robots::MtmDrives>(),
      suture::componentClass<robots::Psm>(),
      suture::componentClass<robots::PsmDrives>(),
      suture::componentClass<robots::KnotSurgeon>(),
      suture::componentClass<robots::KnotGuide>(),
      suture::componentClass<robots::RegistrationTable>(),
      suture::componentClass<robots::StrandSimulation>(),
      suture::componentClass<robots::SyntheticEndoscope>(),
      suture::componentClass<robots::KnotTracker>(),
      suture::componentClass<watching::KnotDisplay>(),
  };
  return suture::workstationMain(argc, argv, classes);
}
