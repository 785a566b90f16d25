// These test the order of commands, with the provider stalled and with the producer racing the
// drain.
#include "conformance/setup.h"
#include "support/patience.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;
using suture::kPatience;

class Order : public Conformance {
 protected:
  /// Runs `work` at the client while the provider is held inside a handler.
  void whileStalled(const std::function<void(Arm&)>& work) {
    stall();
    client->with(work);
    arm->gate().open();
  }
};
class WireOrder : public Order {};
/// DirectOrder has nothing between the client and the queue: what is replaced there has not been
/// sent on.
class DirectOrder : public Order {};

TEST_P(Order, ServoThenHoldEndsInHold) {
  whileStalled([](Arm& remote) {
    EXPECT_TRUE(remote.servo_cp(poseAt(1)));
    EXPECT_TRUE(remote.hold());
  });
  EXPECT_TRUE(eventuallyTaken({"disable", "servo_cp 1", "hold"}));
}

TEST_P(Order, HoldThenServoEndsInServo) {
  whileStalled([](Arm& remote) {
    EXPECT_TRUE(remote.hold());
    EXPECT_TRUE(remote.servo_cp(poseAt(1)));
  });
  EXPECT_TRUE(eventuallyTaken({"disable", "hold", "servo_cp 1"}));
}

TEST_P(Order, NewestWinsCommandsRunInSendingOrder) {
  whileStalled([](Arm& remote) {
    EXPECT_TRUE(remote.servo_cp(poseAt(1)));
    EXPECT_TRUE(remote.servo_jp(JointState{{}, {1, 2}}));
  });
  EXPECT_TRUE(eventuallyTaken({"disable", "servo_cp 1", "servo_jp 2"}));
}

TEST_P(Order, TheNewestServoRuns) {
  whileStalled([](Arm& remote) {
    for (int x = 1; x <= 100; ++x) EXPECT_TRUE(remote.servo_cp(poseAt(x)));
  });
  EXPECT_TRUE(suture::eventually([&] { return arm->lastTaken() == "servo_cp 100"; }));
}

TEST_P(DirectOrder, OnlyTheNewestServoRuns) {
  whileStalled([](Arm& remote) {
    for (int x = 1; x <= 100; ++x) EXPECT_TRUE(remote.servo_cp(poseAt(x)));
  });
  settle();
  EXPECT_EQ(arm->taken(), (std::vector<std::string>{"disable", "servo_cp 100", "hold"}));
}

TEST_P(Order, ALateCommandIsNotExecuted) {
  stall();
  client->with([](Arm& remote) {
    EXPECT_TRUE(remote.servo_cp(poseAt(1)));
    EXPECT_TRUE(remote.hold());
  });
  const suture::Time late = suture::now() + 501ms;  // the contract says ttl(500ms)
  EXPECT_TRUE(suture::eventually([&] { return suture::now() > late; }));
  arm->gate().open();
  EXPECT_TRUE(eventuallyTaken({"disable", "hold"}));
}

TEST_P(WireOrder, FullIsToldToTheCaller) {
  whileStalled([](Arm& remote) {
    int accepted = 0;
    while (remote.hold() && accepted < 100) ++accepted;
    EXPECT_EQ(accepted, 4);  // queue(4)
    EXPECT_EQ(remote.hold().error(), Errc::Full);
  });
  EXPECT_TRUE(eventuallyTaken({"disable", "hold", "hold", "hold", "hold"}));
  EXPECT_TRUE(suture::eventually([&] {  // the credits are back
    bool accepted = false;
    client->with([&](Arm& remote) { accepted = remote.hold().has_value(); });
    return accepted;
  }));
}

TEST_P(Order, ACallEndsAtItsDeadline) {
  whileStalled([](Arm& remote) {
    const suture::Time begin = suture::now();
    const auto answer = remote.distance.start(poseAt(1)).within(20ms);
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error(), Errc::Timeout);
    EXPECT_LT(suture::now() - begin, 20ms + 2s);
  });
  client->with(
      [](Arm& remote) { EXPECT_TRUE(remote.distance.start(poseAt(1)).within(kPatience)); });
}

// The producer races the drain: after every burst the provider ends in the last command sent.
TEST_P(WireOrder, EndsInTheLastCommandSent) {
  for (int burst = 1; burst <= 200; ++burst) {
    const bool endsInHold = burst % 2 == 0;
    client->with([&](Arm& remote) {
      EXPECT_TRUE(remote.servo_cp(poseAt(1000 + burst)));
      EXPECT_TRUE(remote.servo_jp.start(JointState{{}, {1}}).within(kPatience));
      EXPECT_TRUE(remote.hold());
      if (!endsInHold) {
        EXPECT_TRUE(remote.servo_cp(poseAt(-burst)));
        EXPECT_TRUE(remote.servo_jp.start(JointState{{}, {1, 2, 3}}).within(kPatience));
      } else {
        EXPECT_TRUE(remote.hold.start().within(kPatience));
      }
    });
    const std::string last = endsInHold ? "hold" : "servo_jp 3";
    ASSERT_EQ(arm->lastTaken(), last) << "burst " << burst;
  }
}

// A device has no queue to be stalled; what faults delay is in order, but not what comes between.
bool hasOneQueue(const Row& row) { return row.filter != Filter::Faults && !row.providerIsDevice(); }

INSTANTIATE_TEST_SUITE_P(Lanes, Order, testing::ValuesIn(laneRows(hasOneQueue)), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, WireOrder, testing::ValuesIn(wireRows(hasOneQueue)), nameOf);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(DirectOrder);  // over a lane that was added
INSTANTIATE_TEST_SUITE_P(Lanes, DirectOrder, testing::ValuesIn(laneRows([](const Row& row) {
                           return hasOneQueue(row) && row.isDirect();
                         })),
                         nameOf);

}  // namespace
}  // namespace conformance
