#pragma once
// These are the loops where the network shows: both tasks event-driven, everything on one
// processor.

#include <cstddef>
#include <string>

#include "bench/figures/report.h"
#include "bench/table2/options.h"

namespace bench {

/// Measures and leaves the figures "event.scs.local" ... "event.csc.difference" (of medians) and
/// "raw.unix", "raw.tcp", us; the raw sockets carry `payloadBytes` each way. Returns the table.
std::string eventRows(const Table2Options& options, std::size_t payloadBytes, Report& report);

}  // namespace bench
