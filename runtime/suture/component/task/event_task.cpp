#include <suture/component/task/event_task.h>

namespace suture {

bool EventTask::awaitCycle() {
  if (ending() || workPending()) return !ending();
  // What was rung for during the cycle may have been taken in it, by a wait or a poll.
  const bool work = doorbell().takeRing() == rt::RungFor::Work;
  if (work || workPending()) return !ending();
  const Time due = longestSleep_ ? now() + *longestSleep_ : Time::max();
  mutableActivity().sleep(due);
  sleepForWork(due);
  return !ending();
}

}  // namespace suture
