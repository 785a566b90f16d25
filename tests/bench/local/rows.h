#pragma once
// These are the parts of `suture-bench local`. Each measures, leaves its figures in the report and
// returns a table. Nothing else may run in this process meanwhile.

#include <string>

#include "bench/figures/report.h"
#include "bench/local/options.h"

namespace bench {

/// Measures "now": now(), and what it costs beyond the kernel's clock, taken by turns.
std::string clockRows(const LocalOptions& options, Report& report);

/// Measures "ring": a 128-byte command into a ring and out again, on one thread.
std::string ringRow(const LocalOptions& options, Report& report);

/// Measures "state_read": a column of the state table under a 10 kHz writer on the other processor;
/// "read_command": the whole read command of a client. Both have PoseSample.
std::string readRows(const LocalOptions& options, Report& report);

/// Measures "judging": what it costs to ask if the contract admits a PoseSample.
std::string judgingRow(const LocalOptions& options, Report& report);

/// Measures "begin": the executing thread asks before each command if its connection is over.
std::string beginningRows(const LocalOptions& options, Report& report);

/// Measures "csc": client, server, client between two event-driven tasks; "bare": two threads, two
/// rings and two doorbells, nothing else, taken in turns with it.
std::string cscRows(const LocalOptions& options, Report& report);

/// Measures "fan_out": what an event to 64 subscribers costs its sender, for each.
std::string fanOutRow(const LocalOptions& options, Report& report);

/// "throughput": queued writes, executed and counted, on one processor and on two.
std::string throughputRows(const LocalOptions& options, Report& report);

/// Measures "jitter": how late the cycles of a periodic task begin, and those of a bare loop, taken
/// in turns.
std::string jitterRows(const LocalOptions& options, Report& report);

}  // namespace bench
