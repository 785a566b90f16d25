// These tests say what becomes of connections that might use frames.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <suture/frame.capnp.h>
#include <suture/framing/preamble.h>
#include <suture/lane/frame/bytes/frame_writer.h>
#include <suture/lane/frame/payloads/payloads.h>
#include <suture/wiring/memory_layout.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "reference/connect_request.h"
#include "reference/played_client.h"
#include "reference/remote_arm.h"
#include "support/contains.h"
#include "support/patience.h"
#include "support/socket_pair.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

using FrameConnections = RemoteArm;

TEST_F(FrameConnections, OverTcpAreTheFastest) {
  begin("tcp://127.0.0.1:0");
  connect();
  EXPECT_EQ(channel()->lane, "frame");
  EXPECT_EQ(channel()->terms.laneReason, "the two processes are not reached by a Unix socket");
  EXPECT_EQ(outcomeOf(0.5), Errc{});
  EXPECT_TRUE(eventually([&] { return teleop.seen.load(); }));
}

TEST_F(FrameConnections, OverTlsAreTheFastest) {
  begin("tls://127.0.0.1:0");
  connect();
  EXPECT_EQ(channel()->lane, "frame");
  EXPECT_EQ(outcomeOf(0.5), Errc{});
  EXPECT_TRUE(eventually([&] { return teleop.seen.load(); }));
}

TEST_F(FrameConnections, AUnixSocketMayHaveThem) {
  begin(unixAddress());
  connect(Lane::Frame);
  EXPECT_EQ(channel()->lane, "frame");
  EXPECT_EQ(channel()->terms.laneReason, "");
  EXPECT_EQ(outcomeOf(0.5), Errc{});
}

TEST_F(FrameConnections, ServeAClientThatMayOnlyRead) {
  const Policy readers({{"user:same", {.full = {}, .read = {"*/*"}}}});
  begin(unixAddress(), readers);
  connect();
  EXPECT_EQ(channel()->lane, "frame");
  EXPECT_EQ(channel()->terms.laneReason, "the policy gives it for reading only");
  EXPECT_EQ(outcomeOf(0.5), Errc::NotPermitted);
  EXPECT_TRUE(eventually([&] { return teleop.seen.load(); }));
}

TEST_F(FrameConnections, RefuseWhatIsOutOfRange) {
  begin(unixAddress());
  connect(Lane::Frame);
  expectArgumentsJudged();
}

TEST_F(FrameConnections, GiveEverythingBack) {
  begin(unixAddress());
  expectEverythingGivenBack(Lane::Frame);
}

TEST_F(FrameConnections, ComeBackWhenTheirProviderDoes) {
  begin("tcp://127.0.0.1:0");
  connect();
  restartRobot();
  EXPECT_TRUE(eventually([&] { return teleop.reachable.load(); }));
  EXPECT_EQ(outcomeOf(0.5), Errc{});
  EXPECT_EQ(channel()->lane, "frame");
}

/// Both ends of each socket are in this process.
TEST_F(FrameConnections, ConnectionsOfOneProcessShareASocket) {
  constexpr std::size_t kMore = 8;
  for (std::size_t i = 0; i < kMore; ++i) others.push_back(std::make_unique<Teleop>());
  begin("tcp://127.0.0.1:0");
  connect();
  const std::size_t before = openSockets();
  for (std::size_t i = 0; i < kMore; ++i) {
    console->connect("Other" + std::to_string(i) + "/Slave", "robot:PSM/Arm");
    ASSERT_TRUE(eventually([&] { return others[i]->seen.load(); })) << i;
  }
  EXPECT_EQ(openSockets(), before) << "one control link and one for frames serve them all";
  EXPECT_EQ(outcomeOf(0.5), Errc{});
}

// Connections that are lost at once meet again on one link, whichever of them opens it.
TEST_F(FrameConnections, ShareASocketWhenTheyComeBack) {
  for (int i = 0; i < 8; ++i) others.push_back(std::make_unique<Teleop>());
  begin("tcp://127.0.0.1:0");
  connect();
  for (std::size_t i = 0; i < others.size(); ++i) {
    console->connect("Other" + std::to_string(i) + "/Slave", "robot:PSM/Arm");
  }
  const std::size_t before = openSockets();
  restartRobot();
  for (const auto& one : others) {
    EXPECT_TRUE(eventually([&] { return one->reachable.load(); }));
  }
  EXPECT_TRUE(eventually([&] { return teleop.reachable.load(); }));
  for (const auto& one : console->channels())
    EXPECT_EQ(one->lane, "frame") << one->terms.laneReason;
  EXPECT_TRUE(eventually([&] { return openSockets() <= before; })) << openSockets();
}

