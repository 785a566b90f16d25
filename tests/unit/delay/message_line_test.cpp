#include <gtest/gtest.h>
#include <suture/lane/delay/message_line.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace suture {
namespace {

using namespace std::chrono_literals;

struct MessageLineTest : testing::Test {
  static void put(MessageLine& line, std::uint64_t value, Time due = now()) {
    std::byte* memory = line.claim(due, sizeof(value));
    ASSERT_NE(memory, nullptr);
    std::memcpy(memory, &value, sizeof(value));
    line.commit();
  }
  static void mark(MessageLine& line, std::uint64_t sequence) {
    ASSERT_NE(line.claimMark(now(), 0, sequence), nullptr);
    line.commit();
  }
  static std::vector<std::uint64_t> take(MessageLine& line, Time at) {
    std::vector<std::uint64_t> values;
    for (; const std::byte* memory = line.due(at); line.pop()) {
      if (line.isMark()) continue;
      EXPECT_EQ(line.size(), sizeof(std::uint64_t));
      std::memcpy(&values.emplace_back(), memory, sizeof(std::uint64_t));
    }
    return values;
  }
  static void putMany(MessageLine& line, std::uint64_t count) {
    for (std::uint64_t value = 1; value <= count; ++value) put(line, value);
  }

  DeliveryCounters counters;
};

using Values = std::vector<std::uint64_t>;

TEST_F(MessageLineTest, AllComeInOrderWithoutFaults) {
  MessageLine line(8, 64, {}, 0, counters);
  putMany(line, 3);
  EXPECT_EQ(take(line, now()), (Values{1, 2, 3}));
  EXPECT_EQ(line.sent(), 3u);
  EXPECT_EQ(line.reached(), 3u);
}

TEST_F(MessageLineTest, ADuplicateIsTakenOnce) {
  MessageLine line(8, 64, {.duplicate = 1}, 0, counters);
  putMany(line, 10);
  EXPECT_EQ(take(line, now() + 1s), (Values{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(counters.duplicated, 10u);
}

TEST_F(MessageLineTest, OvertakingKeepsTheOutputInOrder) {
  MessageLine line(8, 512, {.seed = 1, .reorder = 0.3, .holdBack = 1ms, .jitter = 3ms}, 0,
                   counters);
  putMany(line, 200);
  const Values taken = take(line, now() + 1s);
  EXPECT_TRUE(std::is_sorted(taken.begin(), taken.end()));
  EXPECT_GT(counters.overtaken, 0u);
  EXPECT_EQ(taken.size() + counters.lost, taken.back());
}

TEST_F(MessageLineTest, ADuplicateDoesNotOvertake) {
  MessageLine line(8, 512, {.seed = 1, .duplicate = 0.5, .delay = 0.2}, 0, counters);
  putMany(line, 200);
  EXPECT_EQ(take(line, now() + 10s).size(), 200u);
  EXPECT_EQ(counters.lost, 0u);
  EXPECT_EQ(counters.overtaken, 0u);
}

TEST_F(MessageLineTest, AMarkCountsLostMessagesAsReached) {
  MessageLine line(8, 64, {.loss = 1}, 0, counters);
  putMany(line, 5);
  EXPECT_EQ(take(line, now()), Values{});
  EXPECT_EQ(line.reached(), 0u);

  FaultPlan lastIsLost{.seed = 0, .loss = 0.5};
  MessageLine other(8, 64, lastIsLost, 0, counters);
  putMany(other, 20);
  (void)take(other, now());
  for (int i = 0; i < 20; ++i) mark(other, 20);  // marks may be lost as well
  EXPECT_EQ(take(other, now()), Values{});
  EXPECT_EQ(other.reached(), 20u);
}

TEST_F(MessageLineTest, AStallHoldsAllUntilItsEnd) {
  MessageLine line(8, 64, {.stall = 1, .stallLength = 1h}, 0, counters);
  putMany(line, 2);
  EXPECT_EQ(take(line, now() + 59min), Values{});
  EXPECT_GT(line.next(), now() + 59min);
  EXPECT_EQ(take(line, now() + 2h), (Values{1, 2}));
}

TEST_F(MessageLineTest, DuplicatesCountAgainstItsBound) {
  MessageLine line(8, 16, {.duplicate = 1}, 0, counters);
  std::uint64_t put = 0;
  while (put < 1000 && line.hasRoom()) MessageLineTest::put(line, ++put);
  EXPECT_LT(put, 16u);
  EXPECT_EQ(line.claim(now(), 8), nullptr);
  EXPECT_EQ(line.sent(), put);
}

}  // namespace
}  // namespace suture
