// Commands that run in the caller's thread are counted like those that run in the provider's.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/channel/counts/ledger.h>
#include <suture/wiring/connect.h>

#include <memory>
#include <stdexcept>

#include "reference/still_arm.h"
#include "unit/component/arm_client.h"

namespace suture {
namespace {

/// A CalledArm is a device, so its commands and direct events run in the thread that calls and
/// emits.
struct CalledArm final : Device, StillArm {
  std::uint32_t reset() override { throw std::runtime_error("no power"); }
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

class CountedHere : public testing::Test {
 protected:
  Sums sums() const {
    Ledger ledger(ConnectionEnd::Both);
    ledger.begin(channel_, 0);
    return ledger.sums();
  }

  CalledArm arm_;
  ArmClient client_;
  const std::shared_ptr<Channel> channel_ = connectLocally(client_.arm, arm_.port, "test");
};

TEST_F(CountedHere, CommandsAreExecutedOrFail) {
  EXPECT_TRUE(client_.arm.hold());
  EXPECT_TRUE(client_.arm.hold.start().within());
  EXPECT_TRUE(client_.arm.distance.start({}).within());
  EXPECT_EQ(client_.arm.reset.start().within().error(), Errc::Faulted);
  const Sums counted = sums();
  EXPECT_EQ(counted.accepted, 4u);
  EXPECT_EQ(counted.tally.executed, 3u);
  EXPECT_EQ(counted.tally.failed, 1u);
  EXPECT_EQ(counted.underWay, 0u);
}

TEST_F(CountedHere, EventsAreDelivered) {
  ASSERT_TRUE(client_.arm.on().stopped.direct([] {}));
  client_.arm.adopt();
  EXPECT_TRUE(arm_.port.emit().stopped());
  EXPECT_TRUE(arm_.port.emit().stopped());
  EXPECT_EQ(sums().eventsDelivered, 2u);
}

}  // namespace
}  // namespace suture
