// This is suture-workstation, which runs any process of any deployment of these arms.

#include <suture/deploy/workstation.h>

#include <array>

#include "arm_control/mtm.suture.h"
#include "arm_control/psm.suture.h"
#include "assistant/assistant.suture.h"
#include "console/system_console.suture.h"
#include "coordinator/coordinator.suture.h"
#include "drives/mtm_drives.suture.h"
#include "drives/psm_drives.suture.h"
#include "guidance/knot_guide.suture.h"
#include "pedals/scripted_pedals.suture.h"
#include "person/gamepad.suture.h"
#include "person/keyboard.suture.h"
#include "recorder/knot_recorder.suture.h"
#include "recorder/recorder.suture.h"
#include "registration/registration_table.suture.h"
#include "strand/strand_simulation.suture.h"
#include "surgeon/knot_surgeon.suture.h"
#include "surgeon/operator.suture.h"
#include "surgeon/surgeon.suture.h"
#include "teleop/teleop.suture.h"
#include "vision/knot_tracker.suture.h"
#include "vision/synthetic_endoscope.suture.h"

int main(int argc, char** argv) {
  const std::array classes{
      suture::componentClass<robots::Mtm>(),
      suture::componentClass<robots::Psm>(),
      suture::componentClass<robots::Assistant>(),
      suture::componentClass<robots::SystemConsole>(),
      suture::componentClass<robots::Coordinator>(),
      suture::componentClass<robots::MtmDrives>(),
      suture::componentClass<robots::PsmDrives>(),
      suture::componentClass<robots::Teleop>(),
      suture::componentClass<robots::Surgeon>(),
      suture::componentClass<robots::ScriptedPedals>(),
      suture::componentClass<robots::Gamepad>(),
      suture::componentClass<robots::Keyboard>(),
      suture::componentClass<robots::Recorder>(),
      suture::componentClass<robots::KnotGuide>(),
      suture::componentClass<robots::KnotSurgeon>(),
      suture::componentClass<robots::Operator>(),
      suture::componentClass<robots::KnotRecorder>(),
      suture::componentClass<robots::RegistrationTable>(),
      suture::componentClass<robots::StrandSimulation>(),
      suture::componentClass<robots::SyntheticEndoscope>(),
      suture::componentClass<robots::KnotTracker>(),
  };
  return suture::workstationMain(argc, argv, classes);
}
