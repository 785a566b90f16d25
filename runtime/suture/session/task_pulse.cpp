#include <suture/session/task_pulse.h>
#include <suture/wire/stamps.h>

namespace suture {

using WireActivity = wire::TaskPulse::Activity;

void toWire(const Pulse::Reading& pulse, wire::TaskPulse::Builder out) {
  switch (pulse.activity) {
    case Activity::Running: out.setActivity(WireActivity::RUNNING); break;
    case Activity::Asleep: out.setActivity(WireActivity::ASLEEP); break;
    case Activity::Suspended: out.setActivity(WireActivity::SUSPENDED); break;
  }
  out.setDue(toNanoseconds(pulse.due));
}

Pulse::Reading fromWire(wire::TaskPulse::Reader in) {
  const bool running = in.getActivity() == WireActivity::RUNNING;
  return {running ? Activity::Running : Activity::Asleep,
          fromNanoseconds(rpc::bounded(in.getDue()))};
}

}  // namespace suture
