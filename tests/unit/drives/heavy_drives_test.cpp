// These run the Drives contract on joints that have mass: it holds there as it does on those that
// only lag.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

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
  void release(double yawEffort, int count) {
    goal_.released.fill(true);
    goal_.effort[0] = yawEffort;
    follow(parked_[0], count);
  }
  double yawEffort() const { return drives_.feedback().effort[0]; }
  double shoulderEffort() const { return drives_.feedback().effort[1]; }
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

TEST_F(HeavyDrivesTest, ASilentStreamLeavesTheJoints) {
  drives_.power_on(drives_.feedback().permitted);
  follow(1, 60);
  cycles(1500);
  const double held = yaw();
  EXPECT_LT(held, 0.9) << "long before the goal";
  cycles(750);
  EXPECT_NEAR(yaw(), held, 1e-3);
  EXPECT_EQ(drives_.feedback().power, DrivePower::On);
}

TEST_F(HeavyDrivesTest, SayThatTheyControlEfforts) {
  EXPECT_TRUE(drives_.feedback().controls_effort);
}

TEST_F(HeavyDrivesTest, PushButDoNotHoldReleasedJoints) {
  drives_.power_on(drives_.feedback().permitted);
  release(0.5, 200);
  EXPECT_GT(yaw(), parked_[0] + 0.005);
  EXPECT_NEAR(yawEffort(), 0.5, 1e-2);
}

TEST_F(HeavyDrivesTest, AddAGoalsEffort) {
  drives_.power_on(drives_.feedback().permitted);
  goal_.effort[0] = 1;
  follow(parked_[0], 600);
  EXPECT_NEAR(yaw(), parked_[0] + 1 / heavyMtm().stiffness[0], 3e-3);
}

TEST_F(HeavyDrivesTest, HoldReleasedJointsAfterSilence) {
  drives_.power_on(drives_.feedback().permitted);
  release(0.5, 200);
  cycles(750);
  const double held = yaw();
  cycles(750);
  EXPECT_NEAR(yaw(), held, 1e-3);
  EXPECT_LT(std::abs(yawEffort()), 0.3);
}

TEST_F(HeavyDrivesTest, DropAnEffortThatIsNoNumber) {
  drives_.power_on(drives_.feedback().permitted);
  follow(parked_[0], 10);
  release(std::numeric_limits<double>::quiet_NaN(), 10);
  EXPECT_TRUE(std::isfinite(yawEffort()));
  EXPECT_NEAR(yaw(), parked_[0], 1e-3);
}

TEST_F(HeavyDrivesTest, HoldWhatABriefLossReleased) {
  drives_.power_on(drives_.feedback().permitted);
  release(0.5, 200);
  drives_.power_off();
  drives_.power_on(drives_.feedback().permitted);
  cycles(300);
  EXPECT_LT(std::abs(yawRate()), 0.05);
}

TEST_F(HeavyDrivesTest, BeginAndEndCompensationGradually) {
  drives_.power_on(drives_.feedback().permitted);
  release(0, 100);
  const double carried = shoulderEffort();
  ASSERT_GT(std::abs(carried), 0.5);
  for (const bool use : {false, true}) {
    goal_.gravity_compensation = use;
    for (int i = 0; i < 400; ++i) {
      const double before = shoulderEffort();
      release(0, 1);
      ASSERT_LT(std::abs(shoulderEffort() - before), 0.02 * std::abs(carried)) << i;
    }
    EXPECT_EQ(shoulderEffort() == 0, !use);
  }
}

TEST_F(HeavyDrivesTest, CarryTheArmAtOnce) {
  drives_.power_on(drives_.feedback().permitted);
  cycles(2);
  EXPECT_GT(std::abs(shoulderEffort()), 0.5);
}

TEST_F(HeavyDrivesTest, LeadALateSetPointNoFarther) {
  auto model = heavyMtm();
  model.rate_limit.setConstant(0.01);
  SimulatedDrives<7> slow{std::make_unique<RigidBodyJoints<7>>(model)};
  slow.permit(true);
  slow.power_on(slow.feedback().permitted);
  goal_.position[0] = 1;
  std::vector<double> efforts;
  for (const suture::Duration wait : {0us, 667us, 1'000'000us}) {
    time_ += wait;
    slow.servo_jp(goal_);
    slow.step(time_);
    efforts.push_back(slow.feedback().effort[0]);
  }
  ASSERT_GT(efforts[1], 0.01);
  EXPECT_LT(efforts[2], 20 * efforts[1]) << "the set-point leads by what a second permits";
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
