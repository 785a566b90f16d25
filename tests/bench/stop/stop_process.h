#pragma once
// This is the desk, a pair of arms or the endoscope in a process of its own.

#include <suture/lane/lane.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "bench/stop/parties.h"

namespace bench {

/// Says where the others are, for connections to them: processes, or "" for this one.
struct Places {
  std::string desk, left, right, vision;
};

/// Connects the drives of a pair to the stop, and its viewer to the endoscope.
void connectPair(suture::Manager& manager, const ArmPair& pair, const Places& places,
                 const suture::Lane& lane);
/// Connects the strand to both slaves.
void connectVision(suture::Manager& manager, const Places& places, const suture::Lane& lane);

/// Adds the hidden subcommand, which is process "desk", "left", "right" or "vision" until it is
/// told to end; a pair then writes how many images it has seen.
void addStopProcess(CLI::App& program);
/// Says how this program is called to be that process.
std::vector<std::string> stopProcessArguments(const std::string& process,
                                              const std::string& managerAddress,
                                              const suture::Lane& lane);

}  // namespace bench
