#pragma once

#include "robot_types/pose.h"

namespace bench {

/// The pose that all measurements send: two frames with names of four characters.
robots::PosePrm samplePose();

}  // namespace bench
