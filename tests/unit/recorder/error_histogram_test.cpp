// Errors of a run of any length are summed up in fixed memory, and no figure is too small by that.

#include "recorder/judging.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace robots::test {
namespace {

TEST(ErrorHistogram, HasNoErrorsAtFirst) {
  const ErrorSummary summary = ErrorHistogram{}.summary();
  EXPECT_EQ(summary.p99, 0);
  EXPECT_EQ(summary.max, 0);
}

TEST(ErrorHistogram, QuantilesAreWithinOnePercent) {
  std::mt19937 random(3);
  std::lognormal_distribution<double> distribution(-9, 2);
  ErrorHistogram histogram;
  std::vector<double> errors;
  for (int i = 0; i < 20'000; ++i) {
    errors.push_back(distribution(random));
    histogram.add(errors.back());
  }
  const ErrorSummary exact = summarise(errors), found = histogram.summary();
  EXPECT_EQ(histogram.count(), errors.size());
  EXPECT_EQ(found.max, exact.max);
  EXPECT_NEAR(found.mean, exact.mean, 1e-9 * exact.mean);
  for (const auto quantile : {&ErrorSummary::p50, &ErrorSummary::p99}) {
    EXPECT_GE(found.*quantile, exact.*quantile);
    EXPECT_LE(found.*quantile, 1.0101 * exact.*quantile);
  }
}

TEST(ErrorHistogram, TellsNoErrorAboveTheGreatest) {
  ErrorHistogram histogram;
  for (int i = 0; i < 3; ++i) histogram.add(0);
  EXPECT_EQ(histogram.summary().p99, 0);
  for (int i = 0; i < 300; ++i) histogram.add(0.0010000001);
  EXPECT_EQ(histogram.summary().p50, 0.0010000001);
  histogram.add(1e9);
  EXPECT_EQ(histogram.summary().max, 1e9);
}

}  // namespace
}  // namespace robots::test
