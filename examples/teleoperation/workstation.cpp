// suture-workstation: runs any process of any deployment of these arms.

#include <suture/deploy/workstation.h>

#include <array>

#include "arm/mtm.suture.h"
#include "arm/psm.suture.h"
#include "recorder/recorder.suture.h"
#include "surgeon/surgeon.suture.h"
#include "teleop/teleop.suture.h"

int main(int argc, char** argv) {
  const std::array classes{
      suture::componentClass<robots::Mtm>(),      suture::componentClass<robots::Psm>(),
      suture::componentClass<robots::Teleop>(),   suture::componentClass<robots::Surgeon>(),
      suture::componentClass<robots::Recorder>(),
  };
  return suture::workstationMain(argc, argv, classes);
}
