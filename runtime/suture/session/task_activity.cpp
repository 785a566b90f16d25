#include <suture/codec/stamps.h>
#include <suture/session/task_activity.h>

namespace suture {

using WireActivity = wire::TaskActivity::Activity;

void toWire(const TaskActivity::Reading& activity, wire::TaskActivity::Builder out) {
  switch (activity.activity) {
    case Activity::Running: out.setActivity(WireActivity::RUNNING); break;
    case Activity::Asleep: out.setActivity(WireActivity::ASLEEP); break;
    case Activity::Suspended: out.setActivity(WireActivity::SUSPENDED); break;
  }
  out.setDue(toNanoseconds(activity.due));
}

TaskActivity::Reading fromWire(wire::TaskActivity::Reader in) {
  const bool running = in.getActivity() == WireActivity::RUNNING;
  return {running ? Activity::Running : Activity::Asleep,
          fromNanoseconds(codec::bounded(in.getDue()))};
}

}  // namespace suture
