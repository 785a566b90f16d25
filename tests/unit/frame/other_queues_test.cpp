// The two processes were built from contracts that keep different queues of one command. Each holds
// to its own, and no command uses a credit for ever or breaks the link.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "reference/arm_numbers.h"
#include "reference/played_channel.h"
#include "unit/frame/joined_links.h"
#include "unit/frame/sides.h"

namespace suture::frame {
namespace {

constexpr std::uint16_t kQueued = reference::kHold;

/// Says how many of hold() may wait.
struct Queue {
  std::uint32_t depth = 4;
  bool latest = false;
};

/// A Version is the contract of an arm in which hold() has that queue.
struct Version {
  explicit Version(Queue queue)
      : commands(arm().commands.begin(), arm().commands.end()), contract(arm()) {
    commands[kQueued].depth = queue.depth;
    commands[kQueued].latest = queue.latest;
    contract.commands = commands;
  }
  static const InterfaceInfo& arm() { return interfaceInfo<reference::ArmLike>(); }
  std::shared_ptr<Channel> makeChannel() const {
    return reference::playedChannel(contract, reference::playedEnds(), "frame");
  }
  /// Returns what a client says of it.
  ClientCommands named() const {
    ClientCommands named;
    for (const CommandInfo& one : commands) named.latest.push_back(one.latest);
    return named;
  }

  std::vector<CommandInfo> commands;
  InterfaceInfo contract;
};

/// Joins a client to a provider whose hold() has another queue; the test plays both of their tasks.
class Unequal {
 public:
  Unequal(Queue client, Queue provider) : client_(client), provider_(provider) {
    links_.far->join(makeSide<ProviderSide>(far, 1, Form::Encoded, client_.named()));
    links_.near->join(makeSide<ClientSide>(near, 1, Form::Encoded));
    links_.exchange();
  }
  /// Returns false if the client has no room for it.
  bool hold(std::uint32_t call = 0) {
    if (!near->commands.claim(kQueued, now(), call)) return false;
    near->commands.commit();
    links_.exchange();
    return true;
  }
  /// The provider takes all that wait; returns how many.
  unsigned take() {
    unsigned taken = 0;
    far->commands.fixCut();
    for (; const rt::CommandRecord* const record = far->commands.next(); ++taken) {
      const bool usesCredit = !provider_.commands[kQueued].latest || record->call != 0;
      if (record->call != 0) far->provider.replyError(record->call, Errc::Timeout);
      far->commands.pop();
      if (usesCredit) far->commands.returnCredit(kQueued);
    }
    links_.exchange();
    return taken;
  }
  bool broken() const { return links_.near->broken() || links_.far->broken(); }

 private:
  const Version client_, provider_;

 public:
  const std::shared_ptr<Channel> near = client_.makeChannel(), far = provider_.makeChannel();

 private:
  JoinedLinks links_;
};

TEST(OtherQueues, AShorterOneRefusesTheRest) {
  Unequal ends({.depth = 9}, {.depth = 2});
  for (int i = 0; i < 9; ++i) ASSERT_TRUE(ends.hold()) << i;
  ASSERT_FALSE(ends.broken());
  EXPECT_EQ(ends.far->counts->turnedAway.load(), 7u);
  EXPECT_EQ(ends.near->counts->told.load().refused, 7u) << "the client is told";
  EXPECT_EQ(ends.take(), 2u);
  EXPECT_EQ(ends.near->commands.waiting(kQueued), 0u) << "all credits are back";
}

TEST(OtherQueues, AShorterOneAnswersTheRest) {
  Unequal ends({.depth = 3}, {.depth = 1});
  ASSERT_TRUE(ends.hold(1));
  ASSERT_TRUE(ends.hold(2));
  const ReplyRecord* const reply = ends.near->client.nextReply();
  ASSERT_NE(reply, nullptr);
  EXPECT_EQ(reply->call, 2u);
  EXPECT_EQ(reply->error, Errc::Full);
}

TEST(OtherQueues, ALongerOneTakesEverything) {
  Unequal ends({.depth = 2}, {.depth = 9});
  for (int lap = 0; lap < 5; ++lap) {
    ASSERT_TRUE(ends.hold() && ends.hold());
    EXPECT_FALSE(ends.hold());
    EXPECT_EQ(ends.take(), 2u);
  }
}

TEST(OtherQueues, TheClientsNewestWaitsAtTheProvider) {
  Unequal ends({.latest = true}, {.depth = 2});
  for (int lap = 0; lap < 5; ++lap) {
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(ends.hold());
    EXPECT_EQ(ends.take(), 2u);
    ASSERT_FALSE(ends.broken()) << lap;
  }
}

TEST(OtherQueues, TheProvidersNewestReplacesTheClients) {
  Unequal ends({.depth = 4}, {.latest = true});
  for (int lap = 0; lap < 5; ++lap) {
    for (int i = 0; i < 4; ++i) ASSERT_TRUE(ends.hold()) << lap;
    EXPECT_EQ(ends.take(), 1u);
    EXPECT_EQ(ends.near->commands.waiting(kQueued), 0u);
  }
}

// The commands before it use no credit, and bring none.
TEST(OtherQueues, ANewestWinsCallKeepsItsCredit) {
  for (const bool latest : {false, true}) {
    Unequal ends({.depth = 1, .latest = true}, {.depth = 4, .latest = latest});
    ASSERT_TRUE(ends.hold());
    ASSERT_TRUE(ends.hold(1));
    EXPECT_FALSE(ends.hold(2)) << latest;
    ends.take();
    EXPECT_TRUE(ends.hold(3)) << latest;
    EXPECT_FALSE(ends.broken()) << latest;
  }
}

}  // namespace
}  // namespace suture::frame
