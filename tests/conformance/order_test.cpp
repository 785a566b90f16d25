// The order of commands, with the provider stalled and with the producer racing the drain.
#include "conformance/setup.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;

class Order : public Conformance {
 protected:
  /// Runs `work` at the client while the provider is held inside a handler.
  void whileStalled(const std::function<void(Arm&)>& work) {
    arm->gate().close();
    client->with([](Arm& remote) { EXPECT_TRUE(remote.set_mode(Mode::Disabled)); });
    arm->gate().awaitVisitor();
    client->with(work);
    arm->gate().open();
  }
};

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

TEST_P(Order, TwoNewestWinsCommandsRunInTheOrderSent) {
  whileStalled([](Arm& remote) {
    EXPECT_TRUE(remote.servo_cp(poseAt(1)));
    EXPECT_TRUE(remote.servo_jp(JointState{{}, {1, 2}}));
  });
  EXPECT_TRUE(eventuallyTaken({"disable", "servo_cp 1", "servo_jp 2"}));
}

TEST_P(Order, OfManyServosTheNewestRuns) {
  whileStalled([](Arm& remote) {
    for (int x = 1; x <= 100; ++x) EXPECT_TRUE(remote.servo_cp(poseAt(x)));
  });
  EXPECT_TRUE(suture::eventually([&] { return arm->lastTaken() == "servo_cp 100"; }));
  if (std::get<0>(GetParam()) == LaneUnderTest::Local) {
    EXPECT_EQ(arm->taken().size(), 2u);  // while it was stalled, each replaced the one before
  }
}

TEST_P(Order, ALateCommandIsNotExecuted) {
  whileStalled([](Arm& remote) {
    EXPECT_TRUE(remote.servo_cp(poseAt(1)));  // ttl 500 ms
    EXPECT_TRUE(remote.hold());
    std::this_thread::sleep_for(600ms);
  });
  EXPECT_TRUE(eventuallyTaken({"disable", "hold"}));
}

TEST_P(Order, FullIsToldToTheCaller) {
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

TEST_P(Order, ACallEndsAtItsDeadlineAndSaysSo) {
  whileStalled([](Arm& remote) {
    const suture::Time begin = suture::now();
    const auto answer = remote.distance.start(poseAt(1)).within(20ms);
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error(), Errc::Timeout);
    EXPECT_LT(suture::now() - begin, 20ms + 2s);
  });
  client->with([](Arm& remote) { EXPECT_TRUE(remote.distance.start(poseAt(1)).within(5s)); });
}

// The producer races the drain: after every burst the provider ends in the last command sent.
TEST_P(Order, EndsInTheLastCommandSentHoweverTheyRace) {
  for (int burst = 1; burst <= 200; ++burst) {
    const bool endsInHold = burst % 2 == 0;
    client->with([&](Arm& remote) {
      EXPECT_TRUE(remote.servo_cp(poseAt(1000 + burst)));
      EXPECT_TRUE(remote.servo_jp.start(JointState{{}, {1}}).within(5s));
      EXPECT_TRUE(remote.hold());
      if (!endsInHold) {
        EXPECT_TRUE(remote.servo_cp(poseAt(-burst)));
        EXPECT_TRUE(remote.servo_jp.start(JointState{{}, {1, 2, 3}}).within(5s));
      } else {
        EXPECT_TRUE(remote.hold.start().within(5s));
      }
    });
    const std::string last = endsInHold ? "hold" : "servo_jp 3";
    ASSERT_EQ(arm->lastTaken(), last) << "burst " << burst;
  }
}

// A device has no queue to be stalled; what faults delay is in order, but not what comes between.
INSTANTIATE_TEST_SUITE_P(Lanes, Order,
                         testing::ValuesIn(combinations([](LaneUnderTest lane, ProviderKind kind) {
                           return lane != LaneUnderTest::FaultyShm && kind != ProviderKind::Device;
                         })),
                         nameOf);

}  // namespace
}  // namespace conformance
