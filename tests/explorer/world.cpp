#include "explorer/world.h"

#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/observe/observe.h>
#include <suture/testing/test_clock.h>

#include <array>
#include <memory>
#include <optional>
#include <random>

#include "fault/history/history_arm.h"
#include "fault/history/history_caller.h"
#include "support/temporary_directory.h"
#include "support/test_thread.h"

namespace explorer {
namespace {

using namespace std::chrono_literals;
using suture::Duration;

constexpr Duration kHarm = 1s;       // how long a world is done harm
constexpr Duration kRecovery = 1s;   // how soon it works again
constexpr Duration kLateness = 2ms;  // a call may end so late: a cycle of the arm
constexpr Duration kLongestPause = 200ms;
// Seeds of these choices are apart from the others, which stay what they were for each seed.
constexpr std::uint64_t kSeedOfMore = 0x9e3779b97f4a7c15;
constexpr Duration kSilence = 100ms;  // some pauses are longer, and some are not

/// Chooses all that is left to chance.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : numbers_(seed) {}
  /// Below `end`.
  std::uint64_t below(std::uint64_t end) { return numbers_() % end; }
  bool oneIn(std::uint64_t cases) { return below(cases) == 0; }
  Duration upTo(Duration longest) {
    return Duration{static_cast<std::int64_t>(below(static_cast<std::uint64_t>(longest.count())))};
  }

 private:
  std::mt19937_64 numbers_;
};

suture::Lane chooseLane(Chance& chance) {
  return std::array{suture::Lane::Shm, suture::Lane::Frame, suture::Lane::Rpc}[chance.below(3)];
}

suture::ConnectionDelay chooseFaults(Chance& chance, std::uint64_t seed) {
  suture::ConnectionDelay delay;
  if (chance.oneIn(2)) return delay;
  delay.commands = chance.upTo(3ms);
  delay.answers = chance.upTo(3ms);
  suture::FaultPlan& plan = delay.faults;
  plan.seed = seed;
  if (chance.oneIn(3)) plan.loss = 0.05;
  if (chance.oneIn(3)) plan.duplicate = 0.2;
  if (chance.oneIn(3)) plan.reorder = 0.1;
  if (chance.oneIn(4)) plan.burst = 0.01;
  if (chance.oneIn(4)) plan.jitter = chance.upTo(4ms);
  return delay;
}

std::string describe(const suture::Lane& lane, const suture::ConnectionDelay& delay) {
  const suture::FaultPlan& plan = delay.faults;
  return toString(lane) + ", delays " + std::to_string(delay.commands.count()) + " and " +
         std::to_string(delay.answers.count()) + " ns, loss " + std::to_string(plan.loss) +
         ", duplicates " + std::to_string(plan.duplicate) + ", reordering " +
         std::to_string(plan.reorder) + ", bursts " + std::to_string(plan.burst) + ", jitter " +
         std::to_string(plan.jitter.count()) + " ns";
}

/// A Robot is the provider's process: an arm with a history of its own.
struct Robot {
  /// Its tasks run as `process`, and what carries its connections as `network`.
  Robot(const std::string& address, const std::string& log, std::uint32_t number,
        suture::TestClock::Process& process, suture::TestClock::Process& network)
      : arm(log, number) {
    network.run([&] { manager.emplace("robot", address); });
    process.run([this] {
      manager->add("PSM", arm);
      manager->start();
    });
  }
  ~Robot() { manager->stop(); }

