// What a full queue of events keeps, and what it drops.
#include <gtest/gtest.h>
#include <suture/rt/queue/event_queue.h>

#include <array>
#include <cstring>
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
  /// All values of the latched event that are there to be heard.
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

TEST_P(FullEventQueue, KeepsTheLastValueOfALatchedEvent) {
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
TEST_P(FullEventQueue, LetsNoLaterValueGoAheadOfTheOneThatItKeeps) {
  EXPECT_TRUE(push(kLatched, 1));
  ASSERT_NE(queue.next(), nullptr);
  queue.pop();
  EXPECT_TRUE(push(kLatched, 2));
  EXPECT_EQ(heard(), Values{2});
  EXPECT_TRUE(push(kLatched, 3));
  EXPECT_TRUE(push(kLatched, 4));
  EXPECT_EQ(heard(), (Values{3, 4}));
}

INSTANTIATE_TEST_SUITE_P(Producers, FullEventQueue, testing::Values(Producers::One, Producers::Any),
                         [](const auto& one) {
                           return one.param == Producers::One ? "One" : "Any";
                         });

}  // namespace
}  // namespace suture::rt
