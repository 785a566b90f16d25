// These press keys at stated times and compare the motion that they mean.

#include "person/key_motion.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string_view>

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;

class KeyMotionTest : public testing::Test {
 protected:
  void press(std::string_view pressed, suture::Duration after = {}) {
    for (const char key : pressed) keys_.take(key, kStart + after);
  }
  HandInput at(suture::Duration after) const { return keys_.at(kStart + after); }

  const suture::Time kStart = suture::fromNanoseconds(5'000'000'000);
  KeyMotion keys_{{.speed = 0.02, .turning_speed = 0.3, .hold = 150ms}};
};

TEST_F(KeyMotionTest, OutlastsTheLastRepeat) {
  press("d");
  EXPECT_EQ(at(0ms).velocity, Vector3d(0.02, 0, 0));
  press("d", 140ms);
  press("d", 170ms);
  EXPECT_EQ(at(320ms - 1ns).velocity, Vector3d(0.02, 0, 0));
  EXPECT_TRUE(at(320ms).isAtRest());
}

TEST_F(KeyMotionTest, CountsEachKeysTimeAlone) {
  press("w");
  press("d", 100ms);
  EXPECT_EQ(at(149ms).velocity, Vector3d(0.02, 0.02, 0));
  EXPECT_EQ(at(150ms).velocity, Vector3d(0.02, 0, 0));
  EXPECT_TRUE(at(250ms).isAtRest());
}

TEST_F(KeyMotionTest, GivesEachDirectionAKey) {
  press("dwr");
  EXPECT_EQ(at(1ms).velocity, Vector3d(0.02, 0.02, 0.02));
  press("asf", 2ms);
  EXPECT_EQ(at(3ms).velocity, Vector3d(-0.02, -0.02, -0.02)) << "the opposite key ends a motion";
  EXPECT_TRUE(at(3ms).angular_velocity.isZero(0));
}

TEST_F(KeyMotionTest, TurnsAboutEachAxis) {
  press("ilo");
  EXPECT_EQ(at(1ms).angular_velocity, Vector3d(0.3, 0.3, 0.3));
  press("kju", 2ms);
  EXPECT_EQ(at(3ms).angular_velocity, Vector3d(-0.3, -0.3, -0.3));
  EXPECT_TRUE(at(3ms).velocity.isZero(0));
}

TEST_F(KeyMotionTest, OneKeyPressesAndAnotherReleases) {
  EXPECT_FALSE(keys_.clutch());
  press("x");
  EXPECT_TRUE(keys_.clutch());
  press("d ");
  EXPECT_TRUE(keys_.clutch()) << "nothing else releases it";
  press("z");
  EXPECT_FALSE(keys_.clutch());
}

// Whether a terminal repeats an even number of times is a matter of luck.
TEST_F(KeyMotionTest, ARepeatedKeyKeepsTheClutch) {
  press("xx");
  EXPECT_TRUE(keys_.clutch());
  press("xxx");
  EXPECT_TRUE(keys_.clutch());
}

TEST_F(KeyMotionTest, StopsAtOnceAtASpace) {
  press("dwi");
  press(" ", 20ms);
  EXPECT_TRUE(at(20ms).isAtRest());
}

TEST_F(KeyMotionTest, AKeyOpensAndClosesTheGripper) {
  EXPECT_FALSE(at(0ms).opening);
  press("c");
  EXPECT_EQ(at(1s).opening, 0);
  press("v", 2s);
  EXPECT_EQ(at(3s).opening, 1);
  EXPECT_TRUE(at(3s).isAtRest());
}

TEST_F(KeyMotionTest, IgnoresWhatHasNoMeaning) {
  press("DWyq7\n\t\x7f");
  EXPECT_TRUE(at(1ms).isAtRest());
  EXPECT_FALSE(at(1ms).opening);
}

// These are an arrow with Shift of one terminal, one with Ctrl of others, Alt and a letter.
TEST_F(KeyMotionTest, IgnoresSequencesThatEndInItsLetter) {
  press(
      "\x1b[d\x1bOd\x1b[1;5d\x1b"
      "d");
  EXPECT_TRUE(at(1ms).isAtRest());
  press("d", 2ms);
  EXPECT_EQ(at(3ms).velocity, Vector3d(0.02, 0, 0));
}

TEST_F(KeyMotionTest, TakesTheKeyAfterEscape) {
  press("\x1b");
  press("x", 10s);
  EXPECT_TRUE(keys_.clutch());
  press("d\x1b", 20s);
  press(" ", 20s + 100ms);
  EXPECT_TRUE(at(20s + 100ms).isAtRest());
}

}  // namespace
}  // namespace robots::test
