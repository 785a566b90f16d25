#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/read_together.h>
#include <suture/wiring/connect.h>

#include "support/allocations.h"
#include "unit/component/driven_arm.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;

struct Client final : Device {
  Required<ArmLike> arm{*this, "Arm"};
};

/// Runs one cycle of the provider, and every way to read its past.
void cycle(DrivenArm& arm, Client& client, reference::PoseStamped& pose,
           reference::JointState& joints) {
  arm.cycle();
  const Time newest = client.arm.measured_cp(pose).stamp();
  (void)client.arm.measured_cp.at(newest, pose);
  (void)client.arm.measured_js.delayed(10us, joints);
  (void)readInto(std::tie(pose, joints), client.arm.measured_cp, client.arm.measured_js);
  (void)readIntoAt(newest - 1us, std::tie(pose), client.arm.measured_cp);
  (void)arm.past[&Required<ArmLike>::measured_cp].at(newest, pose);
}

TEST(History, ReadsRowsAndWindowsDoNotAllocate) {
  DrivenArm arm;
  arm.manualPort.keepState({.manual = true});
  arm.measureOver(100us);
  arm.work = [&arm] { arm.manualPort.advance(); };
  Client client;
  connectLocally(client.arm, arm.automaticPort, "test");
  arm.start();
  reference::PoseStamped pose;
  reference::JointState joints;
  for (int i = 0; i < 100; ++i) cycle(arm, client, pose, joints);  // grow to their capacity

  const std::uint64_t before = allocations();
  for (int i = 0; i < 10'000; ++i) cycle(arm, client, pose, joints);
  EXPECT_EQ(allocations() - before, 0u);
  EXPECT_TRUE(arm.statistics().windows.last().valid());
  EXPECT_EQ(pose.pose.translation().x(), joints.position.at(0));
}

}  // namespace
}  // namespace suture
