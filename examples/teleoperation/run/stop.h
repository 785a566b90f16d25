#pragma once
// The emergency stop that is pressed during a run.

#include <suture/base/time.h>

#include <optional>
#include <string>

#include "recorder/recording.h"
#include "run/moment.h"

namespace demo {

/// "6s", or "6s+1500ms": pressed, and released so much later (without a length, one second); none
/// for "". Throws suture::SetupError for any other text, and as requireRoom() does.
std::optional<Moment> parseStop(const std::string& text, suture::Duration runLength);

/// A stop that was pressed and released.
struct Pressed {
  suture::Time pressed, released;
};

/// The first stop that `recording` heard of, after the one that a coordinator starts with; none if
/// it heard of none, or not of its release.
std::optional<Pressed> firstStop(const robots::Recording& recording);

}  // namespace demo
