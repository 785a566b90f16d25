#pragma once
#include <suture/annotate.h>

#include "force.h"

namespace folders {

// The header above is of the target in the folder above, whose include root is that folder. It lies
// beside this one and is included so, which does not say its path below that root.
struct SUTURE_TYPE() Grasp {
  Force force;
  bool holds = false;
};

}  // namespace folders
