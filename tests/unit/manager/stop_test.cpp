// stop() ends after the handler that runs: what waits behind it is turned away, not executed.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/component/task/event_task.h>
#include <suture/lane/lane_kind.h>
#include <suture/loop/control_thread.h>
#include <suture/loop/failure.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/rt/doorbell.h>

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "reference/still_arm.h"
#include "support/eventually.h"
#include "support/pass.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"
#include "unit/manager/two_processes.h"
#include "unit/manager/way.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

/// Runs until the test ends it.
struct LongHandler {
  void stay() {
    begun = true;
    while (!released_) bell_.wait();
  }
  void end() {
    released_ = true;
    bell_.ring();
  }

  std::atomic<bool> begun{false};

 private:
  std::atomic<bool> released_{false};
  rt::Doorbell bell_;
};

struct OccupiedArm final : EventTask, StillArm {
  ~OccupiedArm() override { stop(); }
  void run() override { runs += handler.begun ? 1 : 0; }
  void limit(double, reference::Mode) override { handler.stay(); }
  std::uint32_t reset() override { return static_cast<std::uint32_t>(++holds); }

  LongHandler handler;
  std::atomic<int> runs{0};
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

struct StopConsole final : Device {
  Required<reference::ArmLike> slave{*this, "Slave"};
};

/// Stops `task` while its handler runs, which ends thereafter.
void stopIn(LongHandler& handler, Task& task) {
  rt::Doorbell stopped;
  std::thread stopping([&] {
    task.stop();
    stopped.ring();
  });
  EXPECT_TRUE(eventually([&] { return task.ending(); }));
  handler.end();
  stopped.wait();
  stopping.join();
}

class Stop : public testing::TestWithParam<Way> {
 protected:
  Stop() {
    robot_.add("PSM", arm_);
    clients().add("Teleop", client_);
    robot_.start();
    if (GetParam().lane) console_.start();
    clients().connect("Teleop/Slave", GetParam().lane ? "robot:PSM/Arm" : "PSM/Arm",
                      GetParam().options());
  }

  Manager& clients() { return GetParam().lane ? console_ : robot_; }

  const TemporaryDirectory directory_;
  loop::ControlThread control_;
  GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  OccupiedArm arm_;
  StopConsole client_;
  Manager robot_{"robot", names_.address()}, console_{"console", names_.address()};
};

INSTANTIATE_TEST_SUITE_P(Lanes, Stop, testing::ValuesIn(allWays()), nameOfWay);

TEST_P(Stop, EndsAfterTheCommandThatRuns) {
  ASSERT_TRUE(client_.slave.limit(0, reference::Mode::Enabled));
  ASSERT_TRUE(eventually([&] { return arm_.handler.begun.load(); }));
  auto answered = client_.slave.reset.start();
  ASSERT_TRUE(client_.slave.hold());
  const std::shared_ptr<Channel> channel = providersChannel(robot_);
  ASSERT_TRUE(eventually([&] { return channel->commands.pending(); }));
  stopIn(arm_.handler, arm_);
  EXPECT_EQ(arm_.holds, 0);
  EXPECT_EQ(arm_.runs, 0);
  EXPECT_EQ(channel->commands.counters.executed, 1u);
  const Errc error = answered.within(kPatience).error();
  EXPECT_TRUE(error == Errc::Lost || error == Errc::OutcomeUnknown) << toString(error);
}

struct OccupiedDevice final : Device, StillArm {
  std::uint32_t reset() override {
    handling();
    handler.stay();
    return ++resets;
  }

  LongHandler handler;
  std::function<void()> handling = [] {};
  std::atomic<std::uint32_t> resets{0};
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

/// A device does not wait for its handler when it stops. Its caller must not be told that nothing
/// was executed.
class StopOfADevice : public testing::TestWithParam<Way> {
 protected:
  StopOfADevice() {
    robot_.add("PSM", arm_);
    console_.add("Teleop", client_);
    robot_.start();
    console_.start();
    console_.connect("Teleop/Slave", "robot:PSM/Arm", GetParam().options());
  }

