#pragma once
// The contract of a stereo endoscope: what both eyes see.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include "robot_types/vision.h"

namespace robots {

/// Two rectified images of one moment; both stamps are that of the exposure.
struct SUTURE_TYPE() StereoPair {
  ImageFrame left;
  ImageFrame right;
};

class SUTURE_INTERFACE() StereoImages {
 public:
  virtual ~StereoImages() = default;

  /// The last pair; invalid while there is nothing to see.
  SUTURE_COMMAND() virtual const StereoPair& images() const = 0;
  /// The stamp of the last pair, and 0 while there is nothing to see: who asks this first copies
  /// megabytes only if they are new.
  SUTURE_COMMAND() virtual suture::Time exposed() const = 0;
};

}  // namespace robots
