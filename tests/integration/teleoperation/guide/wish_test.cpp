// The guide does not make up later for what the fixtures forbade, or what a slave missed.

#include "integration/teleoperation/scene/guided_arms.h"

namespace robots::test {
namespace {

class GuideWish : public Guide {
 protected:
  void moveMaster(std::size_t which, const Vector3d& by) {
    for (int i = 0; i < 100; ++i) {
      arms_[which].place(Eigen::Translation3d(by / 100) * arms_[which].pose());
      pass(1ms);
    }
  }
};

// The left hand pushes the knot against the corridor and rests; the right hand gives room.
TEST_F(GuideWish, ARestingHandHoldsItsTip) {
  eyes_.seen_.knot.x() = 0.0303;  // the corridor's edge: 0.3 mm, and 0.3 m wider for each metre
  pass(50ms);
  moveMaster(0, {0.02, 0, 0});
  const Vector3d rested = left();
  moveMaster(1, {-0.02, 0, 0});
  EXPECT_LT((left() - rested).norm(), 0.5e-3) << "its hand has not moved";
}

TEST_F(GuideWish, HandsBeyondTheTargetPullBack) {
  eyes_.seen_.knot.z() = -0.15;
  pass(50ms);
  moveMasters({0, 0, -0.05}, 500);
  const Vector3d before = left();
  moveMasters({0, 0, 0.01}, 100);
  pass(5ms);
  EXPECT_NEAR((left() - before).z(), 0.004, 0.5e-3);
}

TEST_F(GuideWish, ASlaveWithoutGoalsIsNotGuided) {
  arms_[3].missGoals(true);
  ASSERT_TRUE(becomes(GuidanceState::Preparing));
  moveMasters({0, 0, 0.02}, 50);
  const Vector3d leftHeld = left(), rightHeld = right();
  arms_[3].missGoals(false);
  ASSERT_TRUE(becomes(GuidanceState::Guiding));
  pass(5ms);
  EXPECT_TRUE(left().isApprox(leftHeld, 1e-9)) << "it jumped";
  EXPECT_TRUE(right().isApprox(rightHeld, 1e-9)) << "it jumped";
  expectThatBothFollow();
}

TEST_F(GuideWish, SaysThatASlaveMissesGoals) {
  arms_[3].missGoals(true);
  ASSERT_TRUE(becomes(GuidanceState::Preparing));
  pass(kPreparationLimit + 1s);
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Disabled);
  complaints_.processEvents();
  EXPECT_NE(complaints_.error.find("carries out no goal"), std::string::npos) << complaints_.error;
}

}  // namespace
}  // namespace robots::test
