#pragma once
// This is the emergency stop that is pressed during a run.

#include <suture/base/time.h>

#include <optional>
#include <string>

#include "recorder/recording.h"
#include "run/moment.h"

namespace demo {

/// Parses "6s", or "6s+1500ms": when it is pressed, and how much later it is released (without a
/// length, one second); none for "". Throws suture::SetupError for any other text, and as
/// requireRoom() does.
std::optional<Moment> parseStop(const std::string& text, suture::Duration runLength);

/// Is a stop that was pressed and released.
struct Pressed {
  suture::Time pressed, released;
};

/// Returns the first stop that `recording` has, after the one with which a coordinator starts; none
/// if it has none, or not its release.
std::optional<Pressed> firstStop(const robots::Recording& recording);

}  // namespace demo
