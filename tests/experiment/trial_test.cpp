// These say what the link of a trial does to a connection.

#include "experiment/trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

namespace experiment {
namespace {

using namespace std::chrono_literals;

TEST(Trial, EachWayTakesHalfTheRoundTrip) {
  const suture::ConnectionDelay delay =
      delayOf({.roundTrip = 300ms, .jitter = 0.1}, {.period = 1ms}, 1);
  EXPECT_EQ(delay.commands, 150ms);
  EXPECT_EQ(delay.answers, 150ms);
  EXPECT_EQ(delay.faults.jitter, 15ms);
  EXPECT_TRUE(delay.faults.ordered);
}

TEST(Trial, AStreamRepeatsAfterAcknowledgementsOrTimeout) {
  EXPECT_EQ(repetitionTime({.roundTrip = 300ms}, {.period = 1ms}), 303ms);
  EXPECT_EQ(repetitionTime({.roundTrip = 300ms}, {.period = 100ms}), 500ms);
}

TEST(Trial, ASharedStreamWaitsForLosses) {
  const Link link{.roundTrip = 300ms, .loss = 0.1};
  const suture::ConnectionDelay delay = delayOf(link, {.period = 1ms, .sharing = 2}, 1);
  EXPECT_NEAR(delay.faults.delay, 0.19, 1e-9);
  EXPECT_EQ(delay.faults.delayLength, 301'500us);  // another's packets acknowledge as well
  EXPECT_EQ(delay.faults.delayAgain, 0.1);
}

TEST(Trial, AnUnimpairedLinkIsNone) { EXPECT_FALSE(delayOf({}, {.period = 1ms}, 1).any()); }

TEST(Trial, TheGridsHaveWhatTheyPromise) {
  EXPECT_EQ(fullGrid().size(), 11u * 2 * 4 * 2 * 2);
  const auto quick = quickGrid();
  EXPECT_EQ(quick.size(), 6u * 4 * 2 * 2);
  for (const auto wanted : {0ms, 100ms, 200ms, 300ms, 400ms, 500ms}) {
    EXPECT_TRUE(std::any_of(quick.begin(), quick.end(),
                            [&](const Trial& one) { return one.link.roundTrip == wanted; }));
  }
}

}  // namespace
}  // namespace experiment
