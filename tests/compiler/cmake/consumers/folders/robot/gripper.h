#pragma once
#include <suture/annotate.h>

#include "robot/force.h"

namespace folders {

class SUTURE_INTERFACE() Gripper {
 public:
  virtual ~Gripper() = default;
  SUTURE_COMMAND() virtual void close(const Force& force) = 0;
};

}  // namespace folders
