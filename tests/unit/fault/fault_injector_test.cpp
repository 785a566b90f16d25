#include <gtest/gtest.h>
#include <suture/lane/fault/fault_injector.h>

#include <vector>

namespace suture {
namespace {

using namespace std::chrono_literals;

FaultPlan everything(std::uint64_t seed) {
  return {.seed = seed,
          .loss = 0.1,
          .burst = 0.02,
          .duplicate = 0.1,
          .reorder = 0.1,
          .delay = 0.1,
          .jitter = 5ms,
          .stall = 0.1,
          .counts = std::make_shared<FaultCounts>()};
}

std::vector<std::vector<std::int64_t>> fates(const FaultPlan& plan, std::uint64_t stream) {
  FaultInjector injector(plan, stream);
  std::vector<std::vector<std::int64_t>> all;
  for (int i = 0; i < 1000; ++i) {
    const Fate fate = injector.next();
    all.push_back({fate.lost, fate.overtakable, fate.duplicated, fate.later.count(),
                   fate.duplicateLater.count(), fate.stall.count()});
  }
  return all;
}

int lostOf(const FaultPlan& plan) {
  FaultInjector injector(plan, 0);
  int lost = 0;
  for (int i = 0; i < 10'000; ++i) lost += injector.next().lost ? 1 : 0;
  return lost;
}

TEST(FaultInjector, TheSeedAndTheStreamDecide) {
  EXPECT_EQ(fates(everything(1), 0), fates(everything(1), 0));
  EXPECT_NE(fates(everything(1), 0), fates(everything(2), 0));
  EXPECT_NE(fates(everything(1), 0), fates(everything(1), 1));
}

TEST(FaultInjector, CountsWhatItDoes) {
  const FaultPlan plan = everything(3);
  const auto all = fates(plan, 0);
  std::uint64_t lost = 0, duplicated = 0;
  for (const auto& fate : all) {
    lost += static_cast<std::uint64_t>(fate[0]);
    duplicated += static_cast<std::uint64_t>(fate[2]);
  }
  EXPECT_EQ(plan.counts->lost + plan.counts->burstLost, lost);
  EXPECT_EQ(plan.counts->duplicated, duplicated);
  for (const auto* one : {&plan.counts->lost, &plan.counts->burstLost, &plan.counts->reordered,
                          &plan.counts->delayed, &plan.counts->jittered, &plan.counts->stalls}) {
    EXPECT_GT(*one, 0u);
  }
}

TEST(FaultInjector, LosesAsOftenAsIsAsked) {
  EXPECT_NEAR(lostOf({.seed = 5, .loss = 0.1}), 1000, 150);
  EXPECT_EQ(lostOf({.seed = 5, .loss = 1}), 10'000);
  EXPECT_EQ(lostOf({.seed = 5}), 0);
}

TEST(FaultInjector, ALateOneMayBeLateAgain) {
  const auto lateOf = [](double again) {
    FaultInjector injector({.seed = 5, .delay = 0.1, .delayLength = 1ms, .delayAgain = again}, 0);
    std::vector<int> counts(10);
    for (int i = 0; i < 100'000; ++i)
      ++counts[static_cast<std::size_t>(injector.next().later / 1ms)];
    return counts;
  };
  const auto once = lateOf(0), again = lateOf(0.1);
  EXPECT_EQ(once[1], again[1] + again[2] + again[3] + again[4] + again[5] + again[6]);
  EXPECT_EQ(once[2], 0);
  EXPECT_NEAR(again[1], 9000, 300);
  EXPECT_NEAR(again[2], 900, 100);
  EXPECT_NEAR(again[3], 90, 30);
}

TEST(FaultInjector, JitterLetsNoneOvertakeOnAStream) {
  FaultInjector datagrams({.seed = 9, .jitter = 5ms}, 0);
  FaultInjector stream({.seed = 9, .jitter = 5ms, .ordered = true}, 0);
  for (int i = 0; i < 100; ++i) {
    const Fate free = datagrams.next(), kept = stream.next();
    EXPECT_TRUE(free.overtakable);
    EXPECT_FALSE(kept.overtakable);
    EXPECT_EQ(free.later, kept.later);
  }
}

TEST(FaultInjector, ABurstIsAsLongAsAsked) {
  FaultInjector injector({.seed = 7, .burst = 0.01, .burstLength = 5}, 0);
  int run = 0, bursts = 0;
  for (int i = 0; i < 10'000; ++i) {
    if (injector.next().lost) {
      ++run;
    } else if (run > 0) {
      EXPECT_EQ(run % 5, 0);
      ++bursts;
      run = 0;
    }
  }
  EXPECT_GT(bursts, 0);
}

}  // namespace
}  // namespace suture
