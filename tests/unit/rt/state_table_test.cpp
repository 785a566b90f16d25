#include <gtest/gtest.h>
#include <suture/rt/state_table.h>

#include <array>
#include <cstring>
#include <thread>

namespace suture::rt {
namespace {

constexpr std::uint32_t kSizes[] = {120, 4, 0};

TEST(StateTable, SaysNotYetUntilAColumnHasBeenProduced) {
  StateTable table(kSizes);
  std::array<std::byte, 120> slot;
  EXPECT_EQ(table.read(0, slot.data()).error(), Errc::NotYet);
  table.publish(now(), 0b010, 0);
  EXPECT_EQ(table.read(0, slot.data()).error(), Errc::NotYet);
  EXPECT_TRUE(table.read(1, slot.data()));
}

TEST(StateTable, TellsThatAValueDidNotFit) {
  StateTable table(kSizes);
  table.publish(now(), 0b010, 0b001);
  std::array<std::byte, 120> slot;
  EXPECT_EQ(table.read(0, slot.data()).error(), Errc::TooLarge);
}

TEST(StateTable, AskingIsTrueOnceAndStays) {
  StateTable table(kSizes);
  EXPECT_TRUE(table.ask(1));
  EXPECT_FALSE(table.ask(1));
  EXPECT_EQ(table.demand(), 0b010u);
}

TEST(StateTable, AValueWhoseSizeIsNoMultipleOfAWordKeepsItsNeighbours) {
  StateTable table(kSizes);
  const std::uint32_t value = 0xdeadbeef;
  std::memcpy(table.draft(1), &value, sizeof(value));
  const Time stamp = now();
  table.publish(stamp, 0b010, 0);
  std::array<std::uint32_t, 3> around{1, 2, 3};
  const auto read = table.read(1, reinterpret_cast<std::byte*>(&around[1]));
  EXPECT_EQ(around, (std::array<std::uint32_t, 3>{1, value, 3}));
  EXPECT_EQ(*read, stamp);
}

// One writer, two readers: no value is torn, none goes backwards, and two columns of one row belong
// together.
TEST(StateTable, NeverTornUnderAFastWriter) {
  constexpr std::uint64_t kRows = 300'000;
  constexpr std::uint32_t kColumns[] = {128, 8};
  StateTable table(kColumns, 16);
  std::thread writer([&table] {
    for (std::uint64_t i = 1; i <= kRows; ++i) {
      for (int word = 0; word < 16; ++word) std::memcpy(table.draft(0) + 8 * word, &i, 8);
      std::memcpy(table.draft(1), &i, 8);
      table.publish(fromNanoseconds(static_cast<std::int64_t>(i)), 0b11, 0);
    }
  });
  const auto reader = [&table] {
    std::array<std::uint64_t, 16> wide{};
    std::uint64_t narrow = 0, last = 0;
    const std::array<std::byte*, 2> slots{reinterpret_cast<std::byte*>(wide.data()),
                                          reinterpret_cast<std::byte*>(&narrow)};
    while (last < kRows) {
      const StateTable::Row row = table.readRow(slots);
      if (row.sequence == 0) continue;
      for (const std::uint64_t word : wide) ASSERT_EQ(word, row.sequence);
      ASSERT_EQ(narrow, row.sequence);
      ASSERT_EQ(toNanoseconds(row.stamp), static_cast<std::int64_t>(row.sequence));
      ASSERT_GE(row.sequence, last);
      last = row.sequence;
    }
  };
  std::thread second(reader);
  reader();
  second.join();
  writer.join();
}

}  // namespace
}  // namespace suture::rt
