#pragma once

#include <suture/base/time.h>

namespace robots {

/// Any thread. Returns true if `stamp` is at most `most` ago. One that lies farther in the future
/// than that counts as little as an old one, because a wrong clock made it.
inline bool isRecent(suture::Time stamp, suture::Duration most) {
  const suture::Duration age = suture::now() - stamp;
  return age <= most && age >= -most;
}

}  // namespace robots
