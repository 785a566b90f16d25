// This client ends in the middle of its provider's cycle.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/wiring/connect.h>

#include <memory>
#include <stdexcept>

#include "unit/component/driven_arm.h"

namespace suture {
namespace {

struct GoneListener final : Device {
  GoneListener() {
    arm.on().stopped([] {});
  }
  Required<reference::ArmLike> arm{*this, "Arm"};
};

// AddressSanitizer sees the fault: the provider is about to ring a doorbell that only it keeps.
TEST(GoneClient, ItsDoorbellIsNotRung) {
  DrivenArm arm;
  arm.start();
  auto listener = std::make_unique<GoneListener>();
  connectLocally(listener->arm, arm.automaticPort, "test");
  EXPECT_TRUE(listener->arm.connected());
  arm.cycle();
  arm.work = [&] {
    EXPECT_TRUE(arm.automaticPort.emit().stopped());
    listener.reset();
    throw std::runtime_error("it lets go of closed channels, and then rings");
  };
  arm.cycle();
  EXPECT_EQ(arm.state(), ComponentState::Faulted);
}

}  // namespace
}  // namespace suture
