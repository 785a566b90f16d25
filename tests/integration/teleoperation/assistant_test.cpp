// These test what the scripted assistant does to the emergency stop, and what it enables again.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <array>
#include <chrono>

#include "assistant/assistant.h"
#include "console/system_console.h"
#include "coordinator/coordinator.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "teleop/teleop.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

/// A Bystander is another hand at the stop.
struct Bystander final : suture::Device {
  suture::Required<EmergencyStop> button{*this, "Stop"};
  suture::Required<Console> console{*this, "Console"};
  suture::Required<Arm> slave{*this, "Slave"};
};

class AssistantTest : public testing::Test {
 protected:
  ~AssistantTest() override { manager_.stop(); }

  static AssistantParameters scripted(suture::Duration pressAfter) {
    return {.press_after = pressAfter, .release_after = 1s};
  }
  /// Starts it; it never presses if `pressAfter` is zero.
  void start(suture::Duration pressAfter) {
    assistant_.emplace(scripted(pressAfter));
    manager_.add("Coordinator", coordinator_);
    master_.addTo(manager_, "MTM");
    slave_.addTo(manager_, "PSM");
    manager_.add("Teleop", teleop_);
    manager_.add("Bystander", bystander_);
    manager_.add("Assistant", *assistant_);
    manager_.connect("Teleop/Master", "MTM/Arm");
    manager_.connect("Teleop/Slave", "PSM/Arm");
    manager_.connect("Assistant/Left", "Teleop/Teleoperation");
    manager_.connect("Bystander/Slave", "PSM/Arm");
    for (const char* const one : {"MTMDrives", "PSMDrives", "Bystander", "Assistant"}) {
      manager_.connect(one + std::string("/Stop"), "Coordinator/Stop");
    }
    manager_.start();
  }
  /// Also starts a console that brings all of it up by itself, once.
  void startWithConsole() {
    console_.emplace(
        SystemConsoleParameters{.system = {"MTML", "PSM2", "TeleopL"}, .bring_up_by_itself = true});
    manager_.add("Console", *console_);
    start(0s);
    manager_.connect("Console/Stop", "Coordinator/Stop");
    manager_.connect("Console/MTML", "MTM/Arm");
    manager_.connect("Console/PSM2", "PSM/Arm");
    manager_.connect("Console/TeleopL", "Teleop/Teleoperation");
    manager_.connect("Assistant/Console", "Console/Console");
    manager_.connect("Bystander/Console", "Console/Console");
  }
  /// Makes the permit of the drives lapse, as a cable does that is cut for a moment.
  void letPermitLapse() {
    constexpr std::array kDrives{"MTMDrives/Stop", "PSMDrives/Stop"};
    for (const char* const one : kDrives) manager_.disconnect(one);
    pass(100ms);
    for (const char* const one : kDrives) manager_.connect(one, "Coordinator/Stop");
  }
  /// Starts one more, which knows as little of what happened as one that is started again.
  void startAnother(suture::Duration pressAfter) {
    another_.emplace(scripted(pressAfter));
    manager_.add("Another", *another_);
    manager_.start();
    manager_.connect("Another/Left", "Teleop/Teleoperation");
    pass(100ms);
    manager_.connect("Another/Stop", "Coordinator/Stop");
  }
  void pressAndRelease() {
    ASSERT_TRUE(bystander_.button.press());
    pass(1s);
    ASSERT_TRUE(bystander_.button.release(coordinator_.permit().press));
  }
  /// Makes the slave's drives say nothing for too long.
  void failSlave() {
    manager_.suspend("PSMDrives");
    EXPECT_TRUE(until([this] { return slaveState() == ArmState::Fault; }));
    manager_.resume("PSMDrives");
  }
  /// Somebody who looks for the cause of a fault disables the slave, and it stays so.
  void expectSlaveStaysDisabled() {
    ASSERT_TRUE(bystander_.slave.disable());
    pass(10s);
    EXPECT_EQ(slaveState(), ArmState::Disabled);
  }
  ArmState slaveState() const { return slave_.arm.operating_state().state; }
  bool isUp() const { return console_->console_state() == ConsoleState::Up; }
  bool follows() const { return teleop_.teleop_state() == TeleopState::Following; }
  bool mayHavePower() const { return coordinator_.permit().granted; }
  template <class Condition>
  static bool until(const Condition& condition) {
    return suture::clockOfTest().until(condition);
  }

  Coordinator coordinator_{CoordinatorParameters{}};
  DrivenMtm master_{Side::Left, 30ms};
  DrivenPsm slave_{30ms};
  Teleop teleop_{TeleopParameters{}};
  Bystander bystander_;
  std::optional<Assistant> assistant_, another_;
  std::optional<SystemConsole> console_;
  suture::Manager manager_{"workstation"};
};

