#pragma once
// This reads a process's numbers.

#include <suture/manager/manager.h>
#include <suture/observe/report.h>

namespace suture {

/// The manager's thread; disturbs no task. Reports all connections, tasks and devices of the
/// manager's process now. `began` says when the observation of the process began.
Report observe(const Manager& manager, Time began);

}  // namespace suture
