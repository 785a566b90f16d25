#include <suture/loop/deadline.h>
#include <suture/names/records.h>
#include <suture/session/heartbeat.h>
#include <suture/wire/stamps.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

using WireActivity = wire::TaskPulse::Activity;

// Asks so often in a bound that a loss is told late by at most a tenth of it.
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
  const BootTime begun = BootClock::now();
  const Duration pause = std::min<Duration>(interval_, told_ + bounds_.silence - begun);
  return timer_.afterDelay(rpc::toKj(pause)).then([this, begun]() -> kj::Promise<void> {
    const BootTime present = BootClock::now();
    if (present - told_ >= bounds_.silence) {
      lost_.fulfiller->fulfill(whySilent(present - begun));
      return kj::READY_NOW;
    }
    if (!asked_) ask();
    return look();
  });
}

// A process that has not run for so long must not go on as if the peer had waited for it.
std::string Heartbeat::whySilent(Duration paused) const {
  if (paused < bounds_.silence) {
    return "silent: its process has not answered for " + milliseconds(bounds_.silence);
  }
  return "silent: this process has not run for " + milliseconds(paused);
}

void Heartbeat::ask() {
  asked_ = true;
  auto request = peer_.pingRequest();
  request.setHeard(heard_);
  if (heard_ != 0) told_ = BootClock::now();
  // Ignore a failure: a broken link is told of elsewhere.
  asking_ =
      request.send()
          .then([this, asked = now()](auto&& told) { heard(asked, told); }, [](kj::Exception&&) {})
          .eagerlyEvaluate(nullptr);
}

void Heartbeat::heard(Time asked, wire::Peer::PingResults::Reader told) {
  asked_ = false;
  heard_ = told.getSent();
  if (answered_) answered_(asked, told);
  const Time then = fromNanoseconds(rpc::bounded(told.getSent()));
  for (const auto task : told.getTasks()) {
    if (stringOf(task.getComponent()) == component_ && hangs(task, then)) return;
  }
  well_.fulfiller->fulfill();
}

// Compares times of the peer's clock alone, so that neither its offset nor the way of the answer
// matters. A process that was stopped as a whole answers before its tasks have had a turn, so a
// task hangs only if it has not moved between two answers.
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
