// These tests say what a gamepad's events come to.

#include "person/gamepad_decoder.h"

#include <gtest/gtest.h>
#include <suture/base/errors.h>

#include <vector>

#include "support/refusal.h"
#include "unit/person/recorded_events.h"

namespace robots::test {
namespace {

using Eigen::Vector3d;

class GamepadDecoderTest : public testing::Test {
 protected:
  const GamepadState& after(const std::vector<input_event>& events) {
    for (const input_event& one : events) decoder_.take(one);
    return decoder_.state();
  }

  GamepadDecoder decoder_{GamepadCalibration{}};
};

TEST_F(GamepadDecoderTest, RestsBeforeTheFirstEvent) {
  const GamepadState& state = decoder_.state();
  EXPECT_TRUE(state.push.isZero(0) && state.turn.isZero(0));
  EXPECT_FALSE(state.trigger);
  EXPECT_TRUE(state.clutch) << "it might be pressed";
}

TEST_F(GamepadDecoderTest, KnowsEachAxisByItsDirection) {
  const GamepadState& state =
      after({axis(ABS_X, 32767), axis(ABS_Y, 32767), axis(ABS_RY, -32768), axis(ABS_RX, -32768),
             axis(ABS_HAT0X, 1), axis(ABS_HAT0Y, 1), report()});
  EXPECT_EQ(state.push, Vector3d(1, -1, 1)) << "down is positive on the device";
  EXPECT_EQ(state.turn, Vector3d(-1, 1, -1));
}

TEST_F(GamepadDecoderTest, TakesTheEventsOfOneReportTogether) {
  EXPECT_EQ(after({axis(ABS_X, 32767), axis(ABS_RY, -32768)}).push, Vector3d::Zero());
  EXPECT_EQ(after({report()}).push, Vector3d(1, 0, 1));
}

TEST_F(GamepadDecoderTest, TheDeadZoneEndsWithoutALeap) {
  const auto pushOf = [this](double share) {
    return after({axis(ABS_X, static_cast<std::int32_t>(share * 32767)), report()}).push.x();
  };
  EXPECT_EQ(pushOf(0.149), 0);
  EXPECT_EQ(pushOf(-0.149), 0);
  EXPECT_NEAR(pushOf(0.151), 0.001 / 0.85, 1e-4);
  EXPECT_NEAR(pushOf(-0.575), -0.5, 1e-4);
}

TEST_F(GamepadDecoderTest, IsCalibratedByRanges) {
  GamepadDecoder decoder({.stick = {0, 255}, .trigger = {0, 1023}, .dead_zone = 0.1});
  for (const input_event& one :
       {axis(ABS_X, 255), axis(ABS_Y, 128), axis(ABS_RZ, 1023), report()}) {
    decoder.take(one);
  }
  EXPECT_EQ(decoder.state().push, Vector3d(1, 0, 0));
  EXPECT_EQ(decoder.state().trigger, 1);
  decoder.take(axis(ABS_X, 4000));
  decoder.take(report());
  EXPECT_EQ(decoder.state().push.x(), 1) << "beyond its range";
}

TEST_F(GamepadDecoderTest, KnowsTriggerAndClutch) {
  EXPECT_EQ(after({axis(ABS_RZ, 51), button(BTN_TL, true), report()}).trigger, 0.2);
  EXPECT_TRUE(decoder_.state().clutch);
  EXPECT_FALSE(after({button(BTN_TL, false), report()}).clutch);
}

TEST_F(GamepadDecoderTest, DroppedEventsRestUntilTheNextReport) {
  after(stickToTheRight());
  EXPECT_EQ(after({dropped()}).push, Vector3d::Zero());
  EXPECT_EQ(after({axis(ABS_Y, -32768), report()}).push, Vector3d::Zero())
      << "it is of a state that is gone";
  EXPECT_EQ(after({axis(ABS_Y, -32768), report()}).push, Vector3d(0, 1, 0));
}

TEST_F(GamepadDecoderTest, TakesAnUnknownClutchForPressed) {
  EXPECT_TRUE(after({dropped(), report()}).clutch);
  EXPECT_TRUE(after({button(BTN_TL, true), report()}).clutch);
  EXPECT_FALSE(after({button(BTN_TL, false), report()}).clutch);
}

TEST_F(GamepadDecoderTest, RefusesRangesThatAreEmpty) {
  for (const GamepadCalibration& impossible :
       {GamepadCalibration{.stick = {5, 5}}, GamepadCalibration{.trigger = {1, 0}},
        GamepadCalibration{.dead_zone = 1}}) {
    EXPECT_EQ(suture::refusal([&] { const GamepadDecoder decoder(impossible); }),
              "calibrating a gamepad: a range or what its dead zone leaves is empty. State the "
              "ranges that evtest prints, and a dead zone below 1");
  }
}

}  // namespace
}  // namespace robots::test
