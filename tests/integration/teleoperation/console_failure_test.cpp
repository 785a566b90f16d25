// Parts of a system fail, are stopped or go away while the console brings it up, and later.

#include <algorithm>

#include "integration/teleoperation/scene/console_scene.h"

namespace robots::test {
namespace {

TEST_F(ConsoleTest, TakesBackAFailedBringUp) {
  begin();
  release();
  EXPECT_TRUE(onlooker_.slave.enable());
  pass(50ms);
  EXPECT_TRUE(onlooker_.slave.pause());
  pass(50ms);
  bringUp();
  pass(100ms);
  EXPECT_EQ(masterState(), ArmState::Enabled);
  expectTakenBack("PSM2 is not enabled after the console's patience");
  EXPECT_EQ(onlooker_.states,
            (std::vector{ConsoleState::Enabling, ConsoleState::Leaving, ConsoleState::Down}));
}

TEST_F(ConsoleTest, AStopEndsTheBringUp) {
  begin();
  bringUpUntil(ConsoleState::Homing);
  EXPECT_TRUE(onlooker_.button.press());
  pass(100ms);  // far less than its patience
  release();
  pass(2s);
  look();
  EXPECT_EQ(console_->console_state(), ConsoleState::Down);
  EXPECT_EQ(masterState(), ArmState::Disabled);
  EXPECT_EQ(slaveState(), ArmState::Disabled);
  ASSERT_EQ(onlooker_.errors.size(), 1u);
  EXPECT_TRUE(onlooker_.errors[0].ends_with("; all is taken back")) << onlooker_.errors[0];
}

TEST_F(ConsoleTest, DoesNotHomeAHeldArmAgain) {
  ASSERT_TRUE(slaveHomes());
  EXPECT_TRUE(onlooker_.slave.hold());
  pass(2s);
  EXPECT_FALSE(slave_.arm.operating_state().is_busy);
  expectTakenBack("PSM2 is not homed after the console's patience");
}

// An arm that has not run for a while holds, and nobody has asked it to.
TEST_F(ConsoleTest, HomesAnArmThatAPauseStopped) {
  ASSERT_TRUE(slaveHomes());
  for (const char* const one : {"Console", "PSM2"}) manager_.suspend(one);
  pass(200ms);
  for (const char* const one : {"PSM2", "Console"}) manager_.resume(one);
  EXPECT_TRUE(becomes(ConsoleState::Up));
  look();
  EXPECT_EQ(onlooker_.errors, Names{});
}

TEST_F(ConsoleTest, ItsOwnPauseHomesNoHeldArm) {
  ASSERT_TRUE(slaveHomes());
  EXPECT_TRUE(onlooker_.slave.hold());
  pass(100ms);
  manager_.suspend("Console");
  pass(200ms);
  manager_.resume("Console");
  pass(1s);
  EXPECT_FALSE(slave_.arm.operating_state().is_busy) << "somebody has stopped it";
  expectTakenBack("PSM2 is not homed after the console's patience");
}

TEST_F(ConsoleTest, ADisabledArmEndsTheBringUp) {
  begin();
  bringUpUntil(ConsoleState::Homing);
  EXPECT_TRUE(onlooker_.master.disable());
  expectTakenBack("MTML is not enabled any more");
  EXPECT_EQ(slaveState(), ArmState::Disabled);
}

TEST_F(ConsoleTest, RefusesToBringUpAFaultedArm) {
  begin();
  release();
  EXPECT_TRUE(onlooker_.slave.enable());
  pass(50ms);
  failSlave();
  bringUp();
  look();
  EXPECT_EQ(onlooker_.errors,
            Names{"bring_up: PSM2 is in FAULT: remove the cause, then enable or disable it"});
  EXPECT_EQ(slaveState(), ArmState::Fault);
  EXPECT_TRUE(onlooker_.slave.disable());
  pass(50ms);
  bringUp();
  EXPECT_TRUE(becomes(ConsoleState::Up));
}

TEST_F(ConsoleTest, TakingBackLeavesAFaultedArm) {
  begin();
  release();
  EXPECT_TRUE(onlooker_.slave.trajectory_j_set_ratio(0.05));  // it is long on its way home
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Homing));
  failSlave();
  expectTakenBack("PSM2 is in FAULT: remove the cause, then enable or disable it");
  EXPECT_EQ(slaveState(), ArmState::Fault);
}

TEST_F(ConsoleTest, TellsWhichArmHasLostItsPower) {
  begin();
  bringUpUntil(ConsoleState::Up);
  look();
  EXPECT_TRUE(onlooker_.warnings.empty());
  EXPECT_TRUE(onlooker_.button.press());
  look();
  std::sort(onlooker_.warnings.begin(), onlooker_.warnings.end());
  EXPECT_EQ(onlooker_.warnings, (Names{"MTML has no power, may not have it, or is cut off",
                                       "PSM2 has no power, may not have it, or is cut off"}));
}

TEST_F(ConsoleTest, IsIncompleteWhileAMoverIsDisabled) {
  begin();
  bringUpUntil(ConsoleState::Up);
  EXPECT_TRUE(onlooker_.teleop.disable());
  ASSERT_TRUE(becomes(ConsoleState::Incomplete));
  EXPECT_TRUE(onlooker_.teleop.enable());
  EXPECT_TRUE(becomes(ConsoleState::Up));
}

TEST_F(ConsoleTest, IsIncompleteWhileTheStopIsPressed) {
  begin();
  bringUpUntil(ConsoleState::Up);
  EXPECT_TRUE(onlooker_.button.press());
  ASSERT_TRUE(becomes(ConsoleState::Incomplete));
  release();
  pass(1s);
  EXPECT_EQ(console_->console_state(), ConsoleState::Incomplete) << "nobody has enabled the arms";
  EXPECT_TRUE(onlooker_.teleop.enable());
  EXPECT_TRUE(becomes(ConsoleState::Up));
}

TEST_F(ConsoleTest, IsIncompleteWithoutEveryPart) {
  begin();
  bringUpUntil(ConsoleState::Up);
  manager_.disconnect("Console/TeleopL");
  ASSERT_TRUE(becomes(ConsoleState::Incomplete));
  manager_.connect("Console/TeleopL", "TeleopL/Teleoperation");
  EXPECT_TRUE(becomes(ConsoleState::Up));
}

TEST_F(ConsoleTest, BelievesAPartAgainThatWasSuspended) {
  begin();
  bringUpUntil(ConsoleState::Up);
  for (const char* const one : {"Coordinator", "MTML", "TeleopL"}) {
    manager_.suspend(one);
    EXPECT_TRUE(becomes(ConsoleState::Incomplete)) << one;
    manager_.resume(one);
    release();
    EXPECT_TRUE(onlooker_.teleop.enable());
    EXPECT_TRUE(becomes(ConsoleState::Up)) << one;
  }
}

}  // namespace
}  // namespace robots::test
