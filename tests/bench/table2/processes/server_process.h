#pragma once
// This is the server of a loop in a process of its own.

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/table2/setup.h"

namespace bench {

/// Adds the hidden subcommand that is the server process: it serves "server:Server/Loop" until its
/// standard input ends, then writes its samples.
void addServerProcess(CLI::App& program);

/// Says how this program is called to be that process; `apart` puts it in a network namespace of
/// its own, to which the caller stretches a cable.
std::vector<std::string> serverProcessArguments(const LoopSetup& setup,
                                                const std::string& managerAddress, bool apart);

}  // namespace bench
