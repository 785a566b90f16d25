// Both ends of each lane are in one process, on one stepped clock.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/component/task/event_task.h>
#include <suture/component/task/periodic_task.h>
#include <suture/loop/control_thread.h>
#include <suture/loop/failure.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/net/listener.h>
#include <suture/net/secure.h>
#include <suture/testing/test_clock.h>
#include <suture/wiring/connect.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <vector>

#include "reference/still_arm.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

struct ArmTask final : PeriodicTask, StillArm {
  ArmTask() : PeriodicTask({.period = 1ms}) {}
  ~ArmTask() override { stop(); }
  void run() override {}
  void servo_cp(const reference::PoseStamped&) override { ++moves; }
  void hold() override {
    StillArm::hold();
    port.emit().stopped();
  }
  int moves = 0;
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

struct Operator final : PeriodicTask {
  Operator() : PeriodicTask({.period = 1ms}) {
    slave.on().stopped([this] { ++stops; });
  }
  ~Operator() override { stop(); }
  void run() override {
    if (slave.servo_cp({})) ++sent;
    if (const auto pose = slave.measured_cp()) longestAge = std::max(longestAge, pose.age());
    if (sent % 10 == 0) (void)slave.hold();
  }
  Required<reference::ArmLike> slave{*this, "Slave"};
  int sent = 0, stops = 0;
  Duration longestAge{};
};

/// Holds a global manager, an arm in one process and its operator in another: three managers that
/// share nothing but sockets, and memory on `shm`.
struct System {
  explicit System(const Lane& lane) {
    robot.add("PSM", arm);
    console.add("Operator", user);
    robot.start();
    console.start();
    console.connect("Operator/Slave", "robot:PSM/Arm", {.lane = lane});
  }
  ~System() {
    console.stop();
    robot.stop();
  }

  TemporaryDirectory directory;
  loop::ControlThread control;
  GlobalManager global{control, "unix:" + directory.file("manager.sock")};
  ArmTask arm;
  Operator user;
  Manager robot{"robot", global.address()};
  Manager console{"console", global.address()};
};

class TwoManagers : public testing::TestWithParam<Lane> {};

TEST_P(TwoManagers, SendOnceEachPeriodAndLoseNothing) {
  TestClock clock;
  {
    System system(GetParam());
    EXPECT_EQ(system.console.channels().at(0)->lane, toString(GetParam()));
    clock.advance(2s);
    EXPECT_GE(system.user.sent, 1990);
    EXPECT_NEAR(system.arm.moves, system.user.sent, 3);
    EXPECT_GE(system.user.stops, 190);
    EXPECT_LE(system.user.longestAge, 2ms);
  }
}

Trace traceOf(const Lane& lane, std::uint64_t seed) {
  TestClock clock({.seed = seed, .traced = true});
  {
    System system(lane);
    clock.advance(300ms);
  }
  return clock.trace();
}

/// An OtherProcess is a process that listens at `path` until it is killed.
class OtherProcess {
 public:
  explicit OtherProcess(const std::string& path) {
    int ready[2];
    EXPECT_EQ(pipe(ready), 0);
    process_ = fork();
    if (process_ == 0) {
      loop::EventPort port;
      const net::Listener listener(port, net::Address::parse("unix:" + path));
      [[maybe_unused]] const auto told = write(ready[1], "r", 1);
      for (;;) pause();
    }
    char byte;
    EXPECT_EQ(read(ready[0], &byte, 1), 1);
    close(ready[0]);
    close(ready[1]);
  }
  ~OtherProcess() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }

 private:
  pid_t process_;
};

TEST(SteppedClock, RefusesToTalkToAnotherProcess) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("other.sock");
  const OtherProcess other(path);
  TestClock clock;
  loop::EventPort port;
  std::string said;
  KJ_IF_MAYBE (failure, kj::runCatchingExceptions([&] {
                 reach(port, net::Address::parse("unix:" + path), {}, "other", 1s)
                     .wait(port.scope());
               })) {
    said = loop::describe(*failure);
  }
  EXPECT_THAT(said, testing::HasSubstr("cannot follow the stepped clock of this one"));
}

struct SleepingArm final : EventTask, StillArm {
  ~SleepingArm() override { stop(); }
  void run() override {}
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

struct Caller final : Device {
  Required<reference::ArmLike> arm{*this, "Arm"};
};

TEST(SteppedClock, TellsOfWorkWithoutARing) {
  std::vector<std::string> problems;
  TestClock clock({.problem = [&](const std::string& one) { problems.push_back(one); }});
  SleepingArm arm;
  Caller caller;
  connectLocally(caller.arm, arm.port, "test");
  arm.start();
  clock.advance(1ms);
  EXPECT_TRUE(caller.arm.hold());
  arm.doorbell().takeRing();  // as a defect would lose it
  clock.advance(2s);
  EXPECT_EQ(arm.holds, 1);
  EXPECT_THAT(problems, testing::ElementsAre(testing::HasSubstr("which nobody had rung")));
}

/// Says hold in its first cycle, which takes longer than any task sleeps.
struct SlowCaller final : PeriodicTask {
  SlowCaller() : PeriodicTask({.period = 10s}) {}
  ~SlowCaller() override { stop(); }
  void run() override {
    if (says) {
      EXPECT_TRUE(arm.hold());
    }
    TestClock::spend(5s);
  }
  bool says = true;
  Required<reference::ArmLike> arm{*this, "Arm"};
};

TEST(SteppedClock, TellsOfSilentWorkBesideAnotherThread) {
  std::vector<std::string> problems;
  TestClock clock({.problem = [&](const std::string& one) { problems.push_back(one); }});
  SleepingArm arm;
  SlowCaller busy;
  Caller caller;
  busy.says = false;
  connectLocally(caller.arm, arm.port, "test");
  arm.start();
  busy.start();
  clock.advance(10s + 1ms);
  EXPECT_TRUE(caller.arm.hold());
  arm.doorbell().takeRing();  // as a defect would lose it
  clock.advance(2s);
  EXPECT_EQ(arm.holds, 1);
  EXPECT_THAT(problems, testing::ElementsAre(testing::HasSubstr("which nobody had rung")));
}

TEST(SteppedClock, BearsWorkThatEndsACycle) {
  std::vector<std::string> problems;
  TestClock clock({.problem = [&](const std::string& one) { problems.push_back(one); }});
  SleepingArm arm;
  SlowCaller caller;
  connectLocally(caller.arm, arm.port, "test");
  arm.start();
  caller.start();
  clock.advance(12s);
  EXPECT_EQ(arm.holds, 1);
  EXPECT_TRUE(problems.empty()) << problems.front();
}

TEST_P(TwoManagers, RepeatTheRunOfASeed) {
  const std::string first = toString(traceOf(GetParam(), 7));
  EXPECT_EQ(first, toString(traceOf(GetParam(), 7)));
  EXPECT_NE(first, toString(traceOf(GetParam(), 8)));
  EXPECT_THAT(first, testing::HasSubstr("executes Arm.servo_cp"));
}

INSTANTIATE_TEST_SUITE_P(Lanes, TwoManagers, testing::Values(Lane::Shm, Lane::Frame, Lane::Rpc),
                         [](const auto& one) { return toString(one.param); });

}  // namespace
}  // namespace suture
