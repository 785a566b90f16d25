#pragma once
// Whether a required interface and a provided one mean poses in the same coordinate frames.

#include <suture/base/frames.h>

#include <string>

namespace suture {

/// "expects reference frame 'PSM2_base' and is offered 'PSM1_base'"; "" if they fit: what one of
/// the two does not declare is not compared.
std::string frameDifference(const Frames& required, const Frames& provided);

/// Throws SetupError with that.
void requireSameFrames(const Frames& required, const Frames& provided,
                       const std::string& connection);

}  // namespace suture
