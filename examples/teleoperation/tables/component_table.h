#pragma once
// This says how much processor time each component used, and if it had its rate.

#include <suture/observe/report.h>

#include <string>
#include <vector>

#include "run/plan.h"
#include "tables/table.h"

namespace demo {

/// Returns a row for each task. The rate that is asked for is that of the deployment, if it states
/// one; the one that it had is of its last second; what it held is the share of its periods, from
/// its start, that had a cycle. Processor time is of one processor.
Table componentTable(const Plan& plan, const std::vector<suture::Report>& reports);

/// Returns a sentence about a machine that was too busy for the tasks, and what to do; "" if every
/// task had nearly all of its cycles.
std::string whatTheyMissed(const std::vector<suture::Report>& reports);

/// Returns a sentence about how much of the machine's processors all processes used, and which part
/// of it was not that of tasks.
std::string processorTime(const std::vector<suture::Report>& reports);

}  // namespace demo
