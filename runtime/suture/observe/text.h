#pragma once
// Reports for people.

#include <suture/observe/report.h>

#include <string>

namespace suture {

/// Lines of text: tasks, devices, connections. What the other end of a connection counts is said to
/// be there.
std::string toText(const Report& report);

}  // namespace suture
