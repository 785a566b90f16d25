#include <gtest/gtest.h>
#include <suture/rt/doorbell.h>
#include <suture/rt/histogram.h>
#include <suture/rt/period.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <thread>

#include "support/patience.h"

namespace suture::rt {
namespace {

using namespace std::chrono_literals;

TEST(Doorbell, AnEarlyRingIsNotLost) {
  Doorbell bell;
  bell.ring();
  EXPECT_EQ(bell.waitUntil(now() + kPatience), RungFor::Work);
  EXPECT_EQ(bell.waitUntil(now() + 1ms), RungFor::Nothing);
}

TEST(Doorbell, TellsArrivalsFromWork) {
  Doorbell bell;
  bell.ring(RungFor::Arrival);
  bell.ring(RungFor::Arrival);
  EXPECT_EQ(bell.takeRing(), RungFor::Arrival);
  bell.ring(RungFor::Work);
  bell.ring(RungFor::Arrival);
  EXPECT_EQ(bell.takeRing(), RungFor::Work);
  ASSERT_TRUE(bell.prepareToSleep());
  bell.ring(RungFor::Arrival);
  bell.ring(RungFor::Work);
  EXPECT_EQ(bell.waitUntil(now() + kPatience), RungFor::Work);
  EXPECT_EQ(bell.takeRing(), RungFor::Nothing);
}

TEST(Doorbell, WakesASleeper) {
  Doorbell bell;
  std::thread ringer([&bell] {
    for (int i = 0; i < 1000; ++i) bell.ring();
  });
  EXPECT_EQ(bell.waitUntil(now() + kPatience), RungFor::Work);
  ringer.join();
}

TEST(Doorbell, WritesItsDescriptorOnlyForASleeper) {
  const int descriptor = eventfd(0, EFD_NONBLOCK);
  Doorbell bell(descriptor);
  std::uint64_t count = 0;
  bell.ring();
  EXPECT_EQ(read(descriptor, &count, sizeof(count)), -1);
  EXPECT_FALSE(bell.prepareToSleep());
  EXPECT_EQ(bell.takeRing(), RungFor::Work);
  EXPECT_EQ(bell.takeRing(), RungFor::Nothing);
  ASSERT_TRUE(bell.prepareToSleep());
  bell.ring();
  bell.ring();
  EXPECT_EQ(read(descriptor, &count, sizeof(count)), 8);
  EXPECT_EQ(count, 1u);
  bell.endSleep();
  EXPECT_EQ(bell.takeRing(), RungFor::Work) << "what was rung for during sleep is still to be done";

  ASSERT_TRUE(bell.prepareToSleep());
  bell.endSleep();
  bell.ring();
  EXPECT_EQ(read(descriptor, &count, sizeof(count)), -1);
  close(descriptor);
}

TEST(Histogram, QuantilesAreWithinABucket) {
  Histogram histogram;
  for (int i = 1; i <= 1000; ++i) histogram.record(Duration(i * 1000));
  EXPECT_EQ(histogram.count(), 1000u);
  EXPECT_EQ(histogram.max(), Duration(1'000'000));
  EXPECT_NEAR(static_cast<double>(histogram.quantile(0.5).count()), 500'000, 35'000);
  EXPECT_NEAR(static_cast<double>(histogram.quantile(0.99).count()), 990'000, 65'000);
  EXPECT_EQ(histogram.quantile(1.0), histogram.max());
}

TEST(Histogram, SharesAreWithinABucket) {
  Histogram histogram;
  EXPECT_EQ(histogram.shareUpTo(1s), 0);
  for (int i = 1; i <= 1000; ++i) histogram.record(Duration(i * 1000));
  EXPECT_EQ(histogram.shareUpTo(900ns), 0);
  EXPECT_NEAR(histogram.shareUpTo(500us), 0.5, 0.04);
  EXPECT_EQ(histogram.shareUpTo(1ms), 1);
}

TEST(Histogram, AFullBucketKeepsTheShares) {
  Histogram histogram(1000);
  for (int i = 0; i < 40'000; ++i) histogram.record(i % 4 == 0 ? Duration(1ms) : Duration(1us));
  EXPECT_EQ(histogram.count(), 40'000u);
  EXPECT_NEAR(histogram.shareUpTo(10us), 0.75, 0.002);
  EXPECT_LT(histogram.quantile(0.7), 2us);
  EXPECT_EQ(histogram.quantile(0.8), 1ms);
}

TEST(Histogram, TakesTimesBeyondItsRange) {
  Histogram histogram;
  histogram.record(Duration(-5));
  EXPECT_EQ(histogram.quantile(0.5), Duration(0));
  histogram.record(std::chrono::hours(1));
  EXPECT_EQ(histogram.max(), std::chrono::hours(1));
}

TEST(Period, SkipsAndCountsWhatWasMissed) {
  Period period(10ms);
  const Time start = now();
  period.begin(start);
  EXPECT_EQ(period.advance(start), start + 10ms);
  EXPECT_EQ(period.advance(start + 12ms), start + 20ms);
  // The cycle took 35 ms: the periods due at 30, 40 and 50 ms have passed.
  EXPECT_EQ(period.advance(start + 55ms), start + 60ms);
  EXPECT_EQ(period.skipped(), 3u);
}

// executed + skipped = elapsed / period holds within one, whatever the cycles cost.
TEST(Period, AccountsForEveryPeriod) {
  Period period(1ms);
  const Time start = now();
  period.begin(start);
  Time time = start;
  std::uint64_t executed = 0;
  for (int i = 0; i < 10'000; ++i) {
    time = period.advance(time) + (i % 7) * 450us;
    ++executed;
  }
  const auto elapsed = static_cast<std::uint64_t>((time - start) / 1ms);
  EXPECT_NEAR(static_cast<double>(executed + period.skipped()), static_cast<double>(elapsed), 1);
}

}  // namespace
}  // namespace suture::rt
