#pragma once
// These are reports for people.

#include <suture/observe/report.h>

#include <string>

namespace suture {

/// Returns lines of text: tasks, devices, connections. It says which counts are at the other end of
/// a connection.
std::string toText(const Report& report);

}  // namespace suture
