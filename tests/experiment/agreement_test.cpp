// When a trial in real time agrees with the stepped clock's.

#include "experiment/agreement.h"

#include <gtest/gtest.h>

namespace experiment {
namespace {

Point equalPoint() {
  const Result result{.outcome = Outcome::Placed, .time = 5, .tracking50 = 0.002};
  return {.trial = {}, .real = {.result = result}, .stepped = result};
}

TEST(Agreement, IsWithinATenthOfTimeAndOfTracking) {
  EXPECT_TRUE(agrees(equalPoint()));
  Point point = equalPoint();
  point.real.result.time = 5.49;
  EXPECT_TRUE(agrees(point));
  point.real.result.time = 5.51;
  EXPECT_FALSE(agrees(point));
  point = equalPoint();
  point.real.result.tracking50 = 0.00179;
  EXPECT_FALSE(agrees(point));
}

TEST(Agreement, IsOfOutcomesToo) {
  Point point = equalPoint();
  point.real.result.outcome = Outcome::Misses;
  EXPECT_FALSE(agrees(point));
  point = equalPoint();
  point.real.result.time.reset();
  EXPECT_FALSE(agrees(point));
}

TEST(Agreement, ThereAreSixPoints) { EXPECT_EQ(realTimePoints().size(), 6u); }

}  // namespace
}  // namespace experiment
