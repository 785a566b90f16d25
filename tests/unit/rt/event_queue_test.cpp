// These tests say what a full queue of events keeps, and what it drops.
#include <gtest/gtest.h>
#include <suture/rt/queue/event_queue.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace suture::rt {
namespace {

constexpr std::uint16_t kQueued = 0, kLatched = 1;
constexpr std::array<EventLimits, 2> kEvents = {
    {{.payloadSize = 8, .depth = 2, .latest = false},
     {.payloadSize = 8, .depth = 1, .latest = false, .latched = true}}};

class FullEventQueue : public testing::TestWithParam<Producers> {
 protected:
  FullEventQueue() {
    while (push(kQueued, 0)) continue;
    dropped_ = queue.dropped();
  }
  bool push(std::uint16_t event, std::uint64_t value) {
    return queue.push(event, now(), std::as_bytes(std::span(&value, 1)));
  }
  /// Returns all values of the latched event that are there to be heard.
  std::vector<std::uint64_t> heard() {
    std::vector<std::uint64_t> values;
    while (const EventRecord* const record = queue.next()) {
      std::uint64_t value;
      std::memcpy(&value, record->payload(), sizeof(value));
      if (record->event == kLatched) values.push_back(value);
      queue.pop();
    }
    return values;
  }
  std::uint64_t dropped() const { return queue.dropped() - dropped_; }

  EventQueue queue{kEvents, GetParam()};

 private:
  std::uint64_t dropped_ = 0;
};

using Values = std::vector<std::uint64_t>;

TEST_P(FullEventQueue, KeepsTheLatchedValue) {
  EXPECT_TRUE(push(kLatched, 1));
  EXPECT_FALSE(push(kQueued, 1));
  EXPECT_TRUE(push(kLatched, 2));
  EXPECT_TRUE(push(kLatched, 3));
  EXPECT_EQ(dropped(), 3u) << "the queued event, and the values 1 and 2";
  EXPECT_TRUE(queue.pending());
  EXPECT_EQ(heard(), Values{3});
  EXPECT_FALSE(queue.pending());
}

// There is room in the ring again, but what was kept is older.
TEST_P(FullEventQueue, KeepsTheOrderOfItsValues) {
  EXPECT_TRUE(push(kLatched, 1));
  ASSERT_NE(queue.next(), nullptr);
  queue.pop();
  EXPECT_TRUE(push(kLatched, 2));
  EXPECT_EQ(heard(), Values{2});
  EXPECT_TRUE(push(kLatched, 3));
  EXPECT_TRUE(push(kLatched, 4));
  EXPECT_EQ(heard(), (Values{3, 4}));
}

TEST_P(FullEventQueue, KeepsWhatWaitedFromANewSubscriber) {
  EXPECT_TRUE(push(kLatched, 1));
  queue.beginAnew(kLatched);
  EXPECT_EQ(heard(), Values{}) << "what was kept beside the queue";
  EXPECT_TRUE(push(kLatched, 2));
  queue.beginAnew(kLatched);
  EXPECT_TRUE(push(kLatched, 3));
  ASSERT_NE(queue.next(), nullptr);
  EXPECT_TRUE(queue.fromBefore());
  queue.pop();
  ASSERT_NE(queue.next(), nullptr);
  EXPECT_FALSE(queue.fromBefore());
  queue.pop();
}

TEST_P(FullEventQueue, LeavesAValueWhileItIsHandled) {
  while (queue.next() != nullptr) queue.pop();
  while (push(kQueued, 0)) continue;
  EXPECT_TRUE(push(kLatched, 1));
  const EventRecord* record = queue.next();
  while (record->event != kLatched) queue.pop(), record = queue.next();
  while (push(kQueued, 0)) continue;
  EXPECT_TRUE(push(kLatched, 2));
  queue.beginAnew(kLatched);
  std::uint64_t value;
  std::memcpy(&value, record->payload(), sizeof(value));
  EXPECT_EQ(value, 1u);
  queue.pop();
  EXPECT_EQ(heard(), Values{2});
}

INSTANTIATE_TEST_SUITE_P(Producers, FullEventQueue, testing::Values(Producers::One, Producers::Any),
                         [](const auto& one) {
                           return one.param == Producers::One ? "One" : "Any";
                         });

constexpr std::uint16_t kSmallOne = 0, kLargeOne = 1;
constexpr std::uint32_t kLargeSize = 1u << 20;
constexpr std::array<EventLimits, 2> kWithLarge = {
    {{.payloadSize = 8, .depth = 60, .latest = false},
     {.payloadSize = kLargeSize, .depth = 2, .latest = false}}};

class LargeEvents : public testing::TestWithParam<Producers> {
 protected:
  bool push(std::uint16_t event, std::uint8_t value) {
    const std::vector<std::byte> payload(kWithLarge[event].payloadSize, std::byte{value});
    return queue.push(event, now(), payload);
  }
  /// Returns the event that comes next, as its number and the value that all of it has; -1 if none
  /// comes.
  std::pair<std::uint16_t, int> next() {
    const EventRecord* const record = queue.next();
    if (record == nullptr) return {0, -1};
    const std::uint16_t event = record->event;
    const std::span payload(record->payload(), kWithLarge[event].payloadSize);
    const std::byte first = payload[0];
    const bool whole = std::ranges::all_of(payload, [&](std::byte one) { return one == first; });
    queue.pop();
    return {event, whole ? std::to_integer<int>(first) : -2};
  }

