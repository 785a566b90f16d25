// A handler can ask how old the command was that it executes.

#include <gtest/gtest.h>
#include <suture/component/task.h>
#include <suture/wiring/connect.h>

#include <thread>
#include <vector>

#include "reference/still_arm.h"
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
  void hold() override { ages.push_back(port.commandAge()); }

  std::vector<Duration> ages;
  Provided<ArmLike> port{*this, "Arm", *this};

 private:
  void run() override {}
};

TEST(CommandAge, IsThatFromSendingToTheComparisonWithTheTtl) {
  AgingArm arm;
  ArmClient client;
  connectLocally(client.arm, arm.port, "test");
  arm.start();
  const Time beforeFirst = now();
  ASSERT_TRUE(client.arm.servo_cp(PoseStamped{}));
  const Time afterFirst = now();
  std::this_thread::sleep_for(5ms);
  const Time beforeSecond = now();
  ASSERT_TRUE(client.arm.hold());
  const Time beforeCycle = now();
  arm.cycle();
  const Time afterCycle = now();
  arm.stop();
  ASSERT_EQ(arm.ages.size(), 2u);
  EXPECT_GE(arm.ages[0], beforeCycle - afterFirst);
  EXPECT_LE(arm.ages[0], afterCycle - beforeFirst);
  EXPECT_LE(arm.ages[1], afterCycle - beforeSecond) << "each has its own";
}

}  // namespace
}  // namespace suture
