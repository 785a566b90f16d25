#pragma once
#include <suture/annotate.h>

#include "robot/force.h"

namespace folders {

// The header above is of the target in the folder above, whose include root is that folder.
struct SUTURE_TYPE() Grasp {
  Force force;
  bool holds = false;
};

}  // namespace folders
