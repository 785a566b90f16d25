// The second sockets that a client opens have a bounded cost.

#include <gtest/gtest.h>
#include <suture/loop/failure.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "reference/connect_request.h"
#include "reference/played_client.h"
#include "reference/remote_arm.h"
#include "support/contains.h"
#include "support/refusal.h"
#include "support/socket_pair.h"

namespace suture {
namespace {

class SocketOpener : public reference::PlayedClient {
 public:
  explicit SocketOpener(const std::string& manager) : PlayedClient(manager, "robot") { greet(); }

  net::ByteStream open(const char* lane = "rpc") {
    return control_.run(kPatience, [this, lane] {
      return reference::openSecondSocket(control_.port(), provider(), peer(), lane)
          .then([](reference::SecondSocket socket) { return kj::mv(socket.bytes); });
    });
  }
  std::vector<net::ByteStream> open(std::size_t count) {
    std::vector<net::ByteStream> sockets;
    while (sockets.size() < count) sockets.push_back(open());
    return sockets;
  }
};

/// Both ends of each socket are in this process.
void allowManySockets() {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  limit.rlim_cur = std::min<rlim_t>(std::max<rlim_t>(limit.rlim_cur, 4096), limit.rlim_max);
  setrlimit(RLIMIT_NOFILE, &limit);
}

struct SecondSockets : RemoteArm {
  void SetUp() override {
    allowManySockets();
    begin("tcp://127.0.0.1:0");
  }
};

/// Each peer proves which user runs it, and all are run by the same.
struct SecondSocketsOfAUser : RemoteArm {
  void SetUp() override {
    allowManySockets();
    begin(unixAddress());
  }
};

/// Returns most of a message of 16 MiB.
std::vector<std::byte> begunMessage() {
  std::vector<std::byte> begun(15u << 20, std::byte{0});
  const std::uint32_t words = (16u << 20) / 8 - 2;
  std::memcpy(begun.data() + 4, &words, sizeof(words));
  return begun;
}

// A slow machine may take so long that a message that has begun is refused for that; then try anew.
TEST_F(SecondSockets, UnfinishedMessagesAreBoundedInSum) {
  SocketOpener client(manager());
  const std::vector<std::byte> begun = begunMessage();
  EXPECT_TRUE(eventually([&] {
    const std::vector<net::ByteStream> greedy = client.open(5);
    for (const net::ByteStream& one : greedy) sendAll(one.socket(), begun);
    return contains(robot->refusals().latest, "would need more than 67108864 bytes");
  })) << robot->refusals().latest;
}

TEST_F(SecondSockets, OfAllSessionsAreBounded) {
  SocketOpener first(manager()), second(manager());
  std::vector<net::ByteStream> held = first.open(1000);
  const std::vector<net::ByteStream> more = second.open(24);
  const std::string refused = refusal([&] { second.open(); });
  EXPECT_TRUE(contains(refused, "it has 1024 of them, and no process has more")) << refused;
  EXPECT_TRUE(contains(robot->refusals().latest, refused)) << robot->refusals().latest;
  held.clear();
  EXPECT_TRUE(eventually([&] { return refusal([&] { second.open(); }).empty(); }));
}

TEST_F(SecondSocketsOfAUser, AreBoundedOverItsSessions) {
  SocketOpener first(manager()), second(manager());
  std::vector<net::ByteStream> held = first.open(500);
  const std::vector<net::ByteStream> more = second.open(12);
  const std::string refused = refusal([&] { second.open(); });
  const std::string user = "user " + std::to_string(geteuid());
  EXPECT_TRUE(contains(refused, "512 of them are with " + user + ", and no peer has more"))
      << refused;
  EXPECT_TRUE(contains(robot->refusals().latest, refused)) << robot->refusals().latest;
  held.clear();
  EXPECT_TRUE(eventually([&] { return refusal([&] { second.open(); }).empty(); }));
}

// A lane of frames keeps only the latest socket of a session, and one that has connections.
TEST_F(SecondSockets, DroppedOnesTakeNoPlace) {
  SocketOpener client(manager());
  for (int i = 0; i < 1100; ++i) client.open("frame");
}

}  // namespace
}  // namespace suture
