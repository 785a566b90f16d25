// A process or task that does not run, or is slow, costs bounded memory and delays no other.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/task/event_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/observe/observe.h>

#include <functional>
#include <thread>
#include <utility>

#include "conformance/ends/gate.h"
#include "fault/faulty_arm.h"
#include "fault/history/history_arm.h"
#include "fault/system.h"
#include "support/contains.h"
#include "support/patience.h"
#include "support/resources.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::PoseStamped;

// Memory without a bound would take more than this for what is sent meanwhile.
constexpr std::size_t kMostBytes = std::size_t{2} << 20;
constexpr std::uint64_t kEvents = 30'000;
constexpr int kEventsPerCycle = 50;
constexpr int kCommands = 100'000;
// So many may wait for a subscriber: in its queue, on the lane, and to be counted.
constexpr std::uint64_t kMayWait = 200;

std::string nameOf(const Lane& lane) { return lane == Lane::Auto ? "local" : toString(lane); }
std::string nameOfCase(const testing::TestParamInfo<Lane>& info) { return nameOf(info.param); }

void expectLane(const Manager& manager, const Lane& lane) {
  for (const auto& channel : manager.channels()) {
    EXPECT_EQ(channel->lane, nameOf(lane)) << channel->name();
  }
}

/// Checks when it ends that this process has not grown by kMostBytes since it began.
class MemoryBound {
 public:
  ~MemoryBound() {
    if (!kGivesMemoryBack) return;
    EXPECT_LT(residentBytes(), before_ + kMostBytes);
  }

 private:
  const std::size_t before_ = residentBytes();
};

struct Subscriber final : EventTask {
  Subscriber() {
    arm.on().arrived([this](const PoseStamped&) { ++heard; });
  }
  ~Subscriber() override { stop(); }
  void run() override { gate.pass(); }

  conformance::Gate gate;
  std::atomic<std::uint64_t> heard{0};
  Required<ArmLike> arm{*this, "Arm"};
};

bool hears(const Subscriber& subscriber, std::uint64_t more) {
  const std::uint64_t before = subscriber.heard;
  return eventually([&] { return subscriber.heard >= before + more; });
}

/// StoppedTask has one process, with itself as a peer on the lanes between processes.
class StoppedTask : public testing::TestWithParam<Lane> {
 protected:
  void connect(const std::string& required, const std::string& provided) {
    here_.connect(required, (GetParam() == Lane::Auto ? "" : "here:") + provided,
                  {.lane = GetParam(), .patience = kPatience, .contract = {.silence = 60s}});
  }
  /// Returns how many events the subscriber's end says were dropped, wherever on the lane.
  std::uint64_t droppedFor(const std::string& client) const {
    std::uint64_t dropped = 0;
    for (const ConnectionReport& one : observe(here_, now()).connections) {
      const bool own = one.end != ConnectionEnd::Provider;
      if (own && contains(one.name, client)) dropped += one.eventsDropped;
    }
    return dropped;
  }

  const TemporaryDirectory directory_;
  loop::ControlThread control_;
  const GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  Manager here_{"here", names_.address()};
};

INSTANTIATE_TEST_SUITE_P(Lanes, StoppedTask,
                         testing::Values(Lane::Auto, Lane::Shm, Lane::Frame, Lane::Rpc),
                         nameOfCase);

TEST_P(StoppedTask, AStoppedSubscriberLosesItsOwnEvents) {
  reference::HistoryArm arm(directory_.file("log"), 1, kEventsPerCycle);
  Subscriber stopped, live;
  here_.add("PSM", arm);
  here_.add("Stopped", stopped);
  here_.add("Live", live);
  here_.start();
  connect("Stopped/Arm", "PSM/Arm");
  connect("Live/Arm", "PSM/Arm");
  ASSERT_TRUE(hears(stopped, 100));
  stopped.gate.close();
  ASSERT_TRUE(eventually([&] { return stopped.gate.hasVisitor(); }));
  ASSERT_TRUE(hears(live, 100));
  const std::uint64_t heard = stopped.heard, dropped = droppedFor("Stopped/");
  const std::uint64_t emitted = arm.emitted();
  {
    const MemoryBound bound;
    EXPECT_TRUE(hears(live, 1000));
    EXPECT_TRUE(eventually([&] { return arm.emitted() >= emitted + kEvents; }));
  }
  const std::uint64_t lost = arm.emitted() - emitted;
  EXPECT_EQ(stopped.heard, heard);
  EXPECT_TRUE(eventually([&] { return droppedFor("Stopped/") + kMayWait >= dropped + lost; }))
      << droppedFor("Stopped/") - dropped << " of " << lost;
  const std::uint64_t gone = droppedFor("Stopped/") + stopped.heard;
  EXPECT_LE(gone, arm.emitted()) << "none is counted twice";
  expectLane(here_, GetParam());
  std::printf("1 fault: a task stood still for %d events\n", static_cast<int>(lost));
  stopped.gate.open();
  EXPECT_TRUE(hears(stopped, 100));
  here_.stop();
}

struct Caller final : Device {
  Required<ArmLike> stopped{*this, "Stopped"}, live{*this, "Live"};

