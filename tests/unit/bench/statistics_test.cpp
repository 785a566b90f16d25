#include "bench/figures/statistics.h"

#include <gtest/gtest.h>

#include <numeric>

#include "bench/figures/table.h"

namespace bench {
namespace {

TEST(Statistics, AThousandNumbersAreExact) {
  std::vector<double> samples(1000);
  std::iota(samples.rbegin(), samples.rend(), 1.0);
  const Statistics statistics = statisticsOf(samples);
  EXPECT_EQ(statistics.count, 1000u);
  EXPECT_DOUBLE_EQ(statistics.mean, 500.5);
  EXPECT_NEAR(statistics.std, 288.8194, 1e-4);  // sqrt(n (n + 1) / 12)
  EXPECT_EQ(statistics.min, 1);
  EXPECT_EQ(statistics.p50, 500);
  EXPECT_EQ(statistics.p99, 990);
  EXPECT_EQ(statistics.p999, 999);
  EXPECT_EQ(statistics.max, 1000);
}

TEST(Statistics, OneNumberOrNoneIsFine) {
  const Statistics one = statisticsOf({7});
  EXPECT_EQ(one.p50, 7);
  EXPECT_EQ(one.p999, 7);
  EXPECT_EQ(one.std, 0);
  EXPECT_EQ(statisticsOf({}).count, 0u);
}

TEST(Statistics, UnitsOfSamples) {
  EXPECT_EQ(inUnits({1500, 3000}, kMicrosecond), (std::vector<double>{1.5, 3}));
}

TEST(Table, WordsStandLeftAndNumbersRight) {
  Table table(1);
  table.row({"loop", "mean"});
  table.line();
  table.row({"SCS", "12345"});
  table.row({"CSC, client", "7"});
  EXPECT_EQ(table.toString(),
            "loop          mean\n"
            "------------------\n"
            "SCS          12345\n"
            "CSC, client      7\n");
}

}  // namespace
}  // namespace bench