  const TemporaryDirectory directory_;
  loop::ControlThread control_;
  GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  OccupiedDevice arm_;
  StopConsole client_;
  Manager robot_{"robot", names_.address()}, console_{"console", names_.address()};
};

INSTANTIATE_TEST_SUITE_P(Lanes, StopOfADevice, testing::ValuesIn(waysBetweenProcesses()),
                         nameOfWay);

TEST_P(StopOfADevice, ARunningCallsOutcomeStaysOpen) {
  auto answered = client_.slave.reset.start();
  ASSERT_TRUE(eventually([&] { return arm_.handler.begun.load(); }));
  arm_.stop();
  const auto answer = answered.within(kPatience);
  arm_.handler.end();
  EXPECT_TRUE(eventually([&] { return arm_.resets == 1; }));
  EXPECT_EQ(answer.error(), Errc::OutcomeUnknown);
}

TEST_P(StopOfADevice, IsNotAskedForInItsHandler) {
  std::promise<std::string> refused;
  arm_.handling = [&, first = true]() mutable {
    std::string why = refusal([&] { robot_.stop(); });
    if (std::exchange(first, false)) refused.set_value(std::move(why));
  };
  arm_.handler.end();
  EXPECT_TRUE(client_.slave.reset.start().within(kPatience));
  const std::string why = refused.get_future().get();
  EXPECT_NE(why.find("in its own thread"), std::string::npos) << why;
  EXPECT_TRUE(client_.slave.reset.start().within(kPatience)) << "a part of it has ended";
}

/// Starts an arm and its console in one process.
void startTogether(Manager& manager, Component& arm, StopConsole& client) {
  manager.add("PSM", arm);
  manager.add("Teleop", client);
  manager.start();
  manager.connect("Teleop/Slave", "PSM/Arm");
}

/// Both ends are in one process, so the answers are exact.
TEST(StopLocal, TurnsAwayWhatWaits) {
  OccupiedArm arm;
  StopConsole client;
  Manager manager("robot");
  startTogether(manager, arm, client);
  ASSERT_TRUE(client.slave.limit(0, reference::Mode::Enabled));
  ASSERT_TRUE(eventually([&] { return arm.handler.begun.load(); }));
  auto answered = client.slave.reset.start();
  ASSERT_TRUE(client.slave.hold());
  const std::shared_ptr<Channel> channel = manager.channels().at(0);
  stopIn(arm.handler, arm);
  EXPECT_EQ(answered.within(kPatience).error(), Errc::Lost);
  EXPECT_EQ(channel->commands.counters.refused, 2u);
  EXPECT_FALSE(channel->commands.pending());
}

TEST(StopLocal, IsNotAskedForByATask) {
  struct Asking final : EventTask, StillArm {
    ~Asking() override { stop(); }
    void run() override {}
    std::uint32_t reset() override {
      refused = refusal([this] { manager->stop(); });
      return 0;
    }
    Manager* manager = nullptr;
    std::string refused;
    Provided<reference::ArmLike> port{*this, "Arm", *this};
  } arm;
  OccupiedArm first;
  StopConsole client;
  Manager manager("robot");
  arm.manager = &manager;
  manager.add("First", first);
  startTogether(manager, arm, client);
  EXPECT_TRUE(client.slave.reset.start().within(kPatience));
  EXPECT_NE(arm.refused.find("stopping 'PSM': it is asked for"), std::string::npos) << arm.refused;
  EXPECT_EQ(first.state(), ComponentState::Running) << "a part of it has ended";
  manager.stop();
  EXPECT_EQ(first.state(), ComponentState::Stopped);
  EXPECT_EQ(arm.state(), ComponentState::Stopped);
}

/// Keeps the control thread of a client for itself for a minute.
class SlowLane final : public LaneKind {
 public:
  const char* name() const override { return "slow"; }
  kj::Own<LaneClient> makeClient(ClientSession&) override {
    pass(60s);
    return kj::heap<Client>();
  }
  kj::Own<LaneServer> makeServer(ServerSession&) override { return {}; }

 private:
  struct Client final : LaneClient {
    std::string whyNot(const OutgoingConnection&) const override { return "it is slow"; }
    kj::Promise<kj::Own<LaneAttempt>> attempt(const OutgoingConnection&) override {
      return loop::failure(kj::Exception::Type::FAILED, "it is slow");
    }
  };
};

// What the control thread holds can end nowhere else, so a manager that went on would leave it
// dangling.
TEST(StopOfABusyProcess, WaitsForItsControlThread) {
  OccupiedArm arm;
  StopConsole client;
  TwoProcesses both;
  both.there.add("PSM", arm);
  both.here.add("Teleop", client);
  both.here.addLane(std::make_unique<SlowLane>());
  both.start();
  const std::string unconnected =
      refusal([&] { both.here.connect("Teleop/Slave", "there:PSM/Arm", {.patience = 0ms}); });
  EXPECT_NE(unconnected.find("the control thread hangs"), std::string::npos) << unconnected;
  testing::internal::CaptureStderr();
  EXPECT_EQ(refusal([&] { both.here.stop(); }), "");
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_NE(told.find("here: waits to end its connections: the control thread hangs"),
            std::string::npos)
      << told;
}

/// Hears of modes, and stays in the handler of the first.
struct OccupiedListener final : EventTask {
  OccupiedListener() {
    slave.on().stopped([this] { handler.stay(), ++heard; });
  }
  ~OccupiedListener() override { stop(); }
  void run() override {}

  LongHandler handler;
  std::atomic<int> heard{0};
  Required<reference::ArmLike> slave{*this, "Slave"};
};

struct StoppedEmitter final : Device, StillArm {
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

TEST(StopLocal, EndsAfterTheEventThatIsHandled) {
  StoppedEmitter arm;
  OccupiedListener listener;
  Manager manager("robot");
  manager.add("PSM", arm);
  manager.add("Teleop", listener);
  manager.connect("Teleop/Slave", "PSM/Arm");
  manager.start();
  ASSERT_TRUE(eventually([&] { return arm.port.emit().stopped() && listener.handler.begun; }));
  ASSERT_TRUE(arm.port.emit().stopped());
  stopIn(listener.handler, listener);
  EXPECT_EQ(listener.heard, 1);
}

}  // namespace
}  // namespace suture
