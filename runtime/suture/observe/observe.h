#pragma once
// Takes a process's numbers.

#include <suture/manager/manager.h>
#include <suture/observe/report.h>

namespace suture {

/// All connections, tasks and devices of the manager's process now. The manager's thread; disturbs
/// no task. `began`: when the process began to be observed.
Report observe(const Manager& manager, Time began);

}  // namespace suture
