#pragma once
// A client of an arm that does nothing of itself.

#include <suture/component/device.h>

#include "reference/arm_like.suture.h"

namespace suture {

struct ArmClient final : Device {
  Required<reference::ArmLike> arm{*this, "Arm"};
};

}  // namespace suture
