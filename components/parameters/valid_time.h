#pragma once

#include <suture/base/errors.h>
#include <suture/base/time.h>

#include <chrono>
#include <sstream>
#include <string>

#include "timing/seconds.h"

namespace robots {

/// A component may be asked to wait, or something to last, for a time within this range.
struct TimeRange {
  suture::Duration shortest = std::chrono::milliseconds(1);
  suture::Duration longest = std::chrono::hours(24);
};

/// Throws suture::SetupError unless the parameter `name` is a time within `range`.
inline void requireTime(const char* name, suture::Duration time, const TimeRange& range = {}) {
  if (time >= range.shortest && time <= range.longest) return;
  const auto seconds = [](suture::Duration duration) {
    std::ostringstream text;
    text << inSeconds(duration);
    return text.str();
  };
  throw suture::SetupError(
      "a time \"" + std::string(name) + "\" of " + seconds(time) + " s",
      "it may be from " + seconds(range.shortest) + " s to " + seconds(range.longest) + " s long",
      "Set it to so many seconds, e.g. 0.25");
}

/// Does the same for a time that may be 0 too, which then means something else than a time.
inline void requireTimeOrZero(const char* name, suture::Duration time,
                              const TimeRange& range = {}) {
  if (time != suture::Duration{0}) requireTime(name, time, range);
}

}  // namespace robots
