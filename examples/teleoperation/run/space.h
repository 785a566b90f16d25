#pragma once
// This asks before a run if its recordings have room.

#include <filesystem>

#include "run/plan.h"

namespace demo {

/// Four arms record about so many MB a second at the rates of the topologies' files.
constexpr double kUsualRecording = 2.5;

/// Throws suture::SetupError if the disk of the folder has less room than the recorders of this
/// plan need in a run of that length.
void requireSpace(const Plan& plan, suture::Duration length, const std::filesystem::path& folder);

}  // namespace demo
