#include <gtest/gtest.h>
#include <suture/session/clock_offset.h>

namespace suture {
namespace {

using namespace std::chrono_literals;

constexpr Time kAsked{1s};

/// A question that is `there` under way, answered in `answering`, and `back` under way again; the
/// peer's clock is an hour ahead.
void ask(ClockOffset& clock, Duration there, Duration answering, Duration back) {
  const Time received = kAsked + there + 1h, sent = received + answering;
  clock.add(kAsked, toNanoseconds(received), toNanoseconds(sent),
            kAsked + there + answering + back);
}

TEST(ClockOffset, IsKnownToHalfOfTheWay) {
  ClockOffset clock;
  ask(clock, 3ms, 5ms, 1ms);
  EXPECT_EQ(clock.offset(), 1h + 1ms);
  EXPECT_EQ(clock.error(kAsked + 9ms), 2ms);
}

TEST(ClockOffset, IsThatOfTheFastestQuestion) {
  ClockOffset clock;
  ask(clock, 3ms, 0ms, 1ms);
  ask(clock, 100us, 5ms, 100us);
  ask(clock, 9ms, 0ms, 1ms);
  EXPECT_EQ(clock.offset(), 1h);
  EXPECT_EQ(clock.error(kAsked + 5200us), 100us);
}

// The clocks drift apart by no more than 100 us in a second.
TEST(ClockOffset, IsKnownWorseAsTimeGoesBy) {
  ClockOffset clock;
  ask(clock, 100us, 0ms, 100us);
  const Time compared = kAsked + 200us;
  EXPECT_EQ(clock.error(compared), 100us);
  EXPECT_EQ(clock.error(compared + 10s), 1100us);
}

TEST(ClockOffset, ASlowAnswerBeatsAnOldOne) {
  ClockOffset clock;
  ask(clock, 100us, 0ms, 100us);
  const auto askAgain = [&](Time asked) {
    const Time received = asked + 500us + 1h + 300us;
    return clock.add(asked, toNanoseconds(received), toNanoseconds(received), asked + 1ms);
  };
  EXPECT_FALSE(askAgain(kAsked + 1s));
  EXPECT_EQ(clock.offset(), 1h);
  EXPECT_TRUE(askAgain(kAsked + 10s));
  EXPECT_EQ(clock.offset(), 1h + 300us);
  EXPECT_EQ(clock.error(kAsked + 10s + 1ms), 500us);
}

// This happens when a machine was held up, or its clock is slewed faster than quartz drifts.
TEST(ClockOffset, AContradictedOneIsGivenUp) {
  ClockOffset clock;
  ask(clock, 100us, 0ms, 100us);
  const Time asked = kAsked + 1s, received = asked + 500us + 1h + 5ms;
  EXPECT_TRUE(clock.add(asked, toNanoseconds(received), toNanoseconds(received), asked + 1ms));
  EXPECT_EQ(clock.offset(), 1h + 5ms);
}

TEST(ClockOffset, IsNoneWhereBothHaveOneClock) {
  EXPECT_TRUE(ClockOffset::none().isOne());
  EXPECT_EQ(ClockOffset::none().error(kAsked + 1h), 0ns);
  ClockOffset clock;
  ask(clock, 0ms, 0ms, 0ms);
  EXPECT_FALSE(clock.isOne());
}

// It says that it took longer to answer than the whole question did, or less than no time.
TEST(ClockOffset, APeerCannotImproveIt) {
  for (const Duration lie : {Duration(1h), Duration(-1h)}) {
    ClockOffset clock;
    const Time received = kAsked + 1h;
    clock.add(kAsked, toNanoseconds(received), toNanoseconds(received + lie), kAsked + 4ms);
    EXPECT_EQ(clock.error(kAsked + 4ms), 2ms);
  }
}

}  // namespace
}  // namespace suture
