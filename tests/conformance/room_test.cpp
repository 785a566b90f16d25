// This client has more to send than a queue holds.
#include <suture/rt/queue/mailbox.h>

#include "conformance/setup.h"
#include "support/patience.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;
using suture::kPatience;

/// Leaves out commands that run in the caller's thread, since they have room always.
class Room : public Conformance {
 protected:
  /// Holds the provider inside a handler, and fills the queue of hold().
  void fill() {
    stall();
    client->with([](Arm& remote) {
      for (std::uint32_t left = 4; left > 0; --left) {  // queue(4)
        EXPECT_EQ(remote.hold.room(), left);
        EXPECT_TRUE(remote.hold());
      }
      EXPECT_EQ(remote.hold.room(), 0u);
      EXPECT_EQ(remote.hold().error(), Errc::Full);
    });
  }
};

TEST_P(Room, IsWhatMayStillBeSent) {
  fill();
  client->with([](Arm& remote) {
    EXPECT_TRUE(remote.servo_cp(poseAt(1)));
    EXPECT_EQ(remote.servo_cp.room(), suture::rt::Mailbox::kUnlimited) << "the newest wins";
  });
  arm->gate().open();
  EXPECT_TRUE(suture::eventually([&] {
    std::uint32_t room = 0;
    client->with([&](Arm& remote) { room = remote.hold.room(); });
    return room == 4;
  }));
  disconnectArm();
  client->with([](Arm& remote) {
    EXPECT_EQ(remote.hold.room(), 0u);
    EXPECT_EQ(remote.hold.roomWithin(kPatience).error(), Errc::NotConnected);
  });
}

TEST_P(Room, IsAwaitedUntilTheLimit) {
  fill();
  client->with([this](Arm& remote) {
    EXPECT_EQ(remote.hold.roomWithin(20ms).error(), Errc::Timeout);
    arm->gate().open();
    const auto room = remote.hold.roomWithin(kPatience);
    ASSERT_TRUE(room) << suture::toString(room.error());
    EXPECT_GT(*room, 0u);
    EXPECT_TRUE(remote.hold());
  });
}

TEST_P(Room, AWaitingSenderIsNotRefused) {
  constexpr int kMany = 50;
  const suture::Time begin = suture::now();
  client->with([](Arm& remote) {
    for (int i = 0; i < kMany; ++i) {
      ASSERT_TRUE(remote.hold.roomWithin(kPatience));
      ASSERT_TRUE(remote.hold());
    }
  });
  EXPECT_TRUE(eventuallyTaken(std::vector<std::string>(kMany, "hold")));
  EXPECT_EQ(channel()->commands.counters.full, 0u);
  // A task that is not rung looks again after a second of a stepped clock.
  if (clock) {
    EXPECT_LT(suture::now() - begin, 1s);
  }
}

INSTANTIATE_TEST_SUITE_P(Lanes, Room, testing::ValuesIn(laneRows(isQueued)), nameOf);

}  // namespace
}  // namespace conformance
