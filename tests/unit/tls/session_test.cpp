// A session of ours speaks TLS over a pair of sockets, with another session of ours or with a
// stranger, which is OpenSSL alone.

#include <gtest/gtest.h>
#include <poll.h>
#include <suture/net/tls/key_maker.h>
#include <suture/net/tls/session.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <future>
#include <thread>
#include <vector>

#include "support/contains.h"
#include "support/temporary_directory.h"
#include "unit/tls/strangers.h"

namespace suture::tls {
namespace {

using namespace std::chrono_literals;
using Side = Session::Side;
using Progress = Session::Progress;

struct Sockets {
  Sockets() {
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends) != 0) std::abort();
  }
  ~Sockets() {
    closeEnd(0);
    closeEnd(1);
  }
  void closeEnd(int which) {
    if (ends[which] >= 0) close(ends[which]);
    ends[which] = -1;
  }
  int ends[2];
};

void await(int socket, short events) {
  pollfd ready{socket, events, 0};
  poll(&ready, 1, 10'000);
}

/// Shakes hands. Returns "", or why the handshake failed.
std::string handshake(Session& session, int socket) {
  try {
    for (;;) {
      switch (session.handshake()) {
        case Progress::Done: return "";
        case Progress::WantsRead: await(socket, POLLIN); break;
        case Progress::WantsWrite: await(socket, POLLOUT); break;
      }
    }
  } catch (const HandshakeError& error) {
    return error.what();
  }
}

class SessionTest : public testing::Test {
 protected:
  SessionTest() {
    makeKeys(ours_, {"left", "right"});
    makeKeys(theirs_, {"left"});
    makeKeys(ours_, {"old"}, {.from = -48h, .lasts = std::chrono::days(1)});
    makeKeys(ours_, {"early"}, {.from = 24h, .lasts = std::chrono::days(1)});
  }

  std::shared_ptr<const Keys> keys(const std::string& process) const {
    return std::make_shared<const Keys>(ours_, process);
  }
  static Shown shown(const std::filesystem::path& folder, const std::string& name) {
    return {folder / (name + ".crt"), folder / (name + ".key")};
  }

  struct Verdicts {
    std::string ours, theirs;
  };
  /// Runs our side against a stranger who shows `shown`.
  Verdicts meet(Side side, const Shown& shown, int newest = TLS1_3_VERSION) const {
    Sockets sockets;
    Stranger stranger(shown, newest);
    std::promise<std::string> heard;
    std::thread other(
        [&] { heard.set_value(stranger.tryAt(sockets.ends[1], side == Side::Server)); });
    std::string verdict;
    {
      Session session(keys("right"), side, sockets.ends[0]);
      verdict = handshake(session, sockets.ends[0]);
      if (verdict.empty()) session.send(std::as_bytes(std::span("x", 1)));
    }
    shutdown(sockets.ends[0], SHUT_RDWR);
    other.join();
    return {verdict, heard.get_future().get()};
  }
  /// Runs our side against one that says `bytes` and no more.
  std::string hear(Side side, const std::string& bytes) const {
    Sockets sockets;
    if (write(sockets.ends[1], bytes.data(), bytes.size()) < 0) std::abort();
    Session session(keys("right"), side, sockets.ends[0]);
    return handshake(session, sockets.ends[0]);
  }

  const TemporaryDirectory directory_;
  const std::filesystem::path ours_ = directory_.path() / "ours",
                              theirs_ = directory_.path() / "theirs";
};

/// Holds two sessions of ours that have shaken hands.
struct Pair {
  Pair(std::shared_ptr<const Keys> left, std::shared_ptr<const Keys> right)
      : client(std::move(left), Side::Client, sockets.ends[0]),
        server(std::move(right), Side::Server, sockets.ends[1]) {
    std::thread other([this] { serversVerdict = handshake(server, sockets.ends[1]); });
    clientsVerdict = handshake(client, sockets.ends[0]);
    other.join();
  }
  Sockets sockets;
  Session client, server;
  std::string clientsVerdict, serversVerdict;
};

TEST_F(SessionTest, EachSideLearnsTheOthersName) {
  Pair pair(keys("left"), keys("right"));
  EXPECT_EQ(pair.clientsVerdict, "");
  EXPECT_EQ(pair.serversVerdict, "");
  EXPECT_EQ(pair.client.peer(), "right");
  EXPECT_EQ(pair.server.peer(), "left");
}

TEST_F(SessionTest, BytesArriveAsSent) {
  Pair pair(keys("left"), keys("right"));
  std::vector<std::byte> sent(3'000'000), received;
  for (std::size_t i = 0; i < sent.size(); ++i) sent[i] = static_cast<std::byte>(i * 31 % 251);
  std::thread sender([&] {
    for (std::size_t done = 0; done < sent.size();) {
      const ssize_t count = pair.client.send(std::span(sent).subspan(done));
      if (count < 0) {
        ASSERT_EQ(errno, EAGAIN);
        await(pair.sockets.ends[0], POLLOUT);
      } else {
        done += static_cast<std::size_t>(count);
      }
    }
    pair.client.end();
  });
  std::vector<std::byte> buffer(100'000);
  for (;;) {
    const ssize_t count = pair.server.receive(buffer);
    if (count == 0) break;
    if (count < 0) {
      ASSERT_EQ(errno, EAGAIN) << pair.server.failure();
      await(pair.sockets.ends[1], POLLIN);
    } else {
      received.insert(received.end(), buffer.begin(), buffer.begin() + count);
    }
  }
  sender.join();
  EXPECT_TRUE(received == sent);
}

TEST_F(SessionTest, TheWireIsEncrypted) {
  Pair pair(keys("left"), keys("right"));
  const std::string secret = "servo_cp servo_cp servo_cp";
  ASSERT_GT(pair.client.send(std::as_bytes(std::span(secret))), 0);
  char wire[4096];
  const ssize_t count = recv(pair.sockets.ends[1], wire, sizeof(wire), 0);
  ASSERT_GT(count, 0);
  EXPECT_FALSE(contains(std::string(wire, static_cast<std::size_t>(count)), "servo_cp"));
}

TEST_F(SessionTest, AChangedBitEndsTheSession) {
  Pair pair(keys("left"), keys("right"));
  ASSERT_GT(pair.client.send(std::as_bytes(std::span("move", 4))), 0);
  char wire[4096];
  const ssize_t count = recv(pair.sockets.ends[1], wire, sizeof(wire), 0);
  ASSERT_GT(count, 10);
  wire[count - 5] ^= 1;
  ASSERT_EQ(write(pair.sockets.ends[0], wire, static_cast<std::size_t>(count)), count);
  std::byte into[16];
  EXPECT_EQ(pair.server.receive(into), -1);
  EXPECT_EQ(errno, EPROTO);
  EXPECT_TRUE(contains(pair.server.failure(), "bad record mac")) << pair.server.failure();
}

TEST_F(SessionTest, AReplayedRecordEndsTheSession) {
  Pair pair(keys("left"), keys("right"));
  ASSERT_GT(pair.client.send(std::as_bytes(std::span("move", 4))), 0);
  char wire[4096];
  const auto count = recv(pair.sockets.ends[1], wire, sizeof(wire), 0);
  ASSERT_EQ(write(pair.sockets.ends[0], wire, static_cast<std::size_t>(count)), count);
  ASSERT_EQ(write(pair.sockets.ends[0], wire, static_cast<std::size_t>(count)), count);
  std::byte into[16];
  EXPECT_EQ(pair.server.receive(into), 4);
  EXPECT_EQ(pair.server.receive(into), -1);
  EXPECT_EQ(errno, EPROTO);
}

TEST_F(SessionTest, AClosedSocketIsNoEnd) {
  Pair pair(keys("left"), keys("right"));
  pair.sockets.closeEnd(0);
  std::byte into[16];
  EXPECT_EQ(pair.server.receive(into), -1) << "whoever can cut a cable could end a message";
}

TEST_F(SessionTest, AStrangerWithOurKeysIsAccepted) {
  for (const Side side : {Side::Client, Side::Server}) {
    const Verdicts verdicts = meet(side, shown(ours_, "left"));
    EXPECT_EQ(verdicts.ours, "");
    EXPECT_EQ(verdicts.theirs, "accepted") << "else the refusals of the tests below prove nothing";
  }
}

TEST_F(SessionTest, APeerNeedsACertificate) {
  const Verdicts verdicts = meet(Side::Server, {});
  EXPECT_TRUE(contains(verdicts.ours, "it shows no certificate")) << verdicts.ours;
  EXPECT_TRUE(contains(verdicts.theirs, "certificate required")) << verdicts.theirs;
}

TEST_F(SessionTest, InvalidCertificatesAreRefusedOnBothSides) {
  const std::pair<Shown, const char*> cases[] = {
      {shown(theirs_, "left"), "is not signed by this system's CA"},
      {shown(theirs_, "ca"), "is not signed by this system's CA"},  // signed by itself
      {shown(ours_, "old"), "expired at 2"},
      {shown(ours_, "early"), "Set the clocks of both machines"},
      {shown(ours_, "ca"), "certificate"},  // the CA is no process
  };
  for (const auto& [stranger, reason] : cases) {
    for (const Side side : {Side::Client, Side::Server}) {
      const Verdicts verdicts = meet(side, stranger);
      EXPECT_TRUE(contains(verdicts.ours, reason)) << stranger.certificate << ": " << verdicts.ours;
      EXPECT_NE(verdicts.theirs, "accepted") << stranger.certificate;
    }
  }
}

// In TLS 1.3 the handshake of the client ends before the server has judged its certificate.
TEST_F(SessionTest, AClientLearnsOfItsRefusal) {
  Stranger server(shown(ours_, "left"));
  server.trustNobody();
  Sockets sockets;
  std::thread other([&] { server.tryAt(sockets.ends[1], false); });
  Session client(keys("right"), Side::Client, sockets.ends[0]);
  const std::string verdict = handshake(client, sockets.ends[0]);
  EXPECT_TRUE(contains(verdict, "it does not accept the certificate of 'right'")) << verdict;
  other.join();
}

TEST_F(SessionTest, OlderVersionsAreRefused) {
  EXPECT_NE(meet(Side::Server, shown(ours_, "left"), TLS1_2_VERSION).ours, "");
  EXPECT_NE(meet(Side::Client, shown(ours_, "left"), TLS1_2_VERSION).ours, "");
}

TEST_F(SessionTest, APeerWithoutTlsIsNamed) {
  const std::string zeros(4096, '\0'), ones(4096, '\xff');
  const std::string bytes[] = {"GET / HTTP/1.1\r\n\r\n", zeros, ones,
                               std::string("\0\0\0\0\2\0\0\0\0\0\0\0\0\0\0\0", 16)};
  for (const std::string& said : bytes) {
    for (const Side side : {Side::Client, Side::Server}) {
      const std::string verdict = hear(side, said);
      EXPECT_TRUE(contains(verdict, "it does not speak TLS")) << verdict;
    }
  }
}

}  // namespace
}  // namespace suture::tls
