#include "explorer/seeds.h"

#include <gtest/gtest.h>

namespace explorer {
namespace {

TEST(SeedsOfARun, AreEachInOneOfTheBlocks) {
  for (std::uint64_t count = 1; count <= 40; ++count) {
    std::uint64_t next = 7;
    for (std::uint64_t block = 0; block < blocksOf(count); ++block) {
      const Seeds seeds = seedsOf(block, {7, count});
      EXPECT_EQ(seeds.first, next) << count;
      EXPECT_GT(seeds.count, 0u) << count;
      next += seeds.count;
    }
    EXPECT_EQ(next, 7 + count);
  }
}

TEST(SeedsOfARun, AreNotNone) {
  EXPECT_EQ(numberIn("SUTURE_SEEDS", "1", 1), 1u);
  EXPECT_EQ(numberIn("SUTURE_FIRST_SEED", "0", 0), 0u);
  for (const char* const text : {"0", "", "-1", "many", "1e3", "8 "}) {
    EXPECT_THROW(numberIn("SUTURE_SEEDS", text, 1), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace explorer
