// An arm that is not homed does not know where its tip is.

#include <gtest/gtest.h>

#include <vector>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

ArmModel<6> jumpyModel() {
  ArmModel<6> model = psmModel();
  model.watch = {.jump_factor = 5};
  return model;
}

class HomingTest : public CrtkArmTest {
 protected:
  HomingTest() : CrtkArmTest(jumpyModel()) {}

  void home() {
    crtk_.home();
    while (!crtk_.operating_state().is_homed) cycles(1);
    heard_ = {};
  }
  void expectObeysServo() {
    crtk_.servo_cp(crtk_.setpoint_cp());
    cycles(1);
    EXPECT_EQ(crtk_.operating_state().sub_state, "servo_cp");
    EXPECT_TRUE(heard_.codes.empty());
  }
};

TEST_F(HomingTest, AnUnhomedArmRefusesCartesianCommands) {
  crtk_.unhome();
  expectTipRefused(ArmWarning::NotHomed);
  home();
  expectObeysServo();
}

TEST_F(HomingTest, AnEncoderJumpRefusesCartesianCommands) {
  joints_.displace(1, 0.2);
  cycles(2);
  crtk_.enable();
  cycles(1);
  ASSERT_EQ(crtk_.operating_state().state, ArmState::Enabled);
  expectTipRefused(ArmWarning::NotHomed);
  home();
  expectObeysServo();
}

TEST_F(HomingTest, UnhomingEndsTheWayHome) {
  crtk_.move_jp(joints(0.2));
  cycles(1000);
  heard_ = {};
  crtk_.home();
  cycles(5);
  crtk_.unhome();
  cycles(2000);
  EXPECT_FALSE(crtk_.operating_state().is_homed);
  EXPECT_EQ(crtk_.operating_state().sub_state, "holding");
  EXPECT_EQ(heard_.goals, std::vector<bool>{false});
  EXPECT_GT(setpoint(0), 0.15) << "it holds where it was";
}

TEST_F(HomingTest, UnhomingLeavesAnotherMoveAlone) {
  crtk_.move_jp(joints(0.2));
  cycles(5);
  crtk_.unhome();
  cycles(1000);
  EXPECT_FALSE(crtk_.operating_state().is_homed);
  EXPECT_EQ(heard_.goals, std::vector<bool>{true});
}

TEST_F(HomingTest, UnhomingEndsAVelocityStream) {
  TwistGoal twist;
  twist.linear.x() = 0.01;
  crtk_.servo_cv(twist);
  cycles(5);
  ASSERT_EQ(crtk_.operating_state().sub_state, "servo_cv");
  heard_ = {};
  crtk_.unhome();
  cycles(1);
  EXPECT_EQ(heard_.codes, std::vector{ArmWarning::NotHomed});
  EXPECT_EQ(crtk_.operating_state().sub_state, "holding");
}

}  // namespace
}  // namespace robots::test
