// These call the Drives contract on simulated drives directly: power, brakes, streams.

#include "drives/simulated_drives.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <vector>

#include "kinematics/davinci.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using Joints = DriveModel<6>::Joints;

DriveModel<6> model() {
  const auto chain = kinematics::psm();
  return {.lower = chain.lower(),
          .upper = chain.upper(),
          .parked = Joints::Constant(0.1),
          .rate_limit = Joints::Constant(4),
          .time_constant = 0.01};
}

// Stands in for Provided<Drives>::emit().
struct Heard {
  std::vector<DrivePower> states;
  void power(DrivePower state) { states.push_back(state); }
};

class SimulatedDrivesTest : public testing::Test {
 protected:
  SimulatedDrivesTest() { drives_.permit(true); }

  void cycles(int count) {
    for (int i = 0; i < count; ++i) {
      time_ += 1ms;
      drives_.step(time_);
      drives_.announce(heard_);
    }
  }
  void follow(double position, int count) {
    for (int i = 0; i < count; ++i) {
      drives_.servo_jp(goal(position));
      cycles(1);
    }
  }
  static DriveGoal goal(double position) {
    DriveGoal goal;
    goal.position.fill(position);
    goal.joints = 6;
    return goal;
  }
  double position() const { return drives_.feedback().position[0]; }
  double velocity() const { return drives_.feedback().velocity[0]; }

  SimulatedDrives<6> drives_{model()};
  suture::Time time_ = suture::fromNanoseconds(1'000'000'000);
  Heard heard_;
};

TEST_F(SimulatedDrivesTest, StartParkedWithoutPowerAndSaySo) {
  cycles(1);
  EXPECT_EQ(heard_.states, std::vector{DrivePower::Off});
  EXPECT_EQ(drives_.feedback().power, DrivePower::Off);
  EXPECT_EQ(drives_.feedback().joints, 6u);
  EXPECT_EQ(drives_.feedback().stamp, time_);
  EXPECT_EQ(position(), 0.1);
}

TEST_F(SimulatedDrivesTest, NothingMovesWithoutPower) {
  follow(0.2, 50);
  EXPECT_EQ(position(), 0.1);
  drives_.power_on(drives_.feedback().permitted);
  cycles(5);
  EXPECT_EQ(position(), 0.1) << "a goal from before is none";
}

TEST_F(SimulatedDrivesTest, JointsFollowWithPower) {
  drives_.power_on(drives_.feedback().permitted);
  follow(0.2, 100);
  EXPECT_EQ(heard_.states, std::vector{DrivePower::On});
  EXPECT_NEAR(position(), 0.2, 1e-4);
  follow(0.25, 1);
  cycles(1);
  EXPECT_GT(velocity(), 1);
}

TEST_F(SimulatedDrivesTest, TheBrakesHoldAtOnce) {
  drives_.power_on(drives_.feedback().permitted);
  follow(0.2, 5);
  const double held = position();
  ASSERT_GT(velocity(), 1);
  drives_.power_off();
  cycles(1);
  EXPECT_EQ(velocity(), 0);
  const double stopped = position();
  EXPECT_LT(stopped - held, 0.005) << "it moved for one more cycle";
  cycles(20);
  EXPECT_EQ(position(), stopped);
}

TEST_F(SimulatedDrivesTest, ASilentStreamLeavesTheJoints) {
  drives_.power_on(drives_.feedback().permitted);
  follow(2, 10);
  for (int i = 0; velocity() != 0; ++i) {
    ASSERT_LT(i, 110);
    cycles(1);
  }
  const double held = position();
  EXPECT_LT(held, 1.58) << "long before the goal";
  cycles(20);
  EXPECT_EQ(position(), held);
  EXPECT_EQ(drives_.feedback().power, DrivePower::On);
}

TEST_F(SimulatedDrivesTest, LoseTheTimeOfTheirDelay) {
  drives_.power_on(drives_.feedback().permitted);
  follow(2, 10);
  const double before = position();
  time_ += 80ms;
  follow(2, 1);
  EXPECT_LE(position() - before, 4 * 0.01 + 1e-9);
  EXPECT_GT(position() - before, 0.03);
}

TEST_F(SimulatedDrivesTest, ALateStopMovesThemNoFarther) {
  drives_.power_on(drives_.feedback().permitted);
  follow(2, 10);
  const double before = position();
  time_ += 80ms;
  drives_.permit(false);
  cycles(1);
  EXPECT_LE(position() - before, 4 * 0.01 + 1e-9);
}

TEST(Permit, IsAwaitedByDrivesThatStart) {
  SimulatedDrives<6> drives{model()};
  EXPECT_EQ(drives.feedback().power, DrivePower::NotReady);
  drives.permit(false);
  drives.power_on({});
  EXPECT_EQ(drives.feedback().power, DrivePower::NotReady);
  drives.permit(true);
  EXPECT_EQ(drives.feedback().power, DrivePower::Off);
}

TEST_F(SimulatedDrivesTest, ALostPermitStopsThemForGood) {
  drives_.power_on(drives_.feedback().permitted);
  follow(0.2, 5);
  ASSERT_GT(velocity(), 1);
  drives_.permit(false);
  cycles(1);
  EXPECT_EQ(velocity(), 0);
  const double stopped = position();
  EXPECT_EQ(heard_.states.back(), DrivePower::Stopped);
  drives_.power_on(drives_.feedback().permitted);
  follow(0.2, 5);
  EXPECT_EQ(position(), stopped);
  drives_.permit(true);
  follow(0.2, 5);
  EXPECT_EQ(position(), stopped);
  EXPECT_EQ(heard_.states.back(), DrivePower::Off);
  drives_.power_on(drives_.feedback().permitted);
  follow(0.2, 50);
  EXPECT_NEAR(position(), 0.2, 1e-3);
}

TEST_F(SimulatedDrivesTest, AStopCancelsAnEarlierWish) {
  const suture::Time before = drives_.feedback().permitted;
  drives_.permit(false);
  drives_.permit(true);
  drives_.power_on(before);
  EXPECT_EQ(drives_.feedback().power, DrivePower::Off);
  drives_.power_on(drives_.feedback().permitted);
  EXPECT_EQ(drives_.feedback().power, DrivePower::On);
}

TEST_F(SimulatedDrivesTest, BrakesHoldBetweenSteps) {
  drives_.power_on(drives_.feedback().permitted);
  follow(0.2, 5);
  const double held = position();
  drives_.brake();
  time_ += 1s;
  cycles(1);
  EXPECT_EQ(position(), held);
}

TEST_F(SimulatedDrivesTest, WithoutMassFollowOnlyPositions) {
  EXPECT_FALSE(drives_.feedback().controls_effort);
  drives_.power_on(drives_.feedback().permitted);
  DriveGoal there = goal(0.2);
  there.released.fill(true);
  there.effort.fill(1);
  drives_.servo_jp(there);
  cycles(90);
  EXPECT_NEAR(position(), 0.2, 1e-3);
}

TEST_F(SimulatedDrivesTest, InvalidGoalsMoveNothing) {
  drives_.power_on(drives_.feedback().permitted);
  DriveGoal tooFew = goal(0.2);
  tooFew.joints = 5;
  drives_.servo_jp(tooFew);
  cycles(5);
  EXPECT_EQ(position(), 0.1);
  for (const double number : {std::numeric_limits<double>::quiet_NaN(), 1e308}) {
    drives_.servo_jp(goal(number));
    cycles(5);
    EXPECT_EQ(position(), 0.1) << number;
  }
}

}  // namespace
}  // namespace robots::test
