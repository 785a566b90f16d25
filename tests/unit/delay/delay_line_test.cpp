#include <gtest/gtest.h>
#include <suture/lane/delay/delay_line.h>

#include <cstring>

namespace suture {
namespace {

using namespace std::chrono_literals;

Time at(Duration since) { return Time{} + 1h + since; }

bool put(DelayLine& line, Time due, std::uint64_t value) {
  std::byte* memory = line.claim(due, sizeof(value));
  if (memory == nullptr) return false;
  std::memcpy(memory, &value, sizeof(value));
  line.commit();
  return true;
}

std::uint64_t take(DelayLine& line, Time now) {
  const std::byte* memory = line.due(now);
  if (memory == nullptr) return 0;
  EXPECT_EQ(line.size(), sizeof(std::uint64_t));
  std::uint64_t value = 0;
  std::memcpy(&value, memory, sizeof(value));
  line.pop();
  return value;
}

TEST(DelayLine, KeepsEachUntilItIsDue) {
  DelayLine line(8, 8);
  EXPECT_EQ(line.next(), Time::max());
  ASSERT_TRUE(put(line, at(1ms), 1));
  ASSERT_TRUE(put(line, at(2ms), 2));
  EXPECT_EQ(line.next(), at(1ms));
  EXPECT_EQ(take(line, at(999us)), 0u);
  EXPECT_EQ(take(line, at(1ms)), 1u);
  EXPECT_EQ(take(line, at(1ms)), 0u);
  EXPECT_EQ(take(line, at(3ms)), 2u);
  EXPECT_EQ(line.next(), Time::max());
}

TEST(DelayLine, MessagesStayInOrder) {
  DelayLine line(8, 8);
  ASSERT_TRUE(put(line, at(2ms), 1));
  ASSERT_TRUE(put(line, at(1ms), 2));
  EXPECT_EQ(take(line, at(1ms)), 0u);
  EXPECT_EQ(take(line, at(2ms)), 1u);
  EXPECT_EQ(take(line, at(2ms)), 2u);
}

TEST(DelayLine, OvertakableMessagesAreOvertaken) {
  DelayLine line(8, 8);
  const std::uint64_t one = 1;
  std::memcpy(line.claim(at(3ms), sizeof(one), DelayLine::Order::Overtakable), &one, sizeof(one));
  line.commit();
  ASSERT_TRUE(put(line, at(1ms), 2));
  EXPECT_EQ(take(line, at(1ms)), 2u);
  EXPECT_EQ(take(line, at(2ms)), 0u);
  EXPECT_EQ(take(line, at(3ms)), 1u);
}

TEST(DelayLine, HoldsABoundedNumberOfRecords) {
  DelayLine line(8, 4);
  std::uint64_t taken = 0;
  while (taken < 1000 && put(line, at(1ms), taken + 1)) ++taken;
  EXPECT_GE(taken, 4u);
  EXPECT_LT(taken, 1000u);
  EXPECT_EQ(take(line, at(1ms)), 1u);
  EXPECT_TRUE(put(line, at(1ms), 7));
}

}  // namespace
}  // namespace suture
