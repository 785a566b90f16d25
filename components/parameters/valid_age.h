#pragma once

#include <suture/base/errors.h>
#include <suture/base/time.h>

#include <chrono>
#include <string>

#include "timing/seconds.h"

namespace robots {

/// Throws suture::SetupError if no data can be fresh by the parameter `name`, or if a component
/// would have to remember for too long by it.
inline void requireAge(const char* name, suture::Duration age) {
  if (age > suture::Duration{0} && age <= std::chrono::minutes(1)) return;
  throw suture::SetupError(
      "judging data by \"" + std::string(name) + "\" of " + std::to_string(inSeconds(age)) + " s",
      "an age is longer than nothing and at most a minute", "Set it to so many seconds, e.g. 0.25");
}

}  // namespace robots
