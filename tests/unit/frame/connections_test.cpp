// What becomes of connections that might use frames.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <suture/component/channel.h>
#include <suture/component/periodic_task.h>
#include <suture/manager/global_manager.h>
#include <suture/manager/manager.h>
#include <suture/manager/manager_link.h>
#include <suture/peer.capnp.h>
#include <suture/transport/frame/frame_writer.h>
#include <suture/transport/rpc/control_thread.h>
#include <suture/transport/rpc/link.h>
#include <suture/transport/rpc/opening.h>
#include <suture/transport/shm/memory_layout.h>
#include <suture/transport/tls/key_maker.h>

#include <filesystem>
#include <limits>

#include "reference/still_arm.h"
#include "support/eventually.h"
#include "support/temporary_directory.h"
#include "unit/rpc/socket_pair.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::PoseStamped;

struct Psm final : PeriodicTask, StillArm {
  Psm() : PeriodicTask({.period = 1ms}) {}
  ~Psm() override { stop(); }
  void run() override {}
  bool move(const PoseStamped&, double, const std::string&) override { return true; }
  Provided<ArmLike> port{*this, "Arm", *this};
};

struct Teleop final : PeriodicTask {
  Teleop() : PeriodicTask({.period = 1ms}) {}
  ~Teleop() override { stop(); }
  void run() override {
    if (asked.exchange(false)) {
      call = slave.move.start({}, speed, "test");
      waiting = true;
    }
    if (waiting && call.poll() != nullptr) {
      waiting = false;
      outcome = call.poll()->has_value() ? Errc{} : call.poll()->error();
    }
    reachable = slave.connected();
    seen = slave.measured_cp().hasValue();
  }
  std::atomic<bool> asked{false}, reachable{false}, seen{false};
  std::atomic<double> speed{0};
  bool waiting = false;
  std::atomic<Errc> outcome{Errc::NotYet};
  Required<ArmLike> slave{*this, "Slave"};
  decltype(std::declval<Required<ArmLike>&>().move.start({}, 0, "")) call{Errc::NotYet};
};

std::size_t openDescriptors() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

class FrameConnections : public testing::Test {
 protected:
  void begin(const std::string& address, Policy policy = {}) {
    if (address.starts_with("tls:")) {
      tls::makeKeys(directory_.path() / "keys", {tls::kManagerName, "robot", "console"});
    }
    global_ = std::make_unique<GlobalManager>(control_, address, securityOf(tls::kManagerName));
    robot = std::make_unique<Manager>("robot", global_->address(), securityOf("robot", policy));
    console = std::make_unique<Manager>("console", global_->address(), securityOf("console"));
    robot->add("PSM", psm);
    console->add("Teleop", teleop);
    robot->start();
    console->start();
  }
  std::string unixAddress() const { return "unix:" + directory_.file("manager.sock"); }
  Security securityOf(const std::string& process, Policy policy = {}) const {
    const auto folder = directory_.path() / "keys";
    if (!exists(folder)) return {.policy = std::move(policy)};
    return {.keys = std::make_shared<const tls::Keys>(folder, process),
            .policy = std::move(policy)};
  }
  void connect(Lane lane = Lane::Auto) {
    console->connect("Teleop/Slave", "robot:PSM/Arm", lane);
    ASSERT_TRUE(eventually([&] { return teleop.reachable.load(); }));
  }
  std::shared_ptr<Channel> channel() const { return console->channels().at(0); }
  Errc outcomeOf(double speed) {
    teleop.outcome = Errc::NotYet;
    teleop.speed = speed;
    teleop.asked = true;
    EXPECT_TRUE(eventually([&] { return teleop.outcome != Errc::NotYet; }));
    return teleop.outcome;
  }
  const std::string& manager() const { return global_->address(); }

  Psm psm;
  Teleop teleop;
  std::unique_ptr<Manager> robot, console;

 private:
  TemporaryDirectory directory_;
  rpc::ControlThread control_;
  std::unique_ptr<GlobalManager> global_;
};

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
  Policy readers({{"user:same", {.full = {}, .read = {"*/*"}}}});
  begin(unixAddress(), std::move(readers));
  connect();
  EXPECT_EQ(channel()->lane, "frame");
  EXPECT_EQ(channel()->laneReason, "the policy gives it for reading only");
  EXPECT_EQ(outcomeOf(0.5), Errc::NotPermitted);
  EXPECT_TRUE(eventually([&] { return teleop.seen.load(); }));
}

TEST_F(FrameConnections, RefuseWhatIsOutOfRangeAndNoNumber) {
  begin(unixAddress());
  connect(Lane::Frame);
  EXPECT_EQ(outcomeOf(0.5), Errc{});
  EXPECT_EQ(outcomeOf(1.5), Errc::Invalid);
  EXPECT_EQ(outcomeOf(std::numeric_limits<double>::quiet_NaN()), Errc::Invalid);
  EXPECT_EQ(outcomeOf(1), Errc{});
}

