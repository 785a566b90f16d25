// Drives put an arm in FAULT when they measure what cannot be.

#include <gtest/gtest.h>

#include <string>

#include "arm_control/drive_watch.h"
#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

constexpr int kPitch = 1;

ArmModel<6> watchedModel() {
  ArmModel<6> model = psmModel();
  model.effort_limit.setConstant(0.3);
  model.encoder_step.setConstant(1e-5);
  model.watch = {.jump_factor = 5, .overload_time = 0.05};
  return model;
}

class DriveFaultTest : public CrtkArmTest {
 protected:
  DriveFaultTest() : CrtkArmTest(watchedModel()) {}

  ArmState state() const { return crtk_.operating_state().state; }
  void expectFault(ArmWarning reason, const char* text) {
    EXPECT_EQ(state(), ArmState::Fault);
    ASSERT_EQ(heard_.errors.size(), 1u) << "it says so, once";
    EXPECT_EQ(heard_.codes.back(), reason);
    EXPECT_EQ(heard_.errors[0].find(text), 0u) << heard_.errors[0];
    EXPECT_FALSE(arm_.powered()) << "the brakes hold it";
  }
  /// The encoder of the pitch is wrong in one cycle, and right again.
  void glitch() {
    joints_.displace(kPitch, 0.05);
    cycles(1);
    joints_.displace(kPitch, 0);
  }
  double truePitch() const { return joints_.position()[kPitch]; }
};

TEST_F(DriveFaultTest, AJumpingEncoderIsANamedFault) {
  joints_.displace(kPitch, 0.05);
  cycles(3);
  expectFault(ArmWarning::EncoderJump, "b: its encoder jumped");
  EXPECT_DOUBLE_EQ(setpoint(kPitch), crtk_.measured_js().position[kPitch])
      << "without power its set-point is where it is measured";
}

TEST_F(DriveFaultTest, AWrongEncoderMovesNoJoint) {
  const double before = truePitch();
  glitch();
  cycles(300);
  EXPECT_EQ(state(), ArmState::Fault);
  EXPECT_NEAR(truePitch(), before, 1e-9);
  crtk_.enable();
  cycles(300);
  EXPECT_EQ(state(), ArmState::Enabled);
  EXPECT_NEAR(truePitch(), before, 1e-9);
}

TEST_F(DriveFaultTest, AMovingJointStopsWhereItIs) {
  JointVelocityGoal rate;
  rate.goal.assign(6, 0);
  rate.goal[kPitch] = 1;
  for (int i = 0; i < 100; ++i) {
    crtk_.servo_jv(rate);
    cycles(1);
  }
  const double before = truePitch();
  glitch();
  EXPECT_LT(truePitch() - before, 1.001 * 0.001) << "as far as it goes in the cycle of the glitch";
  const double stopped = truePitch();
  cycles(300);
  EXPECT_EQ(truePitch(), stopped);
}

TEST_F(DriveFaultTest, NoReasonLeavesItPower) {
  const auto expectNone = [&](const char* what) {
    EXPECT_EQ(state(), ArmState::Fault) << what;
    EXPECT_FALSE(arm_.powered()) << what;
    joints_.draw(kPitch, 0);
    cycles(1);
    crtk_.enable();
    cycles(10);
    EXPECT_EQ(state(), ArmState::Enabled) << what;
    EXPECT_TRUE(arm_.powered()) << what;
  };
  glitch();
  cycles(1);
  expectNone("encoder jump");
  joints_.draw(kPitch, 0.31);
  cycles(60);
  expectNone("over-current");
  arm_.step(time_ += 1ms, std::nullopt);
  expectNone("drives silent");
  JointGoal away{positions(), {}};
  away.position[0] += 0.5;
  joints_.block();
  crtk_.move_jp(away);
  cycles(1000);
  expectNone("following error");
}

TEST_F(DriveFaultTest, MotionAtFullSpeedIsNoJump) {
  JointVelocityGoal fastest;
  fastest.goal.assign(6, 0);
  fastest.goal[kPitch] = 4;
  for (int i = 0; i < 150; ++i) {
    crtk_.servo_jv(fastest);
    cycles(1);
  }
  EXPECT_EQ(state(), ArmState::Enabled);
}

// The clock of drives in another process is an estimate, which steps when a better one comes.
TEST_F(DriveFaultTest, ASteppingClockIsNoJump) {
  JointVelocityGoal fastest;
  fastest.goal.assign(6, 0);
  fastest.goal[kPitch] = 4;
  for (int i = 0; i < 100; ++i) {
    joints_.misjudgeClock(i < 50 ? 0us : -900us);
    crtk_.servo_jv(fastest);
    cycles(1);
  }
  EXPECT_EQ(state(), ArmState::Enabled);
  joints_.displace(kPitch, 0.05);
  cycles(1);
  expectFault(ArmWarning::EncoderJump, "b: its encoder jumped");
}

