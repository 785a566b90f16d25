// The console brings a master, a slave and their teleoperation up and down, in order.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "console/system_console.h"
#include "coordinator/coordinator.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "support/pass.h"
#include "support/refusal.h"
#include "support/stepped.h"
#include "teleop/teleop.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;
using Names = std::vector<std::string>;

/// Looks at the console, and notes what it and its arms become.
struct Onlooker final : suture::Device {
  Onlooker() {
    console.on().console_state([this](const ConsoleState& state) { states.push_back(state); });
    console.on().error([this](const suture::Message& error) { errors.push_back(error.text); });
    console.on().warning([this](const suture::Message& news) { warnings.push_back(news.text); });
    note(master, "MTML");
    note(slave, "PSM2");
    teleop.on().teleop_state([this](const TeleopState& state) {
      if (state == TeleopState::Preparing) order.emplace_back("Teleop prepares");
      if (state == TeleopState::Disabled) order.emplace_back("Teleop disabled");
    });
  }
  void note(suture::Required<Arm>& arm, const std::string& name) {
    arm.on().operating_state([this, name](const OperatingState& state) {
      if (state.state == ArmState::Disabled) order.push_back(name + " disabled");
      if (state.state == ArmState::Enabled && !state.is_homed && !state.is_busy) {
        order.push_back(name + " enabled");
      }
      if (state.sub_state == "homing") order.push_back(name + " homing");
    });
  }

  suture::Required<Console> console{*this, "Console"};
  suture::Required<EmergencyStop> button{*this, "Stop"};
  suture::Required<Arm> master{*this, "Master"}, slave{*this, "Slave"};
  suture::Required<Teleoperation> teleop{*this, "Teleop"};
  std::vector<ConsoleState> states;
  Names errors, warnings, order;
};

class ConsoleTest : public testing::Test {
 protected:
  ~ConsoleTest() override { manager_.stop(); }

  void begin(bool byItself = false) {
    console_.emplace(SystemConsoleParameters{
        .system = {"MTML", "PSM2", "TeleopL"}, .patience = 3s, .bring_up_by_itself = byItself});
    manager_.add("Coordinator", coordinator_);
    master_.addTo(manager_, "MTML");
    slave_.addTo(manager_, "PSM2");
    manager_.add("TeleopL", teleop_);
    manager_.add("Console", *console_);
    manager_.add("Onlooker", onlooker_);
    manager_.connect("TeleopL/Master", "MTML/Arm");
    manager_.connect("TeleopL/Slave", "PSM2/Arm");
    for (const char* const one : {"MTMLDrives", "PSM2Drives", "Onlooker", "Console"}) {
      manager_.connect(one + std::string("/Stop"), "Coordinator/Stop");
    }
    manager_.connect("Console/MTML", "MTML/Arm");
    manager_.connect("Console/PSM2", "PSM2/Arm");
    manager_.connect("Console/TeleopL", "TeleopL/Teleoperation");
    manager_.connect("Onlooker/Console", "Console/Console");
    manager_.connect("Onlooker/Master", "MTML/Arm");
    manager_.connect("Onlooker/Slave", "PSM2/Arm");
    manager_.connect("Onlooker/Teleop", "TeleopL/Teleoperation");
    manager_.start();
    pass(50ms);
  }
  void release() {
    EXPECT_TRUE(onlooker_.button.release());
    pass(50ms);
  }
  /// Makes the slave's drives say nothing for too long.
  void failSlave() {
    manager_.suspend("PSM2Drives");
    EXPECT_TRUE(suture::clockOfTest().until(
        [&] { return slave_.arm.operating_state().state == ArmState::Fault; }));
    manager_.resume("PSM2Drives");
    pass(100ms);
  }
  void bringUp() { EXPECT_TRUE(onlooker_.console.bring_up()); }
  bool becomes(ConsoleState wanted) {
    return suture::clockOfTest().until([&] {
      onlooker_.processEvents();
      return console_->console_state() == wanted;
    });
  }
  void look() {
    pass(50ms);
    onlooker_.processEvents();
  }

  Coordinator coordinator_{CoordinatorParameters{}};
  DrivenMtm master_{Side::Left, 30ms};
  DrivenPsm slave_{30ms};
  Teleop teleop_{TeleopParameters{.enable_at_start = false}};
  std::optional<SystemConsole> console_;
  Onlooker onlooker_;
  suture::Manager manager_{"workstation"};
};

