#include <gtest/gtest.h>
#include <suture/rt/due_bells.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <atomic>
#include <deque>

namespace suture::rt {
namespace {

/// A Sleeper is a bell whose owner sleeps, so that each ring that counts can be seen.
class Sleeper {
 public:
  Sleeper() { bell.prepareToSleep(); }
  ~Sleeper() { close(descriptor_); }

  /// Returns how often it has been rung since the last call; it sleeps again.
  std::uint64_t rings() {
    std::uint64_t count = 0;
    if (read(descriptor_, &count, sizeof(count)) != sizeof(count)) return 0;
    bell.takeRing();
    bell.prepareToSleep();
    return count;
  }

 private:
  int descriptor_ = eventfd(0, EFD_NONBLOCK);

 public:
  Doorbell bell{descriptor_};
};

TEST(DueBells, RingsEachOnceAndOnlyWhenTold) {
  std::deque<Sleeper> sleepers(DueBells::kCapacity);
  DueBells due;
  for (int round = 0; round < 3; ++round) {
    for (int again = 0; again < 3; ++again) {
      for (Sleeper& sleeper : sleepers) due.add(sleeper.bell);
    }
    for (Sleeper& sleeper : sleepers) ASSERT_EQ(sleeper.rings(), 0u);
    due.ringAll();
    for (Sleeper& sleeper : sleepers) ASSERT_EQ(sleeper.rings(), 1u);
    due.ringAll();
    for (Sleeper& sleeper : sleepers) ASSERT_EQ(sleeper.rings(), 0u);
  }
}

// A sleeper that wakes up and sleeps again before the end of the cycle is not rung twice for what
// was added twice.
TEST(DueBells, ABellAddedTwiceRingsOnce) {
  Sleeper sleeper, other;
  DueBells due;
  due.add(sleeper.bell);
  due.add(other.bell);
  due.add(sleeper.bell);
  due.ringAll();
  EXPECT_EQ(sleeper.rings(), 1u);
  due.ringAll();
  EXPECT_EQ(sleeper.rings(), 0u);
}

TEST(DueBells, ABellIsRungForBothReasons) {
  Doorbell one, other;
  DueBells due;
  due.add(one, RungFor::Arrival);
  due.add(other, RungFor::Arrival);
  due.add(one, RungFor::Work);
  due.add(one, RungFor::Arrival);
  due.ringAll();
  EXPECT_EQ(one.takeRing(), RungFor::Work);
  EXPECT_EQ(other.takeRing(), RungFor::Arrival);
}

TEST(DueBells, TakenWorkIsNotRungFor) {
  SharedFlag untaken, other;
  untaken.raise();
  Sleeper sleeper;
  DueBells due;
  due.add(sleeper.bell, RungFor::Arrival, &untaken);
  due.add(sleeper.bell, RungFor::Arrival, &untaken);
  due.ringAll();
  EXPECT_EQ(sleeper.rings(), 1u);
  EXPECT_FALSE(untaken.isUp(std::memory_order_relaxed)) << "what comes later is rung for again";

  due.add(sleeper.bell, RungFor::Arrival, &untaken);
  due.ringAll();
  EXPECT_EQ(sleeper.rings(), 0u);

  due.add(sleeper.bell, RungFor::Arrival, &untaken);
  due.add(sleeper.bell, RungFor::Arrival, &other);
  due.ringAll();
  EXPECT_EQ(sleeper.rings(), 1u) << "of two it cannot say which";

  due.add(sleeper.bell, RungFor::Arrival, &untaken);
  due.add(sleeper.bell);
  due.ringAll();
  EXPECT_EQ(sleeper.rings(), 1u) << "work is work";
}

TEST(DueBells, BeyondItsCapacityRingsAtOnce) {
  std::deque<Sleeper> sleepers(DueBells::kCapacity);
  Sleeper late;
  DueBells due;
  for (Sleeper& sleeper : sleepers) due.add(sleeper.bell);
  due.add(late.bell);
  EXPECT_EQ(late.rings(), 1u);
  due.add(sleepers.front().bell);
  EXPECT_EQ(sleepers.front().rings(), 0u);
  due.ringAll();
  for (Sleeper& sleeper : sleepers) EXPECT_EQ(sleeper.rings(), 1u);
}

}  // namespace
}  // namespace suture::rt
