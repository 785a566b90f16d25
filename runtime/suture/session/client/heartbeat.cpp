#include <suture/codec/stamps.h>
#include <suture/codec/text.h>
#include <suture/loop/deadline.h>
#include <suture/session/client/heartbeat.h>
#include <suture/session/task_activity.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

// Asks this many times within a bound, so that a loss is noticed late by at most a tenth of it.
constexpr int kPerBound = 10;

// The peer has heard of an answer after one and a half round trips, and the next is here after two
// and a half.
constexpr double kRoundTripsInSilence = 2.5;

std::string milliseconds(Duration duration) {
  return std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(duration).count()) +
         " ms";
}

}  // namespace

// ---- one watch

Heartbeat::Watch::Watch(Heartbeat& heartbeat, std::string component, Bounds bounds, Lost lost)
    : heartbeat_(heartbeat),
      component_(std::move(component)),
      bounds_(bounds),
      tellLost_(kj::mv(lost)) {}

Heartbeat::Watch::~Watch() { std::erase(heartbeat_.watches_, this); }

kj::Promise<void> Heartbeat::Watch::whenItWorks() {
  auto pair = kj::newPromiseAndFulfiller<void>();
  well_ = kj::mv(pair.fulfiller);
  return kj::mv(pair.promise);
}

// Counts from the beginning of the watch if the peer was told of an answer before that.
BootTime Heartbeat::Watch::silentAt() const {
  if (bounds_.silence == kEver) return BootTime::max();
  return std::max(heartbeat_.told_, begun_) + bounds_.silence;
}

void Heartbeat::Watch::lose(std::string why) {
  if (!std::exchange(lost_, true)) tellLost_(std::move(why));
}

// A process that did not run for that long must not go on as if the peer had waited for it.
void Heartbeat::Watch::look(BootTime present, BootTime begun) {
  if (present < silentAt()) return;
  heartbeat_.lostOne_ = true;
  const Duration paused = present - begun;
  const bool here = paused >= bounds_.silence;
  lose(here ? "silent: this process has not run for " + milliseconds(paused)
            : "silent: its process has not answered for " + milliseconds(bounds_.silence) +
                  heartbeat_.whyTooShort(bounds_.silence));
}

void Heartbeat::Watch::heard(wire::TaskActivity::Reader task, Time then) {
  if (hangs(task, then)) return;
  KJ_IF_MAYBE (well, well_) (*well)->fulfill();
}

// Compares only times of the peer's clock, so that neither its offset nor the time that the answer
// took matters. A process that was stopped as a whole answers before its tasks have run, so a task
// hangs only if it has not moved between two answers.
bool Heartbeat::Watch::hangs(wire::TaskActivity::Reader task, Time then) {
  const TaskActivity::Reading activity = fromWire(task);
  const bool running = activity.activity == Activity::Running;
  const Duration overdue = activity.overdue(then);
  const bool moved = std::exchange(due_, activity.due) != activity.due;
  if (overdue <= bounds_.hang) return false;
  if (moved) return true;
  lose("hung: the thread of '" + component_ + "' " +
       (running ? "has been in one cycle for " : "should have begun a cycle before ") +
       milliseconds(overdue) + ", after " + std::to_string(task.getCycles()) + " others");
  return true;
}

// ---- all of them

kj::Own<Heartbeat::Watch> Heartbeat::watch(std::string component, Bounds bounds, Lost lost) {
  auto watch = kj::heap<Watch>(*this, std::move(component), bounds, kj::mv(lost));
  watches_.push_back(watch.get());
  name();
  looking_ = look().eagerlyEvaluate(nullptr);
  if (!gone_.empty()) watch->lose(gone_);
  return watch;
}

void Heartbeat::end(const std::string& why) {
  if (gone_.empty()) gone_ = why;
  for (Watch* watch : watches_) watch->lose(why);
}

// The places of all watches change with a name, and only then.
void Heartbeat::name() {
  if (std::vector<std::string> now = components(); now != named_) {
    named_ = std::move(now);
    renamed_ = true;
  }
  for (Watch* watch : watches_) {
    const auto place = std::lower_bound(named_.begin(), named_.end(), watch->component_);
    watch->place_ = static_cast<std::size_t>(place - named_.begin());
  }
}

std::vector<std::string> Heartbeat::components() const {
  std::vector<std::string> names;
  for (const Watch* watch : watches_) names.push_back(watch->component_);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

bool Heartbeat::silent() const {
  return lostOne_ && std::none_of(watches_.begin(), watches_.end(), [](Watch* watch) {
           return watch->bounds_.silence != kEver && !watch->lost_;
         });
}

// Returns "" if the silence is long enough for the way, or no answer has come yet.
std::string Heartbeat::whyTooShort(Duration silence) const {
  if (fastest_ == kEver) return "";
  const auto least = std::chrono::ceil<std::chrono::milliseconds>(kRoundTripsInSilence * fastest_);
  if (silence >= least) return "";
  return ", but answers take " + milliseconds(fastest_) + ": let \"silence\" be at least " +
         milliseconds(least);
}

Duration Heartbeat::interval() const {
  Duration shortest = kEver;
  for (const Watch* watch : watches_) {
    shortest = std::min({shortest, watch->bounds_.silence, watch->bounds_.hang});
  }
  return shortest / kPerBound;
}

kj::Promise<void> Heartbeat::look() {
  if (!asked_) ask();
  if (watches_.empty()) return kj::READY_NOW;
  const BootTime begun = BootClock::now();
  Duration pause = interval();
  for (Watch* watch : watches_) {
    if (!watch->lost_) pause = std::min(pause, watch->silentAt() - begun);
  }
  return timer_.afterDelay(loop::toKj(std::max(pause, Duration{0}))).then([this, begun] {
    const BootTime present = BootClock::now();
    for (Watch* watch : watches_) watch->look(present, begun);
    return look();
  });
}

void Heartbeat::ask() {
  asked_ = true;
  auto request = peer_.pingRequest();
  request.setHeard(heard_);
  if (std::exchange(renamed_, false)) {
    auto names = request.initComponents(static_cast<unsigned>(named_.size()));
    for (unsigned i = 0; i < named_.size(); ++i) names.set(i, codec::textOf(named_[i]));
  }
  if (heard_ != 0) told_ = BootClock::now();
  // Ignore a failure: other code learns of a broken link.
  asking_ =
      request.send()
          .then([this, asked = now()](auto&& told) { heard(asked, told); }, [](kj::Exception&&) {})
          .eagerlyEvaluate(nullptr);
}

// An answer to a question from before a change of names is about other components.
void Heartbeat::heard(Time asked, wire::Peer::PingResults::Reader told) {
  asked_ = false;
  lostOne_ = false;
  heard_ = told.getSent();
  noteRoundTrip(now() - asked);
  if (answered_) answered_(asked, told);
  if (renamed_) {
    looking_ = kj::evalLater([this] { return look(); }).eagerlyEvaluate(nullptr);
    return;
  }
  const auto tasks = told.getTasks();
  if (tasks.size() != named_.size()) return;
  const Time then = fromNanoseconds(codec::bounded(told.getSent()));
  for (Watch* watch : watches_) watch->heard(tasks[static_cast<unsigned>(watch->place_)], then);
}

}  // namespace suture
