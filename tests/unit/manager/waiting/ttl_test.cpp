// The age of a command is judged when its turn comes: one that was new when a drain began may be
// too old behind a handler that takes long.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/task/periodic_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <memory>
#include <optional>
#include <string>

#include "reference/still_arm.h"
#include "support/eventually.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

constexpr Duration kTtl = 500ms;  // of servo_cp

/// Takes `length` for each limit().
struct SlowArm final : PeriodicTask, StillArm {
  explicit SlowArm(Duration length) : PeriodicTask({.period = 1ms}), length_(length) {}
  ~SlowArm() override { stop(); }
  void run() override {}
  void limit(double, reference::Mode) override { pass(length_); }
  void servo_cp(const reference::PoseStamped&) override { ++servos; }
  void hold() override { ++holds; }

  std::atomic<int> servos{0};
  Provided<reference::ArmLike> port{*this, "Arm", *this};

 private:
  const Duration length_;
};

/// Sends in one cycle what the provider finds in one drain.
struct SendingClient final : PeriodicTask {
  SendingClient() : PeriodicTask({.period = 1ms}) {}
  ~SendingClient() override { stop(); }
  void run() override {
    if (sent || !slave.connected()) return;
    sent = slave.limit(0, reference::Mode::Enabled) && slave.servo_cp({}) && slave.hold();
  }
  std::atomic<bool> sent{false};
  Required<reference::ArmLike> slave{*this, "Slave"};
};

/// If no lane is given, provider and client are in one process.
class Ttl : public testing::TestWithParam<std::optional<Lane>> {
 protected:
  /// Returns when the provider has executed what was sent last.
  void send(SlowArm& arm) {
    const bool local = !GetParam();
    const auto robot = std::make_unique<Manager>("robot", names_.address());
    const auto console = local ? nullptr : std::make_unique<Manager>("console", names_.address());
    Manager& clients = local ? *robot : *console;
    robot->add("PSM", arm);
    clients.add("Teleop", client_);
    robot->start();
    if (!local) console->start();
    clients.connect("Teleop/Slave", local ? "PSM/Arm" : "robot:PSM/Arm",
                    {.lane = GetParam().value_or(Lane::Auto)});
    EXPECT_TRUE(eventually([&] { return arm.holds == 1; }));
    late_ = robot->channels().at(0)->commands.counters.late;
    clients.stop();
    robot->stop();
  }

  const TemporaryDirectory directory_;
  loop::ControlThread control_;
  GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  SendingClient client_;
  std::uint64_t late_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Lanes, Ttl,
                         testing::Values(std::nullopt, Lane::Shm, Lane::Frame, Lane::Rpc),
                         [](const auto& row) {
                           return std::string(row.param ? toString(*row.param) : "local");
                         });

TEST_P(Ttl, RunsOutBehindALongHandler) {
  SlowArm arm(kTtl + 1ms);
  send(arm);
  EXPECT_EQ(arm.servos, 0);
  EXPECT_EQ(late_, 1u);
}

TEST_P(Ttl, HoldsBehindAHandlerThatIsFaster) {
  SlowArm arm(kTtl - 10ms);
  send(arm);
  EXPECT_EQ(arm.servos, 1);
  EXPECT_EQ(late_, 0u);
}

}  // namespace
}  // namespace suture
