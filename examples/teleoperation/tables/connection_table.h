#pragma once
// What travelled over each connection, and how old it was when it arrived.

#include <suture/observe/report.h>

#include <string>
#include <vector>

#include "run/plan.h"
#include "tables/table.h"

namespace demo {

/// A row for each connection, and a second one if it had both reads and commands. Columns in which
/// nothing happened are left out.
Table connectionTable(const Plan& plan, const std::vector<suture::ConnectionReport>& connections);

/// A sentence on commands that were dropped, or late.
std::string unwelcome(const std::vector<suture::ConnectionReport>& connections);

}  // namespace demo
