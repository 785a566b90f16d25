// The ledger knows where the commands of a connection are, over all channels that it has had.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/channel/counts/ledger.h>

#include <memory>

#include "reference/played_channel.h"

namespace suture {
namespace {

constexpr std::uint64_t kRobot = 7, kNextRobot = 8;

std::shared_ptr<Channel> makeChannel() {
  return reference::armChannel(reference::playedEnds(), "frame", EventSet{0});
}

void send(Channel& channel, std::uint64_t commands) { channel.commands.counters.sent += commands; }

/// Expects each command that was accepted in one place.
void expectBalance(const Sums& sums) {
  EXPECT_EQ(sums.accepted, sums.tally.commands() + sums.lost + sums.unknown + sums.underWay);
}

/// Counts commands without an outcome.
struct Open {
  std::uint64_t lost = 0, unknown = 0, underWay = 0;
};
void expectOpen(const Sums& sums, const Open& open) {
  EXPECT_EQ(sums.lost, open.lost);
  EXPECT_EQ(sums.unknown, open.unknown);
  EXPECT_EQ(sums.underWay, open.underWay);
  expectBalance(sums);
}

class ClientsLedger : public testing::Test {
 protected:
  ~ClientsLedger() override { expectBalance(ledger_.sums()); }

  /// Makes a channel whose client hears of ten commands that six were executed and one came too
  /// late.
  std::shared_ptr<Channel> tenOfWhichThreeAreUnderWay() {
    auto channel = makeChannel();
    ledger_.begin(channel, kRobot);
    send(*channel, 10);
    channel->counts->told.store({.executed = 6, .late = 1});
    return channel;
  }

  Ledger ledger_{ConnectionEnd::Client};
};

TEST_F(ClientsLedger, CommandsWithoutAnOutcomeAreUnderWay) {
  const auto channel = tenOfWhichThreeAreUnderWay();
  const Sums sums = ledger_.sums();
  EXPECT_EQ(sums.accepted, 10u);
  EXPECT_EQ(sums.heard.executed, 6u);
  expectOpen(sums, {.underWay = 3});
}

TEST_F(ClientsLedger, ALossMakesCommandsUnderWayUnknown) {
  const auto channel = tenOfWhichThreeAreUnderWay();
  channel->status = ChannelStatus::Lost;
  expectOpen(ledger_.sums(), {.unknown = 3});
}

TEST_F(ClientsLedger, KeepsTheSumsOfALostChannel) {
  tenOfWhichThreeAreUnderWay();
  EXPECT_EQ(ledger_.sums().accepted, 10u);
  EXPECT_EQ(ledger_.sums().tally.executed, 6u);
  expectOpen(ledger_.sums(), {.unknown = 3});
}

TEST_F(ClientsLedger, LearnsWhatBecameOfUnknownCommands) {
  tenOfWhichThreeAreUnderWay();
  const auto next = makeChannel();
  ledger_.begin(next, kRobot, {{.executed = 7, .late = 1}, false});
  send(*next, 5);
  next->counts->told.store({.executed = 4});
  EXPECT_EQ(ledger_.sums().tally.executed, 11u);
  // The provider may still execute commands of the first channel.
  expectOpen(ledger_.sums(), {.unknown = 2, .underWay = 1});

  ledger_.tell({{.executed = 8, .late = 1}, true});
  EXPECT_EQ(ledger_.sums().tally.executed, 12u);
  expectOpen(ledger_.sums(), {.lost = 1, .underWay = 1});
}

TEST_F(ClientsLedger, CommandsOfAGoneProcessStayUnknown) {
  tenOfWhichThreeAreUnderWay();
  const auto next = makeChannel();
  ledger_.begin(next, kNextRobot, {{}, true});
  const Sums sums = ledger_.sums();
  EXPECT_EQ(sums.tally.executed, 6u);
  EXPECT_EQ(sums.heard, Tally{}) << "this process has told nothing yet";
  EXPECT_EQ(sums.otherProcess, kNextRobot);
  expectOpen(sums, {.unknown = 3});
}

TEST_F(ClientsLedger, LostCommandsStayLostWithoutTheirProcess) {
  tenOfWhichThreeAreUnderWay();
  ledger_.begin(makeChannel(), kRobot, {{.executed = 8, .late = 1}, true});
  ledger_.begin(makeChannel(), kNextRobot, {{}, true});
  EXPECT_EQ(ledger_.sums().tally.executed, 8u);
  expectOpen(ledger_.sums(), {.lost = 1});
}

TEST_F(ClientsLedger, LostCommandsStayLost) {
  tenOfWhichThreeAreUnderWay();
  const auto next = makeChannel();
  ledger_.begin(next, kRobot, {{.executed = 8, .late = 1}, true});
  send(*next, 4);
  ledger_.begin(makeChannel(), kRobot, {{.executed = 10, .late = 1}, false});
  expectOpen(ledger_.sums(), {.lost = 1, .unknown = 2});
  ledger_.tell({{.executed = 11, .late = 1}, true});
  expectOpen(ledger_.sums(), {.lost = 2});
}

TEST_F(ClientsLedger, ALaneSaysWhatItHasLost) {
  const auto channel = tenOfWhichThreeAreUnderWay();
  channel->counts->lost = 2;
  expectOpen(ledger_.sums(), {.lost = 2, .underWay = 1});
}

TEST(ProvidersLedger, KeepsTheCountsOfClosedChannels) {
  Ledger ledger(ConnectionEnd::Provider);
  auto first = makeChannel();
  ledger.begin(first, kRobot);
  send(*first, 3);
  first->commands.counters.executed = 1;
  const auto second = makeChannel();
  ledger.begin(second, kRobot);
  EXPECT_EQ(ledger.before(*second).tally.executed, 1u);
  EXPECT_FALSE(ledger.before(*second).ended) << "a thread may be at one of its commands";
  expectOpen(ledger.sums(), {.underWay = 2});

  first->commands.counters.executed = 2;
  first = nullptr;
  EXPECT_EQ(ledger.before(*second).tally.executed, 2u);
  EXPECT_TRUE(ledger.before(*second).ended);
  expectOpen(ledger.sums(), {.lost = 1});
}

TEST(ProvidersLedger, NeverSaysEndedIfHistoryIsForgotten) {
  Ledger ledger(ConnectionEnd::Provider, Ledger::History::Forgotten);
  const auto channel = makeChannel();
  ledger.begin(channel, kRobot);
  EXPECT_FALSE(ledger.before(*channel).ended);
}

TEST(ProvidersLedger, CountsWhatItsLaneTurnedAway) {
  Ledger ledger(ConnectionEnd::Provider);
  const auto channel = makeChannel();
  ledger.begin(channel, kRobot);
  send(*channel, 2);
  channel->commands.counters.executed = 2;
  channel->counts->turnedAway = 3;
  EXPECT_EQ(ledger.sums().accepted, 5u);
  EXPECT_EQ(ledger.sums().tally.refused, 3u);
  expectOpen(ledger.sums(), {});
}

}  // namespace
}  // namespace suture
