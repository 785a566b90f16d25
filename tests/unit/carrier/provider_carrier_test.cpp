#include <gtest/gtest.h>
#include <suture/lane/carrier/provider_carrier.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "reference/arm_numbers.h"
#include "reference/played_channel.h"

namespace suture {
namespace {

using reference::kHold;
using reference::kLimit;
using reference::kMode;
using reference::kModeOnly;
using reference::kReset;
using reference::kServo;
using reference::kStopped;
using reference::kStoppedOnly;
using Message = ProviderCarrier::Message;
using Credits = std::vector<std::pair<std::uint16_t, std::uint32_t>>;

class Provider : public testing::Test, protected ProviderCarrier::Wire {
 protected:
  Provider() { channel_->ends.provider->takeRing(); }

  bool hasRoom(Message message) const override { return message != full_; }
  void send(const ReplyRecord& reply) override {
    replies_.push_back(reply.call);
    carrier_.replySent();
  }
  void sendCredits(std::uint16_t command, std::uint32_t count) override {
    credits_.emplace_back(command, count);
  }
  void send(const Tally& tally) override { tallies_.push_back(tally); }
  void send(const rt::EventRecord& event, std::uint32_t subscription) override {
    events_.emplace_back(event.event, subscription);
    carrier_.eventSent();
  }
  bool sendRow(rt::ColumnSet columns, std::uint64_t& last) override {
    rows_.emplace_back(columns, last);
    last = channel_->state->rows();
    return false;
  }

  Errc post(std::uint16_t command, std::uint32_t call = 0) {
    return carrier_.post(command, now(), call, [](std::byte*) { return Errc{}; }).error;
  }
  /// The provider takes one command.
  void take(std::uint16_t command) {
    channel_->commands.fixCut();
    ASSERT_NE(channel_->commands.next(), nullptr);
    channel_->commands.pop();
    channel_->commands.returnCredit(command);
  }

