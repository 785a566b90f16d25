// A delay judges what its far channel brings, since the provider's end of it may be foreign.
#include <gtest/gtest.h>
#include <suture/lane/delay/delayed_connection.h>

#include <cstring>
#include <limits>
#include <memory>

#include "reference/arm_numbers.h"
#include "reference/played_channel.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

using reference::kHold;
using reference::kMode;
using reference::kModeOnly;
using reference::kReset;
using reference::kServo;
using reference::kStopped;

constexpr std::uint16_t kMoved = 3;

/// A FarChannel is a delayed connection both of whose ends the test plays.
struct FarChannel : testing::Test {
  /// Takes what there is.
  void turn() { connection.pump(now()); }
  /// Lets everything that is under way arrive.
  void arrive() {
    turn();
    connection.pump(now() + 1s);
  }

  void send(std::uint16_t command, std::uint32_t call) {
    ASSERT_TRUE(near->commands.claim(command, now(), call));
    near->commands.commit();
    arrive();
  }
  /// Lets the provider answer call 1 of reset() with so many bytes.
  Errc answer(std::uint32_t size) {
    send(kReset, 1);
    far->provider.reply(1, {.size = size, .command = kReset}, [size](std::byte* result) {
      std::memset(result, 1, size);
      return Errc{};
    });
    turn();
    arrive();
    const ReplyRecord* const reply = near->client.nextReply();
    return reply == nullptr ? Errc::Timeout : reply->error;
  }
  void emitMode() {
    const reference::Mode mode{};
    far->events.push(kMode, now(), std::as_bytes(std::span(&mode, 1)));
    turn();
  }

  const std::shared_ptr<Channel> near = reference::armChannel(reference::playedEnds(), "near"),
                                 far = reference::armChannel(reference::playedEnds(), "far");
  DelayedConnection connection{near, far, {.answers = 10ms}};
};

TEST_F(FarChannel, AnAnswerOfTheRightSizeArrives) {
  EXPECT_EQ(answer(sizeof(std::uint32_t)), Errc{});
  std::uint32_t result = 0;
  std::memcpy(&result, near->client.nextReply()->result(), sizeof(result));
  EXPECT_EQ(result, 0x01010101u);
}

TEST_F(FarChannel, ATooShortAnswerIsInvalid) { EXPECT_EQ(answer(0), Errc::Invalid); }

TEST_F(FarChannel, ATooLongAnswerIsCut) {
  EXPECT_EQ(answer(4096), Errc{});
  EXPECT_EQ(near->replies.frontSize(), sizeof(ReplyRecord) + sizeof(std::uint32_t));
}

TEST_F(FarChannel, AnAnswerToNoCallIsDropped) {
  far->provider.replyError(7, Errc::Late);
  turn();
  arrive();
  EXPECT_EQ(near->client.nextReply(), nullptr);
}

TEST_F(FarChannel, AnEarlierSubscriptionsEventIsDropped) {
  turn();
  emitMode();
  near->client.subscribe(kModeOnly, kModeOnly);  // the client has left it, and joins it again
  turn();
  arrive();
  EXPECT_EQ(near->events.next(), nullptr);
  emitMode();
  arrive();
  EXPECT_NE(near->events.next(), nullptr);
}

TEST_F(FarChannel, AnInvalidEventIsDroppedAndCounted) {
  turn();
  const EventInfo& moved = near->info.events[kMoved];
  std::vector<std::byte> payload(moved.payloadSize, std::byte{0xff});  // each number is a NaN
  far->events.push(kMoved, now(), payload);
  turn();
  arrive();
  EXPECT_EQ(near->events.next(), nullptr);
  EXPECT_EQ(near->events.dropped(), 1u);
  EXPECT_EQ(near->lastInvalid.read().text().rfind("moved", 0), 0u);
}

