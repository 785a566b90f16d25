// The guide of a knot holds both slaves while the surgeon is away or has a foot on the clutch.

#include <gtest/gtest.h>

#include "integration/teleoperation/scene/guided_arms.h"

namespace robots::test {
namespace {

class GuideWithPedals : public Guide {
 protected:
  GuideWithPedals() {
    manager_.connect("Guide/Pedals", "Console/Pedals");
    manager_.connect("Guide/Presence", "Console/Presence");
    pass(10ms);
    EXPECT_TRUE(becomes(GuidanceState::Guiding));
  }

  /// Both slaves hold, and the masters move without them, until `resume()`; then they follow from
  /// where they are.
  template <class Resume>
  void expectThatBothHoldUntil(const Resume& resume) {
    ASSERT_TRUE(becomes(GuidanceState::Clutched));
    pass(2ms);
    forgetGoals();
    const Vector3d leftHeld = left(), rightHeld = right();
    moveMasters({0.03, 0.02, 0}, 50);
    EXPECT_EQ(goals(), 0u);
    resume();
    ASSERT_TRUE(becomes(GuidanceState::Guiding));
    pass(5ms);
    EXPECT_GT(goals(), 0u);
    EXPECT_TRUE(left().isApprox(leftHeld, 1e-9)) << "it jumped";
    EXPECT_TRUE(right().isApprox(rightHeld, 1e-9)) << "it jumped";
    expectThatBothFollow();
  }
};

TEST_F(GuideWithPedals, TheClutchHoldsBothSlaves) {
  console_.clutch = true;
  expectThatBothHoldUntil([&] { console_.clutch = false; });
}

TEST_F(GuideWithPedals, HoldsBothSlavesWithoutASurgeon) {
  console_.present = false;
  expectThatBothHoldUntil([&] { console_.present = true; });
}

TEST_F(GuideWithPedals, HoldsBothSlavesWhilePedalsAreSilent) {
  console_.stuck = true;
  expectThatBothHoldUntil([&] { console_.stuck = false; });
}

TEST_F(GuideWithPedals, FuturePedalsHoldBothSlaves) {
  console_.ahead = 1000;
  expectThatBothHoldUntil([&] { console_.ahead = 0; });
}

/// A clock that is ahead makes them no newer.
TEST_F(GuideWithPedals, MissingPedalRowsHoldBothSlaves) {
  console_.ahead = 150;
  pass(20ms);
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Guiding) << "that is near enough";
  manager_.disconnect("Guide/Pedals");
  manager_.connect("Guide/Pedals", "Console/Pedals", {.delay = {.answers = 250ms}});
  pass(300ms);
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Clutched);
}

/// The knot is not lost meanwhile, since only the tips move it.
TEST_F(GuideWithPedals, TheClutchHidesNoKnot) {
  console_.clutch = true;
  ASSERT_TRUE(becomes(GuidanceState::Clutched));
  pass(100ms);
  EXPECT_TRUE(guide_.progress().valid);
}

}  // namespace
}  // namespace robots::test
