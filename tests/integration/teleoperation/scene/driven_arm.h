#pragma once
// This is an arm with its drives, as each workstation has them.

#include <suture/manager/manager.h>

#include <string>

#include "arm_control/mtm.h"
#include "arm_control/psm.h"
#include "drives/mtm_drives.h"
#include "drives/psm_drives.h"

namespace robots::test {

template <class Arm, class Drives>
struct DrivenArm {
  /// Adds both to one process, the arm as `name`.
  void addTo(suture::Manager& manager, const std::string& name) {
    manager.add(name, arm);
    manager.add(name + "Drives", drives);
    manager.connect(name + "/Drives", name + "Drives/Drives");
  }

  Arm arm;
  Drives drives;
};

/// `permit` is how old the emergency stop's permission may be; with 0 the drives need none.
struct DrivenPsm : DrivenArm<Psm, PsmDrives> {
  explicit DrivenPsm(suture::Duration permit = {})
      : DrivenArm{Psm(PsmParameters{}), PsmDrives({.permit = permit})} {}
};

struct DrivenMtm : DrivenArm<Mtm, MtmDrives> {
  explicit DrivenMtm(Side side = Side::Left, suture::Duration permit = {})
      : DrivenArm{Mtm({.side = side}), MtmDrives({.side = side, .permit = permit})} {}
};

}  // namespace robots::test
