// A console that brings the system up by itself is restarted, and finds arms that have been up.

#include "integration/teleoperation/scene/console_scene.h"

namespace robots::test {
namespace {

/// RestartedConsole has a second console, which takes the place of the first one when that is
/// restarted.
class RestartedConsole : public ConsoleTest {
 protected:
  ~RestartedConsole() override { manager_.stop(); }
  void SetUp() override {
    add(true);
    manager_.add("Restarted", restarted_);
    start();
    release();
    ASSERT_TRUE(becomes(ConsoleState::Up));
  }
  void restart() {
    for (const char* const one : {"Stop", "MTML", "PSM2", "TeleopL"}) {
      manager_.disconnect(std::string("Console/") + one);
    }
    manager_.disconnect("Onlooker/Console");
    connectConsole("Restarted");
    pass(1s);
  }

  SystemConsole restarted_{console(true)};
};

TEST_F(RestartedConsole, LeavesDownWhatSomebodyBroughtDown) {
  EXPECT_TRUE(onlooker_.console.bring_down());
  ASSERT_TRUE(becomes(ConsoleState::Down));
  restart();
  EXPECT_EQ(masterState(), ArmState::Disabled);
  EXPECT_EQ(slaveState(), ArmState::Disabled);
  EXPECT_EQ(restarted_.console_state(), ConsoleState::Down);
  look();
  EXPECT_EQ(onlooker_.warnings,
            Names{"MTML has homed before this console began; ask for bring_up"});
}

TEST_F(RestartedConsole, EnablesNoMoverThatSomebodyDisabled) {
  EXPECT_TRUE(onlooker_.teleop.disable());
  pass(50ms);
  restart();
  EXPECT_EQ(teleop_.teleop_state(), TeleopState::Disabled);
  EXPECT_EQ(restarted_.console_state(), ConsoleState::Incomplete);
  EXPECT_TRUE(onlooker_.teleop.enable());
  EXPECT_TRUE(
      suture::clockOfTest().until([&] { return restarted_.console_state() == ConsoleState::Up; }));
}

TEST_F(RestartedConsole, FindsARunningSystemUp) {
  onlooker_.order.clear();
  restart();
  EXPECT_EQ(restarted_.console_state(), ConsoleState::Up);
  look();
  EXPECT_EQ(onlooker_.order, Names{}) << "no part was asked for anything";
  EXPECT_EQ(onlooker_.warnings, Names{});
}

}  // namespace
}  // namespace robots::test
