// This task has more to send than a queue holds.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/task/event_task.h>
#include <suture/wiring/connect.h>

#include <atomic>

#include "reference/arm_like.suture.h"
#include "reference/still_arm.h"
#include "support/eventually.h"
#include "support/patience.h"

namespace suture {
namespace {

/// Sends one command after the other, as far as there is room, in each run().
class Feeder final : public EventTask {
 public:
  explicit Feeder(int commands) : left_(commands) {}
  Required<reference::ArmLike> arm{*this, "Arm"};

 private:
  void run() override {
    for (; left_ > 0 && arm.hold.room() > 0; --left_) EXPECT_TRUE(arm.hold());
  }

  int left_;
};

struct Arm final : EventTask {
  void run() override {}

  StillArm still;
  Provided<reference::ArmLike> arm{*this, "Arm", still};
};

/// Fills the queue in its first run(), and waits for room.
class Waiter final : public EventTask {
 public:
  Required<reference::ArmLike> arm{*this, "Arm"};
  std::atomic<bool> waits{false};
  std::atomic<Errc> end{};

 private:
  void run() override {
    if (waits) return;
    while (arm.hold.room() > 0) EXPECT_TRUE(arm.hold());
    waits = true;
    end = arm.hold.roomWithin(kPatience).error();
  }
};

/// Waits in its first run() for an answer, and then for an event; and once more in onStop().
class Awaiter final : public EventTask {
 public:
  Required<reference::ArmLike> arm{*this, "Arm"};
  std::atomic<bool> waits{false};
  std::atomic<Errc> answer{}, event{}, last{};

 private:
  void run() override {
    if (waits.exchange(true)) return;
    answer = arm.hold.start().within(kPatience).error();
    event = arm.on().stopped.next().within(kPatience).error();
  }
  void onStop() override { last = arm.hold.start().within(std::chrono::milliseconds(1)).error(); }
};

/// Its hold() ends when the test says so.
struct SlowArm final : EventTask, StillArm {
  void run() override {}
  void hold() override {
    holding = true;
    while (slow) pass(std::chrono::milliseconds(1));
  }
  Provided<reference::ArmLike> arm{*this, "Arm", *this};
  std::atomic<bool> slow{true}, holding{false};
};

// The provider is not started, so it takes nothing.
TEST(Waits, EndWithTheirTask) {
  Arm provider;
  Awaiter awaiter;
  const auto channel = connectLocally(awaiter.arm, provider.arm, "test");
  awaiter.start();
  EXPECT_TRUE(eventually([&] { return awaiter.waits.load(); }));
  const Time begin = now();
  awaiter.stop();
  EXPECT_LT(now() - begin, kPatience);
  EXPECT_EQ(awaiter.answer, Errc::Cancelled);
  EXPECT_EQ(awaiter.event, Errc::Cancelled);
  EXPECT_EQ(awaiter.last, Errc::Timeout) << "it may bring an arm to rest in onStop()";
  provider.start();
  EXPECT_TRUE(eventually([&] { return channel->commands.counters.cancelled == 1u; }));
  provider.stop();
  EXPECT_EQ(provider.still.holds, 1) << "the one of onStop()";
}

TEST(Waits, ARunningCommandEndsTheWait) {
  SlowArm provider;
  Awaiter awaiter;
  const auto channel = connectLocally(awaiter.arm, provider.arm, "test");
  provider.start();
  awaiter.start();
  EXPECT_TRUE(eventually([&] { return provider.holding.load(); }));
  awaiter.stop();
  EXPECT_EQ(awaiter.answer, Errc::OutcomeUnknown);
  provider.slow = false;
  provider.stop();
}

TEST(Room, RoomRunsAnEventTaskAgain) {
  Arm provider;
  Feeder feeder(100);
  const auto channel = connectLocally(feeder.arm, provider.arm, "test");
  provider.start();
  const Time begin = now();
  feeder.start();
  EXPECT_TRUE(eventually([&] { return provider.still.holds == 100; })) << provider.still.holds;
  EXPECT_EQ(channel->commands.counters.full, 0u);
  EXPECT_LT(now() - begin, std::chrono::seconds(1)) << "nobody rang: it has looked again by itself";
  feeder.stop();
  provider.stop();
}

// The provider is not started, so it takes nothing.
TEST(Room, AWaitEndsWithItsTask) {
  Arm provider;
  Waiter waiter;
  const auto channel = connectLocally(waiter.arm, provider.arm, "test");
  waiter.start();
  EXPECT_TRUE(eventually([&] { return waiter.waits.load(); }));
  waiter.stop();
  EXPECT_EQ(waiter.end, Errc::Lost);
}

TEST(Room, ANewConnectionEndsTheWait) {
  Arm provider, other;
  Waiter waiter;
  const auto channel = connectLocally(waiter.arm, provider.arm, "test");
  waiter.start();
  EXPECT_TRUE(eventually([&] { return waiter.waits.load(); }));
  const auto next = connectLocally(waiter.arm, other.arm, "next");
  EXPECT_TRUE(eventually([&] { return waiter.end == Errc::Lost; }));
  waiter.stop();
}

}  // namespace
}  // namespace suture
