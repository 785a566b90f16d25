// The console brings a master, a slave and their teleoperation up and down, in order.

#include "integration/teleoperation/scene/console_scene.h"
#include "support/refusal.h"

namespace robots::test {
namespace {

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
  bringUpUntil(ConsoleState::Up);
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
  EXPECT_EQ(masterState(), ArmState::Disabled) << "nothing has been begun";
}

TEST_F(ConsoleTest, RefusesToBringUpARunningSystem) {
  begin();
  bringUpUntil(ConsoleState::Up);
  bringUp();
  look();
  EXPECT_EQ(onlooker_.errors, Names{"bring_up: it is not down; bring it down first"});
  EXPECT_EQ(console_->console_state(), ConsoleState::Up);
}

TEST_F(ConsoleTest, BringsUpOnceByItself) {
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

TEST_F(ConsoleTest, BringsDownWhatOthersHaveEnabled) {
  begin();
  release();
  EXPECT_TRUE(onlooker_.master.enable());
  pass(50ms);
  ASSERT_EQ(masterState(), ArmState::Enabled);
  EXPECT_TRUE(onlooker_.console.bring_down());
  pass(1s);
  EXPECT_EQ(masterState(), ArmState::Disabled);
  EXPECT_EQ(console_->console_state(), ConsoleState::Down);
}

TEST_F(ConsoleTest, HomesAnArmThatWasMovedBefore) {
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

TEST_F(ConsoleTest, ForgetsAnUnconnectedStop) {
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
  bringUpUntil(ConsoleState::Homing);
  EXPECT_TRUE(onlooker_.console.bring_down());
  ASSERT_TRUE(becomes(ConsoleState::Down));
  EXPECT_EQ(masterState(), ArmState::Disabled);
  EXPECT_EQ(slaveState(), ArmState::Disabled);
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
