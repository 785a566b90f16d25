#include <gtest/gtest.h>
#include <suture/rt/doorbell.h>
#include <suture/rt/thread.h>
#include <suture/testing/test_clock.h>

#include <atomic>
#include <thread>

#include "support/eventually.h"
#include "support/patience.h"

namespace suture::rt {
namespace {

using namespace std::chrono_literals;

/// Waits for two rings, each far sooner than the deadline.
class AwaitsTwoRings {
 public:
  explicit AwaitsTwoRings(Doorbell& bell)
      : thread_([this, &bell] {
          const Time deadline = now() + kPatience;
          while (rings < 2 && bell.waitUntil(deadline) != RungFor::Nothing) ++rings;
        }) {}
  ~AwaitsTwoRings() { thread_.join(); }

  std::atomic<int> rings{0};

 private:
  std::thread thread_;
};

std::shared_ptr<MemoryBlock> wordOfABell() {
  return std::make_shared<MemoryBlock>("test", sizeof(std::uint64_t));
}

// It may be asleep already, in the way of those that only its own process rings.
TEST(Doorbell, SharingItWhileTheOwnerSleepsWorks) {
  for (int round = 0; round < 200; ++round) {
    Doorbell bell(wordOfABell(), Doorbell::Sleeper::Here);
    AwaitsTwoRings sleeper(bell);
    // Half of them likely sleep by then, the others are on their way.
    if (round % 2 == 0) std::this_thread::sleep_for(1ms);
    const auto again = MemoryBlock::open(bell.share()->descriptor(), sizeof(std::uint64_t),
                                         MemoryBlock::Others::Write);
    ASSERT_TRUE(eventually([&] { return sleeper.rings == 1; })) << "share() is a ring";
    Doorbell(again, Doorbell::Sleeper::Elsewhere).ring();
    ASSERT_TRUE(eventually([&] { return sleeper.rings == 2; }));
  }
}

TEST(Doorbell, ASharedOneIsStillRung) {
  Doorbell bell(wordOfABell(), Doorbell::Sleeper::Here);
  AwaitsTwoRings sleeper(bell);
  bell.share();
  ASSERT_TRUE(eventually([&] { return sleeper.rings == 1; }));
  bell.ring();
  ASSERT_TRUE(eventually([&] { return sleeper.rings == 2; }));
}

/// Sleeps at a bell until it ends, and counts how often it has woken for nothing.
class Looker {
 public:
  explicit Looker(Doorbell& bell) : bell_(bell) {
    thread_.start(
        "sleeper", [this] { sleep(); }, Thread::Signals::None);
  }
  ~Looker() {
    over_ = true;
    bell_.ring();
    thread_.join();
  }

  std::atomic<int> rings{0}, looks{0};

 private:
  void sleep() {
    while (!over_) ++(bell_.waitUntil(Time::max()) == RungFor::Nothing ? looks : rings);
  }

  Doorbell& bell_;
  std::atomic<bool> over_{false};
  Thread thread_;
};

// Another process may lose a ring, by accident or not; this one does not.
TEST(Doorbell, AnotherProcessKeepsItsOwnerLooking) {
  TestClock clock;
  Doorbell bell(wordOfABell(), Doorbell::Sleeper::Here);
  Looker sleeper(bell);
  clock.advance(1h);
  EXPECT_EQ(sleeper.looks, 0);
  bell.share();
  EXPECT_TRUE(clock.until([&] { return sleeper.rings == 1; }));
  clock.advance(10 * Doorbell::kLookAgain);
  EXPECT_EQ(sleeper.looks, 10);
}

}  // namespace
}  // namespace suture::rt
