#pragma once
// This finds what a name on the command line means.

#include "cli/command_line/options.h"
#include "cli/peer/peer.h"

#include <memory>
#include <string>

namespace suture::cli {

/// Finds the process, links to it and greets it. Throws SetupError.
Peer meet(loop::EventPort& loop, const Options& options, const std::string& process);

/// Returns the component that `target` names. Throws SetupError with those that there are.
ComponentRecord findComponent(Peer& peer, const Target& target);

/// This is an interface as its process explains it, and on which side its component has it.
struct Found {
  wire::Peer::Side side;
  Frames frames;
  std::shared_ptr<const Contract> contract;
};

/// Returns the provided interface of that name, or the required one. Throws SetupError with what
/// there is.
Found findInterface(Peer& peer, const Target& target);

}  // namespace suture::cli