  reference::HistoryArm arm;
  std::optional<suture::Manager> manager;
};

class World {
 public:
  World(std::uint64_t seed, suture::TestClock& clock, Outcome& outcome)
      : chance_(seed),
        more_(seed ^ kSeedOfMore),
        outcome_(outcome),
        robotsProcess_(clock),
        robotsNetwork_(clock),
        consolesNetwork_(clock) {
    const suture::Lane lane = chooseLane(chance_);
    const suture::ConnectionDelay delay = chooseFaults(chance_, seed);
    outcome_.lane = toString(lane);
    outcome_.setup = describe(lane, delay) + (hangs_ ? ", an arm that hangs" : "") +
                     (splits_ ? ", a network that splits" : "") +
                     (hasOperator_ ? ", an operator" : "");
    bringManagerUp();
    bringRobotUp();
    const auto resumption = hasOperator_ ? suture::Resume::Operator : suture::Resume::Automatic;
    consolesNetwork_.run([&] {
      console_ = std::make_unique<suture::Manager>("console", address_);
      console_->add("Operator", caller_);
      console_->start();
      console_->connect(
          "Operator/Arm", "robot:PSM/Arm",
          {.lane = lane, .delay = delay, .contract = {.resume = resumption, .silence = kSilence}});
    });
  }
  ~World() {
    console_->stop();
    robot_ = nullptr;
  }

  void run() {
    {
      suture::TestThread harm([this] { doHarm(); });
      while (!harmed_) work();
    }
    recover();
    balance();
  }
  std::vector<suture::HistoryEntry> history() const { return suture::readHistory(logs_); }

 private:
  std::string newLog(const std::string& name) {
    logs_.push_back(directory_.file(name));
    return logs_.back();
  }
  void bringManagerUp() { names_ = std::make_unique<suture::GlobalManager>(control_, address_); }
  void bringRobotUp() {
    ++robots_;
    const std::string log = newLog("robot" + std::to_string(robots_));
    robot_ = std::make_unique<Robot>(address_, log, robots_, robotsProcess_, robotsNetwork_);
  }

  /// The client works in the test's thread.
  void work() {
    if (const Duration pause{standStill_.exchange(0)}; pause > Duration{0}) {
      consolesNetwork_.freeze();
      suture::pass(pause);
      consolesNetwork_.thaw();
    }
    chance_.oneIn(8) ? caller_.burst() : caller_.ask();
    (void)caller_.processEvents();
    if (hasOperator_ && more_.oneIn(16)) caller_.resume(*console_, "Operator/Arm");
    suture::pass(1ms);
  }
  /// The world works as soon as a call is answered.
  void recover() {
    const suture::Time deadline = suture::now() + kRecovery;
    while (suture::now() < deadline) {
      if (hasOperator_) caller_.resume(*console_, "Operator/Arm");
      const auto answer = caller_.arm.distance.start({}).within(20ms);
      if (answer) {
        ++outcome_.answered;
        return;
      }
      suture::pass(1ms);
    }
    outcome_.broken.push_back("no call is answered within a second of the last fault");
  }

  /// Requires of the console's ledger that it says of the commands what has really become of them.
  void balance() {
    // The robot may tell of the last answer after it, and a connection that ends may tell of it
    // only when it is there again.
    const suture::Time deadline = suture::now() + kRecovery;
    while (!isSettled() && suture::now() < deadline) suture::pass(1ms);
    const suture::ConnectionReport console = of(*console_), robot = of(*robot_->manager);
    const std::uint64_t known = console.executed + console.failed;
    require(console.underWay == 0, "all commands have an outcome");
    require(console.sent == known + console.late + console.refused + console.replaced +
                                console.superseded + console.cancelled + console.lost +
                                console.unknown,
            "the console's ledger balances");
    const std::uint64_t executions = executions_ + robot_->arm.executions();
    require(known <= executions && executions <= known + console.unknown,
            std::to_string(executions) + " executions are " + std::to_string(known) +
                " that the console knows of and at most " + std::to_string(console.unknown) +
                " others");
    require(robot.executed + robot.failed == robot_->arm.executions(),
            "the robot has counted what its arm executed");
    require(hasHeard(console, robot), "the console has heard all that the robot has counted");
  }
  static bool hasHeard(const suture::ConnectionReport& console,
                       const suture::ConnectionReport& robot) {
    return console.heard.executed == robot.executed && console.heard.late == robot.late &&
           console.heard.refused == robot.refused;
  }
  bool isSettled() const {
    const suture::ConnectionReport console = of(*console_);
    return console.underWay == 0 && hasHeard(console, of(*robot_->manager));
  }
  void require(bool holds, const std::string& what) {
    if (!holds) outcome_.broken.push_back("not so: " + what);
  }
  /// Returns the report on the only connection between the two processes.
  static suture::ConnectionReport of(const suture::Manager& manager) {
    suture::ConnectionReport last;
    for (auto& one : suture::observe(manager, {}).connections) {
      if (one.name.find("robot:PSM/Arm") != std::string::npos) last = std::move(one);
    }
    return last;
  }

