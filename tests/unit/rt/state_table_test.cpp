#include <gtest/gtest.h>
#include <suture/rt/state/state_table.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <thread>
#include <vector>

namespace suture::rt {
namespace {

constexpr std::uint32_t kSizes[] = {120, 4, 0};

TEST(StateTable, SaysNotYetBeforeTheFirstValue) {
  StateTable table(kSizes);
  std::array<std::byte, 120> slot;
  EXPECT_EQ(table.read(0, slot.data()).error(), Errc::NotYet);
  table.publish(now(), {.valid = 0b010});
  EXPECT_EQ(table.read(0, slot.data()).error(), Errc::NotYet);
  EXPECT_TRUE(table.read(1, slot.data()));
}

TEST(StateTable, TellsThatAValueDidNotFit) {
  StateTable table(kSizes);
  table.publish(now(), {.valid = 0b010, .tooLarge = 0b001});
  std::array<std::byte, 120> slot;
  EXPECT_EQ(table.read(0, slot.data()).error(), Errc::TooLarge);
}

TEST(StateTable, AskingIsTrueOnceAndStays) {
  StateTable table(kSizes);
  EXPECT_TRUE(table.ask(1));
  EXPECT_FALSE(table.ask(1));
  EXPECT_EQ(table.demand(), 0b010u);
}

TEST(StateTable, SeveralColumnsAreAskedForTogether) {
  StateTable table(kSizes);
  EXPECT_TRUE(table.ask(1));
  EXPECT_TRUE(table.askAll(0b011));
  EXPECT_FALSE(table.askAll(0b011));
  EXPECT_FALSE(table.askAll(0));
  EXPECT_EQ(table.demand(), 0b011u);
}

TEST(StateTable, OddSizesLeaveTheirNeighbours) {
  StateTable table(kSizes);
  const std::uint32_t value = 0xdeadbeef;
  std::memcpy(table.draft(1), &value, sizeof(value));
  const Time stamp = now();
  table.publish(stamp, {.valid = 0b010});
  std::array<std::uint32_t, 3> around{1, 2, 3};
  const auto read = table.read(1, reinterpret_cast<std::byte*>(&around[1]));
  EXPECT_EQ(around, (std::array<std::uint32_t, 3>{1, value, 3}));
  EXPECT_EQ(*read, stamp);
}

/// Publishes `value` in column 1 at `value` ns.
void publish(StateTable& table, std::uint32_t value) {
  std::memcpy(table.draft(1), &value, sizeof(value));
  table.publish(fromNanoseconds(value), {.valid = 0b010});
}

Result<std::uint32_t> valueAt(const StateTable& table, std::int64_t nanoseconds) {
  std::uint32_t value = 0;
  const auto read =
      table.readAt(fromNanoseconds(nanoseconds), 1, reinterpret_cast<std::byte*>(&value));
  if (!read) return tl::unexpected(read.error());
  EXPECT_EQ(toNanoseconds(*read), static_cast<std::int64_t>(value));
  return value;
}

TEST(StateTable, FindsTheRowBefore) {
  StateTable table(kSizes, 8);
  for (std::uint32_t stamp = 10; stamp <= 50; stamp += 10) publish(table, stamp);
  EXPECT_EQ(valueAt(table, 10).value(), 10u);
  EXPECT_EQ(valueAt(table, 19).value(), 10u);
  EXPECT_EQ(valueAt(table, 20).value(), 20u);
  EXPECT_EQ(valueAt(table, 49).value(), 40u);
  EXPECT_EQ(valueAt(table, 1000).value(), 50u);
}

TEST(StateTable, TellsNotYetFromNoMore) {
  StateTable table(kSizes, 4);
  EXPECT_EQ(valueAt(table, 5).error(), Errc::NotYet);
  for (std::uint32_t stamp = 10; stamp <= 40; stamp += 10) publish(table, stamp);
  EXPECT_EQ(valueAt(table, 5).error(), Errc::NotYet);
  publish(table, 50);
  EXPECT_EQ(valueAt(table, 15).error(), Errc::TooOld);
  EXPECT_EQ(valueAt(table, 5).error(), Errc::TooOld);
  EXPECT_EQ(valueAt(table, 29).value(), 20u);
}

TEST(StateTable, ALaterColumnWasNotYetThere) {
  StateTable table(kSizes, 4);
  table.publish(fromNanoseconds(10), {.valid = 0b100});
  publish(table, 20);
  EXPECT_EQ(valueAt(table, 10).error(), Errc::NotYet);
  EXPECT_EQ(valueAt(table, 20).value(), 20u);
}

TEST(StateTable, AnEarlierStampCountsAsOneBefore) {
  StateTable table(kSizes, 4);
  publish(table, 20);
  table.publish(fromNanoseconds(10), {.valid = 0b010});
  std::uint32_t value = 0;
  EXPECT_EQ(*table.read(1, reinterpret_cast<std::byte*>(&value)), fromNanoseconds(20));
}

TEST(StateTable, KeepsAsManyRowsAsAsked) {
  StateTable table(kSizes, 2);
  table.resize(100);
  EXPECT_EQ(table.capacity(), 128u);
  for (std::uint32_t stamp = 1; stamp <= 128; ++stamp) publish(table, stamp);
  EXPECT_EQ(valueAt(table, 1).value(), 1u);
  publish(table, 129);
  EXPECT_EQ(valueAt(table, 1).error(), Errc::TooOld);
}

/// Lets this process open no more descriptors.
class NoMoreDescriptors {
 public:
  NoMoreDescriptors() {
    getrlimit(RLIMIT_NOFILE, &before_);
    const rlimit none{0, before_.rlim_max};
    setrlimit(RLIMIT_NOFILE, &none);
  }
  ~NoMoreDescriptors() { setrlimit(RLIMIT_NOFILE, &before_); }
  NoMoreDescriptors(const NoMoreDescriptors&) = delete;
  NoMoreDescriptors& operator=(const NoMoreDescriptors&) = delete;

