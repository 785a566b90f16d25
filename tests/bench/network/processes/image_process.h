#pragma once
// This process sends goals to an arm and images to a viewer, in `suture-bench network`.

#include <suture/manager/manager.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace bench {

/// The threads of connections have this priority: otherwise a thread that computes on an image for
/// milliseconds would keep a goal waiting.
inline constexpr int kLanePriority = 60;

/// Adds the hidden subcommand that the process runs.
void addImageProcess(CLI::App& program);

/// Returns the command line of the process "guide". Its "Commander" calls put() of
/// "arm:Arm/Samples" each millisecond over `lane`, with the time of the call as the value's stamp;
/// "guide:Camera/Images" has a new pair of images 15 times a second.
std::vector<std::string> imageProcessArguments(const std::string& managerAddress,
                                               const suture::Lane& lane);

}  // namespace bench
