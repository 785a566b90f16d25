// Where the commands of a connection are, over all channels that it has had.

#include <gtest/gtest.h>
#include <suture/component/channel.h>
#include <suture/component/ledger.h>

#include <memory>

#include "reference/arm_like.suture.h"

namespace suture {
namespace {

constexpr std::uint64_t kRobot = 7, kNextRobot = 8;

std::shared_ptr<Channel> makeChannel() {
  static rt::Doorbell bell;
  const InterfaceInfo& info = interfaceInfo<reference::ArmLike>();
  return std::make_shared<Channel>(info, "a -> b", "frame", Channel::Ends{&bell, &bell},
                                   makeStateTable(info), EventSet{0});
}

void send(Channel& channel, std::uint64_t commands) { channel.commands.counters.sent += commands; }

/// Each command that was accepted is in one place.
void expectBalance(const Sums& sums) {
  EXPECT_EQ(sums.accepted, sums.tally.commands() + sums.lost + sums.unknown + sums.underWay);
}

class ClientsLedger : public testing::Test {
 protected:
  ~ClientsLedger() override { expectBalance(ledger_.sums()); }

  /// Of ten commands the client hears that six were executed and one came too late.
  std::shared_ptr<Channel> tenOfWhichThreeAreUnderWay() {
    auto channel = makeChannel();
    ledger_.begin(channel, kRobot);
    send(*channel, 10);
    channel->counts->told.store({.executed = 6, .late = 1});
    return channel;
  }

  Ledger ledger_{ChannelCounts::End::Client};
};

TEST_F(ClientsLedger, CommandsWithoutAnOutcomeAreUnderWay) {
  const auto channel = tenOfWhichThreeAreUnderWay();
  const Sums sums = ledger_.sums();
  EXPECT_EQ(sums.accepted, 10u);
  EXPECT_EQ(sums.underWay, 3u);
  EXPECT_EQ(sums.heard.executed, 6u);
  EXPECT_EQ(sums.unknown + sums.lost, 0u);
}

TEST_F(ClientsLedger, WhatWasUnderWayIsUnknownWhenTheConnectionIsLost) {
  const auto channel = tenOfWhichThreeAreUnderWay();
  channel->status = ChannelStatus::Lost;
  EXPECT_EQ(ledger_.sums().unknown, 3u);
  EXPECT_EQ(ledger_.sums().underWay, 0u);
}

TEST_F(ClientsLedger, ALostChannelTakesNothingWithIt) {
  tenOfWhichThreeAreUnderWay();
  const Sums sums = ledger_.sums();
  EXPECT_EQ(sums.accepted, 10u);
  EXPECT_EQ(sums.tally.executed, 6u);
  EXPECT_EQ(sums.unknown, 3u);
}

TEST_F(ClientsLedger, TheSameProcessBackMakesTheUnknownExact) {
  tenOfWhichThreeAreUnderWay();
  const auto next = makeChannel();
  ledger_.begin(next, kRobot, {{.executed = 7, .late = 1}, false});
  send(*next, 5);
  next->counts->told.store({.executed = 4});
  Sums sums = ledger_.sums();
  EXPECT_EQ(sums.tally.executed, 11u);
  EXPECT_EQ(sums.unknown, 2u) << "something of the first channel may still be executed";
  EXPECT_EQ(sums.underWay, 1u);
  expectBalance(sums);

  ledger_.tell({{.executed = 8, .late = 1}, true});
  sums = ledger_.sums();
  EXPECT_EQ(sums.tally.executed, 12u);
  EXPECT_EQ(sums.unknown, 0u);
  EXPECT_EQ(sums.lost, 1u);
}

TEST_F(ClientsLedger, WhatAProcessThatIsGoneMayHaveExecutedStaysUnknown) {
  tenOfWhichThreeAreUnderWay();
  const auto next = makeChannel();
  ledger_.begin(next, kNextRobot, {{}, true});
  const Sums sums = ledger_.sums();
  EXPECT_EQ(sums.tally.executed, 6u);
  EXPECT_EQ(sums.unknown, 3u);
  EXPECT_EQ(sums.heard, Tally{}) << "this process has told nothing yet";
  EXPECT_EQ(sums.otherProcess, kNextRobot);
}

TEST_F(ClientsLedger, WhatWasLostStaysLostWhenTheProcessIsGone) {
  tenOfWhichThreeAreUnderWay();
  ledger_.begin(makeChannel(), kRobot, {{.executed = 8, .late = 1}, true});
  ledger_.begin(makeChannel(), kNextRobot, {{}, true});
  const Sums sums = ledger_.sums();
  EXPECT_EQ(sums.tally.executed, 8u);
  EXPECT_EQ(sums.lost, 1u);
  EXPECT_EQ(sums.unknown, 0u);
}

TEST_F(ClientsLedger, WhatWasLostStaysLostWhileTheLastWordOnMoreIsAwaited) {
  tenOfWhichThreeAreUnderWay();
  const auto next = makeChannel();
  ledger_.begin(next, kRobot, {{.executed = 8, .late = 1}, true});
  send(*next, 4);
  ledger_.begin(makeChannel(), kRobot, {{.executed = 10, .late = 1}, false});
  EXPECT_EQ(ledger_.sums().lost, 1u);
  EXPECT_EQ(ledger_.sums().unknown, 2u);
  ledger_.tell({{.executed = 11, .late = 1}, true});
  EXPECT_EQ(ledger_.sums().lost, 2u);
  EXPECT_EQ(ledger_.sums().unknown, 0u);
}

TEST_F(ClientsLedger, ALaneSaysWhatItHasLost) {
  const auto channel = tenOfWhichThreeAreUnderWay();
  channel->counts->lost = 2;
  EXPECT_EQ(ledger_.sums().lost, 2u);
  EXPECT_EQ(ledger_.sums().underWay, 1u);
}

TEST(ProvidersLedger, TellsOfTheChannelsBeforeWhenNobodyHasThemAnyMore) {
  Ledger ledger(ChannelCounts::End::Provider);
  auto first = makeChannel();
  ledger.begin(first, kRobot);
  send(*first, 3);
  first->commands.counters.executed = 1;
  const auto second = makeChannel();
  ledger.begin(second, kRobot);
  EXPECT_EQ(ledger.before(*second).tally.executed, 1u);
  EXPECT_FALSE(ledger.before(*second).ended) << "a thread may be at one of its commands";
  EXPECT_EQ(ledger.sums().underWay, 2u);

  first->commands.counters.executed = 2;
  first = nullptr;
  EXPECT_EQ(ledger.before(*second).tally.executed, 2u);
  EXPECT_TRUE(ledger.before(*second).ended);
  EXPECT_EQ(ledger.sums().lost, 1u);
  expectBalance(ledger.sums());
}

TEST(ProvidersLedger, CountsWhatItsLaneTurnedAway) {
  Ledger ledger(ChannelCounts::End::Provider);
  const auto channel = makeChannel();
  ledger.begin(channel, kRobot);
  send(*channel, 2);
  channel->commands.counters.executed = 2;
  channel->counts->turnedAway = 3;
  EXPECT_EQ(ledger.sums().accepted, 5u);
  EXPECT_EQ(ledger.sums().tally.refused, 3u);
  expectBalance(ledger.sums());
}

}  // namespace
}  // namespace suture
