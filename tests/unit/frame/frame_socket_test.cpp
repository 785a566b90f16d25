#include <gtest/gtest.h>
#include <suture/transport/frame/frame_socket.h>

#include "support/allocations.h"
#include "unit/rpc/socket_pair.h"

namespace suture::frame {
namespace {

constexpr std::size_t kMostPayload = 64;

/// Two ends of a connection.
struct Ends {
  Ends() : Ends(rpc::makeSocketPair()) {}
  explicit Ends(rpc::SocketPair pair)
      : near(rpc::ByteStream(kj::mv(pair.ours)), 5, kMostPayload),
        far(rpc::ByteStream(kj::mv(pair.theirs)), 5, kMostPayload) {}

  FrameSocket near, far;
};

/// Sends as many as there is room for.
unsigned sendAll(FrameSocket& socket, unsigned most = 1000) {
  unsigned count = 0;
  for (; count < most && socket.hasRoom(); ++count) {
    socket.begin({.kind = Kind::Event}, kMostPayload);
    socket.finish();
  }
  socket.flush();
  return count;
}

unsigned takeAll(FrameSocket& socket) {
  unsigned count = 0;
  for (socket.arrived(); socket.next() != nullptr;) ++count;
  socket.flush();
  return count;
}

TEST(FrameSocket, CarriesFramesBothWays) {
  Ends ends;
  EXPECT_EQ(sendAll(ends.near, 3), 3u);
  EXPECT_EQ(takeAll(ends.far), 3u);
  EXPECT_EQ(sendAll(ends.far, 2), 2u);
  EXPECT_EQ(takeAll(ends.near), 2u);
  EXPECT_EQ(ends.near.sentBytes(), ends.far.receivedBytes());
}

TEST(FrameSocket, AStoppedPeerFindsAWindowOfFramesAndNoMore) {
  Ends ends;
  EXPECT_EQ(sendAll(ends.near), FrameSocket::kWindow);
  EXPECT_EQ(sendAll(ends.near), 0u);
  EXPECT_EQ(takeAll(ends.far), FrameSocket::kWindow);
  EXPECT_EQ(takeAll(ends.near), 0u);  // an acknowledgement
  EXPECT_EQ(sendAll(ends.near), FrameSocket::kWindow);
}

TEST(FrameSocket, FramesTheOtherWayAcknowledge) {
  Ends ends;
  for (int lap = 0; lap < 100; ++lap) {
    ASSERT_EQ(sendAll(ends.near, 1), 1u) << lap;
    ASSERT_EQ(takeAll(ends.far), 1u);
    ASSERT_EQ(sendAll(ends.far, 1), 1u);
    ASSERT_EQ(takeAll(ends.near), 1u);
  }
}

TEST(FrameSocket, AllocatesNothingOnceItStands) {
  Ends ends;
  const std::uint64_t before = allocations();
  for (int lap = 0; lap < 1000; ++lap) {
    sendAll(ends.near, 20);
    takeAll(ends.far);
    takeAll(ends.near);
  }
  EXPECT_EQ(allocations(), before);
}

TEST(FrameSocket, EndsWithItsPeer) {
  Ends ends;
  ends.far.cut();
  takeAll(ends.near);
  EXPECT_EQ(ends.near.why(), "the other end has closed it");
  EXPECT_EQ(ends.near.next(), nullptr);
}

TEST(FrameSocket, BelievesNoAcknowledgementOfWhatItHasNotSent) {
  auto pair = rpc::makeSocketPair();
  FrameSocket socket(rpc::ByteStream(kj::mv(pair.ours)), 5, kMostPayload);
  FrameWriter liar(5, kMostPayload);
  liar.begin({.acknowledged = 1, .kind = Kind::Event}, 0);
  liar.finish();
  rpc::sendAll(pair.theirs, liar.unsent());
  EXPECT_EQ(takeAll(socket), 0u);
  EXPECT_EQ(socket.why(), "the peer has taken more frames than it was sent");
}

}  // namespace
}  // namespace suture::frame
