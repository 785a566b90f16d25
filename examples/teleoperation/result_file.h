#pragma once
// This writes a run's figures into a file.

#include <filesystem>

#include "run/plan.h"
#include "run/processes.h"
#include "verdict.h"

namespace demo {

/// Writes JSON: the topology's name, the options, the programs, each connection, arm, task and
/// check, what stands beside the paper's figures, the knot, and the slaves that held during a
/// break. Durations are ns, lengths m, angles rad. Throws suture::SetupError if the file cannot be
/// written.
void writeResult(const std::filesystem::path& file, const Options& options, const Plan& plan,
                 const Network& network, const CrewResult& result, const Verdict& verdict);

}  // namespace demo
