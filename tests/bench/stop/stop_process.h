#pragma once
// The desk, or a workstation, in a process of its own.

#include <suture/manager/lane.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "bench/stop/parties.h"

namespace bench {

/// Connects the drives of a workstation to the stop of process `desk`, "" if it is this one.
void connectWorkstation(suture::Manager& manager, const StopWorkstation& workstation,
                        const std::string& desk, suture::Lane lane);
/// Connects the strand of a desk to the slaves of both workstations' processes, likewise.
void connectDesk(suture::Manager& manager, const std::string& left, const std::string& right,
                 suture::Lane lane);

/// Adds the hidden subcommand: is process "desk", "left" or "right" until it is told to end.
void addStopProcess(CLI::App& program);
/// How this program is called to be that process.
std::vector<std::string> stopProcessArguments(const std::string& process,
                                              const std::string& managerAddress, suture::Lane lane);

}  // namespace bench
