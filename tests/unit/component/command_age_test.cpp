// A handler can ask how old the command was that it executes.

#include <gtest/gtest.h>
#include <suture/component/task/task.h>
#include <suture/wiring/connect.h>

#include <vector>

#include "reference/still_arm.h"
#include "support/pass.h"
#include "unit/component/arm_client.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::PoseStamped;

/// The test is its thread.
class AgingArm final : public Task, public StillArm {
 public:
  void start() override {
    prepare();
    enter();
  }
  void stop() override { leave(); }
  using Task::cycle;

  void servo_cp(const PoseStamped&) override { ages.push_back(port.commandAge()); }
  void hold() override {
    ages.push_back(port.commandAge());
    pass(length);
  }

  std::vector<Duration> ages;
  Duration length{0};  // hold() takes so long
  Provided<ArmLike> port{*this, "Arm", *this};

 private:
  void run() override {}
};

TEST(CommandAge, CountsUntilTheCommandsTurn) {
  AgingArm arm;
  ArmClient client;
  connectLocally(client.arm, arm.port, "test");
  arm.start();
  ASSERT_TRUE(client.arm.servo_cp(PoseStamped{}));
  pass(5ms);
  ASSERT_TRUE(client.arm.hold());
  arm.cycle();
  arm.stop();
  EXPECT_EQ(arm.ages, (std::vector<Duration>{5ms, 0ms})) << "each has its own";
}

TEST(CommandAge, CountsTheHandlersBeforeIt) {
  AgingArm arm;
  arm.length = 3s;
  ArmClient client;
  const auto channel = connectLocally(client.arm, arm.port, "test");
  arm.start();
  ASSERT_TRUE(client.arm.hold());
  ASSERT_TRUE(client.arm.hold());
  ASSERT_TRUE(client.arm.hold());
  arm.cycle();
  arm.stop();
  EXPECT_EQ(arm.ages, (std::vector<Duration>{0s, 3s, 6s}));
  EXPECT_EQ(channel->provider.commandAge->max(), 6s) << "the reports tell the same";
}

}  // namespace
}  // namespace suture