 private:
  rlimit before_{};
};

TEST(StateTable, MissingMemoryLeavesItUnchanged) {
  StateTable table(kSizes, 4);
  publish(table, 1);
  {
    const NoMoreDescriptors limit;
    EXPECT_THROW(table.resize(128), SetupError);
  }
  ASSERT_EQ(table.capacity(), 4u);
  EXPECT_EQ(valueAt(table, 1).value(), 1u);
  for (std::uint32_t stamp = 2; stamp <= 6; ++stamp) publish(table, stamp);
  EXPECT_EQ(valueAt(table, 6).value(), 6u);
}

TEST(StateTable, PublishesValuesThatLieElsewhere) {
  StateTable table(kSizes);
  std::array<std::byte, 120> first, slot;
  first.fill(std::byte{5});
  const std::uint32_t second = 7;
  const StateTable::Value values[] = {
      {first.data()}, {reinterpret_cast<const std::byte*>(&second)}, {}};
  table.publish(now(), {.valid = 0b011}, values);
  EXPECT_TRUE(table.read(0, slot.data()));
  EXPECT_EQ(slot, first);
  std::uint32_t read = 0;
  EXPECT_TRUE(table.read(1, reinterpret_cast<std::byte*>(&read)));
  EXPECT_EQ(read, second);
}

TEST(StateTable, StoresAheadOfAnUnseenRow) {
  StateTable table(kSizes, 2);
  std::array<std::byte, 120> value, slot;
  for (const unsigned char one : {5, 6, 7}) {
    value.fill(std::byte{one});
    StateTable::Value values[] = {{value.data()}, {}, {}};
    table.storeAhead(0, values[0], 64);
    EXPECT_EQ(values[0].stored, 64u);
    value.fill(std::byte{0});  // which is not stored again
    std::fill(value.begin() + 64, value.end(), std::byte{one});
    if (one != 6) table.storeAhead(0, values[0], 200);
    EXPECT_EQ(values[0].stored, one == 6 ? 64u : 120u) << "publish() stores the rest";
    EXPECT_EQ(table.rows(), one - 5u);
    table.publish(now(), {.valid = 1}, values);
    ASSERT_TRUE(table.read(0, slot.data()));
    EXPECT_EQ(slot.front(), std::byte{one});
    EXPECT_EQ(slot.back(), std::byte{one});
  }
}

TEST(StateTable, ARowBeingStoredIsNotRead) {
  StateTable table(kSizes, 2);
  for (int i = 0; i < 2; ++i) table.publish(now(), {.valid = 1});
  std::array<std::byte, 120> value{}, slot;
  std::byte* const slots[] = {slot.data(), nullptr, nullptr};
  EXPECT_TRUE(table.readRowNumber(1, slots).hasValue(0));
  StateTable::Value ahead{value.data()};
  table.storeAhead(0, ahead, 8);
  EXPECT_TRUE(table.readRowNumber(1, slots).tooOld);
  EXPECT_TRUE(table.readRowNumber(2, slots).hasValue(0));
}

TEST(StateTable, APartIsReadUntilOverwritten) {
  StateTable table(kSizes, 2);
  std::iota(reinterpret_cast<char*>(table.draft(0)), reinterpret_cast<char*>(table.draft(0)) + 120,
            char{0});
  table.publish(now(), {.valid = 1});
  const StateTable::Row row = table.readRow({});
  std::array<std::byte, 24> part;
  ASSERT_TRUE(table.readPart(row, 0, 96, part));
  EXPECT_EQ(part.front(), std::byte{96});
  EXPECT_EQ(part.back(), std::byte{119});
  table.publish(now(), {.valid = 1});
  EXPECT_TRUE(table.readPart(row, 0, 0, part));
  table.publish(now(), {.valid = 1});
  EXPECT_FALSE(table.readPart(row, 0, 0, part));
}

TEST(StateTable, KnowsWhichColumnsThereAre) {
  EXPECT_EQ(StateTable(kSizes).existing(~ColumnSet{0}), 0b111u);
  EXPECT_EQ(StateTable(kSizes).existing(0b1010), 0b010u);
  EXPECT_EQ(StateTable({}).existing(~ColumnSet{0}), 0u);
  EXPECT_EQ(StateTable(std::vector<std::uint32_t>(64, 1)).existing(~ColumnSet{0}), ~ColumnSet{0});
}

TEST(StateTable, RowsAreReadByNumber) {
  StateTable table(kSizes, 4);
  for (std::uint32_t stamp = 10; stamp <= 50; stamp += 10) publish(table, stamp);
  std::uint32_t value = 0;
  const std::array<std::byte*, 3> slots{nullptr, reinterpret_cast<std::byte*>(&value), nullptr};
  EXPECT_TRUE(table.readRowNumber(1, slots).tooOld);
  EXPECT_EQ(table.readRowNumber(2, slots).sequence, 2u);
  EXPECT_EQ(value, 20u);
  EXPECT_EQ(table.readRowNumber(5, slots).valid, 0b010u);
  EXPECT_EQ(value, 50u);
  EXPECT_EQ(table.readRowNumber(6, slots).sequence, 0u);
  EXPECT_FALSE(table.readRowNumber(6, slots).tooOld);
}

// A writer laps the ring all the time: what a reader of the past gets is whole and at or before the
// time, or TooOld.
TEST(StateTable, AFastWriterTearsNoRow) {
  constexpr std::uint64_t kRows = 300'000;
  constexpr std::uint32_t kColumns[] = {128};
  StateTable table(kColumns, 64);
  std::thread writer([&table] {
    for (std::uint64_t i = 1; i <= kRows; ++i) {
      for (std::size_t word = 0; word < 16; ++word) std::memcpy(table.draft(0) + 8 * word, &i, 8);
      table.publish(fromNanoseconds(static_cast<std::int64_t>(2 * i)), {.valid = 1});
    }
  });
  std::array<std::uint64_t, 16> wide{};
  std::uint64_t found = 0, next = 1;
  for (std::uint64_t newest = 0; newest < kRows; newest = table.rows()) {
    if (newest < 40) continue;
    const std::uint64_t wanted = newest - 30;
    const auto at = fromNanoseconds(static_cast<std::int64_t>(2 * wanted + 1));
    const auto read = table.readAt(at, 0, reinterpret_cast<std::byte*>(wide.data()));
    if (read) {
      ++found;
      for (const std::uint64_t word : wide) ASSERT_EQ(word, wanted);
    } else {
      ASSERT_EQ(read.error(), Errc::TooOld);
    }
    const std::array<std::byte*, 1> slots{reinterpret_cast<std::byte*>(wide.data())};
    const StateTable::Row row = table.readRowNumber(next, slots);
    if (row.sequence == next) {
      for (const std::uint64_t word : wide) ASSERT_EQ(word, next);
    }
    next = std::max(next + 1, newest - 30);
  }
  writer.join();
  EXPECT_GT(found, 0u);
}

// One writer, two readers: no value is torn, none goes backwards, and two columns of one row belong
// together.
TEST(StateTable, NeverTornUnderAFastWriter) {
  constexpr std::uint64_t kRows = 300'000;
  constexpr std::uint32_t kColumns[] = {128, 8};
  StateTable table(kColumns, 16);
  std::thread writer([&table] {
    for (std::uint64_t i = 1; i <= kRows; ++i) {
      for (std::size_t word = 0; word < 16; ++word) std::memcpy(table.draft(0) + 8 * word, &i, 8);
      std::memcpy(table.draft(1), &i, 8);
      table.publish(fromNanoseconds(static_cast<std::int64_t>(i)), {.valid = 0b11});
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
