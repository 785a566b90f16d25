// An arm whose client is gone holds its place if it followed that client's stream.
#include <gtest/gtest.h>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

class ClientGone : public CrtkArmTest {
 protected:
  const std::string& activity() const { return crtk_.operating_state().sub_state; }
  template <class Servo>
  void expectHeld(const char* what, const Servo& servo) {
    arm_.commander = &teleop_;
    for (int i = 0; i < 5; ++i) {
      servo();
      cycles(1);
    }
    heard_ = {};
    arm_.clientGone(gui_);
    cycles(1);
    EXPECT_NE(activity(), "holding") << what << ": another client is gone";
    arm_.clientGone(teleop_);
    const std::vector<double> held = positions();
    cycles(1);
    EXPECT_EQ(activity(), "holding") << what;
    EXPECT_EQ(positions(), held) << what;
    cycles(5);
    ASSERT_EQ(heard_.warnings.size(), 1u) << what;
    EXPECT_NE(heard_.warnings[0].find("is gone"), std::string::npos) << heard_.warnings[0];
  }

  const suture::ConnectedClient teleop_{"console:Teleop/Slave", 2s}, gui_{"gui:Panel/Arm", 2s};
};

TEST_F(ClientGone, EndsItsStreamAtOnceAsHold) {
  JointVelocityGoal rates;
  rates.goal.assign(6, 0.1);
  JointEffortGoal efforts;
  efforts.effort.assign(6, 0.1);
  TwistGoal twist;
  twist.linear.x() = 0.01;
  WrenchGoal force;
  force.force.x() = 0.1;
  const PoseStamped pose = crtk_.setpoint_cp();
  expectHeld("servo_jp", [&] { crtk_.servo_jp(joints(0.11)); });
  expectHeld("servo_jr", [&] { crtk_.servo_jr(joints(0.001)); });
  expectHeld("servo_jv", [&] { crtk_.servo_jv(rates); });
  expectHeld("servo_jf", [&] { crtk_.servo_jf(efforts); });
  expectHeld("servo_cp", [&] { crtk_.servo_cp(pose); });
  expectHeld("servo_cv", [&] { crtk_.servo_cv(twist); });
  expectHeld("interpolate_jp", [&] { crtk_.interpolate_jp(joints(0.15)); });
  expectHeld("interpolate_cp", [&] { crtk_.interpolate_cp(pose); });
  expectHeld("servo_cf", [&] { crtk_.spatial_servo_cf(force); });
}

TEST_F(ClientGone, LetsAMoveGoOn) {
  arm_.commander = &teleop_;
  crtk_.move_jp(joints(0.2));
  cycles(1);
  arm_.clientGone(teleop_);
  cycles(1);
  EXPECT_EQ(activity(), "moving");
  EXPECT_TRUE(heard_.warnings.empty());
}

TEST_F(ClientGone, AnotherStreamIsNotAffected) {
  arm_.commander = &teleop_;
  crtk_.servo_jp(joints(0.11));
  arm_.commander = &gui_;
  crtk_.servo_jp(joints(0.12));
  arm_.clientGone(teleop_);
  cycles(1);
  EXPECT_EQ(activity(), "servo_jp");
}

TEST_F(ClientGone, AnEndedStreamIsNotAffected) {
  arm_.commander = &teleop_;
  crtk_.servo_jp(joints(0.11));
  crtk_.pause();
  arm_.clientGone(teleop_);
  cycles(1);
  EXPECT_EQ(crtk_.operating_state().state, ArmState::Paused);
  EXPECT_TRUE(heard_.warnings.empty());
}

}  // namespace
}  // namespace robots::test
