#include <gtest/gtest.h>
#include <suture/lane/frame/frame_socket.h>

#include <algorithm>

#include "support/allocations.h"
#include "support/socket_pair.h"

namespace suture::frame {
namespace {

constexpr std::size_t kSmallPayload = 64;

/// Holds two ends of a connection.
struct Ends {
  Ends() : Ends(makeSocketPair()) {}
  explicit Ends(SocketPair pair)
      : near(net::ByteStream(kj::mv(pair.ours)), 5), far(net::ByteStream(kj::mv(pair.theirs)), 5) {}

  FrameSocket near, far;
};

unsigned send(FrameSocket& socket, unsigned wanted) {
  unsigned count = 0;
  for (; count < wanted && socket.hasRoom(); ++count) {
    std::fill_n(socket.begin({.kind = Kind::Event}, kSmallPayload), kSmallPayload, std::byte{0});
    socket.finish();
  }
  socket.flush();
  return count;
}

unsigned takeAll(FrameSocket& socket) {
  unsigned count = 0;
  socket.arrived();
  do {
    while (socket.next() != nullptr) ++count;
  } while (socket.receive());
  return count;
}

TEST(FrameSocket, CarriesFramesBothWays) {
  Ends ends;
  EXPECT_EQ(send(ends.near, 3), 3u);
  EXPECT_EQ(takeAll(ends.far), 3u);
  EXPECT_EQ(send(ends.far, 2), 2u);
  EXPECT_EQ(takeAll(ends.near), 2u);
}

TEST(FrameSocket, UntakenBytesAreBounded) {
  Ends ends;
  unsigned sent = 0;
  while (const unsigned more = send(ends.near, 1000)) sent += more;
  EXPECT_TRUE(ends.near.isFull());
  EXPECT_FALSE(ends.near.hasRoom());
  EXPECT_LT(sent, 100'000u);
  unsigned taken = 0;
  while (taken < sent) {
    taken += takeAll(ends.far);
    ends.near.flush();
  }
  EXPECT_EQ(taken, sent);
  EXPECT_TRUE(ends.near.hasRoom());
}

TEST(FrameSocket, AllocatesNothingOnceItStands) {
  Ends ends;
  const std::uint64_t before = allocations();
  for (int lap = 0; lap < 1000; ++lap) {
    send(ends.near, 20);
    takeAll(ends.far);
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

}  // namespace
}  // namespace suture::frame
