// A client and a provider read the past of a state table.
#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/component/device.h>
#include <suture/component/read_together.h>
#include <suture/component/task/event_task.h>
#include <suture/rt/state/state_table.h>
#include <suture/wiring/connect.h>

#include "support/refusal.h"
#include "support/resources.h"
#include "unit/component/arm_client.h"
#include "unit/component/driven_arm.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::JointState;
using reference::PoseStamped;

struct History : testing::Test {
  void begin(const StateOptions& automatic = {}) {
    arm.automaticPort.keepState(automatic);
    arm.manualPort.keepState({.manual = true});
    connectLocally(client.arm, arm.automaticPort, "automatic");
    connectLocally(manualClient.arm, arm.manualPort, "manual");
    arm.start();
    EXPECT_EQ(client.arm.measured_cp().error(), Errc::NotYet);
    EXPECT_EQ(client.arm.measured_js().error(), Errc::NotYet);
    EXPECT_EQ(manualClient.arm.measured_cp().error(), Errc::NotYet);
  }
  /// Runs one cycle; returns when its row was published.
  Time cycle() {
    arm.cycle();
    return client.arm.measured_cp().stamp();
  }
  static double x(const PoseStamped& pose) { return pose.pose.translation().x(); }

  DrivenArm arm;
  ArmClient client, manualClient;
};

TEST_F(History, AClientReadsTheRowBefore) {
  begin();
  const Time begun = now();
  const Time first = cycle(), second = cycle(), third = cycle();
  ASSERT_LT(first, second);
  const auto exactly = client.arm.measured_cp.at(second);
  ASSERT_TRUE(exactly);
  EXPECT_EQ(x(*exactly), 2);
  EXPECT_EQ(exactly.stamp(), second);
  EXPECT_EQ(x(*client.arm.measured_cp.at(second - 1ns)), 1);
  EXPECT_EQ(x(*client.arm.measured_cp.at(third + 1h)), 3);
  EXPECT_EQ(client.arm.measured_cp.at(begun).error(), Errc::NotYet);
  JointState joints;
  EXPECT_EQ(client.arm.measured_js.at(second, joints).stamp(), second);
  EXPECT_EQ(joints.position, std::vector<double>{2});
}

TEST_F(History, ReachesAsFarBackAsConfigured) {
  begin({.rows = 4});
  const Time first = cycle(), second = cycle();
  cycle();
  cycle();
  EXPECT_EQ(x(*client.arm.measured_cp.at(first)), 1);
  cycle();
  EXPECT_EQ(client.arm.measured_cp.at(first).error(), Errc::TooOld);
  EXPECT_EQ(x(*client.arm.measured_cp.at(second)), 2);
}

TEST_F(History, ADelayedReadIsOfThePast) {
  begin({.rows = 1u << 14});
  const Time first = cycle();
  while (now() - first < 2ms) cycle();
  const Time before = now();
  const auto delayed = client.arm.measured_cp.delayed(1ms);
  const Time after = now();
  ASSERT_TRUE(delayed);
  EXPECT_GE(delayed.stamp(), client.arm.measured_cp.at(before - 1ms).stamp());
  EXPECT_LE(delayed.stamp(), client.arm.measured_cp.at(after - 1ms).stamp());
  EXPECT_EQ(client.arm.measured_cp.delayed(1h).error(), Errc::NotYet);
}

TEST_F(History, SeveralReadsAreOfOneRow) {
  begin();
  const Time first = cycle();
  cycle();
  const auto row = readTogether(client.arm.measured_cp, client.arm.measured_js);
  ASSERT_TRUE(row);
  const auto& [pose, joints] = *row;
  EXPECT_EQ(x(pose), 2);
  EXPECT_EQ(joints.position, std::vector<double>{2});

  PoseStamped then;
  JointState jointsThen;
  const auto old =
      readIntoAt(first, std::tie(jointsThen, then), client.arm.measured_js, client.arm.measured_cp);
  ASSERT_TRUE(old);
  EXPECT_EQ(old.stamp(), first);
  EXPECT_EQ(x(then), 1);
  EXPECT_EQ(jointsThen.position, std::vector<double>{1});
  EXPECT_EQ(readTogetherAt(first - 1h, client.arm.measured_cp).error(), Errc::NotYet);
}

