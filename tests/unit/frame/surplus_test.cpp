// What connections have taken beyond their contracts comes back to their link when they end.
#include <gtest/gtest.h>
#include <suture/lane/frame/bytes/frame_writer.h>
#include <suture/lane/frame/bytes/surplus.h>
#include <suture/lane/frame/frame_link.h>
#include <sys/socket.h>

#include <array>
#include <atomic>
#include <cstring>
#include <memory>
#include <thread>

#include "reference/played_channel.h"
#include "support/contains.h"
#include "support/repetitions.h"
#include "support/socket_pair.h"
#include "support/test_thread.h"
#include "unit/frame/sides.h"

namespace suture::frame {
namespace {

/// Holds a link, and a peer whose values are as large as may be.
class Growing {
 public:
  explicit Growing(std::unique_ptr<framing::PeerBudget::Share> share = nullptr)
      : link(net::ByteStream(kj::mv(sockets_.ours)), 1, std::move(share)) {}

  /// Adds a connection, and returns what is gone when its end has been noticed.
  std::weak_ptr<Connection> add() {
    channel->status = ChannelStatus::Connected;
    const auto side = makeSide<ClientSide>(channel, ++number_, Form::Encoded);
    link.join(side);
    return side;
  }
  /// The peer sends a piece for the latest connection, which the link takes.
  void grow() { take(Kind::Piece, Kind::Event, 16u << 20); }
  /// The peer sends a value of so many pieces, which the link takes and drops: it answers a call
  /// that is no longer known.
  void takeWhole(std::uint32_t pieces) {
    for (std::uint32_t i = 1; i < pieces; ++i) {
      take(Kind::Piece, Kind::Reply, pieces * static_cast<std::uint32_t>(kMostPayload));
    }
    take(Kind::Reply, Kind{}, 99);
  }
  /// Returns how many pieces the link takes until it has no more room for them.
  int room() {
    constexpr int kMost = 255;  // one value has no more
    for (int pieces = 0;; ++pieces) {
      if (pieces % kMost == 0) add();
      grow();
      if (link.broken()) return pieces;
    }
  }

 private:
  void take(Kind kind, Kind ofWhole, std::uint32_t call) {
    const Header header{.kind = kind,
                        .number = static_cast<std::uint16_t>(ofWhole),
                        .call = call,
                        .connection = number_};
    std::memset(writer_.begin(header, kMostPayload), 0, kMostPayload);
    writer_.finish();
    sendAll(sockets_.theirs, writer_.unsent());
    writer_.sent(writer_.unsent().size());
    std::array<char, 4096> heard;
    while (recv(sockets_.theirs, heard.data(), heard.size(), MSG_DONTWAIT) > 0) continue;
    link.arrived();
    link.turn();
  }

  SocketPair sockets_ = makeSocketPair();
  FrameWriter writer_{1};
  std::uint32_t number_ = 0;

 public:
  const std::shared_ptr<Channel> channel = reference::armChannel(reference::playedEnds(), "frame");
  FrameLink link;
};

TEST(Surplus, IsBoundedForTheWholeLink) {
  const int room = Growing().room();
  EXPECT_GE(room, static_cast<int>(Surplus::kMost / kMostPayload));
  EXPECT_LT(room, static_cast<int>(Surplus::kMost / kMostPayload) + 10);
}

/// Returns a budget of what one peer, or the whole process, may hold.
std::shared_ptr<framing::PeerBudget> budgetOf(std::size_t peer, std::size_t process) {
  return std::make_shared<framing::PeerBudget>(framing::PeerBudget::Limits{peer, process});
}

TEST(Surplus, IsOfTheBudgetOfItsPeer) {
  const auto budget = budgetOf(10 * kMostPayload, 100 * kMostPayload);
  const auto share = [&] {
    return std::make_unique<framing::PeerBudget::Share>(budget, "the peer");
  };
  const auto unfinished = share();
  ASSERT_FALSE(unfinished->hold(4 * kMostPayload));
  Growing growing(share());
  EXPECT_LT(growing.room(), 10);
  EXPECT_EQ(growing.link.refusal(),
            "the unfinished messages of the peer would need more than 655360 bytes. Send smaller "
            "ones, or fewer at a time");
}

TEST(Surplus, IsOfTheBudgetOfTheProcess) {
  const auto budget = budgetOf(10 * kMostPayload, 12 * kMostPayload);
  Surplus first(std::make_unique<framing::PeerBudget::Share>(budget, "one peer"));
  Surplus second(std::make_unique<framing::PeerBudget::Share>(budget, "another"));
  ASSERT_TRUE(first.take(9 * kMostPayload));
  EXPECT_FALSE(second.take(4 * kMostPayload));
  EXPECT_TRUE(contains(second.whyNot(), "the unfinished messages of all peers would need"));
  first.giveBack(kMostPayload);
  EXPECT_TRUE(second.take(4 * kMostPayload));
}

// A value that has been taken is no unfinished message any more.
TEST(Surplus, ComesBackOnceAValueIsTaken) {
  const auto budget = budgetOf(10 * kMostPayload, 100 * kMostPayload);
  const auto share = [&] {
    return std::make_unique<framing::PeerBudget::Share>(budget, "the peer");
  };
  Growing first(share()), second(share());
  for (Growing* const one : {&first, &second}) one->add();
  for (int lap = 0; lap < 3; ++lap) {
    for (Growing* const one : {&first, &second}) {
      one->takeWhole(6);
      ASSERT_FALSE(one->link.broken()) << one->link.refusal();
    }
  }
}

// The thread that ends a connection does so at any moment of a turn.
TEST(Surplus, ComesBackWheneverItsConnectionEnds) {
  Growing growing;
  std::atomic<int> round{0};
  std::atomic<bool> done{false};
  TestThread control([&] {
    for (int seen = 0; !done; ++seen) {
      while (round == seen && !done) std::this_thread::yield();
      for (std::atomic<int> moment = seen % 199; moment > 0; --moment) {
      }
      growing.channel->status = ChannelStatus::Closed;
    }
  });
  for (int lap = 1; lap <= repetitions(1'000); ++lap) {
    const auto connection = growing.add();
    growing.grow();
    round = lap;
    while (!connection.expired()) growing.link.turn();
  }
  done = true;
  control.join();
  EXPECT_EQ(growing.room(), Growing().room());
}

}  // namespace
}  // namespace suture::frame