  const std::shared_ptr<Channel> channel_ = reference::armChannel(reference::playedEnds(), "far");
  // The client's first command is not known here, and its second is hold().
  ProviderCarrier carrier_{*channel_, *this, {ProviderCarrier::kUnknown, kHold}};
  std::optional<Message> full_;
  std::vector<std::uint32_t> replies_;
  Credits credits_, events_;
  std::vector<Tally> tallies_;
  std::vector<std::pair<rt::ColumnSet, std::uint64_t>> rows_;
};

TEST_F(Provider, ReturnsACreditForATakenCommand) {
  carrier_.lend(1);
  EXPECT_EQ(post(kHold), Errc{});
  carrier_.give();
  EXPECT_TRUE(credits_.empty());
  take(kHold);
  full_ = Message::Credits;
  carrier_.give();
  EXPECT_TRUE(credits_.empty());
  full_.reset();
  carrier_.give();
  carrier_.give();
  EXPECT_EQ(credits_, (Credits{{1, 1}}));
}

TEST_F(Provider, ReturnsAnUnknownCommandsCreditAtOnce) {
  EXPECT_EQ(carrier_.commandAt(0), ProviderCarrier::kUnknown);
  EXPECT_EQ(carrier_.commandAt(2), ProviderCarrier::kUnknown) << "the client has two";
  carrier_.lend(0);
  carrier_.give();
  EXPECT_EQ(credits_, (Credits{{0, 1}}));
}

TEST_F(Provider, RefusesCommandsWhileItIsSuspended) {
  channel_->tell(ChannelStatus::Suspended);
  EXPECT_EQ(post(kHold), Errc::Suspended);
  EXPECT_FALSE(channel_->commands.pending());
}

TEST_F(Provider, RefusesCommandsOfAReadOnlyClient) {
  carrier_.setReadOnly();
  EXPECT_EQ(post(kHold), Errc::NotPermitted);
  EXPECT_EQ(post(6, 1), Errc{}) << "distance() reads";
}

TEST_F(Provider, PutsNothingInThatCannotBeDecoded) {
  const auto fail = [](std::byte*) { return Errc::TooLarge; };
  EXPECT_EQ(carrier_.post(kLimit, now(), 0, fail).error, Errc::TooLarge);
  EXPECT_FALSE(channel_->commands.pending());
  EXPECT_EQ(post(kHold), Errc{}) << "its place is free again";
}

TEST_F(Provider, IsRungOnceForManyArrivals) {
  carrier_.ringProvider();
  EXPECT_EQ(channel_->ends.provider->takeRing(), rt::RungFor::Nothing);
  EXPECT_EQ(post(kHold), Errc{});
  carrier_.ringProvider();
  EXPECT_EQ(channel_->ends.provider->takeRing(), rt::RungFor::Work);
  carrier_.ringProvider();
  EXPECT_EQ(channel_->ends.provider->takeRing(), rt::RungFor::Nothing);
}

TEST_F(Provider, SendsEventsToAQuietClient) {
  channel_->events.push(kStopped, now() - std::chrono::seconds(1), {});
  carrier_.give();
  EXPECT_EQ(events_, (Credits{{kStopped, 0}}));
}

TEST_F(Provider, SendsNoEventFromBeforeTheSubscription) {
  const reference::Mode mode{};
  const auto payload = std::as_bytes(std::span(&mode, 1));
  const Time before = now() - std::chrono::seconds(1);
  channel_->events.push(kStopped, before, {});
  channel_->events.push(kMode, before, payload);
  carrier_.subscribe({.number = 4,
                      .events = kModeOnly | kStoppedOnly,
                      .joining = kModeOnly | kStoppedOnly,
                      .columns = 0});
  channel_->events.push(kMode, before, payload);  // the replay
  channel_->events.push(kStopped, now(), {});
  carrier_.give();
  EXPECT_EQ(events_, (Credits{{kMode, 4}, {kStopped, 4}}));
}

TEST_F(Provider, DropsUnwantedEvents) {
  channel_->provider.takeJoining();
  channel_->events.push(kStopped, now(), {});
  carrier_.subscribe({.number = 1, .events = kModeOnly, .joining = kStoppedOnly, .columns = 0});
  EXPECT_FALSE(channel_->provider.joining()) << "who joins an event also wants it";
  carrier_.give();
  EXPECT_TRUE(events_.empty());
  EXPECT_EQ(channel_->events.next(), nullptr);
}

TEST_F(Provider, OffersOnlyExistingColumns) {
  carrier_.give();
  EXPECT_TRUE(rows_.empty()) << "nobody has asked";
  carrier_.subscribe({.number = 1, .events = 0, .joining = 0, .columns = ~rt::ColumnSet{0}});
  carrier_.give();
  ASSERT_EQ(rows_.size(), 1u);
  EXPECT_EQ(rows_[0].first, rt::ColumnSet{3});
  full_ = Message::Row;
  carrier_.give();
  EXPECT_EQ(rows_.size(), 1u);
}

TEST_F(Provider, TellsATallyWhenItHasChanged) {
  carrier_.give();
  EXPECT_TRUE(tallies_.empty());
  carrier_.countRefused();
  full_ = Message::Tally;
  carrier_.give();
  EXPECT_TRUE(tallies_.empty());
  full_.reset();
  carrier_.give();
  carrier_.give();
  ASSERT_EQ(tallies_.size(), 1u);
  EXPECT_EQ(tallies_[0].refused, 1u);
}

TEST_F(Provider, KeepsAnswersThatHaveNoRoom) {
  channel_->provider.replyError(1, Errc::Late);
  channel_->provider.replyError(2, Errc::Late);
  full_ = Message::Reply;
  carrier_.give();
  EXPECT_TRUE(replies_.empty());
  full_.reset();
  carrier_.give();
  EXPECT_EQ(replies_, (std::vector<std::uint32_t>{1, 2}));
}

}  // namespace
}  // namespace suture