TEST_F(FarChannel, ACommandWithoutRoomIsAnswered) {
  far->tell(ChannelStatus::Suspended);
  send(kHold, 3);
  EXPECT_EQ(far->commands.pending(), false);
  ASSERT_NE(near->client.nextReply(), nullptr);
  EXPECT_EQ(near->client.nextReply()->error, Errc::Suspended);
  EXPECT_EQ(near->commands.waiting(kHold), 0u);
  EXPECT_EQ(near->counts->own(ConnectionEnd::Client).refused, 1u);
  EXPECT_EQ(near->counts->told.load().refused, 0u) << "the provider has not seen it";
}

TEST_F(FarChannel, ATakenCommandGivesItsCreditBack) {
  send(kHold, 0);
  EXPECT_EQ(near->commands.waiting(kHold), 1u);
  far->commands.fixCut();
  ASSERT_NE(far->commands.next(), nullptr);
  far->commands.pop();
  far->commands.returnCredit(kHold);
  turn();
  EXPECT_EQ(near->commands.waiting(kHold), 0u);
}

// Its provider may be beyond another lane, whose thread rings the client that gets credits.
TEST_F(FarChannel, CreditsRingAWaiterForRows) {
  near->client.askForRows();
  send(kHold, 0);
  near->ends.client->takeRing();
  far->commands.fixCut();
  ASSERT_NE(far->commands.next(), nullptr);
  far->commands.pop();
  far->commands.returnCredit(kHold);
  turn();
  EXPECT_EQ(near->ends.client->takeRing(), rt::RungFor::Work);
}

TEST_F(FarChannel, TheProviderIsRungForACommand) {
  far->ends.provider->takeRing();
  send(kHold, 0);
  EXPECT_EQ(far->ends.provider->takeRing(), rt::RungFor::Work);
}

// The far channel is attached to its provider before a delay stands between.
TEST_F(FarChannel, AnEventFromBeforeTheDelayArrives) {
  const auto earlier = reference::armChannel(reference::playedEnds(), "far");
  earlier->events.push(kStopped, now() - 1s, {});
  DelayedConnection late(near, earlier, {.answers = 10ms});
  late.pump(now());
  late.pump(now() + 1s);
  EXPECT_NE(near->events.next(), nullptr);
}

TEST_F(FarChannel, ACommandAfterTheEndIsLost) {
  far->tell(ChannelStatus::Lost);
  send(kHold, 3);
  ASSERT_NE(near->client.nextReply(), nullptr);
  EXPECT_EQ(near->client.nextReply()->error, Errc::Lost);
  EXPECT_EQ(near->commands.waiting(kHold), 0u);
  EXPECT_EQ(near->counts->lost.load(), 1u);
  EXPECT_EQ(near->counts->own(ConnectionEnd::Client).refused, 0u);
}

/// The delay has taken as many commands as it has room for, and there is one more.
struct FullLine : FarChannel {
  FullLine() {
    for (unsigned i = 0; i < 2 * kMost; ++i) {
      if (!near->commands.claim(kServo, now(), 0)) break;
      near->commands.commit();
      slow.pump(now());
    }
  }

  static constexpr unsigned kMost = 4096;
  const std::shared_ptr<Channel> provider =
      reference::armChannel(reference::playedEnds(), "provider");
  DelayedConnection slow{near, provider, {.commands = 1h}};
};

TEST_F(FullLine, KeepsTheNewestCommandWithTheClient) {
  EXPECT_TRUE(near->commands.pending());
  EXPECT_FALSE(provider->commands.pending());
}

TEST_F(FullLine, IsReadAgainOnceThereIsRoom) {
  slow.pump(now() + 2h);
  EXPECT_TRUE(provider->commands.pending());
  EXPECT_FALSE(near->commands.pending());
}

TEST_F(FullLine, LetsASubscriptionPass) {
  near->client.subscribe(kModeOnly, kModeOnly);
  slow.pump(now());
  EXPECT_EQ(provider->subscribed(), kModeOnly);
}

}  // namespace
}  // namespace suture
