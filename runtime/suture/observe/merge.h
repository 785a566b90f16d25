#pragma once
// This makes one picture of what several processes report.

#include <suture/observe/report.h>

#include <vector>

namespace suture {

/// Returns one report for each connection, in the order of first appearance: what its two processes
/// know of it, each about its own end. Its end is ConnectionEnd::Both once both ends are known.
std::vector<ConnectionReport> mergeConnections(const std::vector<Report>& reports);

}  // namespace suture