  EventQueue queue{kWithLarge, GetParam()};
};

using Heard = std::pair<std::uint16_t, int>;

TEST_P(LargeEvents, ComeInTheOrderOfAll) {
  for (std::uint8_t lap = 0; lap < 20; ++lap) {
    EXPECT_TRUE(push(kSmallOne, lap));
    EXPECT_TRUE(push(kLargeOne, lap));
    EXPECT_TRUE(push(kSmallOne, 100));
    EXPECT_TRUE(push(kLargeOne, 101));
    EXPECT_EQ(next(), Heard(kSmallOne, lap));
    EXPECT_EQ(next(), Heard(kLargeOne, lap));
    EXPECT_EQ(next(), Heard(kSmallOne, 100));
    EXPECT_EQ(next(), Heard(kLargeOne, 101));
  }
  EXPECT_FALSE(queue.pending());
}

TEST_P(LargeEvents, AreDroppedBeyondTheirDepth) {
  EXPECT_TRUE(push(kLargeOne, 1));
  EXPECT_TRUE(push(kLargeOne, 2));
  EXPECT_FALSE(push(kLargeOne, 3));
  EXPECT_EQ(queue.dropped(), 1u);
  EXPECT_TRUE(push(kSmallOne, 4));
  EXPECT_EQ(next(), Heard(kLargeOne, 1));
  EXPECT_TRUE(push(kLargeOne, 5));
  EXPECT_EQ(next(), Heard(kLargeOne, 2));
  EXPECT_EQ(next(), Heard(kSmallOne, 4));
  EXPECT_EQ(next(), Heard(kLargeOne, 5));
}

// A cell that has found no place in the order is there for the next event.
TEST_P(LargeEvents, AreDroppedBehindManySmallOnes) {
  while (push(kSmallOne, 1)) continue;
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(push(kLargeOne, 2));
  while (next() != Heard(0, -1)) continue;
  EXPECT_TRUE(push(kLargeOne, 3));
  EXPECT_TRUE(push(kLargeOne, 4));
  EXPECT_EQ(next(), Heard(kLargeOne, 3));
}

TEST_P(LargeEvents, TakeNoMoreMemoryThanTheyDeclare) {
  Arena measured = Arena::measuring();
  const EventQueue asked(kWithLarge, GetParam(), measured);
  EXPECT_LT(measured.used(), 2 * kLargeSize + 16'384);
}

std::string nameOf(const testing::TestParamInfo<Producers>& producers) {
  return producers.param == Producers::One ? "One" : "Any";
}

INSTANTIATE_TEST_SUITE_P(Producers, LargeEvents, testing::Values(Producers::One, Producers::Any),
                         nameOf);

}  // namespace
}  // namespace suture::rt
