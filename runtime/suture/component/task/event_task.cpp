#include <suture/component/task/event_task.h>
#include <suture/rt/period.h>

namespace suture {

EventTask::EventTask(const EventOptions& options)
    : ThreadTask(options.scheduling), longestSleep_(options.longestSleep) {
  if (longestSleep_) rt::positivePeriod("the longest sleep of a task", *longestSleep_);
}

bool EventTask::awaitCycle() {
  if (ending() || workPending()) return !ending();
  // What was rung for during the cycle may have been taken in it, by a wait or a poll.
  const bool work = doorbell().takeRing() == rt::RungFor::Work;
  if (work || workPending()) return !ending();
  const Time due = longestSleep_ ? fromNow(*longestSleep_) : Time::max();
  mutableActivity().sleep(due);
  sleepForWork(due);
  return !ending();
}

}  // namespace suture