TEST_F(ConsoleTest, BringsUpThenHomesThenEnables) {
  begin();
  release();
  look();
  onlooker_.order.clear();
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Up));
  look();
  ASSERT_EQ(onlooker_.order.size(), 5u);
  EXPECT_EQ(Names(onlooker_.order.begin(), onlooker_.order.begin() + 2),
            (Names{"MTML enabled", "PSM2 enabled"}));
  EXPECT_EQ(onlooker_.order.back(), "Teleop prepares");
  EXPECT_EQ(onlooker_.states,
            (std::vector{ConsoleState::Enabling, ConsoleState::Homing, ConsoleState::Up}));
  EXPECT_TRUE(suture::clockOfTest().until(
      [&] { return teleop_.teleop_state() == TeleopState::Following; }));
  look();
  EXPECT_EQ(onlooker_.states.size(), 3u) << "it stays up while a master is turned";
  EXPECT_TRUE(onlooker_.errors.empty());
}

TEST_F(ConsoleTest, BringsDownInTheOppositeOrder) {
  begin();
  release();
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Up));
  look();
  onlooker_.order.clear();
  EXPECT_TRUE(onlooker_.console.bring_down());
  ASSERT_TRUE(becomes(ConsoleState::Down));
  look();
  EXPECT_EQ(onlooker_.order, (Names{"Teleop disabled", "PSM2 disabled", "MTML disabled"}));
  EXPECT_EQ(slave_.drives.feedback().power, DrivePower::Off);
}

TEST_F(ConsoleTest, NamesEachReasonAgainstABringUp) {
  begin();
  manager_.disconnect("Console/PSM2");
  manager_.disconnect("Console/TeleopL");
  bringUp();
  look();
  ASSERT_EQ(onlooker_.errors.size(), 1u);
  EXPECT_EQ(
      onlooker_.errors[0],
      "bring_up: the emergency stop is pressed, or says nothing; MTML has no power permitted, "
      "or says nothing; PSM2 has no power permitted, or says nothing; TeleopL says nothing");
  EXPECT_EQ(console_->console_state(), ConsoleState::Down);
  release();
  bringUp();
  look();
  EXPECT_EQ(onlooker_.errors.back(),
            "bring_up: PSM2 has no power permitted, or says nothing; TeleopL says nothing");
  EXPECT_EQ(master_.arm.operating_state().state, ArmState::Disabled) << "nothing has been begun";
}

TEST_F(ConsoleTest, RefusesToBringUpWhatIsNotDown) {
  begin();
  release();
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Up));
  bringUp();
  look();
  EXPECT_EQ(onlooker_.errors, Names{"bring_up: it is not down; bring it down first"});
  EXPECT_EQ(console_->console_state(), ConsoleState::Up);
}

TEST_F(ConsoleTest, BringsUpOnceByItselfWhenEverythingIsThere) {
  begin(true);
  pass(1s);
  EXPECT_EQ(console_->console_state(), ConsoleState::Down) << "the stop is pressed";
  release();
  ASSERT_TRUE(becomes(ConsoleState::Up));
  EXPECT_TRUE(onlooker_.console.bring_down());
  ASSERT_TRUE(becomes(ConsoleState::Down));
  pass(1s);
  EXPECT_EQ(console_->console_state(), ConsoleState::Down) << "somebody wanted it so";
}

TEST_F(ConsoleTest, TakesBackABringUpInWhichAPartFails) {
  begin();
  release();
  EXPECT_TRUE(onlooker_.slave.enable());
  pass(50ms);
  EXPECT_TRUE(onlooker_.slave.pause());
  pass(50ms);
  bringUp();
  pass(100ms);
  EXPECT_EQ(master_.arm.operating_state().state, ArmState::Enabled);
  ASSERT_TRUE(becomes(ConsoleState::Down));
  look();
  EXPECT_EQ(onlooker_.states,
            (std::vector{ConsoleState::Enabling, ConsoleState::Leaving, ConsoleState::Down}));
  EXPECT_EQ(onlooker_.errors,
            Names{"PSM2 is not enabled after the console's patience; all is taken back"});
  EXPECT_EQ(master_.arm.operating_state().state, ArmState::Disabled);
}

