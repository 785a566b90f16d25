// These run the state machine of CRTK: every command in every state.
#include "arm_control/operating_states.h"

#include <gtest/gtest.h>

#include <string>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

constexpr ArmState kStates[] = {ArmState::Undefined, ArmState::Disabled, ArmState::Enabled,
                                ArmState::Paused, ArmState::Fault};

TEST(OperatingStates, FaultIsEnteredByNoCommand) {
  for (const ArmState state : kStates) {
    for (const std::string_view name : kStateCommands) {
      const auto next = after(state, stateCommandNamed(name).value());
      EXPECT_TRUE(next != ArmState::Fault || state == ArmState::Fault) << name;
    }
  }
}

TEST(OperatingStates, AreLeftByCrtksCommands) {
  const auto leaving = [](ArmState state) {
    std::string names;
    for (const std::string_view name : kStateCommands) {
      const auto next = after(state, stateCommandNamed(name).value());
      if (next && *next != state) names += std::string(name) + " ";
    }
    return names;
  };
  EXPECT_EQ(leaving(ArmState::Undefined), "");
  EXPECT_EQ(leaving(ArmState::Disabled), "enable ");
  EXPECT_EQ(leaving(ArmState::Enabled), "disable pause ");
  EXPECT_EQ(leaving(ArmState::Paused), "disable resume ");
  EXPECT_EQ(leaving(ArmState::Fault), "enable disable ");
}

class OperatingStatesTest : public CrtkArmTest {
 protected:
  ArmState state() const { return crtk_.operating_state().state; }
  /// Sends a goal that the joints cannot follow as closely as they must.
  void fault() {
    JointGoal far{positions(), {}};
    far.position[0] += 0.38;
    crtk_.servo_jp(far);
    cycles(2);
  }
  void bringInto(ArmState wanted) {
    crtk_.disable();
    cycles(1);
    if (wanted == ArmState::Disabled) return;
    crtk_.enable();
    cycles(1);
    if (wanted == ArmState::Paused) crtk_.pause();
    if (wanted == ArmState::Fault) fault();
  }
};

TEST_F(OperatingStatesTest, CommandsFollowTheTableOfStates) {
  for (const ArmState before : kStates) {
    if (before == ArmState::Undefined) continue;  // no arm is ever seen in it
    for (const std::string_view name : kStateCommands) {
      bringInto(before);
      ASSERT_EQ(state(), before);
      heard_ = {};
      crtk_.state_command(std::string(name));
      const auto next = after(before, stateCommandNamed(name).value());
      EXPECT_EQ(state(), next.value_or(before)) << name;
      cycles(1);
      EXPECT_EQ(heard_.errors.size() + heard_.warnings.size(), next ? 0u : 1u) << name;
    }
  }
}

TEST_F(OperatingStatesTest, AJointBeyondItsBoundFaults) {
  fault();
  EXPECT_EQ(state(), ArmState::Fault);
  ASSERT_EQ(heard_.errors.size(), 1u);
  EXPECT_NE(heard_.errors[0].find("trailed"), std::string::npos) << heard_.errors[0];
  const double measured = crtk_.measured_js().position[0];
  EXPECT_EQ(setpoint(0), measured) << "it goes nowhere any more";
  cycles(100);
  EXPECT_EQ(crtk_.measured_js().position[0], measured);
}

TEST_F(OperatingStatesTest, AJointWithinItsBoundGoesOn) {
  JointGoal near{positions(), {}};
  near.position[0] += 0.34;
  crtk_.servo_jp(near);
  cycles(50);
  EXPECT_EQ(state(), ArmState::Enabled);
}

TEST_F(OperatingStatesTest, AFaultedArmRefusesMotion) {
  JointVelocityGoal rates;
  rates.goal.assign(6, 0.1);
  const auto expectRefused = [&](const char* what, const auto& motion) {
    bringInto(ArmState::Fault);
    heard_ = {};
    const std::vector<double> before = positions();
    motion();
    cycles(5);
    EXPECT_EQ(positions(), before) << what;
    EXPECT_EQ(state(), ArmState::Fault) << what;
    ASSERT_EQ(heard_.warnings.size(), 1u) << what;
    EXPECT_NE(heard_.warnings[0].find("enabled"), std::string::npos) << heard_.warnings[0];
  };
  expectRefused("home", [&] { crtk_.home(); });
  expectRefused("servo_jp", [&] { crtk_.servo_jp(joints(0.11)); });
  expectRefused("servo_cp", [&] { crtk_.servo_cp(crtk_.setpoint_cp()); });
  expectRefused("servo_jv", [&] { crtk_.servo_jv(rates); });
  expectRefused("move_jp", [&] { crtk_.move_jp(joints(0.2)); });
  expectRefused("free", [&] { crtk_.free(); });
  expectRefused("hold", [&] { crtk_.hold(); });
}

TEST_F(OperatingStatesTest, EnableWhilePausedIsAnError) {
  crtk_.pause();
  cycles(1);
  for (std::size_t count = 1; count <= 2; ++count) {
    crtk_.enable();
    cycles(1);
    EXPECT_EQ(state(), ArmState::Paused);
    ASSERT_EQ(heard_.errors.size(), count);
    EXPECT_NE(heard_.errors.back().find("paused"), std::string::npos);
  }
  EXPECT_EQ(heard_.desired.back(), ArmState::Paused) << "nothing else was asked for in vain";
}

}  // namespace
}  // namespace robots::test