/// A Caller is a client of the robot that the test plays.
class Caller : public reference::PlayedClient {
 public:
  explicit Caller(const std::string& manager) : PlayedClient(manager, "robot") {}
  ~Caller() {
    control_.run(kPatience, [this] { connections_.clear(); });
  }

  struct Socket {
    std::uint32_t number = 0;
    framing::Token token;
  };
  /// Asks for a second connection.
  Socket socket() {
    return control_.run(kPatience, [this] {
      auto request = peer().socketRequest();
      request.setLane("frame");
      return request.send().then([](auto&& results) {
        Socket socket{results.getNumber(), {}};
        const auto token = results.getToken();
        std::memcpy(socket.token.data(), token.begin(),
                    std::min(token.size(), socket.token.size()));
        return socket;
      });
    });
  }
  /// Returns why the arm is not connected by frames on that socket; "" if it is.
  std::string connect(std::uint32_t socket, frame::Form form = frame::Form::Slots) {
    return control_.run(kPatience, [this, socket, form] {
      auto request = peer().connectRequest();
      reference::askForArm(request, "test");
      request.setLane("frame");
      auto frame = request.initBrings().initAs<wire::FrameRequest>();
      if (form == frame::Form::Slots) {
        frame.setLayout(memoryLayout(interfaceInfo<reference::ArmLike>()).c_str());
      }
      request.setNotices(kj::heap<Hearer>(refused_));
      frame.setSocket(socket);
      return request.send().then([this](auto&& results) -> std::string {
        if (results.isRefused()) return results.getRefused().getText();
        if (results.isDeclined()) return results.getDeclined();
        connections_.push_back(results.getAccepted().getConnection());
        number_ =
            results.getAccepted().getAnswer().template getAs<wire::FrameAnswer>().getConnection();
        return std::string();
      });
    });
  }
  /// Returns the number that the frames of that connection carry.
  std::uint32_t number() const { return number_; }
  /// Returns why the robot has refused what it was sent; "" if it has not.
  std::string refused() {
    return control_.run(kPatience, [this] { return refused_; });
  }

 private:
  /// The robot tells it.
  struct Hearer final : wire::Notices::Server {
    explicit Hearer(std::string& refused) : why(refused) {}
    kj::Promise<void> refused(RefusedContext context) override {
      why = context.getParams().getWhy();
      return kj::READY_NOW;
    }
    std::string& why;
  };

  std::uint32_t number_ = 0;
  std::string refused_;
  std::vector<wire::Connection::Client> connections_;
};

/// Opens a second connection, blocking, that shows the token.
kj::AutoCloseFd secondConnection(const net::Address& provider, const framing::Token& token) {
  const net::SocketAddress target(provider);
  kj::AutoCloseFd socket(::socket(AF_INET, SOCK_STREAM, 0));
  EXPECT_EQ(::connect(socket, target.get(), target.length), 0);
  const timeval patience{.tv_sec = 5, .tv_usec = 0};
  setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
  sendAll(socket, framing::preambleOf(token));
  return socket;
}

void subscribe(int socket, std::uint32_t epoch, std::uint32_t connection) {
  frame::FrameWriter writer(epoch);
  const frame::Subscription everything{0, 0, ~std::uint64_t{0}};
  const frame::Header header{.kind = frame::Kind::Subscribe, .call = 1, .connection = connection};
  std::memcpy(writer.begin(header, sizeof(everything)), &everything, sizeof(everything));
  writer.finish();
  sendAll(socket, writer.unsent());
}

/// Tells if the provider answers that the token is good; or, later, if it sends a row.
bool isServed(int socket) {
  std::byte answer[sizeof(framing::Token) + 8];
  return recv(socket, answer, sizeof(answer), MSG_WAITALL) == sizeof(answer);
}

TEST_F(FrameConnections, ATokenIsGoodForOneConnection) {
  begin("tcp://127.0.0.1:0");
  Caller caller(manager());
  caller.greet();
  const Caller::Socket socket = caller.socket();
  const kj::AutoCloseFd first = secondConnection(caller.provider(), socket.token);
  ASSERT_TRUE(isServed(first));
  const kj::AutoCloseFd replayed = secondConnection(caller.provider(), socket.token);
  EXPECT_FALSE(isServed(replayed));
  ASSERT_EQ(caller.connect(socket.number), "");
  subscribe(first, socket.number, caller.number());
  EXPECT_TRUE(isServed(first));
}

