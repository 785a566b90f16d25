// What becomes of connections that might use frames.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <suture/framing/link.h>
#include <suture/framing/preamble.h>
#include <suture/lane/frame/codec/frame_writer.h>
#include <suture/names/manager_link.h>
#include <suture/peer.capnp.h>
#include <suture/wiring/memory_layout.h>

#include <algorithm>
#include <cstring>

#include "reference/connect_request.h"
#include "reference/remote_arm.h"
#include "support/patience.h"
#include "unit/rpc/socket_pair.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

using FrameConnections = RemoteArm;

TEST_F(FrameConnections, OverTcpAreTheFastest) {
  begin("tcp://127.0.0.1:0");
  connect();
  EXPECT_EQ(channel()->lane, "frame");
  EXPECT_EQ(channel()->laneReason, "the two processes are not reached by a Unix socket");
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

TEST_F(FrameConnections, AskedForOnAUnixSocketAreHandedOver) {
  begin(unixAddress());
  connect(Lane::Frame);
  EXPECT_EQ(channel()->lane, "frame");
  EXPECT_EQ(channel()->laneReason, "");
  EXPECT_EQ(outcomeOf(0.5), Errc{});
}

TEST_F(FrameConnections, ServeWhoMayOnlyRead) {
  const Policy readers({{"user:same", {.full = {}, .read = {"*/*"}}}});
  begin(unixAddress(), readers);
  connect();
  EXPECT_EQ(channel()->lane, "frame");
  EXPECT_EQ(channel()->laneReason, "the policy gives it for reading only");
  EXPECT_EQ(outcomeOf(0.5), Errc::NotPermitted);
  EXPECT_TRUE(eventually([&] { return teleop.seen.load(); }));
}

TEST_F(FrameConnections, RefuseWhatIsOutOfRangeAndNoNumber) {
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
TEST_F(FrameConnections, OfOneProcessShareASocket) {
  constexpr std::size_t kMore = 8;
  for (std::size_t i = 0; i < kMore; ++i) others.push_back(std::make_unique<Teleop>());
  begin("tcp://127.0.0.1:0");
  connect();
  const std::size_t before = openSockets();
  for (std::size_t i = 0; i < kMore; ++i) {
    console->connect("Other" + std::to_string(i) + "/Slave", "robot:PSM/Arm");
    ASSERT_TRUE(eventually([&] { return others[i]->seen.load(); })) << i;
  }
  EXPECT_EQ(openSockets(), before + 2 * kMore);  // of control connections
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
  for (const auto& one : console->channels()) EXPECT_EQ(one->lane, "frame") << one->laneReason;
  EXPECT_TRUE(eventually([&] { return openSockets() <= before; })) << openSockets();
}

/// A caller that plays the client's end itself.
class Caller {
 public:
  explicit Caller(const std::string& manager) : manager_(rpc::Address::parse(manager)) {}

  struct Offer {
    std::uint32_t epoch = 0, connection = 0;
    bool hasToken = false;
    rpc::Token token;
    rpc::Address provider;
  };

  /// Connects as a client would, up to the second connection. The offer is good as long as this.
  /// `client`: whose connections share a socket.
  Offer connect(const std::string& client = "") {
    return control_.run(kPatience, [this, client] {
      link_ = kj::heap<ManagerLink>(control_, std::vector{manager_}, "test");
      return link_->open(kPatience)
          .then([this] { return link_->resolve("robot", kPatience); })
          .then([this](ProcessRecord robot) {
            offer_.provider = rpc::Address::parse(robot.addresses.at(0));
            return link_->reach(robot, kPatience);
          })
          .then([this, client](rpc::ByteStream bytes) {
            auto stream = kj::heap<rpc::MessageStream>(control_.port(), kj::mv(bytes));
            peers_.add(kj::heap<rpc::Link>(kj::mv(stream), capnp::rpc::twoparty::Side::CLIENT));
            return ask(peers_.back()->bootstrap<wire::Peer>(), client);
          });
    });
  }
  ~Caller() {
    control_.run(kPatience, [this] {
      connections_.clear();
      peers_.clear();
      link_ = nullptr;
    });
  }

 private:
  kj::Promise<Offer> ask(wire::Peer::Client peer, const std::string& client) {
    auto request = peer.connectRequest();
    reference::askForArm(request, "test");
    auto frame = request.initFrame();
    frame.setLayout(memoryLayout(interfaceInfo<reference::ArmLike>()).c_str());
    frame.setClient(kj::StringPtr(client.c_str(), client.size()).asBytes());
    return request.send().then([this](auto&& results) {
      connections_.add(results.getAccepted().getConnection());
      const auto offer = results.getAccepted().getFrame();
      offer_.epoch = offer.getEpoch();
      offer_.connection = offer.getConnection();
      offer_.hasToken = offer.hasToken();
      std::copy_n(reinterpret_cast<const std::byte*>(offer.getToken().begin()),
                  offer.getToken().size(), offer_.token.begin());
      return offer_;
    });
  }

  rpc::ControlThread control_;
  const rpc::Address manager_;
  Offer offer_;
  kj::Own<ManagerLink> link_;
  kj::Vector<kj::Own<rpc::Link>> peers_;
  kj::Vector<wire::Connection::Client> connections_;
};

/// A second connection, blocking, that shows the offer's token and sends a subscription.
kj::AutoCloseFd secondConnection(const Caller::Offer& offer) {
  const rpc::SocketAddress target(offer.provider);
  kj::AutoCloseFd socket(::socket(AF_INET, SOCK_STREAM, 0));
  EXPECT_EQ(::connect(socket, target.get(), target.length), 0);
  const timeval patience{.tv_sec = 5, .tv_usec = 0};
  setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
  rpc::sendAll(socket, rpc::preambleOf(offer.token));
  frame::FrameWriter writer(offer.epoch, sizeof(frame::Subscription));
  const frame::Subscription everything{0, 0, ~std::uint64_t{0}};
  const frame::Header header{
      .kind = frame::Kind::Subscribe, .call = 1, .connection = offer.connection};
  std::memcpy(writer.begin(header, sizeof(everything)), &everything, sizeof(everything));
  writer.finish();
  rpc::sendAll(socket, writer.unsent());
  return socket;
}

/// That the token is good; or, later, a row.
bool isServed(int socket) {
  std::byte answer[sizeof(rpc::Token) + 8];
  return recv(socket, answer, sizeof(answer), MSG_WAITALL) == sizeof(answer);
}

TEST_F(FrameConnections, ATokenIsGoodForOneConnection) {
  begin("tcp://127.0.0.1:0");
  Caller caller(manager());
  const Caller::Offer offer = caller.connect();
  const kj::AutoCloseFd first = secondConnection(offer);
  EXPECT_TRUE(isServed(first));
  const kj::AutoCloseFd replayed = secondConnection(offer);
  EXPECT_FALSE(isServed(replayed));
  EXPECT_TRUE(isServed(first));
}

TEST_F(FrameConnections, OnlyThoseOfOneClientShareASocket) {
  begin("tcp://127.0.0.1:0");
  Caller caller(manager());
  const Caller::Offer first = caller.connect("one"), second = caller.connect("one"),
                      other = caller.connect("other"), nobodys = caller.connect(),
                      nobodysToo = caller.connect();
  EXPECT_TRUE(first.hasToken);
  EXPECT_FALSE(second.hasToken);
  EXPECT_EQ(second.epoch, first.epoch);
  EXPECT_NE(second.connection, first.connection);
  for (const Caller::Offer& own : {other, nobodys, nobodysToo}) {
    EXPECT_TRUE(own.hasToken);
    EXPECT_NE(own.epoch, first.epoch);
  }
  EXPECT_NE(nobodys.epoch, nobodysToo.epoch);
}

TEST_F(FrameConnections, ATokenThatNobodyGaveIsGoodForNothing) {
  begin("tcp://127.0.0.1:0");
  Caller caller(manager());
  Caller::Offer offer = caller.connect();
  offer.token[7] ^= std::byte{1};
  EXPECT_FALSE(isServed(secondConnection(offer)));
}

}  // namespace
}  // namespace suture
