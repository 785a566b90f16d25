#pragma once
// This is the paper's own experiment: both tasks periodic, SCHED_OTHER and SCHED_FIFO.

#include <string>

#include "bench/figures/report.h"
#include "bench/table2/options.h"

namespace bench {

/// Measures and leaves the figures "other.scs.local" ... "fifo.csc.difference.p50", ms. Returns the
/// table.
std::string periodicRows(const Table2Options& options, Report& report);

}  // namespace bench