TEST_F(FrameConnections, OnlyOneSessionSharesASocket) {
  begin("tcp://127.0.0.1:0");
  Caller caller(manager()), other(manager());
  caller.greet();
  const Caller::Socket socket = caller.socket();
  EXPECT_EQ(caller.connect(socket.number), "the session's frames have ended")
      << "nobody has shown its token";
  ASSERT_TRUE(isServed(secondConnection(caller.provider(), socket.token)));
  EXPECT_EQ(other.connect(socket.number), "the session's frames have ended");
}

// The provider reads only a little of a stranger, and nothing would bound what it reads of a second
// connection.
TEST_F(FrameConnections, AStrangerGetsNoToken) {
  begin("tcp://127.0.0.1:0");
  Caller caller(manager());
  EXPECT_THROW(caller.socket(), loop::ControlFailure);
  caller.greet();
  caller.socket();
}

/// Begins values that are as large as may be, and ends none.
class Beginner : public Caller {
 public:
  explicit Beginner(const std::string& manager) : Caller(manager) {
    greet();
    const Socket opened = Caller::socket();
    socket_ = secondConnection(provider(), opened.token);
    EXPECT_TRUE(isServed(socket_));
    number_ = opened.number;
    writer_.emplace(number_);
  }
  /// Begins one on a connection of its own, and sends most of it.
  void begin() {
    ASSERT_EQ(connect(number_, frame::Form::Encoded), "");
    const frame::Header header{.kind = frame::Kind::Piece,
                               .number = static_cast<std::uint16_t>(frame::Kind::Command),
                               .call = 16u << 20,
                               .connection = number()};
    for (int piece = 0; piece < 250; ++piece) {
      std::memset(writer_->begin(header, frame::kMostPayload), 0, frame::kMostPayload);
      writer_->finish();
      while (!writer_->unsent().empty()) {
        if (!sendSome()) return;
      }
    }
  }

 private:
  /// Returns false once the robot takes no more: it may have ended the link and keep its socket.
  bool sendSome() {
    pollfd ready{.fd = socket_, .events = POLLOUT | POLLRDHUP, .revents = 0};
    poll(&ready, 1, -1);
    if ((ready.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0) return false;
    const auto unsent = writer_->unsent();
    const ssize_t count =
        ::send(socket_, unsent.data(), unsent.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0) return errno == EAGAIN;
    writer_->sent(static_cast<std::size_t>(count));
    return true;
  }

  kj::AutoCloseFd socket_;
  std::uint32_t number_ = 0;
  std::optional<frame::FrameWriter> writer_;
};

// Neither takes more than a link may.
TEST_F(FrameConnections, OfAPeerTakeFromOneBudget) {
  begin("tcp://127.0.0.1:0");
  Beginner first(manager()), second(manager());
  for (int value = 0; value < 3; ++value) first.begin();
  EXPECT_EQ(robot->refusals().count, 0u) << robot->refusals().latest;
  for (int value = 0; value < 2; ++value) second.begin();
  const std::string why =
      "the unfinished messages of a peer without proof of who it is (plain TCP) would need more "
      "than 67108864 bytes. Send smaller ones, or fewer at a time";
  EXPECT_TRUE(eventually([&] { return contains(robot->refusals().latest, why); }))
      << robot->refusals().latest;
  EXPECT_EQ(robot->refusals().count, 1u);
  EXPECT_TRUE(eventually([&] { return second.refused() == why; })) << second.refused();
  EXPECT_EQ(first.refused(), "");
}

TEST_F(FrameConnections, ASenselessFrameIsTold) {
  begin("tcp://127.0.0.1:0");
  Caller caller(manager());
  caller.greet();
  const Caller::Socket socket = caller.socket();
  const kj::AutoCloseFd frames = secondConnection(caller.provider(), socket.token);
  ASSERT_TRUE(isServed(frames));
  ASSERT_EQ(caller.connect(socket.number), "");
  subscribe(frames, socket.number + 1, caller.number());
  EXPECT_TRUE(eventually([&] { return !caller.refused().empty(); }));
  EXPECT_TRUE(contains(robot->refusals().latest, caller.refused())) << robot->refusals().latest;
}

TEST_F(FrameConnections, AForgedTokenIsRefused) {
  begin("tcp://127.0.0.1:0");
  Caller caller(manager());
  caller.greet();
  framing::Token token = caller.socket().token;
  token[7] ^= std::byte{1};
  EXPECT_FALSE(isServed(secondConnection(caller.provider(), token)));
}

}  // namespace
}  // namespace suture
