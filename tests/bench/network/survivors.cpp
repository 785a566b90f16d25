#include <signal.h>
#include <suture/base/errors.h>
#include <suture/component/channel.h>
#include <suture/rt/period.h>
#include <suture/rt/thread.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <optional>
#include <thread>

#include "bench/network/arm_process.h"
#include "bench/network/lanes.h"
#include "bench/network/names.h"
#include "bench/network/rows.h"
#include "bench/placement.h"
#include "bench/sleep_until.h"
#include "bench/table.h"
#include "bench/table2/child_process.h"
#include "rt/task_thread/arm_tasks.h"

namespace bench {
namespace {

using namespace std::chrono_literals;
using suture::now;
using suture::SetupError;

// A stop is noticed as a loss, and there is some work between two faults.
constexpr suture::Duration kSilence = 100ms, kStopped = 200ms, kBetween = 100ms;

// Of both loops. What else runs on the machine would hide the one behind the noise of the other.
suture::rt::Scheduling scheduling(const NetworkOptions& options) {
  constexpr int kPriority = 80;
  if (!whyNotFifo(kPriority).empty()) return {.cpu = options.cpu};
  return {.fifoPriority = kPriority, .cpu = options.cpu};
}

struct Periods {
  std::uint64_t executed = 0, skipped = 0;
  suture::Duration longest{0};  // of the cycles

  Periods& operator+=(const Periods& other) {
    executed += other.executed;
    skipped += other.skipped;
    longest = std::max(longest, other.longest);
    return *this;
  }
  double skippedPercent() const {
    return 100 * static_cast<double>(skipped) / static_cast<double>(executed + skipped);
  }
};

/// The arm's process, to which it happens.
class Victim {
 public:
  /// `cpu`: of all of its threads; a process that begins takes a processor for a while.
  Victim(const Names& names, int cpu) : names_(names), cpu_(cpu) { begin(); }

  void killAndBegin() {
    ++faults_;
    process_.reset();
    begin();
  }
  void stop() {
    ++faults_;
    kill(process_->pid(), SIGSTOP);
  }
  void goOn() { kill(process_->pid(), SIGCONT); }
  std::uint64_t faults() const { return faults_; }

 private:
  void begin() {
    const Pinned pinned(cpu_);
    process_.emplace(armProcessArguments(names_.address()));
  }

  const Names& names_;
  const int cpu_;
  std::optional<ChildProcess> process_;
  std::uint64_t faults_ = 0;
};

/// One fault of each kind at least. `awaitBack`: what follows the end of each.
template <class AwaitBack>
void injectFor(suture::Duration length, Victim& victim, const AwaitBack& awaitBack) {
  const suture::Time end = now() + length;
  do {
    victim.killAndBegin();
    awaitBack();
    std::this_thread::sleep_for(kBetween);
    victim.stop();
    std::this_thread::sleep_for(kStopped);
    victim.goOn();
    awaitBack();
    std::this_thread::sleep_for(kBetween);
  } while (now() < end);
}

/// A client of the arm that lives on.
class Survivor {
 public:
  Survivor(suture::Lane lane, const Names& names, const NetworkOptions& options)
      : lane_(lane),
        client_(
            suture::PeriodicOptions{.period = kCycle.period, .scheduling = scheduling(options)}),
        manager_("client", names.address()) {
    client_.also = [this] { look(client_.arm.connected()); };
    manager_.add("Client", client_);
    manager_.start();
    connectBy(lane, manager_, "Client/Arm", "arm:Arm/Crtk", {.silence = kSilence});
    awaitConnection();
  }

  /// Waits for one more than there have been. Throws SetupError: the fault has not been noticed, or
  /// its end has not.
  void awaitConnection() {
    const suture::Time deadline = now() + 10s;
    while (connections_.load() == awaited_) {
      if (now() > deadline) {
        throw SetupError("a connection after a fault", "no new one in 10 s", "Run it again");
      }
      std::this_thread::sleep_for(1ms);
    }
    awaited_ = connections_;
  }

  Periods periods() const {
    const suture::TaskStatistics& counted = client_.statistics();
    return {.executed = counted.cycles,
            .skipped = counted.skipped,
            .longest = counted.computeTime.max()};
  }

