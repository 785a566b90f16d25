// The ages of what a client has read belong to one connection.
#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>

#include "reference/played_channel.h"
#include "unit/component/arm_client.h"

namespace suture {
namespace {

/// Returns a connection whose provider has published one row.
std::shared_ptr<Channel> channelWithRow(Time stamp) {
  auto channel = reference::armChannel(reference::playedEnds(), "frame");
  channel->state->draft(0);
  channel->state->publish(stamp, {.valid = 1});
  return channel;
}

TEST(ReadAge, IsOfARowWhenItIsFirstRead) {
  ArmClient client;
  const auto channel = channelWithRow(now());
  client.arm.attach(channel);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(client.arm.measured_cp().hasValue());
  EXPECT_EQ(channel->client.readAge->count(), 1u);
}

TEST(ReadAge, BeginsWithTheFirstRowOfAConnection) {
  ArmClient client;
  const Time stamp = now();
  client.arm.attach(channelWithRow(stamp));
  EXPECT_TRUE(client.arm.measured_cp().hasValue());
  const auto next = channelWithRow(stamp);
  client.arm.attach(next);
  EXPECT_TRUE(client.arm.measured_cp().hasValue());
  EXPECT_EQ(next->client.readAge->count(), 1u);
}

TEST(ReadAge, IsTooGreatForAnyLimitWithoutAValue) {
  ArmClient client;
  EXPECT_EQ(client.arm.measured_cp().age(), Duration::max());  // it was never connected
  client.arm.attach(channelWithRow(now()));
  EXPECT_LT(client.arm.measured_cp().age(), Duration::max());
}

}  // namespace
}  // namespace suture
