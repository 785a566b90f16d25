#pragma once

#include <suture/base/time.h>

namespace robots {

/// Any thread. Returns true if `stamp` is at most `most` ago. One that is as far in the future
/// counts as little as an old one, because a clock that is wrong makes it.
inline bool isRecent(suture::Time stamp, suture::Duration most) {
  const suture::Duration age = suture::now() - stamp;
  return age <= most && age >= -most;
}

}  // namespace robots
