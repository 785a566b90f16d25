#pragma once
// Which poses of an arm may be acted on.

#include <suture/base/sample.h>
#include <suture/base/time.h>

#include "robot_types/pose.h"

namespace robots {

/// The pose, in the frame of its source, if it is valid and its row is no older than `maxAge`; else
/// null. Any thread; lives as long as `sample`.
inline const PoseStamped* freshPose(const suture::Sample<PoseStamped>& sample,
                                    suture::Duration maxAge) {
  return sample && sample.age() <= maxAge && sample->valid ? &*sample : nullptr;
}

/// The same, if it was also measured no longer ago than `maxAge`: a row may be newer than what it
/// carries.
inline const PoseStamped* freshMeasurement(const suture::Sample<PoseStamped>& sample,
                                           suture::Duration maxAge) {
  const PoseStamped* const pose = freshPose(sample, maxAge);
  return pose != nullptr && suture::now() - pose->stamp <= maxAge ? pose : nullptr;
}

}  // namespace robots
