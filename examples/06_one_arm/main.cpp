// This runs any process of any deployment of these arms, including those of 07_swapped_slaves and
// 09_three_namespaces.

#include <suture/deploy/workstation.h>

#include <array>

#include "06_one_arm/motion_display.suture.h"
#include "arm_control/mtm.suture.h"
#include "arm_control/psm.suture.h"
#include "drives/mtm_drives.suture.h"
#include "drives/psm_drives.suture.h"
#include "surgeon/surgeon.suture.h"
#include "teleop/teleop.suture.h"

int main(int argc, char** argv) {
  const std::array classes{
      suture::componentClass<robots::Mtm>(),
      suture::componentClass<robots::MtmDrives>(),
      suture::componentClass<robots::Psm>(),
      suture::componentClass<robots::PsmDrives>(),
      suture::componentClass<robots::Teleop>(),
      suture::componentClass<robots::Surgeon>(),
      suture::componentClass<watching::MotionDisplay>(),
  };
  return suture::workstationMain(argc, argv, classes);
}
