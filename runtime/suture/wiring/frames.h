#pragma once
// This checks if a required interface and a provided one mean poses in the same coordinate frames.

#include <suture/base/frames.h>

#include <string>

namespace suture {

/// Returns "expects reference frame 'PSM2_base' and is offered 'PSM1_base'", or "" if they fit. It
/// does not compare what one of the two does not declare.
std::string frameDifference(const Frames& required, const Frames& provided);

/// Throws SetupError with that difference.
void requireSameFrames(const Frames& required, const Frames& provided,
                       const std::string& connection);

}  // namespace suture
