// A task looks once more before it sleeps, and finds what came meanwhile, because nobody rings for
// that.

#include <gtest/gtest.h>
#include <suture/component/task/event_task.h>
#include <suture/component/task/periodic_task.h>
#include <suture/wiring/connect.h>

#include <chrono>

#include "reference/still_arm.h"

namespace suture {
namespace {

struct EmittingArm final : PeriodicTask, StillArm {
  EmittingArm() : PeriodicTask({.period = std::chrono::milliseconds(1)}) {}
  void run() override {}
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

struct SleepingListener final : EventTask {
  SleepingListener() {
    arm.on().stopped([] {});
  }
  void run() override {}
  Required<reference::ArmLike> arm{*this, "Arm"};
};

TEST(LastLook, FindsAnEventThatComesMeanwhile) {
  EmittingArm arm;
  SleepingListener listener;
  const auto channel = connectLocally(listener.arm, arm.port, "test");
  listener.arm.adopt();
  arm.port.drain();
  arm.ringNow();
  listener.arm.handleEvents();
  while (listener.doorbell().takeRing() != rt::RungFor::Nothing) {
  }
  ASSERT_FALSE(listener.arm.pending());
  EXPECT_TRUE(arm.port.emit().stopped());
  const bool seen = listener.arm.unseen();
  arm.ringNow();
  EXPECT_TRUE(seen || listener.doorbell().takeRing() != rt::RungFor::Nothing);
}

}  // namespace
}  // namespace suture
