// The provider of this state table is another process, which may write anything at any time.
#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/rt/state/state_table.h>

#include <array>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "support/refusal.h"

namespace suture::rt::foreign_state_table {
namespace {

constexpr std::uint32_t kLarge = 600;
/// Describes a list of bytes, behind 4 bytes and with 4 behind it.
constexpr BoundedLevel kListOfLarge[] = {
    {.size = 4, .data = 8, .stride = 1, .capacity = kLarge - 12}};

TEST(ForeignStateTable, IsReadAndAskedByAnotherProcess) {
  const std::array<std::uint32_t, 2> sizes = {8, 24};
  StateTable table(sizes, 4);
  const auto asked = std::make_shared<std::atomic<ColumnSet>>(0);
  StateTable view(sizes, 4,
                  MemoryBlock::open(table.memory()->descriptor(), StateTable::bytesFor(sizes, 4),
                                    MemoryBlock::Others::Read),
                  asked);
  EXPECT_TRUE(view.ask(1));
  EXPECT_EQ(*asked, 2u);
  std::array<std::byte, 24> slot{};
  EXPECT_EQ(view.read(1, slot.data()).error(), Errc::NotYet);
  for (int row = 1; row <= 10; ++row) {
    std::memset(table.draft(1), row, 24);
    const Time stamp = now();
    table.publish(stamp, {.valid = 2});
    EXPECT_EQ(view.read(1, slot.data()).value(), stamp);
    EXPECT_EQ(slot[23], static_cast<std::byte>(row));
  }
  EXPECT_EQ(view.rows(), 10u);
}

TEST(ForeignStateTable, CopiesTheUsedPartOfLargeLists) {
  const std::array<std::uint32_t, 2> sizes = {12, kLarge};
  const std::array<BoundedLevels, 2> levels = {BoundedLevels{}, kListOfLarge};
  StateTable table(sizes, 4, 0, StateTable::Readers::Elsewhere, levels);
  const StateTable view(sizes, 4, table.memory(), std::make_shared<std::atomic<ColumnSet>>(),
                        levels);
  constexpr std::uint32_t kFull = kLarge - 12;  // in each row, before there is less
  for (const std::uint32_t used : {kFull, kFull, kFull, kFull, 0u, 1u, 5u, kLarge / 2}) {
    std::memset(table.draft(0), 0xdd, sizes[0]);
    std::memset(table.draft(1), 0xee, kLarge);
    std::memcpy(table.draft(1) + 4, &used, sizeof(used));
    table.publish(now(), {.valid = 3});
    std::array<std::byte, 12> small{};
    std::array<std::byte, kLarge> large{};
    const std::array<std::byte*, 2> slots = {small.data(), large.data()};
    EXPECT_EQ(view.readRow(slots).valid, 3u);
    EXPECT_EQ(small[11], std::byte{0xdd});
    for (std::size_t i = 0; i < kLarge; ++i) {
      if (i >= 4 && i < 8) continue;  // how many they are
      const bool fixed = i < 8 || i >= kLarge - 4;
      if (fixed || i < 8 + used) {
        EXPECT_EQ(large[i], std::byte{0xee}) << i;
      } else if (i >= 16 + used && i < kLarge - 12) {  // beyond the words that it shares
        EXPECT_EQ(large[i], std::byte{0}) << i;
      }
    }
  }
}

TEST(ForeignStateTable, MemoryThatIsTooSmallIsRefused) {
  const std::array<std::uint32_t, 2> columns = {8, 24};
  const StateTable provider(columns, 4);
  const auto view = [&] {
    const StateTable client(columns, 8, provider.memory(),
                            std::make_shared<std::atomic<ColumnSet>>());
  };
  EXPECT_EQ(refusal(view), "read a state table of 8 rows: the memory has " +
                               std::to_string(provider.memory()->size()) + " bytes of " +
                               std::to_string(StateTable::bytesFor(columns, 8)) +
                               ". Build both processes from the same release");
}

// There cannot be as many rows as it says: the search for a time ends all the same.
TEST(ForeignStateTable, IsReadWhateverItsNumberOfRows) {
  const std::array<std::uint32_t, 1> columns = {8};
  StateTable provider(columns, 4);
  const StateTable client(columns, 4, provider.memory(),
                          std::make_shared<std::atomic<ColumnSet>>());
  std::uint64_t value = 0;
  const std::array<std::byte*, 1> slots = {reinterpret_cast<std::byte*>(&value)};
  for (const std::uint64_t rows : {~std::uint64_t{0}, ~std::uint64_t{0} - 1, StateTable::kMostRows,
                                   StateTable::kMostRows + 1, std::uint64_t{1} << 63}) {
    std::memcpy(provider.memory()->data(), &rows, sizeof(rows));
    EXPECT_TRUE(client.readRowAt(now(), slots).tooOld);
    EXPECT_EQ(client.readAt(now(), 0, slots[0]).error(), Errc::TooOld);
    EXPECT_EQ(client.readRow(slots).valid, 0u);
  }
}

TEST(ForeignStateTable, StampsHaveAnAge) {
  const std::array<std::uint32_t, 1> columns = {8};
  StateTable provider(columns, 4);
  const StateTable client(columns, 4, provider.memory(),
                          std::make_shared<std::atomic<ColumnSet>>());
  provider.publish(now(), {.valid = 1});
  std::vector<std::uint64_t> words(provider.memory()->size() / 8);
  std::memcpy(words.data(), provider.memory()->data(), words.size() * 8);
  for (std::uint64_t& word : words) {
    if (word > 1) word = std::uint64_t{1} << 63;  // the stamp is the only number beyond 1
  }
  std::memcpy(provider.memory()->data(), words.data(), words.size() * 8);
  const auto stamp = client.read(0, reinterpret_cast<std::byte*>(words.data()));
  ASSERT_TRUE(stamp);
  EXPECT_GE(*stamp, Time{});
}

}  // namespace
}  // namespace suture::rt::foreign_state_table