TEST_F(AssistantTest, ReleasesTheStopOfTheStart) {
  start(0s);
  EXPECT_TRUE(until([this] { return mayHavePower(); }));
  EXPECT_TRUE(until([this] { return follows(); }));
  pass(10s);
  EXPECT_TRUE(mayHavePower() && follows());
}

TEST_F(AssistantTest, FollowsItsScriptAndEnablesAgain) {
  start(5s);
  ASSERT_TRUE(until([this] { return mayHavePower(); }));
  pass(4900ms);
  EXPECT_TRUE(mayHavePower() && follows());
  pass(200ms);
  EXPECT_FALSE(mayHavePower() || follows());
  EXPECT_EQ(slave_.drives.feedback().power, DrivePower::Stopped);
  pass(850ms);
  EXPECT_FALSE(mayHavePower());
  EXPECT_EQ(slave_.arm.operating_state().state, ArmState::Disabled) << "nobody has enabled it";
  pass(200ms);
  EXPECT_TRUE(mayHavePower());
  EXPECT_EQ(slave_.arm.operating_state().state, ArmState::Disabled) << "a person would look first";
  EXPECT_TRUE(until([this] { return follows(); }));
  pass(10s);
  EXPECT_TRUE(mayHavePower() && follows()) << "it presses once";
}

TEST_F(AssistantTest, LeavesTheStopOfAnotherAlone) {
  start(0s);
  ASSERT_TRUE(until([this] { return follows(); }));
  ASSERT_TRUE(bystander_.button.press());
  pass(10s);
  EXPECT_FALSE(mayHavePower() || follows());
  EXPECT_EQ(slave_.arm.operating_state().state, ArmState::Disabled);
  ASSERT_TRUE(bystander_.button.release(coordinator_.permit().press));
  EXPECT_TRUE(until([this] { return follows(); })) << "it enables what waits";
}

TEST_F(AssistantTest, DoesNothingWhileAnotherStops) {
  start(5s);
  ASSERT_TRUE(until([this] { return follows(); }));
  ASSERT_TRUE(bystander_.button.press());
  pass(15s);
  EXPECT_FALSE(mayHavePower());
}

TEST_F(AssistantTest, KeepsAStopThatAnotherPressedToo) {
  start(5s);
  ASSERT_TRUE(until([this] { return follows(); }));
  ASSERT_TRUE(until([this] { return !mayHavePower(); }));
  pass(500ms);
  ASSERT_TRUE(bystander_.button.press());
  pass(10s);
  EXPECT_FALSE(mayHavePower());
}

TEST_F(AssistantTest, LeavesTheStopOfARunningCoordinator) {
  start(0s);
  ASSERT_TRUE(until([this] { return follows(); }));
  manager_.suspend("Coordinator");
  ASSERT_FALSE(bystander_.button.press()) << "it cannot take a command";
  manager_.resume("Coordinator");
  pass(10s);
  EXPECT_FALSE(mayHavePower() || follows());
  ASSERT_TRUE(bystander_.button.release(coordinator_.permit().press));
  EXPECT_TRUE(until([this] { return follows(); }));
}

TEST_F(AssistantTest, LeavesAStopFromBeforeItsStart) {
  start(0s);
  ASSERT_TRUE(until([this] { return follows(); }));
  ASSERT_TRUE(bystander_.button.press());
  pass(100ms);
  startAnother(2s);
  pass(10s);
  EXPECT_FALSE(mayHavePower() || follows());
  ASSERT_TRUE(bystander_.button.release(coordinator_.permit().press));
  pass(10s);
  EXPECT_TRUE(mayHavePower() && follows()) << "its script is over, and the first one enables";
}

TEST_F(AssistantTest, LeavesAStopOfAnEarlierCoordinator) {
  start(0s);
  ASSERT_TRUE(until([this] { return follows(); }));
  manager_.suspend("Coordinator");
  pass(100ms);
  manager_.resume("Coordinator");
  startAnother(0s);
  pass(10s);
  EXPECT_FALSE(mayHavePower() || follows());
}

TEST_F(AssistantTest, EnablesNothingBeforeItKnowsTheStop) {
  start(0s);
  ASSERT_TRUE(until([this] { return follows(); }));
  ASSERT_TRUE(bystander_.slave.disable());
  ASSERT_TRUE(until([this] { return !follows(); }));
  startAnother(0s);
  pass(10s);
  EXPECT_EQ(slaveState(), ArmState::Disabled) << "a person has disabled it";
}

