#pragma once
// This client of an arm does nothing of itself, so that each call is the test's.

#include <suture/component/device.h>

#include "reference/arm_like.suture.h"

namespace suture {

struct ArmClient final : Device {
  Required<reference::ArmLike> arm{*this, "Arm"};
};

}  // namespace suture
