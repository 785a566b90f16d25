// Several connections share one socket.
#include <gtest/gtest.h>
#include <suture/lane/frame/frame_end.h>
#include <suture/lane/frame/frame_link.h>
#include <suture/lane/frame/lane_thread.h>

#include <sys/socket.h>
#include <sys/syscall.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "reference/played_channel.h"
#include "support/eventually.h"
#include "support/pass.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/refused_call.h"
#include "support/repetitions.h"
#include "support/socket_pair.h"
#include "support/stepped.h"
#include "support/test_thread.h"
#include "unit/frame/joined_links.h"
#include "unit/frame/sides.h"

namespace suture::frame {
namespace {

constexpr std::uint16_t kHold = 2, kStopped = 2, kMoved = 3;

/// Holds both ends of a connection, whose tasks the test plays.
struct Pair {
  explicit Pair(std::uint32_t number)
      : client(makeSide<ClientSide>(near, number)), provider(makeSide<ProviderSide>(far, number)) {}

  static std::shared_ptr<Channel> makeChannel() {
    return reference::armChannel(reference::playedEnds(), "frame");
  }
  bool hold() {
    if (!near->commands.claim(kHold, now(), 0)) return false;
    near->commands.commit();
    return true;
  }
  int held() {
    int count = 0;
    far->commands.fixCut();
    for (; far->commands.next() != nullptr; ++count) {
      far->commands.pop();
      far->commands.returnCredit(kHold);
    }
    return count;
  }
  int heard() {
    int count = 0;
    for (; near->events.next() != nullptr; ++count) near->events.pop();
    return count;
  }

  const std::shared_ptr<Channel> near = makeChannel(), far = makeChannel();
  const std::shared_ptr<ClientSide> client;
  const std::shared_ptr<ProviderSide> provider;
};

class LinkTest : public testing::Test, protected JoinedLinks {
 protected:
  Pair& add(std::uint32_t number) {
    pairs.push_back(std::make_unique<Pair>(number));
    far->join(pairs.back()->provider);
    near->join(pairs.back()->client);
    return *pairs.back();
  }

