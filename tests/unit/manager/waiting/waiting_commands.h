#pragma once
// Here a provider finds in one drain what waits behind a command that takes long.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/task/periodic_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "reference/still_arm.h"
#include "support/eventually.h"
#include "support/temporary_directory.h"
#include "unit/manager/way.h"

namespace suture {

constexpr Duration kTtl = std::chrono::milliseconds(500);  // as servo_cp declares it

/// Does what the test says in each limit().
struct SlowArm final : PeriodicTask, StillArm {
  explicit SlowArm(std::function<void()> inLimit)
      : PeriodicTask({.period = std::chrono::milliseconds(1)}), inLimit_(std::move(inLimit)) {}
  ~SlowArm() override { stop(); }
  void run() override {
    if (inRun) inRun();
  }
  void limit(double, reference::Mode) override {
    ++limits;
    inLimit_();
  }
  void servo_cp(const reference::PoseStamped&) override { ++servos; }
  void hold() override { ++holds; }

  std::function<void()> inRun = nullptr;
  std::atomic<int> limits{0}, servos{0}, holds{0};
  Provided<reference::ArmLike> port{*this, "Arm", *this};

 private:
  const std::function<void()> inLimit_;
};

/// Sends in one cycle what the provider finds in one drain.
struct SendingClient final : PeriodicTask {
  SendingClient() : PeriodicTask({.period = std::chrono::milliseconds(1)}) {}
  ~SendingClient() override { stop(); }
  void run() override {
    const bool connected = slave.connected();
    lost = lost || (sent > 0 && !connected);
    if (sent == wanted || !connected) return;
    if (slave.limit(0, reference::Mode::Enabled) && slave.servo_cp({}) && slave.hold()) ++sent;
  }
  std::atomic<int> wanted{1}, sent{0};  // times
  std::atomic<bool> lost{false};
  Required<reference::ArmLike> slave{*this, "Slave"};
};

class WaitingCommands : public testing::TestWithParam<Way> {
 protected:
  /// Sends, and returns when `done` says so. Notes what became of the commands.
  void send(SlowArm& arm, const std::function<bool()>& done, ConnectionContract contract = {}) {
    const bool local = !GetParam().lane;
    const auto robot = std::make_unique<Manager>("robot", names_.address());
    const auto console = local ? nullptr : std::make_unique<Manager>("console", names_.address());
    Manager& clients = local ? *robot : *console;
    robot->add("PSM", arm);
    clients.add("Teleop", client_);
    robot->start();
    if (!local) console->start();
    clients.connect("Teleop/Slave", local ? "PSM/Arm" : "robot:PSM/Arm",
                    GetParam().options(contract));
    std::shared_ptr<Channel> channel;
    EXPECT_TRUE(eventually([&] {
      if (channel == nullptr) channel = providersChannel(*robot);
      return channel != nullptr && done();
    }));
    late_ = channel->commands.counters.late;
    refused_ = channel->commands.counters.refused;
    oldest_ = channel->provider.commandAge->max();
    clients.stop();
    robot->stop();
  }
  /// Sends, and returns when the provider has executed what was sent last.
  void send(SlowArm& arm) {
    send(arm, [&] { return arm.holds == 1; });
  }

  const TemporaryDirectory directory_;
  loop::ControlThread control_;
  GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  SendingClient client_;
  std::uint64_t late_ = 0, refused_ = 0;
  Duration oldest_{0};  // of all that were executed, the one that waited longest
};

}  // namespace suture
