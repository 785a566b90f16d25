// These send every kind of command.
#include <suture/component/channel/channel.h>
#include <suture/component/read_together.h>

#include "conformance/setup.h"
#include "support/patience.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;
using suture::kPatience;

class Commands : public Conformance {};
class WireCommands : public Conformance {};
/// A copy of what they carry is taken; in the caller's thread it is passed on as it is.
class QueuedCommands : public Conformance {};
class QueuedWireCommands : public Conformance {};

TEST_P(Commands, AVoidCommandIsExecuted) {
  client->with([](Arm& remote) { EXPECT_TRUE(remote.hold()); });
  EXPECT_TRUE(eventuallyTaken({"hold"}));
}

TEST_P(WireCommands, AWriteCommandBringsItsArgument) {
  client->with([](Arm& remote) { EXPECT_TRUE(remote.servo_cp(poseAt(7))); });
  EXPECT_TRUE(eventuallyTaken({"servo_cp 7"}));
  EXPECT_EQ(arm->at([](ArmComponent& one) { return one.measured_cp().valid; }), true);
}

TEST_P(Commands, ABlockingWriteReturnsAfterItsExecution) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.servo_cp.start(poseAt(3)).within(kPatience));
    EXPECT_EQ(arm->taken(), std::vector<std::string>{"servo_cp 3"});
    EXPECT_TRUE(remote.hold.start().within(kPatience));
  });
}

TEST_P(WireCommands, StringsAndListsArriveWhole) {
  JointState goal;
  goal.name = {"yaw", "", "a name of 15 ch"};
  goal.position = {0.1, -0.0, 1e300};
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.servo_jp.start(goal).within(kPatience));
    const auto back = remote.measured_js.fresh().within(kPatience);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->name, goal.name);
    EXPECT_EQ(back->position, goal.position);
  });
}

TEST_P(QueuedCommands, ATooLargeArgumentIsRefused) {
  JointState goal;
  goal.name = {"a name of 16 chr"};
  client->with([&](Arm& remote) {
    const auto written = remote.servo_jp(goal);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error(), Errc::TooLarge);
  });
}

TEST_P(Commands, AReadIsNotYetThere) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.servo_cp.start(poseAt(5)).within(kPatience));
    const auto first =
        remote.measured_cp();  // asking wakes a sleeping provider, which may be quick
    EXPECT_TRUE(first || first.error() == Errc::NotYet);
  });
  EXPECT_TRUE(suture::eventually([&] {
    bool there = false;
    client->with([&](Arm& remote) {
      const auto pose = remote.measured_cp();
      there = pose && pose->pose.translation().x() == 5 && pose->valid;
      if (there) {
        EXPECT_GE(pose.age(), 0ns);
        EXPECT_LT(pose.age(), 10s);
      }
    });
    return there;
  }));
}

TEST_P(WireCommands, AReadFollowsTheProvider) {
  for (int x = 1; x <= 20; ++x) {
    client->with(
        [&](Arm& remote) { EXPECT_TRUE(remote.servo_cp.start(poseAt(x)).within(kPatience)); });
    EXPECT_TRUE(suture::eventually([&] {
      double seen = 0;
      client->with([&](Arm& remote) {
        PoseStamped pose;
        if (remote.measured_cp(pose)) seen = pose.pose.translation().x();
      });
      return seen == x;
    }));
  }
}

TEST_P(Commands, EachFreshReadIsEvaluated) {
  client->with([](Arm& remote) {
    for (int x = 1; x <= 20; ++x) {
      EXPECT_TRUE(remote.servo_cp.start(poseAt(x)).within(kPatience));
      const auto pose = remote.measured_cp.fresh().within(kPatience);
      ASSERT_TRUE(pose) << suture::toString(pose.error());
      EXPECT_EQ(pose->pose.translation().x(), x);
    }
  });
}

// The way back to the client is part of its age.
TEST_P(QueuedWireCommands, TheProviderStampsAFreshRead) {
  client->with([this](Arm& remote) {
    const suture::Time asked = suture::now();
    const auto pose = remote.measured_cp.fresh().within(kPatience);
    ASSERT_TRUE(pose);
    EXPECT_GE(pose.stamp(), asked);
    EXPECT_LE(pose.stamp(), arm->at([](ArmComponent& one) { return one.evaluated(); }));
  });
}

TEST_P(QueuedCommands, AReadWithoutAValueSaysWhy) {
  const auto becomes = [this](Errc joints, Errc pose) {
    arm->at([](ArmComponent& one) { one.emitSoon([](Ports) {}); });  // in a cycle, which publishes
    return suture::eventually([&] {
      bool is = false;
      client->with([&](Arm& remote) {
        const auto jointsRead = remote.measured_js();
        const auto poseRead = remote.measured_cp();
        is = (jointsRead ? Errc{} : jointsRead.error()) == joints &&
             (poseRead ? Errc{} : poseRead.error()) == pose;
      });
      return is;
    });
  };
  EXPECT_TRUE(becomes(Errc{}, Errc{}));
  arm->at([](ArmComponent& one) { one.garble(true); });
  EXPECT_TRUE(becomes(Errc{}, Errc::Invalid));
  client->with([](Arm& remote) {
    const auto fresh = remote.measured_cp.fresh().within(kPatience);
    EXPECT_EQ(fresh ? Errc{} : fresh.error(), Errc::Invalid);
    const auto row = suture::readTogether(remote.measured_js, remote.measured_cp);
    EXPECT_EQ(row ? Errc{} : row.error(), Errc::Invalid);
  });
  arm->at([](ArmComponent& one) {
    one.garble(false);
    one.outgrow();
  });
  EXPECT_TRUE(becomes(Errc::TooLarge, Errc{}));
}

TEST_P(Commands, AQualifiedReadAnswersItsQuestion) {
  client->with([](Arm& remote) {
    EXPECT_TRUE(remote.servo_cp.start(poseAt(1)).within(kPatience));
    const auto distance = remote.distance.start(poseAt(4)).within(kPatience);
    ASSERT_TRUE(distance);
    EXPECT_EQ(*distance, 3.0);
  });
  // No client gets an answer that is no number.
  arm->at([](ArmComponent& one) { one.garble(true); });
  client->with([](Arm& remote) {
    const auto distance = remote.distance.start(poseAt(4)).within(kPatience);
    EXPECT_EQ(distance ? Errc{} : distance.error(), Errc::Invalid);
  });
}

TEST_P(Commands, SeveralCallsMayBeUnderWay) {
  client->with([](Arm& remote) {
    auto near = remote.distance.start(poseAt(1));
    auto far = remote.distance.start(poseAt(9));
    EXPECT_EQ(*far.within(kPatience), 9.0);
    EXPECT_EQ(*near.within(kPatience), 1.0);
  });
}

TEST_P(Commands, PollingNeverBlocks) {
  client->with([](Arm& remote) {
    auto call = remote.distance.start(poseAt(2));
    ASSERT_TRUE(awaitInPlace(remote, [&] { return call.poll() != nullptr; }));
    EXPECT_EQ(**call.poll(), 2.0);
  });
}

INSTANTIATE_TEST_SUITE_P(Lanes, Commands, testing::ValuesIn(laneRows()), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, WireCommands, testing::ValuesIn(wireRows()), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, QueuedCommands, testing::ValuesIn(laneRows(isQueued)), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, QueuedWireCommands, testing::ValuesIn(wireRows(isQueued)), nameOf);

}  // namespace
}  // namespace conformance
