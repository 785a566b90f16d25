// Both ends of each lane in one process, on one stepped clock.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <suture/component/channel.h>
#include <suture/component/event_task.h>
#include <suture/component/periodic_task.h>
#include <suture/manager/global_manager.h>
#include <suture/manager/manager.h>
#include <suture/testing/test_clock.h>
#include <suture/transport/rpc/control_thread.h>

#include <optional>
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

/// A global manager, an arm in one process and its operator in another: three managers that share
/// nothing but sockets, and memory on `shm`.
struct System {
  explicit System(Lane lane) {
    robot.add("PSM", arm);
    console.add("Operator", user);
    robot.start();
    console.start();
    console.connect("Operator/Slave", "robot:PSM/Arm", lane);
  }
  ~System() {
    console.stop();
    robot.stop();
  }

  TemporaryDirectory directory;
  rpc::ControlThread control;
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

Trace traceOf(Lane lane, std::uint64_t seed) {
  TestClock clock({.seed = seed});
  {
    System system(lane);
    clock.advance(300ms);
  }
  return clock.trace();
}

TEST_P(TwoManagers, DoTheSameInEachRunOfOneSeed) {
  const std::string first = toString(traceOf(GetParam(), 7));
  EXPECT_EQ(first, toString(traceOf(GetParam(), 7)));
  EXPECT_NE(first, toString(traceOf(GetParam(), 8)));
  EXPECT_THAT(first, testing::HasSubstr("executes Arm.servo_cp"));
}

INSTANTIATE_TEST_SUITE_P(Lanes, TwoManagers, testing::Values(Lane::Shm, Lane::Frame, Lane::Rpc),
                         [](const auto& one) { return std::string(toString(one.param)); });

}  // namespace
}  // namespace suture
