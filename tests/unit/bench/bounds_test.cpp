// --check must be able to fail.

#include "bench/figures/bounds.h"

#include <gtest/gtest.h>

namespace bench {
namespace {

Report reportOf(double median) {
  Report report;
  Statistics statistics;
  statistics.p50 = median;
  report.add("event.csc", "us", statistics);
  report.add("rate", "1/s", 100.0);
  report.addUnavailable("fifo.scs", "not granted");
  return report;
}

std::vector<std::string> check(const char* bounds, double median = 30) {
  return shortfalls(parseBounds(bounds), "table2", reportOf(median));
}

TEST(Bounds, FiguresWithinTheirBoundsAreSilent) {
  EXPECT_TRUE(check("table2.event.csc.p50 <= 35 us | CSC <= 35 us").empty());
  EXPECT_TRUE(check("table2.event.csc.p50 <= 30 us | exactly at the bound").empty());
  EXPECT_TRUE(check("table2.rate >= 100 1/s | at least").empty());
}

TEST(Bounds, APlantedBoundFails) {
  const auto lines = check("# planted\n\ntable2.event.csc.p50 <= 29.9 us | CSC must be faster\n");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0], "event.csc.p50: 30.0 us, must be <= 29.9 us (CSC must be faster)");
  EXPECT_EQ(check("table2.rate >= 101 1/s | at least").size(), 1u);
}

TEST(Bounds, ABoundWithoutAValueFallsShort) {
  ASSERT_EQ(check("table2.event.scs.p50 <= 45 us | SCS").size(), 1u);
  EXPECT_NE(check("table2.event.scs.p50 <= 45 us | SCS")[0].find("not measured"),
            std::string::npos);
  const auto lines = check("table2.fifo.scs.p50 <= 45 us | FIFO");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("not available: not granted"), std::string::npos);
}

TEST(Bounds, AnotherUnitIsNotCompared) {
  const auto lines = check("table2.event.csc.p50 <= 35 ms | CSC");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("measured in us, bounded in ms"), std::string::npos);
}

TEST(Bounds, ThoseOfOtherSubcommandsDoNotCount) {
  EXPECT_TRUE(check("throughput.event.csc.p50 <= 1 us | another subcommand").empty());
}

TEST(Bounds, ABrokenLineIsAnError) {
  EXPECT_THROW(parseBounds("table2.event.csc.p50 < 35 us | CSC"), std::runtime_error);
  EXPECT_THROW(parseBounds("table2.event.csc.p50 <= 35 us"), std::runtime_error);
  EXPECT_THROW(parseBounds("table2.event.csc.p50 <= 35 | CSC"), std::runtime_error);
  EXPECT_THROW(parseBounds("table2.event.csc.p50 <= 35 us |"), std::runtime_error);
  EXPECT_THROW(parseBounds("table2.event.csc.p50 <= 35 us 36 | CSC"), std::runtime_error);
}

TEST(Bounds, ThoseOfTheProjectCanBeRead) {
  const auto bounds = parseBounds(boundsText());
  EXPECT_FALSE(bounds.empty());
  for (const Bound& bound : bounds)
    EXPECT_GE(bound.limit, 0) << bound.figure;  // 0: a count that must stay 0
}

}  // namespace
}  // namespace bench