  std::vector<std::unique_ptr<Pair>> pairs;
};

TEST_F(LinkTest, CarriesEachConnectionsOwn) {
  Pair& one = add(1);
  Pair& other = add(2);
  exchange();
  ASSERT_TRUE(one.hold());
  ASSERT_TRUE(other.far->events.push(kStopped, now(), {}));
  exchange();
  EXPECT_EQ(one.held(), 1);
  EXPECT_EQ(other.held(), 0);
  EXPECT_EQ(one.heard(), 0);
  EXPECT_EQ(other.heard(), 1);
}

/// The message of what has become of the commands is larger than anything else that such a contract
/// has.
TEST_F(LinkTest, TellsTheOutcomesOfATinyContract) {
  const std::vector<CommandInfo> commands{{.name = "press", .kind = CommandKind::Void, .depth = 4}};
  InterfaceInfo contract{};
  contract.name = "Button";
  contract.commands = commands;
  const auto makeEnd = [&] {
    return reference::playedChannel(contract, reference::playedEnds(), "frame");
  };
  const auto client = makeEnd(), provider = makeEnd();
  far->join(makeSide<ProviderSide>(provider, 1));
  near->join(makeSide<ClientSide>(client, 1));
  ++provider->commands.counters.executed;
  exchange();
  EXPECT_FALSE(near->broken());
  EXPECT_EQ(client->counts->told.load().executed, 1u);
}

TEST_F(LinkTest, TakesAConnectionThatJoinsLater) {
  Pair& late = *(add(7), pairs.back());
  exchange();
  Pair& early = add(3);
  ASSERT_TRUE(early.hold());
  exchange();
  EXPECT_EQ(early.held(), 1);
  EXPECT_EQ(late.held(), 0);
}

TEST_F(LinkTest, AConnectionThatEndsLeavesTheOthers) {
  Pair& ended = add(1);
  Pair& stays = add(2);
  exchange();
  ASSERT_TRUE(ended.hold());
  near->turn();  // on its way to an end that is there no more
  ended.far->status = ChannelStatus::Closed;
  exchange();
  ended.near->status = ChannelStatus::Closed;
  ASSERT_TRUE(stays.hold());
  exchange();
  EXPECT_EQ(stays.held(), 1);
  EXPECT_FALSE(near->broken() || far->broken() || stays.client->broken());
}

TEST_F(LinkTest, ProviderIsSilentUntilItsClientSpeaks) {
  pairs.push_back(std::make_unique<Pair>(1));
  Pair& pair = *pairs.back();
  far->join(pair.provider);
  ASSERT_TRUE(pair.far->events.push(kStopped, now(), {}));
  exchange();
  near->join(pair.client);
  exchange();
  EXPECT_EQ(pair.heard(), 1);
}

// A client that joins is given the last value of a latched event, which comes no second time.
TEST_F(LinkTest, ALateSubscriberJoins) {
  constexpr EventSet kEvent = EventSet{1} << kStopped;
  Pair& pair = add(1);
  exchange();
  std::atomic<int> laps{0};
  std::atomic<bool> done{false};
  TestThread lane([&] {
    for (; !done; ++laps) {
      for (int turn = 0; turn < 64; ++turn) near->turn();
      far->arrived();
      far->turn();
      near->arrived();
    }
  });
  const auto subscribe = [&](EventSet wanted) {
    pair.near->client.subscribe(wanted, wanted);
    for (const int before = laps; laps < before + 3;) std::this_thread::yield();
    return pair.far->provider.takeJoining();
  };
  int missed = 0;
  for (int round = 0; round < repetitions(4'000); ++round) {
    subscribe(0);
    for (std::atomic<int> moment = round % 199; moment > 0; --moment) {
    }
    if (subscribe(kEvent) != kEvent) ++missed;
  }
  done = true;
  lane.join();
  EXPECT_EQ(missed, 0);
}

TEST_F(LinkTest, ABrokenLinkEndsAllConnections) {
  Pair& one = add(1);
  exchange();
  far.reset();
  near->arrived();
  near->turn();
  EXPECT_TRUE(near->broken());
  EXPECT_TRUE(one.client->broken());
  EXPECT_EQ(one.client->why(), "the other end has closed it");
  Pair late(2);
  near->join(late.client);
  EXPECT_TRUE(late.client->broken());
}

TEST_F(LinkTest, ABrokenLinkTellsItsEnds) {
  Pair& one = add(1);
  exchange();
  far.reset();
  near->arrived();
  near->turn();
  loop::ControlThread control;
  std::string told;
  kj::Own<FrameEnd> end;
  control.run(kPatience, [&] {
    end = kj::refcounted<FrameEnd>(control, one.near, one.client);
    end->onBroken([&told](std::string why) { told = std::move(why); });
  });
  control.run(kPatience, [] {});  // it looks at its ends between one work and the next
  control.run(kPatience, [&end] { end = nullptr; });
  EXPECT_EQ(told, "closed: its frames end: the other end has closed it");
}

TEST_F(LinkTest, AConnectionAfterItsEndIsTold) {
  Pair& one = add(1);
  EXPECT_FALSE(near->endIfEmpty());  // it is joining
  exchange();
  EXPECT_FALSE(near->endIfEmpty());
  one.near->status = ChannelStatus::Closed;
  exchange();
  EXPECT_TRUE(near->endIfEmpty());
  Pair late(2);
  near->join(late.client);
  EXPECT_EQ(late.client->why(), "all of its connections have ended");
}

TEST_F(LinkTest, ANumberIsOneConnections) {
  Pair& one = add(1);
  exchange();
  Pair second(1);
  near->join(second.client);
  exchange();
  EXPECT_EQ(second.client->why(), "another connection has its number");
  ASSERT_TRUE(one.hold());
  exchange();
  EXPECT_EQ(one.held(), 1);
}

// One connection floods its link: the window and the turns leave the others theirs.
TEST_F(LinkTest, NoConnectionTakesAllTheRoom) {
  Pair& loud = add(1);
  Pair& quiet = add(2);
  exchange();
  for (int lap = 0; lap < 100; ++lap) {
    while (loud.far->events.push(kStopped, now(), {})) continue;
    ASSERT_TRUE(quiet.far->events.push(kStopped, now(), {}));
    exchange();
    ASSERT_EQ(quiet.heard(), 1) << lap;
    loud.heard();
  }
}

// There is more than a link sends at once, and nothing else would wake its thread.
TEST(LaneThread, LeavesNothingBehindForWantOfRoom) {
  auto sockets = makeSocketPair();
  const auto near = std::make_shared<FrameLink>(net::ByteStream(kj::mv(sockets.ours)), 1);
  const auto far = std::make_shared<FrameLink>(net::ByteStream(kj::mv(sockets.theirs)), 1);
  std::vector<std::unique_ptr<Pair>> pairs;
  for (std::uint32_t i = 0; i < 64; ++i) {
    pairs.push_back(std::make_unique<Pair>(i));
    far->join(pairs.back()->provider);
    near->join(pairs.back()->client);
  }
  LaneThread nearLane, farLane;
  farLane.add(far);
  nearLane.add(near);
  const std::vector<std::byte> payload(pairs[0]->far->info.events[kMoved].payloadSize);
  constexpr std::uint32_t kUnacknowledged = Window::kAcknowledged - 1;
  std::size_t sent = 0, heard = 0;
  for (const auto& one : pairs) {
    for (std::uint32_t i = 0; i < kUnacknowledged; ++i, ++sent) {
      ASSERT_TRUE(one->far->events.push(kMoved, now(), payload));
    }
  }
  ASSERT_GT(sent * (sizeof(Header) + payload.size()), 2 * kMostFrame);
  farLane.doorbell()->ring();
  EXPECT_TRUE(eventually([&] {
    for (const auto& one : pairs) heard += static_cast<std::size_t>(one->heard());
    return heard == sent;
  })) << heard
      << " of " << sent;
}

// Nothing would be heard of a socket that the thread cannot watch.
TEST(LaneThread, BreaksALinkThatItCannotWatch) {
  std::thread([] {  // what is refused to it, is to the thread that it starts
    auto sockets = makeSocketPair();
    const auto link = std::make_shared<FrameLink>(net::ByteStream(kj::mv(sockets.ours)), 1);
    Pair pair(1);
    link->join(pair.client);
    LaneThread lane;
    refuseCall(SYS_epoll_ctl, ENOSPC);
    lane.add(link);
    EXPECT_TRUE(eventually([&] { return pair.client->broken(); }));
    EXPECT_EQ(refusal([] { LaneThread another; }),
              "watch the bell of the thread of frames: No space left on device. Raise the limit of "
              "what a user watches (fs.epoll.max_user_watches)");
    EXPECT_EQ(pair.client->why(), "the kernel does not watch its socket: No space left on device");
  })
      .join();
}

TEST(LaneThread, StopsWheneverItIsTold) {
  for (int lap = 0; lap < 3000; ++lap) {
    auto sockets = makeSocketPair();
    LaneThread lane;
    lane.add(std::make_shared<FrameLink>(net::ByteStream(kj::mv(sockets.ours)), 1));
    const Time end = now() + std::chrono::microseconds(30 + lap % 50);
    while (now() < end) lane.doorbell()->ring();
  }
}

// Acknowledgements, and frames of no connection, count in no window: the other links have their
// turns all the same.
TEST(FrameLink, AnEndlessPeerGetsItsTurnOnly) {
  auto sockets = makeSocketPair();
  const int room = 8 << 20;
  if (setsockopt(sockets.theirs, SOL_SOCKET, SO_SNDBUFFORCE, &room, sizeof(room)) != 0) {
    GTEST_SKIP() << "only root may send so much at once";
  }
  FrameWriter writer(1);
  for (int lap = 0; lap < 32; ++lap) {
    while (writer.hasRoom()) {
      writer.begin({.kind = Kind::Acknowledge, .connection = 9}, 0);
      writer.finish();
    }
    sendAll(sockets.theirs, writer.unsent());
    writer.sent(writer.unsent().size());
  }
  FrameLink link(net::ByteStream(kj::mv(sockets.ours)), 1);
  link.arrived();
  link.turn();
  EXPECT_TRUE(link.hasMore());
  int turns = 1;
  for (; link.hasMore(); ++turns) link.turn();
  EXPECT_GT(turns, 2);
  EXPECT_FALSE(link.broken());
}

TEST(LaneThread, DropsAnEmptyLinkWithoutAnOwner) {
  const TestClock clock(steppedOptions());
  auto pair = makeSocketPair();
  FrameLink far(net::ByteStream(kj::mv(pair.theirs)), 1);
  Pair first(1), second(2);
  for (Pair* const one : {&first, &second}) far.join(one->provider);
  const auto isHeard = [&far](Pair& one) {
    return eventually([&] {
      far.arrived();
      far.turn();
      return one.far->bytesReceived > 0;
    });
  };
  LaneThread lane;
  auto link = std::make_shared<FrameLink>(net::ByteStream(kj::mv(pair.ours)), 1);
  const std::weak_ptr<FrameLink> seen = link;
  link->join(first.client);
  lane.add(link);
  EXPECT_TRUE(isHeard(first));
  first.near->status = ChannelStatus::Closed;
  lane.doorbell()->ring();
  pass(std::chrono::milliseconds(20));
  link->join(second.client);  // it is ours, and so still carried
  lane.doorbell()->ring();
  EXPECT_TRUE(isHeard(second));
  link.reset();
  second.near->status = ChannelStatus::Closed;
  lane.doorbell()->ring();
  EXPECT_TRUE(eventually([&] { return seen.expired(); }));
}

}  // namespace
}  // namespace suture::frame
