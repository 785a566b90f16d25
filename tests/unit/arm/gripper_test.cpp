// These test the gripper of a master, as its drives measure it.

#include "arm_control/gripper_reading.h"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

namespace robots::test {
namespace {

class GripperTest : public testing::Test {
 protected:
  struct Heard {
    std::vector<bool> states;
    void closed(bool is) { states.push_back(is); }
  };

  void hold(double angle, int cycles) {
    for (int i = 0; i < cycles; ++i) {
      time_ += std::chrono::milliseconds(1);
      DriveReading<7> reading;
      reading.stamp = time_;
      reading.tool = {.position = angle, .velocity = 0.5};
      gripper_.step(time_, reading);
      gripper_.announce(heard_);
    }
  }

  GripperReading gripper_{{.lower = -0.2, .upper = 1, .closed = 0.05, .debounce = 0.02}};
  suture::Time time_ = suture::fromNanoseconds(1'000'000'000);
  Heard heard_;
};

TEST_F(GripperTest, TellsWhatIsMeasured) {
  EXPECT_FALSE(gripper_.measured_js().valid) << "nothing has been measured";
  hold(0.4, 1);
  EXPECT_EQ(gripper_.measured_js().position, std::vector{0.4});
  EXPECT_EQ(gripper_.measured_js().velocity, std::vector{0.5});
  EXPECT_EQ(gripper_.measured_js().stamp, time_);
  EXPECT_TRUE(gripper_.measured_js().valid);
  gripper_.step(time_, std::nullopt);
  EXPECT_FALSE(gripper_.measured_js().valid) << "the drives are silent";
}

TEST_F(GripperTest, TellsWhenItOpensOrCloses) {
  hold(0.4, 50);
  EXPECT_EQ(heard_.states, std::vector{false});
  hold(0.05, 50);
  EXPECT_EQ(heard_.states, (std::vector{false, true}));
  hold(0.06, 50);
  EXPECT_EQ(heard_.states, (std::vector{false, true, false}));
}

TEST_F(GripperTest, IsNotClosedByATremble) {
  hold(0.4, 50);
  for (int i = 0; i < 10; ++i) {
    hold(0.04, 10);
    hold(0.06, 10);
  }
  EXPECT_EQ(heard_.states, std::vector{false});
}

TEST_F(GripperTest, TellsItsRange) {
  EXPECT_EQ(gripper_.configuration_js().position_min, std::vector{-0.2});
  EXPECT_EQ(gripper_.configuration_js().position_max, std::vector{1.0});
}

}  // namespace
}  // namespace robots::test
