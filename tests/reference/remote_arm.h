#pragma once
// This is a fixture for tests of a lane: an arm, and its client in another process.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/task/periodic_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/net/tls/certificate.h>
#include <suture/net/tls/key_maker.h>
#include <suture/net/tls/keys.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "reference/still_arm.h"
#include "support/eventually.h"
#include "support/resources.h"
#include "support/temporary_directory.h"

namespace suture {

/// Moves wherever it is sent.
struct MovingArm final : PeriodicTask, StillArm {
  MovingArm() : PeriodicTask({.period = std::chrono::milliseconds(1)}) {}
  ~MovingArm() override { stop(); }
  void run() override {}
  bool move(const reference::PoseStamped&, double, const std::string&) override { return true; }
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

/// Shows its connection.
struct Teleop final : PeriodicTask {
  Teleop() : PeriodicTask({.period = std::chrono::milliseconds(1)}) {}
  ~Teleop() override { stop(); }
  void run() override {
    if (asked.exchange(false)) {
      call = slave.move.start({}, speed, "test");
      waiting = true;
    }
    if (waiting && call.poll() != nullptr) {
      waiting = false;
      outcome = call.poll()->has_value() ? Errc{} : call.poll()->error();
    }
    reachable = slave.connected();
    seen = slave.measured_cp().hasValue();
  }
  std::atomic<bool> asked{false}, reachable{false}, seen{false};
  std::atomic<double> speed{0};
  bool waiting = false;
  std::atomic<Errc> outcome{Errc::NotYet};
  Required<reference::ArmLike> slave{*this, "Slave"};
  decltype(std::declval<Required<reference::ArmLike>&>().move.start({}, 0, "")) call{Errc::NotYet};
};

/// A robot and its console, two processes to each other: nothing is shared but the sockets.
class RemoteArm : public testing::Test {
 protected:
  void begin(const std::string& address, const Policy& policy = {}) {
    if (address.starts_with("tls:")) {
      tls::makeKeys(directory_.path() / "keys", {tls::kManagerName, "robot", "console"});
    }
    global_ = std::make_unique<GlobalManager>(control_, address, securityOf(tls::kManagerName));
    robot = std::make_unique<Manager>("robot", global_->address(), securityOf("robot", policy));
    console = std::make_unique<Manager>("console", global_->address(), securityOf("console"));
    robot->add("PSM", psm);
    console->add("Teleop", teleop);
    for (std::size_t i = 0; i < others.size(); ++i) {
      console->add("Other" + std::to_string(i), *others[i]);
    }
    robot->start();
    console->start();
  }
  std::string unixAddress() const { return "unix:" + directory_.file("manager.sock"); }
  Security securityOf(const std::string& process, Policy policy = {}) const {
    const auto folder = directory_.path() / "keys";
    if (!exists(folder)) return {.policy = std::move(policy)};
    return {.keys = std::make_shared<const tls::Keys>(folder, process),
            .policy = std::move(policy)};
  }
  void connect(const Lane& lane = Lane::Auto) {
    console->connect("Teleop/Slave", "robot:PSM/Arm", {.lane = lane});
    ASSERT_TRUE(eventually([&] { return teleop.reachable.load(); }));
  }
  std::shared_ptr<Channel> channel() const { return console->channels().at(0); }
  Errc outcomeOf(double speed) {
    teleop.outcome = Errc::NotYet;
    teleop.speed = speed;
    teleop.asked = true;
    EXPECT_TRUE(eventually([&] { return teleop.outcome != Errc::NotYet; }));
    return teleop.outcome;
  }
  /// `speed` of ArmLike::move() has a range() of 0 to 1.
  void expectArgumentsJudged() {
    EXPECT_EQ(outcomeOf(0.5), Errc{});
    EXPECT_EQ(outcomeOf(1.5), Errc::Invalid);
    EXPECT_EQ(outcomeOf(std::numeric_limits<double>::quiet_NaN()), Errc::Invalid);
    EXPECT_EQ(outcomeOf(1), Errc{});
  }
  /// Connects again and again over `lane`.
  void expectEverythingGivenBack(const Lane& lane) {
    std::size_t before = 0;
    for (int lap = 0; lap < 50; ++lap) {
      connect(lane);
      EXPECT_EQ(channel()->lane, toString(lane));
      console->disconnect("Teleop/Slave");
      ASSERT_TRUE(eventually([&] { return !teleop.reachable; }));
      if (lap == 4) before = openDescriptors();
    }
    EXPECT_TRUE(eventually([&] { return openDescriptors() <= before + 3; })) << openDescriptors();
  }
  const std::string& manager() const { return global_->address(); }
  /// Starts another process of that name, in the place of the one before.
  void restartRobot() {
    robot->stop();
    robot.reset();
    EXPECT_TRUE(eventually([&] { return !teleop.reachable; }));
    robot = std::make_unique<Manager>("robot", manager(), securityOf("robot"));
    robot->add("PSM", psmAgain);
    robot->start();
  }

  MovingArm psm, psmAgain;  // of the robot, and when it is restarted
  Teleop teleop;
  std::vector<std::unique_ptr<Teleop>> others;  // more of the console's; before begin()
  std::unique_ptr<Manager> robot, console;

 private:
  TemporaryDirectory directory_;
  loop::ControlThread control_;
  std::unique_ptr<GlobalManager> global_;
};

}  // namespace suture
