#include <signal.h>
#include <suture/base/errors.h>
#include <suture/component/channel/channel.h>
#include <suture/rt/period.h>
#include <suture/rt/scheduling.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <optional>
#include <thread>

#include "bench/figures/table.h"
#include "bench/network/lanes.h"
#include "bench/network/names.h"
#include "bench/network/processes/arm_process.h"
#include "bench/network/rows.h"
#include "bench/placement.h"
#include "bench/sleep_until.h"
#include "bench/table2/processes/child_process.h"
#include "rt/task_thread/arm_tasks.h"

namespace bench {
namespace {

using namespace std::chrono_literals;
using suture::now;
using suture::SetupError;

// A stop is noticed as a loss, and there is some work between two faults.
constexpr suture::Duration kSilence = 100ms, kStopped = 200ms, kBetween = 100ms;

constexpr int kPriority = 80;  // the survivor's task has it

// Both loops have real-time priority, since what else runs on the machine would hide one loop
// behind the noise of the other.
suture::rt::Scheduling scheduling(const NetworkOptions& options, int priority) {
  return urgent(priority, options.cpu);
}

struct Periods {
  std::uint64_t executed = 0, skipped = 0;
  suture::Duration longest{0};  // the longest cycle

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

/// A Victim is the arm's process, to which it happens.
class Victim {
 public:
  /// `cpu` is the processor of all of its threads; a process that begins takes a processor for a
  /// while.
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

/// A Survivor is a client of the arm that lives on.
class Survivor {
 public:
  Survivor(const suture::Lane& lane, const Names& names, const NetworkOptions& options)
      : lane_(lane),
        client_(suture::PeriodicOptions{.period = kCycle.period,
                                        .scheduling = scheduling(options, kPriority)}),
        manager_("client", names.address()) {
    client_.also = [this] { look(client_.arm.connected()); };
    manager_.add("Client", client_);
    manager_.start();
    connectBy(lane, manager_, "Client/Arm", "arm:Arm/Arm", {.silence = kSilence});
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
  // Its task's thread calls this once a cycle.
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

/// Injects one fault of each kind at least; the survivor is connected anew after each.
void injectFor(suture::Duration length, Victim& victim, Survivor& survivor) {
  const suture::Time end = now() + length;
  do {
    victim.killAndBegin();
    survivor.awaitConnection();
    std::this_thread::sleep_for(kBetween);
    victim.stop();
    std::this_thread::sleep_for(kStopped);
    victim.goOn();
    survivor.awaitConnection();
    std::this_thread::sleep_for(kBetween);
  } while (now() < end);
}

/// A BareLoop is a loop that only sleeps, on the survivor's processor at the same time: what the
/// machine takes from the one it takes from the other. It has the higher priority, so that what the
/// survivor itself takes too long for is missing to the survivor alone.
class BareLoop {
 public:
  explicit BareLoop(const NetworkOptions& options)
      : thread_([this, scheduling = scheduling(options, kPriority + 1)] { run(scheduling); }) {}
  ~BareLoop() { end(); }
  BareLoop(const BareLoop&) = delete;
  BareLoop& operator=(const BareLoop&) = delete;

  Periods end() {
    over_ = true;
    if (thread_.joinable()) thread_.join();
    return periods_;
  }

 private:
  void run(const suture::rt::Scheduling& scheduling) {
    suture::rt::configureThisThread("bare-loop", scheduling);
    suture::rt::Period period(kCycle.period);
    period.begin(now());
    for (; !over_; ++periods_.executed) sleepUntil(period.advance(now()));
    periods_.skipped = period.skipped();
  }

  std::atomic<bool> over_{false};
  Periods periods_;
  std::thread thread_;
};

/// Counts what one lane went through.
struct Survived {
  std::uint64_t faults = 0;
  Periods task, bare;

  Survived& operator+=(const Survived& other) {
    faults += other.faults;
    task += other.task;
    bare += other.bare;
    return *this;
  }
};

Survived survive(const suture::Lane& lane, const Names& names, const NetworkOptions& options) {
  Victim victim(names, options.otherCpu);
  Survivor survivor(lane, names, options);
  const Periods before = survivor.periods();
  BareLoop bare(options);
  injectFor(options.survivorWindow(), victim, survivor);
  Survived survived{.faults = victim.faults(), .task = survivor.periods(), .bare = bare.end()};
  survived.task.executed -= before.executed;
  survived.task.skipped -= before.skipped;
  survivor.end();
  return survived;
}

}  // namespace

std::string survivorRows(const NetworkOptions& options, Report& report) {
  const Names names(Transport::Unix);
  std::map<std::string, Survived> survived;  // by lane
  for (std::size_t round = 0; round < options.survivorRounds(); ++round) {
    for (const suture::Lane& lane : kLanes)
      survived[toString(lane)] += survive(lane, names, options);
  }

  Table table(1);
  const bool fifo = scheduling(options, kPriority).policy == suture::rt::Policy::Fifo;
  table.row({std::string("1 kHz while the arm is killed and stopped, ") +
                 (fifo ? "SCHED_FIFO" : "default policy"),
             "faults", "periods", "skipped, %", "a bare loop beside", "longest cycle, ms"});
  table.line();
  for (const suture::Lane& lane : kLanes) {
    const std::string figure = "survivors." + toString(lane);
    const auto& [faults, task, bare] = survived[toString(lane)];
    const double longest = static_cast<double>(task.longest.count()) / 1e6;
    report.add(figure + ".faults", "faults", static_cast<double>(faults));
    report.add(figure + ".skipped", "%", task.skippedPercent());
    report.add(figure + ".bare", "%", bare.skippedPercent());
    report.add(figure + ".excess", "%", task.skippedPercent() - bare.skippedPercent());
    report.add(figure + ".longest", "ms", longest);
    table.row({toString(lane), std::to_string(faults), std::to_string(task.executed + task.skipped),
               number(task.skippedPercent(), 3), number(bare.skippedPercent(), 3),
               number(longest, 2)});
  }
  return table.toString();
}

}  // namespace bench
