// Drives that do not follow yet, or not any more: the arm's set-point does not run ahead of the
// joints, which would leap after it.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

class InterruptionTest : public CrtkArmTest {
 protected:
  double joint() const { return joints_.position()[0]; }
  JointGoal yawBy(double angle) const {
    JointGoal goal{positions(), {}};
    goal.position[0] += angle;
    return goal;
  }
  /// Returns how far the first joint went in the fastest of so many cycles.
  double fastest(int count) {
    double most = 0;
    for (int i = 0; i < count; ++i) {
      const double before = joint();
      cycles(1);
      most = std::max(most, std::abs(joint() - before));
    }
    return most;
  }
  /// Lets the drives hold, and the arm go on with what they measured last.
  void cutOff(suture::Duration time) {
    joints_.block();
    DriveReading<6> last{joints_.position(), {}, DrivePower::On, suture::fromNanoseconds(1), time_};
    last.velocity.setZero();
    for (const suture::Time end = time_ + time; time_ < end;) {
      time_ += 1ms;
      crtk_.advance(time_);
      arm_.step(time_, last);
      crtk_.publish(time_);
      crtk_.announce(heard_);
    }
  }

  static constexpr double kMoveStep = 0.002;  // rad a cycle: moves use half of the rate
};

TEST_F(InterruptionTest, AMoveAwaitsTheDrivesPower) {
  joints_.force(DrivePower::Off);
  const double before = joint();
  const JointGoal goal = yawBy(0.5);
  crtk_.move_jp(goal);
  cycles(1000);
  EXPECT_TRUE(heard_.goals.empty()) << "no joint has moved";
  EXPECT_EQ(crtk_.operating_state().sub_state, "moving");
  EXPECT_NEAR(setpoint(0), before, 1e-9);
  joints_.force(std::nullopt);
  EXPECT_LE(fastest(2000), kMoveStep * 1.01);
  EXPECT_EQ(heard_.goals, std::vector{true});
  EXPECT_NEAR(joint(), goal.position[0], 1e-6);
}

TEST_F(InterruptionTest, NoArmIsHomedWithoutPower) {
  crtk_.move_jp(yawBy(0.5));
  cycles(2000);
  crtk_.unhome();
  joints_.force(DrivePower::Off);
  crtk_.home();
  cycles(2000);
  EXPECT_FALSE(crtk_.operating_state().is_homed);
  joints_.force(std::nullopt);
  cycles(2000);
  EXPECT_TRUE(crtk_.operating_state().is_homed);
}

TEST_F(InterruptionTest, AnInterpolatedGoalAwaitsPower) {
  joints_.force(DrivePower::Off);
  const double before = joint();
  crtk_.interpolate_jp(yawBy(0.3));
  cycles(500);
  EXPECT_NEAR(setpoint(0), before, 1e-9);
  joints_.force(std::nullopt);
  cycles(500);
  EXPECT_NEAR(setpoint(0), before + 0.3, 1e-9);
}

TEST_F(InterruptionTest, ADroppedGoalEndsItsMove) {
  crtk_.trajectory_j_set_ratio(0.1);
  crtk_.move_jp(yawBy(0.3));
  cycles(500);
  heard_ = {};
  const double there = joint();
  cutOff(200ms);
  EXPECT_GT(setpoint(0), there + 0.01) << "the arm has heard of nothing yet";
  cycles(1);
  EXPECT_EQ(heard_.goals, std::vector{false});
  EXPECT_EQ(crtk_.operating_state().sub_state, "holding");
  EXPECT_NEAR(setpoint(0), there, 1e-3);
}

TEST_F(InterruptionTest, AShorterSilenceInterruptsNoMove) {
  crtk_.trajectory_j_set_ratio(0.1);
  crtk_.move_jp(yawBy(0.3));
  cycles(500);
  heard_ = {};
  cutOff(50ms);
  cycles(1);
  EXPECT_TRUE(heard_.goals.empty());
  EXPECT_EQ(crtk_.operating_state().sub_state, "moving");
}

TEST_F(InterruptionTest, AGoalAfterAPauseIsReached) {
  const double before = setpoint(0);
  time_ += 150ms;  // longer than the drives go on with a goal
  crtk_.interpolate_jp(yawBy(0.1));
  cycles(500);
  EXPECT_NEAR(setpoint(0), before + 0.1, 1e-9);
  EXPECT_EQ(crtk_.operating_state().sub_state, "interpolate_jp");
}

}  // namespace
}  // namespace robots::test