  void takeRobotDown() {
    executions_ += robot_->arm.executions();
    robot_ = nullptr;
  }

  // A thread of its own runs this, beside the client's.
  void doHarm() {
    const suture::Time end = suture::now() + kHarm;
    Chance chance(chance_.below(UINT64_MAX)), more(more_.below(UINT64_MAX));
    while (suture::now() < end) {
      suture::pass(chance.upTo(kLongestPause));
      if (hangs_ && more.oneIn(3)) robot_->arm.hang(more.upTo(2 * kLongestPause));
      if (splits_ && more.oneIn(3)) split(more);
      harm(chance);
      ++outcome_.harms;
    }
    harmed_ = true;
  }
  void harm(Chance& chance) {
    switch (chance.below(7)) {
      case 0:
        takeRobotDown();
        suture::pass(chance.upTo(kLongestPause));
        bringRobotUp();
        break;
      case 1:
        names_ = nullptr;
        suture::pass(chance.upTo(kLongestPause));
        bringManagerUp();
        break;
      case 2:
        robot_->manager->suspend("PSM");
        suture::pass(chance.upTo(kLongestPause));
        robot_->manager->resume("PSM");
        break;
      case 3: freezeRobot(chance); break;
      case 4: freezeConsole(chance); break;
      case 5:
        freezeConsole(chance);
        freezeRobot(chance);
        break;
      default: suture::pass(chance.upTo(kLongestPause));
    }
  }
  void freezeRobot(Chance& chance) {
    robotsProcess_.freeze();
    robotsNetwork_.freeze();
    suture::pass(chance.upTo(kLongestPause));
    robotsNetwork_.thaw();
    robotsProcess_.thaw();
  }
  /// Cuts the processes off from each other, though both work.
  void split(Chance& chance) {
    suture::TestClock::Process& network = chance.oneIn(2) ? robotsNetwork_ : consolesNetwork_;
    network.freeze();
    suture::pass(chance.upTo(kLongestPause));
    network.thaw();
  }
  void freezeConsole(Chance& chance) { standStill_ = chance.upTo(kLongestPause).count(); }

  Chance chance_, more_;
  const bool hangs_ = more_.oneIn(3);
  const bool hasOperator_ = more_.oneIn(4);
  const bool splits_ = more_.oneIn(3);
  Outcome& outcome_;
  suture::TemporaryDirectory directory_;
  const std::string address_ = "unix:" + directory_.file("manager.sock");
  suture::TestClock::Process robotsProcess_, robotsNetwork_, consolesNetwork_;
  std::vector<std::string> logs_;
  suture::loop::ControlThread control_;
  std::unique_ptr<suture::GlobalManager> names_;
  std::uint32_t robots_ = 0;
  std::uint64_t executions_ = 0;  // those of former robots
  std::unique_ptr<Robot> robot_;
  suture::HistoryCaller caller_{newLog("operator"), 1};
  std::unique_ptr<suture::Manager> console_;
  std::atomic<bool> harmed_{false};
  std::atomic<Duration::rep> standStill_{0};  // for so long the console is to be frozen
};

}  // namespace

Outcome runWorld(std::uint64_t seed) {
  Outcome outcome;
  suture::TestClock clock(
      {.seed = seed, .traced = true, .problem = [&outcome](const std::string& problem) {
         outcome.broken.push_back(problem);
       }});
  World world(seed, clock, outcome);
  world.run();
  for (std::string& violation : suture::violations(world.history(), {.lateness = kLateness})) {
    outcome.broken.push_back(std::move(violation));
  }
  outcome.trace = clock.trace();
  return outcome;
}

}  // namespace explorer
