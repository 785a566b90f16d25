// The state table is under stress, and the last test says what the stress is worth.

#include <gtest/gtest.h>
#include <suture/rt/state/state_table.h>

#include <array>
#include <atomic>
#include <cstring>
#include <vector>

#include "rt/stress/payload.h"
#include "rt/stress/two_cores.h"

namespace stress {
namespace {

namespace rt = suture::rt;

// The fewer rows, the sooner a writer catches a reader at it.
TEST(Stress, AStateTablesRowsAreWhole) {
  constexpr std::uint32_t kColumns[] = {sizeof(Bytes), sizeof(Bytes)};
  rt::StateTable table(kColumns, 4);
  const Span span;
  std::atomic<bool> ended{false};
  std::vector<Faults> faults(2);
  std::uint64_t apart = 0;  // rows whose columns are not theirs
  const auto write = [&] {
    for (std::uint64_t serial = 1; !span.over(serial - 1); ++serial) {
      for (unsigned column : {0u, 1u}) fill(at(table.draft(column)), serial);
      table.publish(suture::now(), {.valid = 3});
    }
    ended = true;
  };
  const auto readColumn = [&] {
    Bytes bytes{};
    std::uint64_t before = 0;
    while (!ended || faults[0].seen == 0) {
      if (!table.read(1, bytes.data())) continue;
      const std::uint64_t serial = serialOf(bytes);
      if (serial != before) faults[0].take(serial);
      before = serial;
    }
  };
  const auto readRow = [&] {
    Bytes first{}, second{};
    std::byte* const slots[] = {first.data(), second.data()};
    std::uint64_t before = 0;
    while (!ended || faults[1].seen == 0) {
      const auto row = table.readRow(slots);
      if (row.sequence == before || row.valid != 3) continue;
      before = row.sequence;
      const bool whole =
          faults[1].take(serialOf(first)) == row.sequence && serialOf(second) == row.sequence;
      apart += whole ? 0 : 1;
    }
  };
  runAcrossProcessors({write, readColumn, readRow});
  expectNone(faults[0], "columns");
  expectNone(faults[1], "rows");
  EXPECT_EQ(apart, 0u);
}

// This is a table of one row without its sequence, and shows what the sums are for.
TEST(Stress, FindsATornPayload) {
  std::array<std::atomic<std::uint64_t>, sizeof(Bytes) / 8> shared{};
  std::atomic<bool> ended{false};
  const suture::Time end = suture::now() + std::chrono::seconds(30);
  Faults faults;
  runAcrossProcessors({[&] {
                         Bytes bytes;
                         for (std::uint64_t serial = 1; !ended; ++serial) {
                           fill(bytes, serial);
                           for (std::size_t i = 0; i < shared.size(); ++i) {
                             std::uint64_t word;
                             std::memcpy(&word, bytes.data() + 8 * i, 8);
                             shared[i].store(word, std::memory_order_release);
                           }
                         }
                       },
                       [&] {
                         Bytes bytes;
                         while (faults.torn == 0 && suture::now() < end) {
                           for (std::size_t i = 0; i < shared.size(); ++i) {
                             const std::uint64_t word = shared[i].load(std::memory_order_acquire);
                             std::memcpy(bytes.data() + 8 * i, &word, 8);
                           }
                           faults.take(serialOf(bytes));
                         }
                         ended = true;
                       }});
  EXPECT_GT(faults.torn, 0u);
}

}  // namespace
}  // namespace stress
