// These tests are of an arm whose drives have no power, may not have it, or say nothing.
#include <gtest/gtest.h>

#include <string>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

class PowerTest : public CrtkArmTest {
 protected:
  ArmState state() const { return crtk_.operating_state().state; }
  void expectError(const char* part) {
    ASSERT_FALSE(heard_.errors.empty());
    EXPECT_NE(heard_.errors.back().find(part), std::string::npos) << heard_.errors.back();
  }
  /// Steps the arm as if the drives had not answered.
  void silence() {
    time_ += 1ms;
    arm_.step(time_, std::nullopt);
    crtk_.announce(heard_);
  }
};

TEST(Power, AnArmWithoutPowerIsUndefined) {
  ArmController<6> arm{psmModel()};
  TrailingJoints<6> joints{psmModel(), psmParked()};
  suture::Time time = suture::now();
  const auto stateWith = [&](DrivePower power) {
    joints.force(power);
    joints.step(arm, time += 1ms);
    return arm.operating_state().state;
  };
  arm.step(time, std::nullopt);
  EXPECT_EQ(arm.operating_state().state, ArmState::Undefined);
  EXPECT_FALSE(arm.motion().measured_cp().valid);
  EXPECT_FALSE(arm.motion().setpoint_cp().valid);
  EXPECT_EQ(stateWith(DrivePower::NotReady), ArmState::Undefined);
  arm.obey(StateCommand::Enable);
  EXPECT_EQ(stateWith(DrivePower::NotReady), ArmState::Undefined);
  EXPECT_EQ(stateWith(DrivePower::Off), ArmState::Disabled);
  EXPECT_TRUE(arm.motion().measured_cp().valid);
  EXPECT_EQ(arm.motion().measured_cp().stamp, time);
}

TEST_F(PowerTest, IsWantedWhereTheArmHolds) {
  EXPECT_TRUE(arm_.powered());
  crtk_.pause();
  EXPECT_TRUE(arm_.powered());
  crtk_.disable();
  EXPECT_FALSE(arm_.powered());
}

TEST_F(PowerTest, ForbiddenPowerDisablesTheArm) {
  for (const DrivePower power : {DrivePower::Stopped, DrivePower::NotReady}) {
    joints_.force(power);
    cycles(1);
    EXPECT_EQ(state(), ArmState::Disabled);
    expectError("may not have it");
    crtk_.enable();
    cycles(1);
    EXPECT_EQ(state(), ArmState::Disabled) << "it is refused";
    joints_.force(std::nullopt);
    cycles(1);
    EXPECT_EQ(state(), ArmState::Disabled) << "it does not come back by itself";
    crtk_.enable();
    cycles(1);
    EXPECT_EQ(state(), ArmState::Enabled);
  }
}

TEST_F(PowerTest, APauseAfterEnablingIsNoLoss) {
  joints_.force(DrivePower::Off);
  cycles(5);
  EXPECT_EQ(state(), ArmState::Enabled) << "the drives have not switched on yet";
  crtk_.disable();
  crtk_.enable();
  cycles(5);
  EXPECT_EQ(state(), ArmState::Enabled);
}

TEST_F(PowerTest, ABriefLossDisablesTheArm) {
  joints_.permitAnew();
  cycles(1);
  EXPECT_EQ(state(), ArmState::Disabled);
  expectError("may not have it");
  crtk_.enable();
  cycles(1);
  EXPECT_EQ(state(), ArmState::Enabled);
}

TEST_F(PowerTest, ARestartDisablesTheArm) {
  arm_.startAnew();
  EXPECT_EQ(state(), ArmState::Undefined);
  cycles(1);
  EXPECT_EQ(state(), ArmState::Disabled);
  EXPECT_FALSE(crtk_.operating_state().is_homed);
}

TEST_F(PowerTest, SilentDrivesFaultTheArm) {
  silence();
  EXPECT_EQ(state(), ArmState::Fault);
  EXPECT_EQ(crtk_.operating_state().sub_state, "drives silent");
  crtk_.publish(time_);
  EXPECT_FALSE(crtk_.measured_cp().valid);
  EXPECT_FALSE(crtk_.measured_cv().valid);
  EXPECT_FALSE(crtk_.measured_cs().position_is_valid);
  EXPECT_FALSE(crtk_.spatial_jacobian().valid);
  EXPECT_TRUE(crtk_.goal_js().valid);
  expectError("silent");
  cycles(1);
  EXPECT_EQ(state(), ArmState::Fault);
  EXPECT_TRUE(crtk_.measured_cp().valid);
  crtk_.enable();
  cycles(1);
  EXPECT_EQ(state(), ArmState::Enabled);
}

TEST_F(PowerTest, SilentDrivesLeaveADisabledArm) {
  crtk_.disable();
  silence();
  EXPECT_EQ(state(), ArmState::Disabled);
}

TEST_F(PowerTest, TheUnpoweredSetPointFollowsTheJoints) {
  JointGoal away{positions(), {}};
  away.position[0] += 0.3;
  crtk_.servo_jp(away);
  cycles(3);
  crtk_.disable();
  cycles(2);
  EXPECT_EQ(crtk_.setpoint_js().position, crtk_.measured_js().position);
}

TEST_F(PowerTest, APausedMoveDoesNotLeap) {
  JointVelocityGoal rates;
  rates.goal.assign(6, 0.2);
  JointGoal away{positions(), {}};
  away.position[0] += 0.5;
  const auto expectRest = [&](const char* what, const auto& move) {
    move();
    cycles(50);
    const double before = crtk_.measured_js().position[0];
    time_ += 400ms;
    cycles(1);
    EXPECT_NEAR(setpoint(0), before, 0.02) << what;
    cycles(20);
    EXPECT_NEAR(crtk_.measured_js().position[0], before, 0.02) << what;
    EXPECT_EQ(crtk_.operating_state().sub_state, "holding") << what;
  };
  expectRest("move_jp", [&] { crtk_.move_jp(away); });
  expectRest("servo_jv", [&] { crtk_.servo_jv(rates); });
}

}  // namespace
}  // namespace robots::test
