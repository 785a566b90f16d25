// The judge gets courses that are known.

#include "experiment/result.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace experiment {
namespace {

constexpr std::size_t kMoments = 20'000;

/// Returns 20 s in which the knot is `error(t)` m from its target.
template <class Error>
std::vector<Moment> course(const Error& error) {
  std::vector<Moment> moments(kMoments);
  for (std::size_t i = 0; i < kMoments; ++i) {
    moments[i] = {.error = {error(kMomentLength * static_cast<double>(i)), 0, 0},
                  .guided = true,
                  .left = 0.001,
                  .right = 0.003};
  }
  return moments;
}

double swinging(double t, double amplitude) { return amplitude * std::sin(2 * t); }

TEST(Judge, PlacedMeansNearForTwoSeconds) {
  const Result result = judge(course([](double t) { return t < 5 ? 0.01 : 0.0005; }));
  EXPECT_EQ(result.outcome, Outcome::Placed);
  EXPECT_NEAR(result.time.value_or(0), 5, 0.002);
  EXPECT_NEAR(result.error, 0.0005, 1e-9);
  EXPECT_EQ(result.guided, 1);
}

TEST(Judge, PassingTheTargetIsNotPlacing) {
  EXPECT_FALSE(judge(course([](double t) { return 0.02 - 0.004 * t; })).time);
  EXPECT_FALSE(judge(course([](double t) { return swinging(t, 0.005); })).time);
}

TEST(Judge, TellsSteadySwingsFromGrowingOnes) {
  const auto outcomeOf = [](auto error) { return judge(course(error)).outcome; };
  EXPECT_EQ(outcomeOf([](double t) { return swinging(t, 0.005); }), Outcome::Oscillates);
  EXPECT_EQ(outcomeOf([](double t) { return swinging(t, 0.001 * t); }), Outcome::Diverges);
  EXPECT_EQ(outcomeOf([](double) { return 0.003; }), Outcome::Misses);
}

TEST(Judge, AnEndedGuideHasPlacedNothing) {
  auto moments = course([](double) { return 0.0005; });
  for (std::size_t i = kMoments - 1000; i < kMoments; ++i) moments[i].guided = false;
  EXPECT_EQ(judge(moments).outcome, Outcome::Unguided);
  EXPECT_EQ(judge({}).outcome, Outcome::Unguided);
}

TEST(Judge, TrackingCountsBothGuidedSlaves) {
  auto moments = course([](double) { return 0.0005; });
  moments[7] = {.error = {0.0005, 0, 0}, .guided = false, .left = 1, .right = 1};
  const Result result = judge(moments);
  EXPECT_EQ(result.tracking50, 0.001);
  EXPECT_EQ(result.tracking99, 0.003);
}

}  // namespace
}  // namespace experiment
