// These call the jaw on the arm that holds it directly.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "arm_control/jaw_controller.h"
#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

constexpr JawModel kJaw{
    .lower = -0.7, .upper = 1.4, .rate_limit = 2, .acceleration_limit = 20, .effort_limit = 0.16};

class JawTest : public CrtkArmTest {
 protected:
  struct HeardOfJaw {
    std::vector<ArmWarning> codes;
    std::vector<bool> goals;
    void warning(const suture::Message& said) { codes.push_back(ArmWarning{said.code}); }
    void goal_reached(bool reached) { goals.push_back(reached); }
  };

  JawTest() { jawCycles(1); }

  void jawCycles(int count) {
    for (int i = 0; i < count; ++i) {
      cycles(1);
      DriveReading<6> reading;
      reading.stamp = time_;
      reading.power = power_;
      reading.tool.position = measured_;
      jaw_.step(time_, silent_ ? std::nullopt : std::optional(reading));
      jaw_.announce(said_);
    }
  }
  static JointGoal angle(double value) { return {{value}, {}}; }
  static JointEffortGoal effort(double value) {
    JointEffortGoal goal;
    goal.effort = {value};
    return goal;
  }
  double setpoint() const { return jaw_.setpoint_js().position[0]; }

  JawController jaw_{kJaw, arm_};
  double measured_ = 0.2;
  DrivePower power_ = DrivePower::On;
  bool silent_ = false;
  HeardOfJaw said_;
};

TEST_F(JawTest, StartsWhereItIs) {
  measured_ = 0.3;
  crtk_.disable();
  jawCycles(1);
  EXPECT_EQ(setpoint(), 0.3);
  EXPECT_EQ(jaw_.measured_js().position[0], 0.3);
  EXPECT_EQ(jaw_.measured_js().stamp, time_);
  EXPECT_TRUE(jaw_.measured_js().valid);
}

TEST_F(JawTest, HoldsAgainstAPullWhilePaused) {
  jaw_.servo_jp(angle(0.5));
  jawCycles(10);
  crtk_.pause();
  measured_ = 0.25;
  jawCycles(1);
  EXPECT_EQ(setpoint(), 0.25);
  measured_ = 0.3;
  jawCycles(5);
  EXPECT_EQ(setpoint(), 0.25);
}

TEST_F(JawTest, ServosNoFasterThanItsRate) {
  const double before = setpoint();
  double last = before;
  for (int i = 0; i < 200; ++i) {
    jaw_.servo_jp(angle(0.5));
    jawCycles(1);
    EXPECT_LE(setpoint() - last, kJaw.rate_limit * 0.001 + 1e-12);
    last = setpoint();
  }
  EXPECT_DOUBLE_EQ(setpoint(), 0.5);
  EXPECT_TRUE(said_.codes.empty());
}

TEST_F(JawTest, StopsAtALimitAndSaysSo) {
  for (int i = 0; i < 1000; ++i) {
    jaw_.servo_jp(angle(-5));
    jawCycles(1);
  }
  EXPECT_EQ(setpoint(), kJaw.lower);
  EXPECT_EQ(said_.codes, std::vector{ArmWarning::AtLimit});
}

TEST_F(JawTest, AStreamThatFallsSilentLeavesIt) {
  jaw_.servo_jp(angle(1.4));
  jawCycles(105);
  const double held = setpoint();
  EXPECT_LT(held, 0.5);
  jawCycles(200);
  EXPECT_EQ(setpoint(), held);
}

TEST_F(JawTest, AnEffortSetsItsSpeed) {
  const double before = setpoint();
  for (int i = 0; i < 50; ++i) {
    jaw_.servo_jf(effort(-kJaw.effort_limit / 2));
    jawCycles(1);
  }
  EXPECT_NEAR(setpoint(), before - 0.05 * kJaw.rate_limit / 2, 1e-9);
  EXPECT_EQ(jaw_.setpoint_js().effort[0], -kJaw.effort_limit / 2);
  jaw_.servo_jf(effort(-100));
  jawCycles(1);
  EXPECT_EQ(jaw_.setpoint_js().effort[0], -kJaw.effort_limit);
}

TEST_F(JawTest, MovesSmoothlyAndSaysThatItArrived) {
  jaw_.move_jp(angle(1));
  double last = setpoint();
  for (int i = 0; i < 3000 && said_.goals.empty(); ++i) {
    jawCycles(1);
    EXPECT_GE(setpoint(), last);
    last = setpoint();
  }
  EXPECT_EQ(said_.goals, std::vector{true});
  EXPECT_DOUBLE_EQ(setpoint(), 1);
}