  /// Sends the provider that does not run more than it takes, and requires answers of the other.
  void flood() {
    const MemoryBound bound;
    for (int i = 0; i < kCommands; ++i) {
      EXPECT_TRUE(stopped.servo_cp(PoseStamped{}));  // the newest wins
      (void)stopped.hold();
      if (i % 2000 != 0) continue;
      EXPECT_TRUE(live.reset.start().within(kPatience)) << i;
    }
    EXPECT_EQ(stopped.hold().error(), Errc::Full);
    std::printf("1 fault: a provider stood still for %d commands\n", kCommands);
  }
  bool isFull() {
    return eventually([this] {
      const auto held = stopped.hold();
      return !held && held.error() == Errc::Full;
    });
  }
  bool isAnswered() {
    return eventually([this] { return stopped.reset.start().within(500ms).has_value(); });
  }
};

TEST_P(StoppedTask, AStoppedProvidersCommandsAreBounded) {
  const PeriodicOptions often{.period = 1ms};
  const std::string file = directory_.file("hang");
  reference::FaultyArm<PeriodicTask> stopped(file, often), live(directory_.file("never"), often);
  Caller caller;
  here_.add("Stopped", stopped);
  here_.add("Live", live);
  here_.add("Caller", caller);
  here_.start();
  connect("Caller/Stopped", "Stopped/Arm");
  connect("Caller/Live", "Live/Arm");
  ASSERT_TRUE(caller.isAnswered());
  std::ofstream created(file);
  ASSERT_TRUE(caller.stopped.limit(0, reference::Mode::Enabled));
  ASSERT_TRUE(caller.isFull());
  caller.flood();
  expectLane(here_, GetParam());
  std::filesystem::remove(file);
  EXPECT_TRUE(caller.isAnswered());
  here_.stop();
  stopped.stop();
  live.stop();
}

class StoppedProcess : public testing::TestWithParam<Lane> {
 protected:
  /// Waits until the latest client has written so much more down; it writes only what it hears.
  /// Looks at the size alone, because this process's memory is measured.
  bool hasHeard(std::uintmax_t bytes) const {
    const std::uintmax_t before = system_.clientsHistorySize();
    return eventually([&] { return system_.clientsHistorySize() >= before + bytes; });
  }
  /// Runs a provider with two clients, and has the first one hurt while the other listens.
  /// `hurt` tells how many faults it has injected.
  void hurtASubscriber(const std::function<int(Child&)>& hurt) {
    const TemporaryDirectory directory;
    reference::HistoryArm arm(directory.file("log"), 1, kEventsPerCycle);
    Manager here("robot", system_.address());
    here.add("PSM", arm);
    here.start();
    const auto hurtOne = client(), live = client();
    ASSERT_TRUE(hasHeard(2000));
    const std::uint64_t emitted = arm.emitted();
    int faults = 0;
    {
      const MemoryBound bound;
      while (arm.emitted() < emitted + kEvents) {
        faults += hurt(*hurtOne);
        ASSERT_TRUE(hasHeard(500));
      }
      EXPECT_TRUE(hasHeard(20000));
    }
    hurtOne->signal(SIGCONT);
    EXPECT_EQ(live->end(SIGTERM), 0);
    EXPECT_EQ(hurtOne->end(SIGTERM), 0);
    EXPECT_EQ(system_.lanes(), System::Lanes{toString(GetParam())});
    expectSoundHistory(system_.history());
    std::printf("seed %u: %d faults, %zu entries\n", faultSeed(), faults, system_.history().size());
    EXPECT_GT(faults, 0);
    here.stop();
  }
  std::unique_ptr<Child> client() {
    auto child = system_.client("idle", 5000, toString(GetParam()));
    EXPECT_EQ(child->line(), "begun");
    EXPECT_EQ(child->line(), "ready");
    return child;
  }

  System system_;
  const std::unique_ptr<Child> manager_ = system_.manager();
};

INSTANTIATE_TEST_SUITE_P(Lanes, StoppedProcess, testing::Values(Lane::Shm, Lane::Frame, Lane::Rpc),
                         nameOfCase);

TEST_P(StoppedProcess, AStoppedSubscriberDelaysNoOther) {
  bool stopped = false;
  hurtASubscriber([&](Child& child) {
    if (std::exchange(stopped, true)) return 0;
    child.signal(SIGSTOP);
    return 1;
  });
}

// The slow client reads for a short while now and then.
TEST_P(StoppedProcess, ASlowReaderDelaysNoOther) {
  std::mt19937 random(faultSeed());
  std::uniform_int_distribution<int> microseconds(0, 4000);
  hurtASubscriber([&](Child& child) {
    child.signal(SIGCONT);
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
    child.signal(SIGSTOP);
    return 1;
  });
}

TEST_P(StoppedProcess, AStoppedProviderDelaysNoOther) {
  const auto stopped = system_.provider("stopped"), live = system_.provider("live");
  ASSERT_EQ(stopped->line(), "ready");
  ASSERT_EQ(live->line(), "ready");
  Caller caller;
  Manager here("here", system_.address());
  here.add("Caller", caller);
  here.start();
  const ConnectionContract patient{.silence = 60s};
  here.connect("Caller/Stopped", "stopped:PSM/Arm",
               {.lane = GetParam(), .patience = kPatience, .contract = patient});
  here.connect("Caller/Live", "live:PSM/Arm",
               {.lane = GetParam(), .patience = kPatience, .contract = patient});
  ASSERT_TRUE(caller.isAnswered());
  stopped->signal(SIGSTOP);
  ASSERT_TRUE(caller.isFull());
  caller.flood();
  expectLane(here, GetParam());
  stopped->signal(SIGCONT);
  EXPECT_TRUE(caller.isAnswered());
  here.stop();
}

}  // namespace
}  // namespace suture
