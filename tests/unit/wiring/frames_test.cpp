// The coordinate frames that two interfaces declare are compared when they are connected.
#include <suture/wiring/frames.h>

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/wiring/connect.h>

#include "reference/simulated_arm.h"
#include "support/refusal.h"

namespace suture {
namespace {

static_assert(frameId("") == 0, "none is named");
static_assert(frameId("PSM1_base") == frameId("PSM1_base"));
static_assert(frameId("PSM1_base") != frameId("PSM2_base"));
static_assert(frameId("a") == 0xe40c292c, "FNV-1a, so that any program can tell");

TEST(Frames, DifferOnlyWhereBothSidesDeclareThem) {
  const Frames none, base{"base", "tip"}, scene{"scene", "tip"}, camera{"scene", "camera"};
  for (const Frames& one : {none, base, scene}) {
    EXPECT_EQ(frameDifference(one, one), "");
    EXPECT_EQ(frameDifference(none, one), "");
    EXPECT_EQ(frameDifference(one, none), "");
  }
  EXPECT_EQ(frameDifference({"scene", ""}, {"", "tip"}), "");
  EXPECT_EQ(frameDifference(base, scene), "expects reference frame 'base' and is offered 'scene'");
  EXPECT_EQ(frameDifference(scene, camera), "expects moving frame 'tip' and is offered 'camera'");
  EXPECT_EQ(frameDifference(base, camera),
            "expects reference frame 'base' and is offered 'scene', and moving frame 'tip' and is "
            "offered 'camera'");
}

struct FramedArm final : Device {
  reference::SimulatedArm arm{{}};
  Provided<reference::ArmLike> port{*this, "Arm", arm};
};

struct FramedClient final : Device {
  Required<reference::ArmLike> slave{*this, "Slave"};
};

TEST(Frames, AreDeclaredOnceAndInParts) {
  FramedArm arm;
  arm.port.declareFrames({"base", ""});
  arm.port.declareFrames({"", "tip"});
  arm.port.declareFrames({"base", "tip"});
  EXPECT_EQ(arm.port.frames(), (Frames{"base", "tip"}));
  EXPECT_EQ(refusal([&] {
              arm.port.declareFrames({"scene", "tip"});
            }),
            "declaring 'scene' as the reference frame of 'Arm': that is 'base' already. Declare "
            "each frame once");
  FramedClient client;
  client.slave.declareFrames({"base", "tip"});
  EXPECT_EQ(refusal([&] {
              client.slave.declareFrames({"", "camera"});
            }),
            "declaring 'camera' as the moving frame of 'Slave': that is 'tip' already. Declare "
            "each frame once");
}

TEST(Frames, DifferentFramesAreNotConnected) {
  FramedArm arm;
  FramedClient client;
  arm.port.declareFrames({"PSM1_base", "PSM1_tip"});
  client.slave.declareFrames({"PSM2_base", ""});
  EXPECT_EQ(refusal([&] { connectLocally(client.slave, arm.port, "Client/Slave -> PSM1/Arm"); }),
            "connecting Client/Slave -> PSM1/Arm: it expects reference frame 'PSM2_base' and is "
            "offered 'PSM1_base'. Connect it to an interface of its frames, or correct the frames "
            "that its component or the deployment declares");
  EXPECT_TRUE(arm.port.channels().empty());
}

TEST(Frames, EqualFramesAreConnected) {
  FramedArm arm;
  FramedClient client;
  arm.port.declareFrames({"PSM1_base", "PSM1_tip"});
  client.slave.declareFrames({"PSM1_base", ""});
  connectLocally(client.slave, arm.port, "Client/Slave -> PSM1/Arm");
  EXPECT_TRUE(client.slave.connected());
}

}  // namespace
}  // namespace suture
