// This runs either process of deployment.json.

#include <suture/deploy/workstation.h>

#include <array>

#include "04_contract_and_loss/follower.suture.h"
#include "04_contract_and_loss/simulated_joystick.suture.h"

int main(int argc, char** argv) {
  const std::array classes{
      suture::componentClass<following::SimulatedJoystick>(),
      suture::componentClass<following::Follower>(),
  };
  return suture::workstationMain(argc, argv, classes);
}
