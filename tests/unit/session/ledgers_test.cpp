// A process keeps the sums of so many connections of each peer, and says when it may have dropped
// some.

#include <gtest/gtest.h>
#include <suture/session/ledgers.h>

#include <memory>
#include <string>

#include "reference/played_channel.h"

namespace suture {
namespace {

constexpr std::uint64_t kClient = 7;

class LedgersTest : public testing::Test {
 protected:
  /// Makes a connection of that name, and returns its sums.
  std::shared_ptr<Ledger> connect(const std::string& peer, const std::string& name) {
    auto ledger = ledgers_.of(peer, name, kClient);
    ledgers_.keep(peer, name, kClient, ledger);
    return ledger;
  }
  /// The peer has as many connections as are kept, one after another.
  void fill(const std::string& peer, std::size_t count = Ledgers::kMostOfPeer) {
    for (std::size_t i = 0; i < count; ++i) connect(peer, std::to_string(i));
  }
  /// Tells if this process is sure that it knows all that the connection had before.
  bool knowsAll(const std::string& peer, const std::string& name) {
    const auto ledger = ledgers_.of(peer, name, kClient);
    const auto channel = reference::armChannel(reference::playedEnds(), "rpc");
    ledger->begin(channel, kClient);
    return ledger->before(*channel).ended;
  }

  Ledgers ledgers_{ConnectionEnd::Provider};
};

TEST_F(LedgersTest, ForgetNothingWithinTheBound) {
  fill("user 1");
  EXPECT_TRUE(knowsAll("user 1", "0"));
  EXPECT_TRUE(knowsAll("user 1", "a new one"));
}

TEST_F(LedgersTest, ForgetThePeersOldest) {
  fill("user 1");
  connect("user 1", "0");  // it is back
  connect("user 1", "one too many");
  EXPECT_FALSE(knowsAll("user 1", "1")) << "the oldest";
  EXPECT_FALSE(knowsAll("user 1", "a new one")) << "it may have been forgotten";
  EXPECT_TRUE(knowsAll("user 1", "0"));
  EXPECT_TRUE(knowsAll("user 1", "2"));
  EXPECT_TRUE(knowsAll("user 1", "one too many")) << "it came when nothing had been forgotten";
}

TEST_F(LedgersTest, OfOtherPeersAreWhole) {
  connect("user 2", "old");
  fill("user 1", Ledgers::kMostOfPeer + 10);
  EXPECT_TRUE(knowsAll("user 2", "old"));
  EXPECT_TRUE(knowsAll("user 2", "a new one"));
}

TEST_F(LedgersTest, OfConnectionsThatStandAreKept) {
  const auto standing = connect("user 1", "standing");
  fill("user 1", Ledgers::kMostOfPeer + 10);
  EXPECT_EQ(ledgers_.of("user 1", "standing", kClient), standing);
}

}  // namespace
}  // namespace suture