  /// Throws SetupError if it did not command and read over its lane to the end.
  void end() {
    std::string others;
    for (const auto& channel : manager_.channels()) {
      if (channel->lane != toString(lane_)) others += ", lane " + channel->lane;
    }
    manager_.stop();
    const proof::ArmUser& user = client_.user;
    if (others.empty() && user.reads > 0 && user.commands > 0) return;
    throw SetupError(std::string("an arm in use over the lane ") + toString(lane_),
                     std::to_string(user.reads) + " reads, " + std::to_string(user.commands) +
                         " commands" + others,
                     "Run it again");
  }

 private:
  // Its task's thread, once a cycle.
  void look(bool connected) {
    if (connected && !connected_) ++connections_;
    connected_ = connected;
  }

  const suture::Lane lane_;
  proof::UserTask<suture::PeriodicTask> client_;
  bool connected_ = false;
  std::atomic<unsigned> connections_{0};
  unsigned awaited_ = 0;
  suture::Manager manager_;
};

Periods survive(suture::Lane lane, const Names& names, Victim& victim,
                const NetworkOptions& options) {
  Survivor survivor(lane, names, options);
  const Periods before = survivor.periods();
  injectFor(options.survivorWindow(), victim, [&] { survivor.awaitConnection(); });
  const Periods after = survivor.periods();
  survivor.end();
  return {.executed = after.executed - before.executed,
          .skipped = after.skipped - before.skipped,
          .longest = after.longest};
}

/// Beside the same faults, which concern it in no way.
Periods bareLoop(Victim& victim, const NetworkOptions& options) {
  std::atomic<bool> over{false};
  Periods periods;
  std::thread loop([&] {
    suture::rt::configureThisThread("bare-loop", scheduling(options));
    suture::rt::Period period(kCycle.period);
    period.begin(now());
    for (; !over; ++periods.executed) sleepUntil(period.advance(now()));
    periods.skipped = period.skipped();
  });
  injectFor(options.survivorWindow(), victim, [] { std::this_thread::sleep_for(50ms); });
  over = true;
  loop.join();
  return periods;
}

}  // namespace

std::string survivorRows(const NetworkOptions& options, Report& report) {
  const Names names(Transport::Unix);
  Victim victim(names, options.otherCpu);
  Periods bare;
  std::map<suture::Lane, Periods> survived;
  std::map<suture::Lane, std::uint64_t> faults;
  for (std::size_t round = 0; round < options.survivorRounds(); ++round) {
    for (const suture::Lane lane : kLanes) {
      const std::uint64_t before = victim.faults();
      survived[lane] += survive(lane, names, victim, options);
      faults[lane] += victim.faults() - before;
      bare += bareLoop(victim, options);
    }
  }

  Table table(1);
  const bool fifo = scheduling(options).fifoPriority.has_value();
  table.row({std::string("1 kHz while the arm is killed and stopped, ") +
                 (fifo ? "SCHED_FIFO" : "default policy"),
             "faults", "periods", "skipped, %", "longest cycle, ms"});
  table.line();
  const auto row = [&](const char* name, std::uint64_t count, const Periods& periods,
                       const std::string& longest) {
    report.add(std::string("survivors.") + name + ".skipped", "%", periods.skippedPercent());
    table.row({name, std::to_string(count), std::to_string(periods.executed + periods.skipped),
               number(periods.skippedPercent(), 3), longest});
  };
  std::uint64_t beside = victim.faults();
  for (const suture::Lane lane : kLanes) {
    const std::string figure = std::string("survivors.") + toString(lane);
    const double longest = static_cast<double>(survived[lane].longest.count()) / 1e6;
    row(toString(lane), faults[lane], survived[lane], number(longest, 2));
    report.add(figure + ".longest", "ms", longest);
    report.add(figure + ".excess", "%", survived[lane].skippedPercent() - bare.skippedPercent());
    report.add(figure + ".faults", "faults", static_cast<double>(faults[lane]));
    beside -= faults[lane];
  }
  row("bare", beside, bare, "");
  return table.toString();
}

}  // namespace bench