TEST_F(History, ReadsOfTwoInterfacesAreNoRow) {
  begin();
  cycle();
  EXPECT_EQ(readTogether(client.arm.measured_cp, manualClient.arm.measured_js).error(),
            Errc::Invalid);
}

TEST_F(History, ARowIsWhole) {
  begin();
  arm.cycle();
  EXPECT_EQ(readTogether(manualClient.arm.measured_cp, manualClient.arm.measured_js).error(),
            Errc::NotYet);
  arm.manualPort.advance();
  // The joints have been asked for only by the call above.
  EXPECT_TRUE(readTogether(manualClient.arm.measured_cp, manualClient.arm.measured_js));
}

TEST_F(History, AManualTableAdvancesOnRequest) {
  begin();
  int cycles = 0;
  arm.work = [&] {
    if (++cycles % 3 == 0) arm.manualPort.advance();
  };
  for (int i = 0; i < 7; ++i) arm.cycle();
  EXPECT_EQ(x(*manualClient.arm.measured_cp()), 2);
  EXPECT_EQ(x(*client.arm.measured_cp()), 7);
  EXPECT_EQ(arm.manualPort.state()->rows(), 2u);
}

TEST_F(History, AProviderReadsItsOwn) {
  begin();
  const Time first = cycle();
  cycle();
  const auto then = arm.past[&Required<ArmLike>::measured_cp].at(first);
  ASSERT_TRUE(then);
  EXPECT_EQ(x(*then), 1);
  EXPECT_EQ(x(*arm.past[&Required<ArmLike>::measured_cp]()), 2);
  EXPECT_TRUE(arm.required().empty());  // no manager has to wire it
}

TEST_F(History, AUsedStateStaysUnchanged) {
  begin();
  EXPECT_EQ(refusal([&] { arm.automaticPort.keepState({.rows = 1000}); }),
            "the state table of 'Automatic': somebody uses it already. Call keepState() in the "
            "component's constructor");
}

class CountingArmDevice final : public Device {
 public:
  CountingArm arm;
  Provided<ArmLike> port{*this, "Arm", arm};
};

struct SleepingArm final : EventTask, CountingArm {
  ~SleepingArm() override { stop(); }
  void run() override {}
  Provided<ArmLike> port{*this, "Arm", *this};
};

TEST(DeviceHistory, ADeviceHasNone) {
  CountingArmDevice device;
  ArmClient client;
  EXPECT_EQ(refusal([&] { device.port.keepState({.manual = true}); }),
            "the state table of 'Arm': a device, which has no thread to publish rows in. Make the "
            "component a task, or leave 'manual' out");
  connectLocally(client.arm, device.port, "device");
  EXPECT_TRUE(client.arm.measured_cp());
  EXPECT_TRUE(client.arm.measured_cp.at(now() + 1h));
  EXPECT_EQ(client.arm.measured_cp.delayed(1ms).error(), Errc::TooOld);
  EXPECT_TRUE(readTogether(client.arm.measured_cp, client.arm.measured_js));
}

TEST(KeepState, TakesNoDescriptorWithoutAConnection) {
  ArmClient first, second;
  const std::size_t before = openMemory();
  SleepingArm arm;
  arm.port.keepState({.rows = 128});
  EXPECT_EQ(openMemory(), before + 1) << "its bell";
  EXPECT_EQ(arm.port.demand(), 0u);
  connectLocally(first.arm, arm.port, "first");
  EXPECT_EQ(openMemory(), before + 2) << "its rows";
  EXPECT_EQ(arm.port.state()->capacity(), 128u);
  connectLocally(second.arm, arm.port, "second");
  EXPECT_EQ(openMemory(), before + 2) << "one table for both";
}

TEST(KeepState, RefusesTooFewAndTooManyRows) {
  DrivenArm arm;
  for (const unsigned rows : {0u, 1u, 1u << 30}) {
    EXPECT_EQ(
        refusal([&] { arm.automaticPort.keepState({.rows = rows}); }),
        "the state table of 'Automatic': " + std::to_string(rows) + " rows. Keep 2 to 1048576");
  }
}

}  // namespace
}  // namespace suture
