#include <gtest/gtest.h>
#include <suture/lane/fault/sequence_check.h>

#include <vector>

namespace suture {
namespace {

struct SequenceCheckTest : testing::Test {
  std::vector<std::uint64_t> accepted(const std::vector<std::uint64_t>& come) {
    std::vector<std::uint64_t> taken;
    for (const std::uint64_t one : come) {
      if (check.accepts(one)) taken.push_back(one);
    }
    return taken;
  }
  DeliveryCounters counters;
  SequenceCheck check{counters};
};

using Numbers = std::vector<std::uint64_t>;

TEST_F(SequenceCheckTest, TakesWhatComesInOrder) {
  EXPECT_EQ(accepted({1, 2, 3}), (Numbers{1, 2, 3}));
  EXPECT_EQ(counters.lost + counters.duplicated + counters.overtaken, 0u);
}

TEST_F(SequenceCheckTest, DropsADuplicateAtOnceOrLater) {
  EXPECT_EQ(accepted({1, 1, 2, 3, 2, 1}), (Numbers{1, 2, 3}));
  EXPECT_EQ(counters.duplicated, 3u);
  EXPECT_EQ(counters.lost + counters.overtaken, 0u);
}

TEST_F(SequenceCheckTest, CountsAGap) {
  EXPECT_EQ(accepted({1, 4, 5, 200}), (Numbers{1, 4, 5, 200}));
  EXPECT_EQ(counters.lost, 2u + 194u);
}

TEST_F(SequenceCheckTest, DropsWhatWasOvertakenAndItsDuplicate) {
  EXPECT_EQ(accepted({1, 3, 2, 2}), (Numbers{1, 3}));
  EXPECT_EQ(counters.lost, 1u);
  EXPECT_EQ(counters.overtaken, 1u);
  EXPECT_EQ(counters.duplicated, 1u);
}

TEST_F(SequenceCheckTest, SkippedNumbersAreNotTaken) {
  EXPECT_EQ(accepted({1}), Numbers{1});
  check.passOver(3);
  check.passOver(2);  // an older mark
  EXPECT_EQ(check.reached(), 3u);
  EXPECT_EQ(counters.lost, 2u);
  EXPECT_EQ(accepted({2, 3, 4}), Numbers{4});
  EXPECT_EQ(counters.overtaken, 2u);
  EXPECT_EQ(counters.lost, 2u);
}

}  // namespace
}  // namespace suture
