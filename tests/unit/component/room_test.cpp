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

TEST(Room, AnEventTaskRunsAgainWhenThereIsRoom) {
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

TEST(Room, AWaitEndsWhenAnotherConnectionTakesItsPlace) {
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
