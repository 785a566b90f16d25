// These handlers come and go while other threads call them.
#include <gtest/gtest.h>
#include <suture/component/channel/direct_handlers.h>
#include <suture/component/device.h>
#include <suture/wiring/connect.h>

#include <atomic>
#include <thread>

#include "reference/still_arm.h"
#include "support/eventually.h"
#include "unit/component/arm_client.h"

namespace suture {
namespace {

TEST(DirectHandlers, AreReplacedWhileSeveralThreadsCallThem) {
  struct Owner final : Device {
  } owner;
  DirectHandlers handlers(1);
  std::atomic<bool> over{false};
  std::atomic<long> attempts{0}, calls{0};
  std::vector<std::thread> callers;
  for (int i = 0; i < 2; ++i) {
    callers.emplace_back([&] {
      for (; !over; ++attempts) handlers.call(0, nullptr);
    });
  }
  for (int i = 0; i < 2000; ++i) {
    // Longer than a std::function keeps in itself, so that a use after its end is seen.
    handlers.set(0, owner,
                 std::make_shared<const DirectHandlers::Handler>(
                     [&calls, text = std::string(64, 'x')](const std::byte*) {
                       if (text.back() == 'x') calls.fetch_add(1, std::memory_order_relaxed);
                     }));
    if (i % 3 == 0) handlers.clear();
  }
  EXPECT_TRUE(eventually([&] {
    handlers.set(0, owner, std::make_shared<const DirectHandlers::Handler>([&](const std::byte*) {
                   calls.fetch_add(1, std::memory_order_relaxed);
                 }));
    return calls > 0;
  }));
  handlers.clear();
  handlers.awaitCalls();
  const long before = calls;
  const long enough = attempts + 1000;
  EXPECT_TRUE(eventually([&] { return attempts > enough; }));
  EXPECT_EQ(calls, before);
  over = true;
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(owner.state(), ComponentState::Constructed);
}

TEST(DirectHandlers, AFaultedOwnersHandlersDoNotRun) {
  struct Owner final : Device {
  } owner;
  DirectHandlers handlers(1);
  EXPECT_FALSE(handlers.call(0, nullptr));
  handlers.set(0, owner, std::make_shared<const DirectHandlers::Handler>([](const std::byte*) {
                 throw std::runtime_error("no room");
               }));
  EXPECT_EQ(handlers.events(), 1u);
  EXPECT_TRUE(handlers.call(0, nullptr));
  EXPECT_EQ(owner.fault(), "no room");
  EXPECT_FALSE(handlers.call(0, nullptr));
}

TEST(DirectHandlers, AnEarlyHandlerRunsWithTheEvent) {
  struct Bell final : Device, StillArm {
    Provided<reference::ArmLike> port{*this, "Arm", *this};
  } bell;
  ArmClient client;
  int heard = 0;
  ASSERT_TRUE(client.arm.on().stopped.direct([&heard] { ++heard; }));
  connectLocally(client.arm, bell.port, "test");
  client.arm.adopt();
  EXPECT_TRUE(bell.port.emit().stopped());
  EXPECT_EQ(heard, 1);
}

}  // namespace
}  // namespace suture
