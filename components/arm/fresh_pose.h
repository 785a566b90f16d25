#pragma once
// This says which poses of an arm a client may act on.

#include <suture/base/sample.h>
#include <suture/base/time.h>

#include "robot_types/pose.h"
#include "robot_types/rigid_pose.h"
#include "timing/recent.h"

namespace robots {

/// Any thread. Returns the pose, in the frame of its source, if it is valid, rigid and its row is
/// no older than `maxAge`; else null. It lives as long as `sample`.
inline const PoseStamped* freshPose(const suture::Sample<PoseStamped>& sample,
                                    suture::Duration maxAge) {
  const bool usable = sample && sample.age() <= maxAge && sample->valid && isRigid(sample->pose);
  return usable ? &*sample : nullptr;
}

/// Returns the same if it was also measured no longer ago than `maxAge`, and not in the future;
/// else null. A row may be newer than the measurement that it carries.
inline const PoseStamped* freshMeasurement(const suture::Sample<PoseStamped>& sample,
                                           suture::Duration maxAge) {
  const PoseStamped* const pose = freshPose(sample, maxAge);
  return pose != nullptr && isRecent(pose->stamp, maxAge) ? pose : nullptr;
}

}  // namespace robots
