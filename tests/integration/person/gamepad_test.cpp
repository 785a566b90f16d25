// A person is at a gamepad, whose events come through a FIFO.

#include "person/gamepad.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "integration/person/seat.h"
#include "pedals/foot_pedals.suture.h"
#include "support/allocations.h"
#include "unit/person/fifo.h"
#include "unit/person/recorded_events.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

class GamepadTest : public testing::Test {
 protected:
  void start() {
    fifo_.plugIn();
    seat_.start(gamepad_);
  }
  void startWithTeleoperation() {
    fifo_.plugIn();
    seat_.connect(gamepad_);
    seat_.addTeleoperation();
    seat_.begin();
  }
  /// It has just been told to the right, at full speed.
  void pushRight() {
    fifo_.write(stickToTheRight());
    pass(1ms);
    ASSERT_GT(seat_.goalsIn(20ms), 0u) << "it does not move";
  }
  std::vector<std::string> errors() {
    EXPECT_TRUE(seat_.listener.processEvents());
    return seat_.listener.errors;
  }

  Fifo fifo_;
  Gamepad gamepad_{{.file = fifo_.path(), .speed = 0.05, .turning_speed = 0.5, .opening = 0.6}};
  Seat seat_;
};

TEST_F(GamepadTest, MovesAsFastAsTheStickSays) {
  start();
  fifo_.write(stickToTheRight());
  pass(200ms);
  fifo_.write(stickReleased());
  EXPECT_LE(seat_.goalsIn(200ms), 1u);
  EXPECT_TRUE(seat_.position().isApprox(Eigen::Vector3d(0.05 * 0.2, 0, 0), 1e-9))
      << seat_.position().transpose();
}

TEST_F(GamepadTest, TurnsAsFastAsTheStickSays) {
  start();
  fifo_.write({axis(ABS_RX, 32767), report()});
  pass(200ms);
  fifo_.write({axis(ABS_RX, 0), report()});
  pass(5ms);
  const Eigen::AngleAxisd turned(seat_.master.pose().linear());
  EXPECT_NEAR(turned.angle(), 0.5 * 0.2, 1e-6);
  EXPECT_TRUE(turned.axis().isApprox(Eigen::Vector3d::UnitZ(), 1e-6));
}

TEST_F(GamepadTest, TakesAnEventInTwoParts) {
  start();
  const auto events = stickToTheRight();
  fifo_.write(events, 0, 10);
  EXPECT_EQ(seat_.goalsIn(20ms), 0u);
  fifo_.write(events, 10, 2 * sizeof(input_event) - 1);
  EXPECT_EQ(seat_.goalsIn(20ms), 0u);
  fifo_.write(events, 2 * sizeof(input_event) - 1, 2 * sizeof(input_event));
  EXPECT_GT(seat_.goalsIn(20ms), 0u);
}

TEST_F(GamepadTest, RestsAfterDroppedEvents) {
  start();
  pushRight();
  fifo_.write({dropped(), axis(ABS_X, 32767)});
  pass(1ms);
  EXPECT_EQ(seat_.goalsIn(20ms), 0u);
  fifo_.write({report()});
  EXPECT_EQ(seat_.goalsIn(20ms), 0u);
  fifo_.write({axis(ABS_X, 32767), report()});
  EXPECT_GT(seat_.goalsIn(20ms), 0u);
}

TEST_F(GamepadTest, RestsWhenItsDeviceIsGone) {
  start();
  pushRight();
  EXPECT_TRUE(errors().empty());
  fifo_.pullOut();
  pass(1ms);
  EXPECT_EQ(seat_.goalsIn(5s), 0u);
  ASSERT_EQ(errors().size(), 1u);
  EXPECT_NE(errors().front().find(fifo_.path()), std::string::npos) << errors().front();

  fifo_.plugIn();
  EXPECT_EQ(seat_.goalsIn(2s), 0u) << "the stick was held when it was there last";
  EXPECT_EQ(errors().size(), 1u);
  EXPECT_EQ(seat_.listener.statuses.size(), 2u) << "it is there, and is there again";
  pushRight();
  fifo_.pullOut();
  pass(1s);
  EXPECT_EQ(errors().size(), 2u);
}

TEST_F(GamepadTest, WaitsForItsDevice) {
  seat_.start(gamepad_);
  pass(5s);
  EXPECT_EQ(errors().size(), 1u);
  fifo_.plugIn();
  pass(1s);
  pushRight();
}

TEST_F(GamepadTest, MovesNothingUntilTheArmIsReady) {
  start();
  seat_.master.sayDisabled(true);
  pass(5ms);
  fifo_.write(stickToTheRight());
  EXPECT_EQ(seat_.goalsIn(100ms), 0u);
  seat_.master.sayDisabled(false);
  EXPECT_EQ(seat_.goalsIn(100ms), 0u) << "the stick has to be let go first";
  fifo_.write(stickReleased());
  EXPECT_EQ(seat_.goalsIn(5ms), 0u);
  pushRight();
}

TEST_F(GamepadTest, MovesNothingWhileTheArmIsSilent) {
  start();
  pushRight();
  seat_.master.beSilent(true);
  pass(25ms);
  EXPECT_EQ(seat_.goalsIn(100ms), 0u);
}