TEST_F(ConsoleTest, AStopEndsTheBringUpForGood) {
  begin();
  release();
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Homing));
  EXPECT_TRUE(onlooker_.button.press());
  pass(100ms);  // far less than its patience
  release();
  pass(2s);
  look();
  EXPECT_EQ(console_->console_state(), ConsoleState::Down);
  EXPECT_EQ(master_.arm.operating_state().state, ArmState::Disabled);
  EXPECT_EQ(slave_.arm.operating_state().state, ArmState::Disabled);
  ASSERT_EQ(onlooker_.errors.size(), 1u);
  EXPECT_TRUE(onlooker_.errors[0].ends_with("; all is taken back")) << onlooker_.errors[0];
}

TEST_F(ConsoleTest, DoesNotHomeAHeldArmAgain) {
  begin();
  release();
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Homing));
  ASSERT_TRUE(suture::clockOfTest().until([&] { return slave_.arm.operating_state().is_busy; }));
  EXPECT_TRUE(onlooker_.slave.hold());
  pass(2s);
  EXPECT_FALSE(slave_.arm.operating_state().is_busy);
  ASSERT_TRUE(becomes(ConsoleState::Down));
  look();
  EXPECT_EQ(onlooker_.errors,
            Names{"PSM2 is not homed after the console's patience; all is taken back"});
}

// An arm that has not run for a while holds, and nobody has asked it to.
TEST_F(ConsoleTest, HomesAnArmAgainThatAPauseOfTheMachineStopped) {
  begin();
  release();
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Homing));
  ASSERT_TRUE(suture::clockOfTest().until([&] { return slave_.arm.operating_state().is_busy; }));
  for (const char* const one : {"Console", "PSM2"}) manager_.suspend(one);
  pass(200ms);
  for (const char* const one : {"PSM2", "Console"}) manager_.resume(one);
  EXPECT_TRUE(becomes(ConsoleState::Up));
  look();
  EXPECT_EQ(onlooker_.errors, Names{});
}

TEST_F(ConsoleTest, HomesAnArmThatWasMovedBeforeTheBringUp) {
  begin();
  release();
  EXPECT_TRUE(onlooker_.slave.enable());
  pass(100ms);
  EXPECT_TRUE(onlooker_.slave.move_jr({std::vector<double>(6, 0.01), {}}));
  pass(2s);
  bringUp();
  EXPECT_TRUE(becomes(ConsoleState::Up));
  look();
  EXPECT_TRUE(onlooker_.errors.empty());
}

TEST_F(ConsoleTest, EndsBringingUpWhenAnArmIsDisabledMeanwhile) {
  begin();
  release();
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Homing));
  EXPECT_TRUE(onlooker_.master.disable());
  ASSERT_TRUE(becomes(ConsoleState::Down));
  look();
  EXPECT_EQ(onlooker_.errors, Names{"MTML is not enabled any more; all is taken back"});
  EXPECT_EQ(slave_.arm.operating_state().state, ArmState::Disabled);
}

TEST_F(ConsoleTest, RefusesToBringUpAnArmInFault) {
  begin();
  release();
  EXPECT_TRUE(onlooker_.slave.enable());
  pass(50ms);
  failSlave();
  bringUp();
  look();
  EXPECT_EQ(onlooker_.errors,
            Names{"bring_up: PSM2 is in FAULT: remove the cause, then enable or disable it"});
  EXPECT_EQ(slave_.arm.operating_state().state, ArmState::Fault);
  EXPECT_TRUE(onlooker_.slave.disable());
  pass(50ms);
  bringUp();
  EXPECT_TRUE(becomes(ConsoleState::Up));
}

TEST_F(ConsoleTest, LeavesAnArmInFaultAsItTakesABringUpBack) {
  begin();
  release();
  EXPECT_TRUE(onlooker_.slave.trajectory_j_set_ratio(0.05));  // it is long on its way home
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Homing));
  failSlave();
  ASSERT_TRUE(becomes(ConsoleState::Down));
  pass(5s);
  look();
  EXPECT_EQ(onlooker_.errors, Names{"PSM2 is in FAULT: remove the cause, then enable or disable "
                                    "it; all is taken back"});
  EXPECT_EQ(slave_.arm.operating_state().state, ArmState::Fault);
  EXPECT_EQ(master_.arm.operating_state().state, ArmState::Disabled);
}

