#pragma once
// What a client of an arm asks of the arm's process, for tests that play the client by hand.

#include "reference/arm_like.suture.h"

namespace reference {

/// `from`: the process that it says it is. Connects its "Teleop/Slave" to "PSM/Arm".
template <class Request>
void askForArm(Request& request, const char* from) {
  const suture::InterfaceInfo& contract = suture::interfaceInfo<ArmLike>();
  request.setFromProcess(from);
  request.setFromComponent("Teleop");
  request.setRequired("Slave");
  request.setToComponent("PSM");
  request.setProvided("Arm");
  request.setContract(contract.name);
  request.setHash(contract.hash);
  request.setDescription(contract.description);
}

}  // namespace reference
