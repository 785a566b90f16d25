#pragma once
// What each component asked of its processor, and whether it had its rate.

#include <suture/observe/report.h>

#include <string>
#include <vector>

#include "run/plan.h"
#include "tables/table.h"

namespace demo {

/// A row for each task. The rate that is asked for is that of the deployment, if it states one; the
/// one that it had is of its last second; what it held is the share of its periods, from its start,
/// that had a cycle. Processor time is of one processor.
Table componentTable(const Plan& plan, const std::vector<suture::Report>& reports);

/// A sentence: what all processes had of the machine's processors, and which part of it was not
/// tasks'.
std::string processorTime(const std::vector<suture::Report>& reports);

}  // namespace demo
