#pragma once
// This asks before a run if its recordings have room.

#include <filesystem>

#include "run/plan.h"

namespace demo {

/// This is about what four arms record at the rates of the topologies' files, in MB a second.
constexpr double kUsualRecording = 2.5;

/// Throws suture::SetupError if what the recorders of this plan write in a run of that length does
/// not fit into what is free where the folder is.
void requireSpace(const Plan& plan, suture::Duration length, const std::filesystem::path& folder);

}  // namespace demo