TEST_F(JawTest, APausedMoveBeginsWhereItIs) {
  time_ += 150ms;  // longer than the drives go on with a goal
  jaw_.move_jp(angle(1));
  jawCycles(1);
  EXPECT_TRUE(said_.goals.empty()) << "nothing has replaced it";
  jawCycles(3000);
  EXPECT_EQ(said_.goals, std::vector{true});
  EXPECT_DOUBLE_EQ(setpoint(), 1);
}

TEST_F(JawTest, AMoveAwaitsTheDrivesPower) {
  power_ = DrivePower::Off;
  jaw_.move_jp(angle(1));
  jawCycles(3000);
  EXPECT_TRUE(said_.goals.empty());
  EXPECT_EQ(setpoint(), measured_);
  power_ = DrivePower::On;
  jawCycles(3000);
  EXPECT_EQ(said_.goals, std::vector{true});
  EXPECT_DOUBLE_EQ(setpoint(), 1);
}

TEST_F(JawTest, AMoveThatIsReplacedSaysSo) {
  jaw_.move_jp(angle(1));
  jawCycles(20);
  jaw_.servo_jp(angle(0.3));
  jawCycles(1);
  EXPECT_EQ(said_.goals, std::vector{false});
}

TEST_F(JawTest, IgnoresMotionOfADisabledArm) {
  crtk_.pause();
  jawCycles(1);
  const double before = setpoint();
  for (int i = 0; i < 10; ++i) {
    jaw_.servo_jp(angle(1));
    jaw_.servo_jf(effort(0.1));
    jaw_.move_jp(angle(1));
    jawCycles(1);
  }
  EXPECT_EQ(setpoint(), before);
  EXPECT_EQ(said_.codes, std::vector{ArmWarning::NotEnabled});
}

TEST_F(JawTest, StopsWithItsArm) {
  jaw_.move_jp(angle(1));
  jawCycles(50);
  measured_ = 0.22;
  crtk_.disable();
  jawCycles(1);
  EXPECT_EQ(setpoint(), 0.22);
  EXPECT_EQ(said_.goals, std::vector{false});
}

TEST_F(JawTest, RefusesWhatIsNoGoal) {
  const double before = setpoint();
  jaw_.servo_jp({});
  jaw_.servo_jp(angle(std::numeric_limits<double>::quiet_NaN()));
  jaw_.servo_jf({});
  jaw_.move_jp(angle(2));
  jawCycles(1);
  EXPECT_EQ(setpoint(), before);
  EXPECT_EQ(said_.codes, (std::vector{ArmWarning::OutOfReach, ArmWarning::Malformed}));
}

TEST_F(JawTest, HoldsWhenItsClientIsGone) {
  const suture::ConnectedClient teleop{"console:Teleop/Jaw", 2s}, gui{"gui:Panel/Jaw", 2s};
  arm_.commander = &teleop;
  jaw_.servo_jp(angle(1));
  jawCycles(1);
  jaw_.clientGone(gui);
  jawCycles(1);
  const double before = setpoint();
  jaw_.clientGone(teleop);
  jawCycles(5);
  EXPECT_EQ(setpoint(), before);
  EXPECT_EQ(said_.codes, std::vector{ArmWarning::ClientGone});
}

TEST_F(JawTest, MeasuresNothingOfSilentDrives) {
  silent_ = true;
  jawCycles(1);
  EXPECT_FALSE(jaw_.measured_js().valid);
}

TEST_F(JawTest, TellsWhatItMayDo) {
  const JointConfiguration& may = jaw_.configuration_js();
  ASSERT_TRUE(may.valid);
  EXPECT_EQ(may.name, std::vector<std::string>{"jaw"});
  EXPECT_EQ(may.position_min, std::vector{kJaw.lower});
  EXPECT_EQ(may.position_max, std::vector{kJaw.upper});
  EXPECT_EQ(may.velocity_max, std::vector{kJaw.rate_limit});
  EXPECT_EQ(may.acceleration_max, std::vector{kJaw.acceleration_limit});
  EXPECT_EQ(may.effort_max, std::vector{kJaw.effort_limit});
}

}  // namespace
}  // namespace robots::test