TEST_F(DriveFaultTest, HasNoFaultWithoutPower) {
  crtk_.disable();
  cycles(2);
  joints_.displace(kPitch, 0.05);
  cycles(3);
  EXPECT_EQ(state(), ArmState::Disabled);
  ASSERT_EQ(heard_.errors.size(), 1u) << "it says so all the same";
  EXPECT_EQ(heard_.errors[0].find("b: its encoder jumped"), 0u) << heard_.errors[0];
}

TEST_F(DriveFaultTest, AfterAJumpItIsNotHomed) {
  cycles(3);
  crtk_.home();
  cycles(3000);
  ASSERT_TRUE(crtk_.operating_state().is_homed);
  joints_.displace(kPitch, 0.05);
  cycles(3);
  EXPECT_FALSE(crtk_.operating_state().is_homed);
}

TEST_F(DriveFaultTest, ALastingHighEffortIsAFault) {
  joints_.draw(kPitch, -0.31);
  cycles(49);
  EXPECT_EQ(state(), ArmState::Enabled);
  EXPECT_EQ(crtk_.measured_js().effort[kPitch], -0.31);
  cycles(3);
  expectFault(ArmWarning::OverCurrent, "b: its effort");
}

TEST_F(DriveFaultTest, AFallenEffortMayRiseAgain) {
  for (int i = 0; i < 5; ++i) {
    joints_.draw(kPitch, 0.31);
    cycles(45);
    joints_.draw(kPitch, 0.29);
    cycles(1);
  }
  EXPECT_EQ(state(), ArmState::Enabled);
}

TEST_F(DriveFaultTest, AnEffortAtItsLimitMayLast) {
  joints_.draw(kPitch, 0.3 * (1 + 1e-15));
  cycles(200);
  EXPECT_EQ(state(), ArmState::Enabled);
}

TEST_F(DriveFaultTest, IsLeftByEnableAndDisableAlone) {
  joints_.displace(kPitch, 0.05);
  cycles(2);
  for (const char* command : {"pause", "resume", "home", "unhome"}) {
    crtk_.state_command(command);
    cycles(1);
    EXPECT_EQ(state(), ArmState::Fault) << command;
  }
  crtk_.enable();
  cycles(20);
  EXPECT_EQ(state(), ArmState::Enabled) << "the encoder has not jumped again";
  joints_.displace(kPitch, 0);
  cycles(1);
  EXPECT_EQ(state(), ArmState::Fault) << "it jumps back";
  crtk_.disable();
  cycles(1);
  EXPECT_EQ(state(), ArmState::Disabled);
}

TEST_F(DriveFaultTest, ALastingEffortFaultsAgain) {
  joints_.draw(kPitch, 0.31);
  cycles(60);
  ASSERT_EQ(state(), ArmState::Fault);
  crtk_.enable();
  cycles(40);
  EXPECT_EQ(state(), ArmState::Enabled) << "for as long as it may last";
  cycles(20);
  EXPECT_EQ(state(), ArmState::Fault);
}

class DriveWatchTest : public testing::Test {
 protected:
  using Watch = DriveWatch<2>;

  std::optional<DriveFault> look(double position, double tool, suture::Duration later) {
    reading_.position[1] = position;
    reading_.tool.position = tool;
    reading_.stamp += later;
    return watch_.look(reading_, reading_.stamp);
  }

  Watch watch_{{DriveBounds{}, {.rate_limit = 1, .encoder_step = 0.01}, {.rate_limit = 2}},
               {.jump_factor = 2}};
  DriveReading<2> reading_;
};

TEST_F(DriveWatchTest, JudgesByTheTimeThatHasPassed) {
  EXPECT_FALSE(look(5, 0, 1s)) << "the first reading may be anywhere";
  EXPECT_FALSE(look(5.2, 0, 100ms));
  EXPECT_FALSE(look(5.42, 0, 100ms)) << "2 x (1 x 0.1 + 0.01)";
  const auto fault = look(5.65, 0, 100ms);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->joint, 1);
}

TEST(DriveWatch, CountsFromTheFirstHighEffort) {
  DriveWatch<2> watch{{DriveBounds{.effort_limit = 1}, {}, {}}, {.overload_time = 0.1}};
  DriveReading<2> reading;
  const auto look = [&](double effort, suture::Duration later) {
    reading.effort[0] = effort;
    reading.stamp += later;
    return watch.look(reading, reading.stamp);
  };
  EXPECT_FALSE(look(0, 1s));
  EXPECT_FALSE(look(2, 150ms)) << "of the time before nothing is known";
  EXPECT_FALSE(look(2, 60ms));
  EXPECT_TRUE(look(2, 60ms));
}

TEST_F(DriveWatchTest, LooksAtAReadingOnce) {
  (void)look(0, 0, 1s);
  EXPECT_FALSE(look(9, 0, 0s));
}

TEST_F(DriveWatchTest, LooksAtTheToolToo) {
  (void)look(0, 0, 1s);
  EXPECT_FALSE(look(0, 0.4, 100ms));
  const auto fault = look(0, 0.9, 100ms);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->joint, 2);
}

}  // namespace
}  // namespace robots::test
