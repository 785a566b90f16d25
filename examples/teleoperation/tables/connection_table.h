#pragma once
// What travelled over each connection, and how old it was when it arrived.

#include <suture/deploy/document/deployment.h>
#include <suture/observe/report.h>

#include <string>
#include <vector>

#include "tables/table.h"

namespace demo {

/// A row for each connection, and a second one if it had both reads and commands. Columns in which
/// nothing happened are left out. Fits a terminal of 120 columns, unless commands were dropped or
/// late.
Table connectionTable(const suture::Deployment& deployment,
                      const std::vector<suture::ConnectionReport>& connections);

/// A sentence on commands that were dropped, or late.
std::string unwelcome(const std::vector<suture::ConnectionReport>& connections);

}  // namespace demo
