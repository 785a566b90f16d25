#pragma once
// This says what travelled over each connection, and how old it was when it arrived.

#include <suture/deploy/document/deployment.h>
#include <suture/observe/report.h>

#include <string>
#include <vector>

#include "tables/table.h"

namespace demo {

/// Returns a row for each connection, and a second one if it had both reads and commands. Columns
/// in which nothing happened are left out. It fits a terminal of 120 columns, unless commands were
/// dropped or late.
Table connectionTable(const suture::Deployment& deployment,
                      const std::vector<suture::ConnectionReport>& connections);

/// Returns a sentence about commands that were dropped, or late.
std::string lostCommands(const std::vector<suture::ConnectionReport>& connections);

}  // namespace demo
