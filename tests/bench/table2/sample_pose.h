#pragma once

#include "robot_types/pose.h"

namespace bench {

/// Returns the pose that all measurements send: two frames with names of four characters.
robots::PosePrm samplePose();

}  // namespace bench
