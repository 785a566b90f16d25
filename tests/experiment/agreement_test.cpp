// These say when a trial in real time agrees with the stepped clock's.

#include "experiment/agreement.h"

#include <gtest/gtest.h>

namespace experiment {
namespace {

Result placed(double time, double tracking) {
  return {.outcome = Outcome::Placed, .time = time, .tracking50 = tracking};
}

/// Returns a point with a knot that is placed after 5 s, and tracked within 2 mm.
Point pointWith(const Result& real, bool fixtures) {
  return {.trial = {.link = {}, .fixtures = fixtures},
          .real = {placed(4, 0.001), real},
          .stepped = {placed(4, 0.001), placed(6, 0.003)}};
}

TEST(Agreement, WithFixturesItComparesTheTime) {
  EXPECT_NEAR(difference(pointWith(placed(6.6, 9), true)), 0.06, 1e-9);
  EXPECT_TRUE(agrees(pointWith(placed(6.99, 9), true)));
  EXPECT_FALSE(agrees(pointWith(placed(7.01, 9), true)));
  EXPECT_FALSE(agrees(pointWith(placed(4.99, 9), true)));
}

TEST(Agreement, WithoutFixturesItComparesTheTracking) {
  EXPECT_TRUE(agrees(pointWith(placed(9, 0.00339), false)));
  EXPECT_FALSE(agrees(pointWith(placed(9, 0.00341), false)));
}

TEST(Agreement, AnUnplacedKnotAgreesWithNone) {
  Result missed = placed(6, 0.003);
  missed.outcome = Outcome::Misses;
  EXPECT_FALSE(agrees(pointWith(missed, false)));
  missed.time.reset();
  EXPECT_FALSE(agrees(pointWith(missed, true)));
}

TEST(Agreement, ThereAreSixPoints) { EXPECT_EQ(realTimePoints().size(), 6u); }

}  // namespace
}  // namespace experiment
