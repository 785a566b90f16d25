// The jaw follows the gripper: jaw = scale x gripper + offset, slowly until it has caught up.

#include "teleop/jaw_law.h"

#include <gtest/gtest.h>

namespace robots::test {
namespace {

constexpr JawSettings kSettings{
    .scale = 2, .offset = 0.1, .rate = 10, .ghost_rate = 0.5, .tolerance = 0.03};

TEST(JawLaw, BeginsWhereTheJawIs) {
  JawLaw law(kSettings, 0.7);
  EXPECT_EQ(law.follow(0.2, 0), 0.7);
}

TEST(JawLaw, CatchesUpSlowlyAsAGhost) {
  JawLaw law(kSettings, 0.7);  // the gripper asks for 0.5
  EXPECT_NEAR(law.follow(0.2, 0.1), 0.65, 1e-12);
  EXPECT_TRUE(law.isGhost());
  EXPECT_NEAR(law.follow(0.2, 0.2), 0.55, 1e-12);
  EXPECT_TRUE(law.isGhost());
  EXPECT_NEAR(law.follow(0.2, 0.05), 0.525, 1e-12);
  EXPECT_FALSE(law.isGhost()) << "it is within the tolerance";
}

TEST(JawLaw, FollowsFastOnceItHasCaughtUp) {
  JawLaw law(kSettings, 0.5);
  EXPECT_NEAR(law.follow(0.2, 0), 0.5, 1e-12);
  EXPECT_NEAR(law.follow(0.4, 0.1), 0.9, 1e-12);
  EXPECT_NEAR(law.follow(-0.4, 0.1), -0.1, 1e-12) << "1 rad in 0.1 s";
  EXPECT_NEAR(law.follow(-0.4, 0.1), -0.7, 1e-12);
  EXPECT_FALSE(law.isGhost()) << "far behind is not a new entry";
}

}  // namespace
}  // namespace robots::test