TEST_F(GamepadTest, BeginsEachTimeWhereTheArmIs) {
  start();
  pushRight();
  fifo_.write(stickReleased());
  pass(5ms);
  Eigen::Isometry3d elsewhere = Eigen::Isometry3d::Identity();
  elsewhere.translation() = Eigen::Vector3d(-0.3, 0.1, 0.2);
  seat_.master.place(elsewhere);
  pass(5ms);
  pushRight();
  EXPECT_LT((seat_.position() - elsewhere.translation()).norm(), 0.002) << "it leapt";
}

TEST_F(GamepadTest, GoesOnAfterARefusedStep) {
  start();
  pushRight();
  seat_.master.refuseStepsBeyond(0.005);
  Eigen::Isometry3d elsewhere = seat_.master.pose();
  elsewhere.translation().y() += 0.01;
  seat_.master.place(elsewhere);
  pass(10ms);
  EXPECT_GT(seat_.goalsIn(20ms), 0u);
  EXPECT_NEAR(seat_.position().y(), 0.01, 1e-9);
}

TEST_F(GamepadTest, ComesAwayFromALimitAtOnce) {
  start();
  seat_.master.stayAbove(-0.001);
  fifo_.write({axis(ABS_RY, 32767), report()});
  pass(10s);
  EXPECT_NEAR(seat_.position().z(), -0.001, 1e-9);
  fifo_.write({axis(ABS_RY, -32768), report()});
  pass(500ms);
  EXPECT_GT(seat_.position().z(), 0.002) << "its goal ran away behind the limit";
}

TEST_F(GamepadTest, MovesWhileFollowedOrClutched) {
  startWithTeleoperation();
  pushRight();
  for (const TeleopState other :
       {TeleopState::Preparing, TeleopState::Aligning, TeleopState::Disabled}) {
    seat_.teleoperation.state = other;
    pass(5ms);
    EXPECT_EQ(seat_.goalsIn(50ms), 0u) << static_cast<int>(other);
  }
  seat_.teleoperation.state = TeleopState::Clutched;
  fifo_.write(stickReleased());
  pass(5ms);
  pushRight();
}

TEST_F(GamepadTest, LeadsTheGripperByItsTrigger) {
  fifo_.plugIn();
  seat_.connect(gamepad_);
  seat_.addHand();
  seat_.begin();
  EXPECT_EQ(seat_.hand.angle, -1) << "nobody has touched the trigger";
  fifo_.write({axis(ABS_RZ, 51), report()});
  pass(5ms);
  EXPECT_NEAR(seat_.hand.angle, 0.8 * 0.6, 1e-9);
  fifo_.write({axis(ABS_RZ, 255), report()});
  pass(5ms);
  EXPECT_EQ(seat_.hand.angle, 0);
  seat_.master.sayDisabled(true);
  pass(5ms);
  fifo_.write({axis(ABS_RZ, 0), axis(ABS_X, 32767), report()});
  pass(50ms);
  EXPECT_EQ(seat_.hand.angle, 0) << "the arm is not ready";
  seat_.master.sayDisabled(false);
  pass(50ms);
  EXPECT_EQ(seat_.hand.angle, 0) << "the stick has to be let go first";
  fifo_.write(stickReleased());
  pass(5ms);
  EXPECT_EQ(seat_.hand.angle, 0.6);
}

TEST_F(GamepadTest, ItsClutchIsFreshWithTheDevice) {
  fifo_.plugIn();
  seat_.connect(gamepad_);
  seat_.addFeet();
  seat_.begin();
  (void)seat_.feet.pedals.pedals();
  const auto press = [&](bool pressed) {
    fifo_.write({button(BTN_TL, pressed), report()});
    pass(5ms);
  };
  pass(5ms);
  ASSERT_TRUE(seat_.feet.pedals.pedals());
  EXPECT_TRUE(seat_.feet.pedals.pedals()->clutch) << "somebody may have held it before";
  press(true);
  EXPECT_TRUE(seat_.feet.pedals.pedals()->clutch);
  press(false);
  EXPECT_FALSE(seat_.feet.pedals.pedals()->clutch);
  EXPECT_LE(suture::now() - seat_.feet.pedals.pedals()->stamp, 2ms);
  fifo_.pullOut();
  pass(300ms);
  EXPECT_TRUE(seat_.feet.pedals.pedals()->clutch) << "nobody knows, so it counts as pressed";
  EXPECT_GT(suture::now() - seat_.feet.pedals.pedals()->stamp, 290ms);
  EXPECT_TRUE(seat_.feet.processEvents());
  EXPECT_EQ(seat_.feet.clutch, (std::vector<bool>{true, false, true}));
}

// There is no arm, since its clock and its goals would be counted too.
TEST(Gamepad, NeverAllocatesInItsCycle) {
  Fifo fifo;
  fifo.plugIn();
  Gamepad gamepad{{.file = fifo.path()}};
  fifo.write({axis(ABS_X, 32767), button(BTN_TL, false), report(), dropped(), report()});
  const std::uint64_t before = suture::allocations();
  gamepad.run();
  EXPECT_TRUE(gamepad.pedals().clutch);
  fifo.pullOut();
  for (int i = 0; i < 10; ++i) gamepad.run();
  EXPECT_EQ(suture::allocations() - before, 0u);
}

}  // namespace
}  // namespace robots::test
