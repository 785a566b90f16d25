#include <suture/manager/heartbeat.h>
#include <suture/manager/records.h>
#include <suture/transport/rpc/deadline.h>
#include <suture/transport/rpc/stamps.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

using WireActivity = wire::TaskPulse::Activity;

// What is told late by as much keeps within a tenth of the bound.
constexpr int kPerBound = 10;

std::string milliseconds(Duration duration) {
  return std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(duration).count()) +
         " ms";
}

}  // namespace

void toWire(const Pulse::Reading& pulse, wire::TaskPulse::Builder out) {
  switch (pulse.activity) {
    case Activity::Running: out.setActivity(WireActivity::RUNNING); break;
    case Activity::Asleep: out.setActivity(WireActivity::ASLEEP); break;
    case Activity::Suspended: out.setActivity(WireActivity::SUSPENDED); break;
  }
  out.setDue(toNanoseconds(pulse.due));
}

Heartbeat::Heartbeat(kj::Timer& timer, wire::Peer::Client peer, std::string component,
                     Bounds bounds)
    : timer_(timer),
      peer_(kj::mv(peer)),
      component_(std::move(component)),
      bounds_(bounds),
      interval_(std::min(bounds.silence, bounds.hang) / kPerBound) {}

kj::Promise<std::string> Heartbeat::whenLost() {
  ask();
  looking_ = look().eagerlyEvaluate(nullptr);
  return kj::mv(lost_.promise);
}

kj::Promise<void> Heartbeat::whenWell() { return kj::mv(well_.promise); }

kj::Promise<void> Heartbeat::look() {
  const Time due = std::min(now() + interval_, heard_ + bounds_.silence);
  return timer_.afterDelay(rpc::toKj(due - now())).then([this, due]() -> kj::Promise<void> {
    const Time present = now();
    // It was this process that did not run; what the peer has sent meanwhile has yet to be read.
    if (present - due > interval_) heard_ = std::max(heard_, present - bounds_.silence + interval_);
    if (present - heard_ >= bounds_.silence) {
      lost_.fulfiller->fulfill("silent: its process has not answered for " +
                               milliseconds(bounds_.silence));
      return kj::READY_NOW;
    }
    if (!asked_) ask();
    return look();
  });
}

void Heartbeat::ask() {
  asked_ = true;
  // A broken link is told of elsewhere.
  asking_ =
      peer_.pingRequest()
          .send()
          .then([this, asked = now()](auto&& told) { heard(asked, told); }, [](kj::Exception&&) {})
          .eagerlyEvaluate(nullptr);
}

void Heartbeat::heard(Time asked, wire::Peer::PingResults::Reader told) {
  asked_ = false;
  heard_ = now();
  if (answered_) answered_(asked, told);
  const Time then = fromNanoseconds(rpc::bounded(told.getSent()));
  for (const auto task : told.getTasks()) {
    if (stringOf(task.getComponent()) == component_ && hangs(task, then)) return;
  }
  well_.fulfiller->fulfill();
}

// On the peer's clock alone, so that neither its offset nor the way of the answer matters. A
// process that was stopped as a whole answers before its tasks have had a turn: a task hangs if it
// has not moved between two answers.
bool Heartbeat::hangs(wire::TaskPulse::Reader task, Time then) {
  const bool running = task.getActivity() == WireActivity::RUNNING;
  const Pulse::Reading pulse{running ? Activity::Running : Activity::Asleep,
                             fromNanoseconds(rpc::bounded(task.getDue()))};
  const Duration overdue = pulse.overdue(then);
  const bool moved = std::exchange(due_, pulse.due) != pulse.due;
  if (overdue <= bounds_.hang) return false;
  if (moved) return true;
  lost_.fulfiller->fulfill(
      "hung: the thread of '" + component_ + "' " +
      (running ? "has been in one cycle for " : "should have begun a cycle before ") +
      milliseconds(overdue) + ", after " + std::to_string(task.getCycles()) + " others");
  return true;
}

}  // namespace suture
