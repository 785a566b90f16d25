#pragma once
// The desk, or a pair of arms, in a process of its own.

#include <suture/manager/lane.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "bench/stop/parties.h"

namespace bench {

/// Connects the drives of a pair to the stop and its viewer to the endoscope of process `desk`, ""
/// if that is this one.
void connectPair(suture::Manager& manager, const ArmPair& pair, const std::string& desk,
                 suture::Lane lane);
/// Connects the strand of a desk to the slaves of both pairs' processes, likewise.
void connectDesk(suture::Manager& manager, const std::string& left, const std::string& right,
                 suture::Lane lane);

/// Adds the hidden subcommand: is process "desk", "left" or "right" until it is told to end; a pair
/// then writes how many images it has seen.
void addStopProcess(CLI::App& program);
/// How this program is called to be that process.
std::vector<std::string> stopProcessArguments(const std::string& process,
                                              const std::string& managerAddress, suture::Lane lane);

}  // namespace bench
