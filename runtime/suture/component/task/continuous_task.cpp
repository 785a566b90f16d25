#include <suture/base/virtual_time.h>
#include <suture/component/task/continuous_task.h>

namespace suture {

bool ContinuousTask::awaitCycle() {
  if (VirtualTime* const time = virtualTime(); time != nullptr) time->spend(kLeastCycle);
  return !ending();
}

}  // namespace suture
