#pragma once
#include <suture/annotate.h>

#include "robot_types/pose.suture.h"

namespace grasp {

struct SUTURE_TYPE() Grasp {
  robots::PoseStamped at;  ///< of the jaw
  SUTURE_FIELD(unit("N")) double force = 0;
};

}  // namespace grasp
