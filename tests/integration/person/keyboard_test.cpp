// A person is at a keyboard, whose keys come through a pseudo terminal.

#include "person/keyboard.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>

#include "integration/person/seat.h"
#include "support/allocations.h"
#include "surgeon/pause.h"
#include "unit/person/pseudo_terminal.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

class KeyboardTest : public testing::Test {
 protected:
  void start() { seat_.start(keyboard_); }
  suture::Time lastGoal() const { return seat_.master.goals().back().stamp; }

  PseudoTerminal pty_;
  Keyboard keyboard_{{.terminal = pty_.path(), .speed = 0.02, .opening = 0.6}};
  Seat seat_;
};

// The cycle after the press reads it, and the one 150 ms after that rests.
TEST_F(KeyboardTest, OnePressMovesForHundredFiftyMilliseconds) {
  start();
  const suture::Time pressed = suture::now();
  pty_.type("d");
  pass(1s);
  EXPECT_EQ(lastGoal() - pressed, 150ms);
  EXPECT_TRUE(seat_.position().isApprox(Eigen::Vector3d(0.02 * 0.15, 0, 0), 1e-9))
      << seat_.position().transpose();
}

TEST_F(KeyboardTest, MotionOutlastsTheLastRepeat) {
  start();
  suture::Time repeated;
  for (int i = 0; i < 10; ++i) {
    repeated = suture::now();
    pty_.type("w");
    pass(33ms);
  }
  pass(1s);
  EXPECT_EQ(lastGoal() - repeated, 150ms);
  EXPECT_NEAR(seat_.position().y(), 0.02 * (9 * 0.033 + 0.15), 1e-9) << "it has rested meanwhile";
}

TEST_F(KeyboardTest, TellsWhichKeyDoesWhat) {
  start();
  EXPECT_TRUE(seat_.listener.processEvents());
  ASSERT_EQ(seat_.listener.statuses.size(), 1u);
  EXPECT_EQ(seat_.listener.statuses.front(), KeyMotion::kHelp) << "a message cuts a longer one";
}

TEST_F(KeyboardTest, MovesNothingUntilTheArmIsReady) {
  start();
  seat_.master.sayDisabled(true);
  pass(5ms);
  pty_.type("d");
  EXPECT_EQ(seat_.goalsIn(100ms), 0u);
  seat_.master.sayDisabled(false);
  EXPECT_EQ(seat_.goalsIn(1s), 0u) << "it was meant for then";
  pty_.type("d");
  EXPECT_GT(seat_.goalsIn(1s), 0u);
}

// Meanwhile a shell has had the terminal.
TEST_F(KeyboardTest, ForgetsKeysThatCameBeforeItRan) {
  seat_.connect(keyboard_);
  seat_.addHand();
  seat_.begin();
  seat_.manager.suspend("Person");
  pass(10ms);
  pty_.type("dddv");
  pass(2 * kLongestPause);
  pty_.waitForLines();
  seat_.manager.resume("Person");
  EXPECT_EQ(seat_.goalsIn(1s), 0u);
  EXPECT_EQ(seat_.hand.angle, -1);
  EXPECT_TRUE(pty_.handsOverKeys());
}

TEST_F(KeyboardTest, StopsWhenTheTerminalIsGone) {
  start();
  pty_.type("d");
  EXPECT_GT(seat_.goalsIn(10ms), 0u);
  pty_.hangUp();
  pass(1ms);
  EXPECT_EQ(seat_.goalsIn(1s), 0u);
  EXPECT_TRUE(seat_.listener.processEvents());
  EXPECT_EQ(seat_.listener.errors.size(), 1u);
}

TEST_F(KeyboardTest, OpensAndClosesTheGripper) {
  seat_.connect(keyboard_);
  seat_.addHand();
  seat_.begin();
  EXPECT_EQ(seat_.hand.angle, -1) << "nobody has said so yet";
  pty_.type("v");
  pass(5ms);
  EXPECT_EQ(seat_.hand.angle, 0.6);
  pty_.type("c");
  pass(5ms);
  EXPECT_EQ(seat_.hand.angle, 0);
}

TEST_F(KeyboardTest, ItsClutchIsFreshWithTheTerminal) {
  seat_.connect(keyboard_);
  seat_.addFeet();
  seat_.begin();
  (void)seat_.feet.pedals.pedals();
  pty_.type("x");
  pass(5ms);
  ASSERT_TRUE(seat_.feet.pedals.pedals());
  EXPECT_TRUE(seat_.feet.pedals.pedals()->clutch);
  EXPECT_LE(suture::now() - seat_.feet.pedals.pedals()->stamp, 2ms);
  pty_.type("z");
  pass(5ms);
  EXPECT_FALSE(seat_.feet.pedals.pedals()->clutch);
  pty_.hangUp();
  pass(300ms);
  EXPECT_GT(suture::now() - seat_.feet.pedals.pedals()->stamp, 290ms);
  EXPECT_TRUE(seat_.feet.processEvents());
  EXPECT_EQ(seat_.feet.clutch, (std::vector<bool>{false, true, false}));
}

TEST(Keyboard, LeavesTheTerminalAsItWas) {
  const PseudoTerminal pty;
  {
    Keyboard keyboard{{.terminal = pty.path()}};
    Seat seat;
    seat.start(keyboard);
    EXPECT_TRUE(pty.handsOverKeys());
  }
  EXPECT_FALSE(pty.handsOverKeys());
}

// There is no arm, since its clock and its goals would be counted too.
TEST(Keyboard, NeverAllocatesInItsCycle) {
  PseudoTerminal pty;
  Keyboard keyboard{{.terminal = pty.path()}};
  const std::uint64_t before = suture::allocations();
  keyboard.run();
  pty.type("dv");
  keyboard.run();
  pty.hangUp();
  for (int i = 0; i < 10; ++i) keyboard.run();
  EXPECT_EQ(suture::allocations() - before, 0u);
}

}  // namespace
}  // namespace robots::test
