// Hands feel fixtures as something viscous, and get no energy from news of them that come late.

#include "force_feedback/fixture_resistance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <stdexcept>

#include "hand/hand.h"
#include "support/allocations.h"

namespace robots::test {
namespace {

using Eigen::Vector3d;

constexpr double kTick = 0.001;        // s
constexpr double kMostLacking = 1e-3;  // J, that may be missing

/// A hand sways twice a second about a plane across x, beyond which it may not lead the tip, and
/// hears so many cycles late that it did. Returns the least energy that it has given, J.
double leastOfSwaying(bool passive, std::size_t late) {
  FixtureResistance feedback({.port = {.passive = passive}});
  Hand hand{HandModel{}};
  std::deque<Vector3d> link(late, Vector3d::Zero());
  double least = 0;
  for (int i = 0; i < 10'000; ++i) {
    const double outward = hand.position().x() > 0 ? std::max(hand.velocity().x(), 0.0) : 0;
    link.emplace_back(outward, 0, 0);
    const Vector3d force = feedback.force({hand.position(), hand.velocity()}, link.front(), kTick);
    link.pop_front();
    const double wanted = 0.02 * std::sin(4 * std::numbers::pi * i * kTick);
    hand.advance(kTick, {wanted, 0, 0}, force);
    least = std::min(least, feedback.energy().minCoeff());
  }
  return least;
}

TEST(FixtureResistance, PushesAgainstWhatIsForbidden) {
  FixtureResistance feedback({.damping = 10});
  const TipMotion hand{.velocity = {0.1, 0, 0}};
  EXPECT_EQ(feedback.force(hand, {0.1, 0, -0.2}, kTick), Vector3d(-1, 0, 2));
  EXPECT_EQ(feedback.force(hand, Vector3d::Zero(), kTick), Vector3d::Zero());
}

TEST(FixtureResistance, IsPassiveByItselfWithoutADelay) {
  EXPECT_GT(leastOfSwaying(false, 0), -kMostLacking);
}

TEST(FixtureResistance, LateNewsGiveEnergyWithoutTheController) {
  EXPECT_LT(leastOfSwaying(false, 200), -10 * kMostLacking);
}

TEST(FixtureResistance, LateNewsGiveNoneWithTheController) {
  for (const std::size_t late : {1u, 20u, 100u, 200u, 300u}) {
    EXPECT_GT(leastOfSwaying(true, late), -kMostLacking) << late;
  }
}

TEST(FixtureResistance, PushesNoHarderThanItsBound) {
  FixtureResistance feedback({.damping = 1000, .port = {.most_force = 4}});
  EXPECT_EQ(feedback.force({}, {1, 0, 0}, kTick), Vector3d(-4, 0, 0));
}

TEST(FixtureResistance, RefusesWhatCannotBe) {
  EXPECT_THROW(FixtureResistance({.damping = -1}), std::invalid_argument);
  EXPECT_THROW(FixtureResistance({.damping = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(FixtureResistance({.port = {.mass = -1}}), std::invalid_argument);
}

TEST(FixtureResistance, NeverAllocatesInACycle) {
  FixtureResistance feedback(FixtureResistanceModel{});
  const TipMotion hand{.velocity = {0.1, 0.1, 0.1}};
  const std::uint64_t before = suture::allocations();
  for (int i = 0; i < 1000; ++i) feedback.force(hand, {0.1, 0, 0}, kTick);
  EXPECT_EQ(suture::allocations() - before, 0u);
}

}  // namespace
}  // namespace robots::test