TEST_F(AssistantTest, EnablesAgainWhatStoppedByItself) {
  startWithConsole();
  ASSERT_TRUE(until([this] { return follows() && isUp(); }));
  letPermitLapse();
  pass(300ms);
  EXPECT_FALSE(follows()) << "a permit that lapsed is no reason to go on";
  pass(500ms);
  EXPECT_TRUE(until([this] { return follows(); }));
}

TEST_F(AssistantTest, EnablesAgainWhatLostItsPower) {
  startWithConsole();
  ASSERT_TRUE(until([this] { return follows() && isUp(); }));
  for (const char* const one : {"Console/PSM2", "Teleop/Slave", "PSMDrives/Stop"}) {
    manager_.disconnect(one);
  }
  ASSERT_TRUE(until([this] { return slaveState() == ArmState::Disabled; }));
  pass(3s);
  manager_.connect("Console/PSM2", "PSM/Arm");
  manager_.connect("Teleop/Slave", "PSM/Arm");
  manager_.connect("PSMDrives/Stop", "Coordinator/Stop");
  EXPECT_TRUE(until([this] { return follows() && isUp(); }));
}

TEST_F(AssistantTest, LeavesADisabledArm) {
  startWithConsole();
  ASSERT_TRUE(until([this] { return follows() && isUp(); }));
  ASSERT_TRUE(bystander_.slave.disable());
  pass(10s);
  EXPECT_EQ(slaveState(), ArmState::Disabled);
  pressAndRelease();
  pass(10s);
  EXPECT_EQ(slaveState(), ArmState::Disabled) << "the stop did not take its power";
  letPermitLapse();
  pass(10s);
  EXPECT_EQ(slaveState(), ArmState::Disabled) << "nor did the permit";
}

TEST_F(AssistantTest, LeavesAnUnhomedArm) {
  startWithConsole();
  ASSERT_TRUE(until([this] { return follows() && isUp(); }));
  ASSERT_TRUE(bystander_.slave.unhome());
  pass(10s);
  EXPECT_FALSE(slave_.arm.operating_state().is_homed);
  pressAndRelease();
  pass(10s);
  EXPECT_FALSE(slave_.arm.operating_state().is_homed);
}

TEST_F(AssistantTest, LeavesAnArmInFault) {
  startWithConsole();
  ASSERT_TRUE(until([this] { return follows() && isUp(); }));
  failSlave();
  pass(10s);
  EXPECT_EQ(slaveState(), ArmState::Fault);
  expectSlaveStaysDisabled();
}

// The slave homes slowly, so that it fails on its way.
TEST_F(AssistantTest, LeavesASystemWithAFaultedArm) {
  startWithConsole();
  ASSERT_TRUE(bystander_.slave.trajectory_j_set_ratio(0.1));
  ASSERT_TRUE(until([this] { return console_->console_state() == ConsoleState::Homing; }));
  failSlave();
  ASSERT_TRUE(until([this] { return console_->console_state() == ConsoleState::Down; }));
  pass(10s);
  EXPECT_EQ(slaveState(), ArmState::Fault);
  EXPECT_EQ(console_->console_state(), ConsoleState::Down);
  expectSlaveStaysDisabled();
}

TEST_F(AssistantTest, LeavesASystemWithADisabledArm) {
  startWithConsole();
  ASSERT_TRUE(until([this] { return console_->console_state() == ConsoleState::Homing; }));
  ASSERT_TRUE(bystander_.slave.disable());
  ASSERT_TRUE(until([this] { return console_->console_state() == ConsoleState::Down; }));
  pass(10s);
  EXPECT_EQ(console_->console_state(), ConsoleState::Down);
  EXPECT_EQ(slaveState(), ArmState::Disabled);
}

TEST_F(AssistantTest, BringsUpWhatWentDownEarly) {
  startWithConsole();
  ASSERT_TRUE(until([this] { return console_->console_state() == ConsoleState::Homing; }));
  letPermitLapse();
  pass(300ms);
  EXPECT_EQ(console_->console_state(), ConsoleState::Down) << "a person would look first";
  EXPECT_TRUE(until([this] { return console_->console_state() == ConsoleState::Up; }));
  EXPECT_TRUE(until([this] { return follows(); }));
}

TEST_F(AssistantTest, LeavesASystemThatWasBroughtDown) {
  startWithConsole();
  ASSERT_TRUE(until([this] { return console_->console_state() == ConsoleState::Up; }));
  ASSERT_TRUE(bystander_.console.bring_down());
  ASSERT_TRUE(until([this] { return console_->console_state() == ConsoleState::Down; }));
  pass(5s);
  EXPECT_EQ(console_->console_state(), ConsoleState::Down);
}

}  // namespace
}  // namespace robots::test
