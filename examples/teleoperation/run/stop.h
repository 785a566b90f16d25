#pragma once
// This is the emergency stop that is pressed during a run.

#include <suture/base/time.h>

#include <optional>
#include <string>
#include <vector>

#include "recorder/recording.h"
#include "run/moment.h"

namespace demo {

/// Parses "6s", or "6s+1500ms": when it is pressed, and how much later it is released (without a
/// length, one second); none for "". Throws suture::SetupError for any other text, and as
/// requireRoom() does.
std::optional<Moment> parseStop(const std::string& text, suture::Duration runLength);

struct Pressed {
  suture::Time pressed;
  std::optional<suture::Time> released;  ///< none: nobody heard of that
};

/// Returns the first stop of a recording after the one with which a coordinator starts.
std::optional<Pressed> firstStop(const std::vector<robots::StopNews>& stops);

}  // namespace demo