TEST_F(ConsoleTest, TellsWhichArmHasLostItsPower) {
  begin();
  release();
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Up));
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
  release();
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Up));
  EXPECT_TRUE(onlooker_.teleop.disable());
  ASSERT_TRUE(becomes(ConsoleState::Incomplete));
  EXPECT_TRUE(onlooker_.teleop.enable());
  EXPECT_TRUE(becomes(ConsoleState::Up));
}

TEST_F(ConsoleTest, ForgetsAStopThatItIsNotConnectedTo) {
  begin();
  release();
  manager_.disconnect("Console/Stop");
  pass(50ms);
  bringUp();
  look();
  EXPECT_EQ(onlooker_.errors, Names{"bring_up: the emergency stop is pressed, or says nothing"});
}

TEST_F(ConsoleTest, BringsDownWhatIsBeingBroughtUp) {
  begin();
  release();
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Homing));
  EXPECT_TRUE(onlooker_.console.bring_down());
  ASSERT_TRUE(becomes(ConsoleState::Down));
  EXPECT_EQ(master_.arm.operating_state().state, ArmState::Disabled);
  EXPECT_EQ(slave_.arm.operating_state().state, ArmState::Disabled);
}

TEST(ConsoleReasons, AreCountedWhereTheyHaveNoRoom) {
  SystemConsole console(
      {.system = {"MTML", "MTMR", "PSM1", "PSM2", "TeleopL", "TeleopR"}, .patience = 3s});
  Onlooker onlooker;
  suture::Manager manager("workstation");
  manager.add("Console", console);
  manager.add("Onlooker", onlooker);
  manager.start();
  manager.connect("Onlooker/Console", "Console/Console");
  EXPECT_TRUE(onlooker.console.bring_up());
  pass(50ms);
  onlooker.processEvents();
  ASSERT_EQ(onlooker.errors.size(), 1u);
  EXPECT_TRUE(onlooker.errors[0].ends_with("; and 1 more")) << onlooker.errors[0];
  manager.stop();
}

TEST_F(ConsoleTest, IsIncompleteWhileTheStopIsPressed) {
  begin();
  release();
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Up));
  EXPECT_TRUE(onlooker_.button.press());
  ASSERT_TRUE(becomes(ConsoleState::Incomplete));
  release();
  pass(1s);
  EXPECT_EQ(console_->console_state(), ConsoleState::Incomplete) << "nobody has enabled the arms";
  EXPECT_TRUE(onlooker_.teleop.enable());
  EXPECT_TRUE(becomes(ConsoleState::Up));
}

TEST_F(ConsoleTest, IsIncompleteWhileAPartIsNotConnected) {
  begin();
  release();
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Up));
  manager_.disconnect("Console/TeleopL");
  ASSERT_TRUE(becomes(ConsoleState::Incomplete));
  manager_.connect("Console/TeleopL", "TeleopL/Teleoperation");
  EXPECT_TRUE(becomes(ConsoleState::Up));
}

TEST_F(ConsoleTest, BelievesAPartAgainThatWasSuspended) {
  begin();
  release();
  bringUp();
  ASSERT_TRUE(becomes(ConsoleState::Up));
  for (const char* const one : {"Coordinator", "MTML", "TeleopL"}) {
    manager_.suspend(one);
    EXPECT_TRUE(becomes(ConsoleState::Incomplete)) << one;
    manager_.resume(one);
    EXPECT_TRUE(onlooker_.teleop.enable());
    EXPECT_TRUE(becomes(ConsoleState::Up)) << one;
  }
}

TEST(ConsoleParts, AreKnownNamedOnceAndArmsFirst) {
  const auto refusalOf = [](const Names& system) {
    return suture::refusal([&] { SystemConsole({.system = system}); });
  };
  EXPECT_EQ(refusalOf({"MTML", "PSM2", "TeleopL", "Guide"}), "");
  EXPECT_EQ(refusalOf({"PSM3"}),
            "a system with the part 'PSM3': this console knows MTML, MTMR, PSM1, PSM2, TeleopL, "
            "TeleopR and Guide. Use one of those names");
  EXPECT_EQ(refusalOf({"PSM1", "PSM1"}),
            "a system with the part 'PSM1': it is named already. Name each part once");
  EXPECT_EQ(refusalOf({"TeleopL", "PSM1"}),
            "a system with the part 'PSM1': something that moves arms is named before it. Name all "
            "arms first");
}

}  // namespace
}  // namespace robots::test
