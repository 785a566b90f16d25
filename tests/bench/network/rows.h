#pragma once
// The parts of `suture-bench network`. Each measures, leaves its figures in the report and returns
// a table. Nothing else may run in this process meanwhile.

#include <string>

#include "bench/network/options.h"
#include "bench/report.h"

namespace bench {

/// "shm", "rpc.unix", "rpc.tcp": PoseSample from task to task and back, between two processes;
/// "raw.shm", "raw.unix", "raw.tcp": as many bytes without Suture, in the same run; the ratios.
std::string roundTripRows(const NetworkOptions& options, Report& report);

/// "mirror_read": a read command whose provider is in another process, by shared memory;
/// "local_read": the same in this one.
std::string mirrorRows(const NetworkOptions& options, Report& report);

}  // namespace bench
