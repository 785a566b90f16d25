#include <gtest/gtest.h>
#include <suture/lane/carrier/client_carrier.h>

#include <memory>
#include <vector>

#include "reference/arm_numbers.h"
#include "reference/played_channel.h"

namespace suture {
namespace {

using reference::kHold;
using reference::kModeOnly;
using reference::kReset;
using reference::kServo;

class Client : public testing::Test, protected ClientCarrier::Wire {
 protected:
  bool hasRoom(ClientCarrier::Message message) const override {
    return message == ClientCarrier::Message::Interest || room_ > 0;
  }
  void send(const Interest& interest) override { interests_.push_back(interest); }
  void send(const rt::CommandRecord& command) override {
    --room_;
    commands_.push_back(command.command);
    carrier_.commandSent();
  }

  void put(std::uint16_t command, std::uint32_t call = 0) {
    ASSERT_TRUE(channel_->commands.claim(command, now(), call));
    channel_->commands.commit();
  }

  const std::shared_ptr<Channel> channel_ = reference::armChannel(reference::playedEnds(), "near");
  ClientCarrier carrier_{*channel_, *this};
  int room_ = 100;
  std::vector<Interest> interests_;
  std::vector<std::uint16_t> commands_;
};

TEST_F(Client, TellsItsInterestOnceUntilThatChanges) {
  carrier_.give();
  carrier_.give();
  ASSERT_EQ(interests_.size(), 1u);
  EXPECT_EQ(interests_[0].number, 1u);
  EXPECT_EQ(interests_[0].joining, 0u) << "the provider's channel was made with these events";
  channel_->state->ask(1);
  channel_->client.subscribe(kModeOnly, kModeOnly);
  carrier_.give();
  ASSERT_EQ(interests_.size(), 2u);
  EXPECT_EQ(interests_[1].events, kModeOnly);
  EXPECT_EQ(interests_[1].joining, kModeOnly);
  EXPECT_EQ(interests_[1].columns, rt::ColumnSet{2});
}

TEST_F(Client, TellsItsInterestWithoutRoomForCommands) {
  room_ = 0;
  put(kHold);
  carrier_.give();
  EXPECT_EQ(interests_.size(), 1u);
  EXPECT_TRUE(commands_.empty());
}

TEST_F(Client, SendsInOrderWhatHadNoRoom) {
  room_ = 1;
  put(kHold);
  put(kServo);
  put(kHold);
  carrier_.give();
  EXPECT_EQ(commands_, std::vector<std::uint16_t>{kHold});
  room_ = 100;
  carrier_.give();
  EXPECT_EQ(commands_, (std::vector<std::uint16_t>{kHold, kServo, kHold}));
}

TEST_F(Client, GetsBackOnlyTheUsedCredits) {
  put(kHold);
  put(kServo);  // which uses none
  EXPECT_FALSE(carrier_.credits(kHold, 1)) << "it has not been sent";
  carrier_.give();
  EXPECT_FALSE(carrier_.credits(kHold, 2));
  EXPECT_TRUE(carrier_.credits(kHold, 1));
  EXPECT_FALSE(carrier_.credits(kHold, 1));
  EXPECT_FALSE(carrier_.credits(kServo, 1));
  EXPECT_FALSE(carrier_.credits(0xffff, 0)) << "there is no such command";
  EXPECT_EQ(channel_->commands.waiting(kHold), 0u);
}

TEST_F(Client, TakesOneAnswerToACall) {
  put(kReset, 1);
  EXPECT_FALSE(carrier_.commandOf(1)) << "it has not been sent";
  carrier_.give();
  EXPECT_EQ(carrier_.commandOf(1), kReset);
  const std::uint32_t result = 7;
  carrier_.reply(1, now(), Errc{}, std::as_bytes(std::span(&result, 1)));
  carrier_.replyError(1, Errc::Late);
  carrier_.replyError(17, Errc::Late);  // which would have its place
  ASSERT_NE(channel_->client.nextReply(), nullptr);
  EXPECT_EQ(channel_->client.nextReply()->error, Errc{});
  EXPECT_EQ(channel_->client.nextReply()->command, kReset);
  channel_->client.popReply();
  EXPECT_EQ(channel_->client.nextReply(), nullptr);
}

TEST_F(Client, SendsNoCommandThatIsCancelled) {
  put(kReset, 1);
  ASSERT_TRUE(channel_->client.cancel(1));
  carrier_.give();
  EXPECT_TRUE(commands_.empty());
  ASSERT_NE(channel_->client.nextReply(), nullptr);
  EXPECT_EQ(channel_->client.nextReply()->error, Errc::Cancelled);
  EXPECT_EQ(channel_->commands.waiting(kReset), 0u);
}

TEST_F(Client, PublishesTheRequestedRow) {
  channel_->state->ask(0);
  carrier_.give();
  rt::RowColumns columns;
  columns.valid = 3;
  carrier_.row(now(), columns);
  EXPECT_EQ(channel_->state->readRow({}).valid, rt::ColumnSet{1});
  columns.valid = 2;
  carrier_.row(now(), columns);
  EXPECT_EQ(channel_->state->rows(), 1u) << "nobody asked for any of it";
}

// Its provider may be beyond another lane, whose thread carries on what comes here.
TEST_F(Client, RingsALaneForItsUpdates) {
  const auto rung = [this] {
    carrier_.ringClient();
    return channel_->ends.client->takeRing();
  };
  put(kHold);
  carrier_.give();
  rung();
  carrier_.tally({});
  EXPECT_EQ(rung(), rt::RungFor::Nothing) << "a component looks by itself";
  channel_->client.askForRows();
  carrier_.tally({});
  EXPECT_EQ(rung(), rt::RungFor::Work);
  EXPECT_TRUE(carrier_.credits(kHold, 1));
  EXPECT_EQ(rung(), rt::RungFor::Work);
}

TEST_F(Client, RingsAFullClientOnce) {
  const auto rung = [this] {
    carrier_.ringClient();
    return channel_->ends.client->takeRing();
  };
  for (int i = 0; i < 4; ++i) put(kHold);  // queue(4)
  carrier_.give();
  EXPECT_TRUE(carrier_.credits(kHold, 1));
  EXPECT_EQ(rung(), rt::RungFor::Nothing) << "it has not asked";
  put(kHold);
  EXPECT_EQ(channel_->commands.room(kHold), 0u);
  carrier_.give();
  EXPECT_TRUE(carrier_.credits(kHold, 1));
  EXPECT_EQ(rung(), rt::RungFor::Work);
  EXPECT_TRUE(carrier_.credits(kHold, 1));
  EXPECT_EQ(rung(), rt::RungFor::Nothing) << "it has not asked again";
}

TEST_F(Client, RingsAClientAfterACancelledCall) {
  for (std::uint32_t call = 1; call <= 4; ++call) put(kHold, call);
  EXPECT_EQ(channel_->commands.room(kHold), 0u);
  ASSERT_TRUE(channel_->client.cancel(1));
  channel_->ends.client->takeRing();
  carrier_.give();
  EXPECT_EQ(channel_->ends.client->takeRing(), rt::RungFor::Work);
}

}  // namespace
}  // namespace suture
