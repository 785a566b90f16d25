#pragma once

#include <suture/base/errors.h>

#include <string>

#include "teleop/follow_law.h"

namespace robots {

/// Returns `scale`, which is how many metres the slave moves for each metre of the master. Throws
/// suture::SetupError if no slave can follow with it.
inline double requireValidScale(double scale) {
  if (FollowLaw::isValidScale(scale)) return scale;
  throw suture::SetupError("teleoperation with scale " + std::to_string(scale),
                           "a slave can only follow with a finite scale above zero",
                           "Set \"scale\" to slave metres a master metre, e.g. 0.2");
}

}  // namespace robots
