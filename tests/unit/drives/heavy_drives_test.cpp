// These run the Drives contract on joints that have mass: it holds there as it does on those that
// only lag.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <memory>

#include "drives/simulated_drives.h"
#include "support/allocations.h"
#include "unit/drives/davinci_models.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;

class HeavyDrivesTest : public testing::Test {
 protected:
  HeavyDrivesTest() {
    drives_.permit(true);
    goal_.joints = 7;
    std::copy(parked_.begin(), parked_.end(), goal_.position.begin());
  }

  void cycles(int count) {
    for (int i = 0; i < count; ++i) {
      time_ += 667us;
      drives_.step(time_);
    }
  }
  void follow(double yaw, int count) {
    goal_.position[0] = yaw;
    for (int i = 0; i < count; ++i) {
      drives_.servo_jp(goal_);
      cycles(1);
    }
  }
  double yaw() const { return drives_.feedback().position[0]; }
  double yawRate() const { return drives_.feedback().velocity[0]; }

  const RigidBodyModel<7>::Joints parked_ = kinematics::mtmHome();
  SimulatedDrives<7> drives_{std::make_unique<RigidBodyJoints<7>>(heavyMtm())};
  DriveGoal goal_;
  suture::Time time_ = suture::fromNanoseconds(1);
};

TEST_F(HeavyDrivesTest, FollowGoalsWithPowerAndNotWithout) {
  follow(0.2, 300);
  EXPECT_NEAR(yaw(), 0, 1e-4);
  drives_.power_on(drives_.feedback().permitted);
  follow(0.2, 1500);
  EXPECT_NEAR(yaw(), 0.2, 2e-3);
  EXPECT_NEAR(drives_.feedback().position[1], parked_[1], 2e-3);
}

TEST_F(HeavyDrivesTest, BrakeAtOnceWhereTheyAre) {
  drives_.power_on(drives_.feedback().permitted);
  follow(0.2, 60);
  ASSERT_GT(yawRate(), 0.1);
  drives_.power_off();
  cycles(1);
  const double stopped = yaw();
  cycles(400);
  EXPECT_EQ(yaw(), stopped);
  EXPECT_EQ(yawRate(), 0);
}

TEST_F(HeavyDrivesTest, StopWithoutAPermit) {
  drives_.power_on(drives_.feedback().permitted);
  follow(0.2, 60);
  drives_.permit(false);
  cycles(1);
  const double stopped = yaw();
  follow(0.2, 200);
  EXPECT_EQ(yaw(), stopped);
}

TEST_F(HeavyDrivesTest, AStreamThatFallsSilentLeavesTheJoints) {
  drives_.power_on(drives_.feedback().permitted);
  follow(1, 60);
  cycles(1500);
  const double held = yaw();
  EXPECT_LT(held, 0.9) << "long before the goal";
  cycles(750);
  EXPECT_NEAR(yaw(), held, 1e-3);
  EXPECT_EQ(drives_.feedback().power, DrivePower::On);
}

TEST_F(HeavyDrivesTest, NeverAllocateInTheirCycle) {
  SimulatedDrives<7> noisy{std::make_unique<RigidBodyJoints<7>>(heavyMtm({.noise = 1}))};
  const std::uint64_t before = suture::allocations();
  noisy.permit(true);
  noisy.power_on(noisy.feedback().permitted);
  for (int i = 0; i < 300; ++i) {
    goal_.position[0] = 0.001 * i;
    noisy.servo_jp(goal_);
    time_ += 667us;
    noisy.step(time_);
  }
  noisy.brake();
  EXPECT_EQ(suture::allocations() - before, 0u);
}

}  // namespace
}  // namespace robots::test
