#pragma once
// This is a whole program that runs any process of any deployment; main() lists the component
// classes that it offers, and the lanes that it brings.

#include <suture/component/factory/component_class.h>
#include <suture/lane/added_lanes.h>

#include <span>

namespace suture {

/// Call it before any thread is started. Options: --deployment FILE, --process NAME, --seconds N,
/// --report-interval S, --report-fd N or "-", --report-form json|text, --messages, --check (--help
/// explains them). Runs until the time is over or SIGINT or SIGTERM comes; with --check it judges
/// the file (check.h) and runs nothing. Exit status 0: it ran, and lost no connection, no component
/// and no report before its end, or was told to end while it started, or found no mistake; 1: it
/// did not, and standard error says why; 2: the command line makes no sense.
int workstationMain(int argc, const char* const* argv, std::span<const ComponentClass> classes,
                    const AddedLanes& added = {});

}  // namespace suture
