#pragma once
// This is the contract of a stereo endoscope, which shows what both eyes see.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include "robot_types/vision.h"

namespace robots {

/// Holds two rectified images of one moment; both stamps are that of the exposure.
struct SUTURE_TYPE() StereoPair {
  ImageFrame left;
  ImageFrame right;
};

class SUTURE_INTERFACE() StereoImages {
 public:
  virtual ~StereoImages() = default;

  /// Returns the last pair; it is not valid while there is nothing to see.
  SUTURE_COMMAND() virtual const StereoPair& images() const = 0;
  /// Returns the stamp of the last pair, and 0 while there is nothing to see. A client that asks
  /// this first copies megabytes only if they are new.
  SUTURE_COMMAND() virtual suture::Time exposed() const = 0;
};

}  // namespace robots