TEST_F(FrameConnections, GiveEverythingBack) {
  begin(unixAddress());
  connect(Lane::Frame);
  console->disconnect("Teleop/Slave");
  ASSERT_TRUE(eventually([&] { return !teleop.reachable; }));
  std::size_t before = 0;
  for (int lap = 0; lap < 50; ++lap) {
    connect(Lane::Frame);
    EXPECT_EQ(channel()->lane, "frame");
    console->disconnect("Teleop/Slave");
    ASSERT_TRUE(eventually([&] { return !teleop.reachable; }));
    if (lap == 4) before = openDescriptors();
  }
  EXPECT_TRUE(eventually([&] { return openDescriptors() <= before + 3; })) << openDescriptors();
}

TEST_F(FrameConnections, ComeBackWhenTheirProviderDoes) {
  begin("tcp://127.0.0.1:0");
  connect();
  robot->stop();
  robot.reset();
  EXPECT_TRUE(eventually([&] { return !teleop.reachable; }));
  Psm again;
  Manager restarted("robot", manager());
  restarted.add("PSM", again);
  restarted.start();
  EXPECT_TRUE(eventually([&] { return teleop.reachable.load(); }));
  EXPECT_EQ(outcomeOf(0.5), Errc{});
  EXPECT_EQ(channel()->lane, "frame");
  restarted.stop();
}

/// A caller that plays the client's end itself.
class Caller {
 public:
  explicit Caller(const std::string& manager) : manager_(rpc::Address::parse(manager)) {}

  struct Offer {
    std::uint32_t epoch = 0;
    rpc::Token token;
    rpc::Address provider;
  };

  /// Connects as a client would, up to the second connection. The offer is good as long as this.
  Offer connect() {
    return control_.run(5s, [this] {
      link_ = kj::heap<ManagerLink>(control_, std::vector{manager_}, "test");
      return link_->open(5s)
          .then([this] { return link_->resolve("robot", 5s); })
          .then([this](ProcessRecord robot) {
            offer_.provider = rpc::Address::parse(robot.addresses.at(0));
            return link_->reach(robot, 5s);
          })
          .then([this](rpc::ByteStream bytes) {
            auto stream = kj::heap<rpc::MessageStream>(control_.port(), kj::mv(bytes));
            peer_ = kj::heap<rpc::Link>(kj::mv(stream), capnp::rpc::twoparty::Side::CLIENT);
            return ask(peer_->bootstrap<wire::Peer>());
          });
    });
  }
  ~Caller() {
    control_.run(5s, [this] {
      connection_ = nullptr;
      peer_ = nullptr;
      link_ = nullptr;
    });
  }

 private:
  kj::Promise<Offer> ask(wire::Peer::Client peer) {
    const InterfaceInfo& contract = interfaceInfo<ArmLike>();
    auto request = peer.connectRequest();
    request.setFromProcess("test");
    request.setFromComponent("Test");
    request.setRequired("Slave");
    request.setToComponent("PSM");
    request.setProvided("Arm");
    request.setContract(contract.name);
    request.setHash(contract.hash);
    request.setDescription(contract.description);
    request.initFrame().setLayout(shm::memoryLayout(contract).c_str());
    return request.send().then([this](auto&& results) {
      connection_ = results.getAccepted().getConnection();
      const auto frame = results.getAccepted().getFrame();
      offer_.epoch = frame.getEpoch();
      std::copy_n(reinterpret_cast<const std::byte*>(frame.getToken().begin()), offer_.token.size(),
                  offer_.token.begin());
      return offer_;
    });
  }

  rpc::ControlThread control_;
  const rpc::Address manager_;
  Offer offer_;
  kj::Own<ManagerLink> link_;
  kj::Own<rpc::Link> peer_;
  kj::Maybe<wire::Connection::Client> connection_;
};

/// A second connection, blocking, that shows the offer's token and sends a subscription.
kj::AutoCloseFd secondConnection(const Caller::Offer& offer) {
  const rpc::SocketAddress target(offer.provider);
  kj::AutoCloseFd socket(::socket(AF_INET, SOCK_STREAM, 0));
  EXPECT_EQ(::connect(socket, target.get(), target.length), 0);
  const timeval patience{.tv_sec = 5, .tv_usec = 0};
  setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
  rpc::sendAll(socket, rpc::openingOf(offer.token));
  frame::FrameWriter writer(offer.epoch, sizeof(frame::Subscription));
  const frame::Subscription everything{0, 0, ~std::uint64_t{0}};
  std::memcpy(writer.begin({.kind = frame::Kind::Subscribe, .call = 1}, sizeof(everything)),
              &everything, sizeof(everything));
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

TEST_F(FrameConnections, ATokenThatNobodyGaveIsGoodForNothing) {
  begin("tcp://127.0.0.1:0");
  Caller caller(manager());
  Caller::Offer offer = caller.connect();
  offer.token[7] ^= std::byte{1};
  EXPECT_FALSE(isServed(secondConnection(offer)));
}

}  // namespace
}  // namespace suture
