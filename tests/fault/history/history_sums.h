#pragma once
// These turn what the report of a process says of its connections into the sums of a history.

#include <suture/manager/manager.h>
#include <suture/observe/observe.h>

#include <map>
#include <stdexcept>
#include <string>

#include "fault/history/history.h"

namespace suture {

inline HistorySums sumsOf(const ConnectionReport& report, std::uint64_t process) {
  const std::uint64_t executed = report.executed + report.failed;
  return {.accepted = report.sent,
          .executed = executed,
          .others = report.commands() - executed,
          .lost = report.lost,
          .unknown = report.unknown,
          .underWay = report.underWay,
          .heard = report.heard.commands(),
          .process = process,
          .other = report.otherIncarnation};
}

/// Returns what the manager's process reports of its only connection that has such an end here.
inline ConnectionReport reportOf(const Manager& manager, ConnectionEnd end) {
  for (const ConnectionReport& one : observe(manager, now()).connections) {
    if (one.end == end) return one;
  }
  throw std::logic_error("there is no connection");
}

/// Returns the sums of all connections of the process, by the connection's name.
inline std::map<std::string, HistorySums> sumsOf(const Manager& manager) {
  std::map<std::string, HistorySums> sums;
  for (const ConnectionReport& one : observe(manager, {}).connections) {
    sums[one.name] = sumsOf(one, manager.incarnation());
  }
  return sums;
}

}  // namespace suture
