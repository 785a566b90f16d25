// The ages of what a client has read belong to one connection.
#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/read_together.h>

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

TEST(ReadAge, CountsEachRowOnce) {
  ArmClient client;
  const auto channel = channelWithRow(now());
  client.arm.attach(channel);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(client.arm.measured_cp().hasValue());
  EXPECT_EQ(channel->client.readAge->count(), 1u);
}

TEST(ReadAge, CountsANewConnectionsEqualStamp) {
  ArmClient client;
  const Time stamp = now();
  client.arm.attach(channelWithRow(stamp));
  EXPECT_TRUE(client.arm.measured_cp().hasValue());
  const auto next = channelWithRow(stamp);
  client.arm.attach(next);
  EXPECT_TRUE(client.arm.measured_cp().hasValue());
  EXPECT_EQ(next->client.readAge->count(), 1u);
}

// Over shared memory, the bytes that a client receives are those that its reads copy.
TEST(ReadBytes, CountValuesThatAreReadTogether) {
  const InterfaceInfo& contract = interfaceInfo<reference::ArmLike>();
  const auto block = std::make_shared<MemoryBlock>("reads", Channel::bytesFor(contract));
  const auto channel = std::make_shared<Channel>(
      contract, Channel::Terms{.name = "client -> provider"}, "shm", reference::playedEnds(),
      makeStateTable(contract, rt::StateTable::Readers::Here), EventSet{0},
      Arena(block, Arena::Content::Zeros));
  channel->state->draft(0);
  channel->state->publish(now(), {.valid = 1});
  ArmClient client;
  client.arm.attach(channel);
  ASSERT_TRUE(client.arm.measured_cp().hasValue());
  const std::uint64_t ofOne = channel->bytesReceived;
  EXPECT_GT(ofOne, 0u);
  EXPECT_TRUE(readTogether(client.arm.measured_cp).hasValue());
  EXPECT_EQ(channel->bytesReceived, 2 * ofOne);
}

TEST(ReadTogether, GivesARepeatedValueTwice) {
  ArmClient client;
  const auto channel = reference::armChannel(reference::playedEnds(), "frame");
  reference::PoseStamped pose;
  pose.pose.translation().x() = 3;
  ASSERT_TRUE(
      store(pose, *reinterpret_cast<reference::PoseStampedSlot*>(channel->state->draft(0))));
  channel->state->publish(now(), {.valid = 1});
  client.arm.attach(channel);
  const auto both = readTogether(client.arm.measured_cp, client.arm.measured_cp);
  ASSERT_TRUE(both.hasValue());
  EXPECT_EQ(std::get<0>(*both).pose.translation().x(), 3);
  EXPECT_EQ(std::get<1>(*both).pose.translation().x(), 3);
}

TEST(ReadAge, ExceedsEveryLimitWithoutAValue) {
  ArmClient client;
  EXPECT_EQ(client.arm.measured_cp().age(), Duration::max());  // it was never connected
  client.arm.attach(channelWithRow(now()));
  EXPECT_LT(client.arm.measured_cp().age(), Duration::max());
}

}  // namespace
}  // namespace suture
