// A client that breaks the protocol, or asks for too much, is told what it did.

#include <gtest/gtest.h>
#include <suture/calls.capnp.h>
#include <suture/loop/failure.h>
#include <suture/names/records.h>
#include <suture/shm.capnp.h>
#include <suture/wiring/memory_layout.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "reference/connect_request.h"
#include "reference/played_client.h"
#include "reference/remote_arm.h"
#include "support/contains.h"
#include "support/patience.h"
#include "support/refusal.h"

namespace suture::broken_clients {
namespace {

class Client : public reference::PlayedClient {
 public:
  explicit Client(const std::string& manager, const std::string& process = "robot")
      : PlayedClient(manager, process) {}
  ~Client() {
    control_.run(kPatience, [this] {
      asked_.clear();
      bells_.clear();
      link_ = nullptr;
      opened_.clear();
    });
  }

  /// Pings, and says that it watches so many components.
  void watch(unsigned components) {
    control_.run(kPatience, [&] {
      auto request = peer().pingRequest();
      request.initComponents(components);
      return request.send().ignoreResult();
    });
  }
  /// Pings, and says that it watches a component of that name.
  void watch(const std::string& component) {
    control_.run(kPatience, [&] {
      auto request = peer().pingRequest();
      request.initComponents(1).set(0, component.c_str());
      return request.send().ignoreResult();
    });
  }
  /// Says hello. Returns what it is refused with.
  std::string greetAs(const std::string& process, const std::string& bootId) {
    return control_.run(kPatience, [&] {
      auto request = peer().helloRequest();
      request.setVersion(wire::PROTOCOL_VERSION);
      request.setProcess(process.c_str());
      request.setBootId(bootId.c_str());
      return request.send().then([](auto&& results) {
        return results.isRefused() ? fromWire(results.getRefused()).text : std::string();
      });
    });
  }
  /// Asks for the arm, with one of the texts of the request as `change(request)` leaves it. Returns
  /// what it is refused with.
  std::string connectAs(const std::function<void(wire::ConnectRequest::Builder)>& change) {
    return control_.run(kPatience, [&] {
      auto request = peer().connectRequest();
      reference::askForArm(request, "test");
      change(request);
      return request.send().then([](auto&& results) {
        return results.isRefused() ? fromWire(results.getRefused()).text : std::string();
      });
    });
  }
  void openSocket() {
    control_.run(kPatience, [this] {
      return reference::openSecondSocket(control_.port(), provider(), peer()).ignoreResult();
    });
  }
  /// Shows a token that it was not given.
  void forge() {
    control_.run(kPatience, [this] {
      return net::dial(control_.port(), provider(), kPatience)
          .then([this](kj::AutoCloseFd socket) {
            return framing::exchangeToken(control_.port(), net::ByteStream(kj::mv(socket)),
                                          framing::Token{});
          })
          .ignoreResult();
    });
  }
  /// Opens an interface. Returns what that is refused with.
  std::string open(const std::string& component, const std::string& interface) {
    return control_.run(kPatience, [&] {
      auto request = peer().openRequest();
      request.setComponent(component.c_str());
      request.setInterface(interface.c_str());
      return request.send().then([this](auto&& results) {
        if (results.isRefused()) return fromWire(results.getRefused()).text;
        opened_.push_back(results.getContract());
        return std::string();
      });
    });
  }
  /// Asks for the contract of an interface. Returns what that is refused with.
  std::string explain(const std::string& component, const std::string& interface) {
    return control_.run(kPatience, [&] {
      auto request = peer().explainRequest();
      request.setComponent(component.c_str());
      request.setInterface(interface.c_str());
      return request.send().then([](auto&& results) {
        return results.isRefused() ? fromWire(results.getRefused()).text : std::string();
      });
    });
  }
  /// Asks what the process has, and awaits no answer.
  void askForAll() {
    control_.run(kPatience, [this] {
      wire::Peer::Client robot = peer();
      asked_.push_back(robot.describeRequest().send().then([](auto&&) { return true; },
                                                           [](kj::Exception&&) { return false; }));
      return robot.pingRequest().send().ignoreResult();
    });
  }
  /// Opens the arm so often. Returns what the last attempt is refused with.
  std::string openArm(std::size_t times) {
    std::string refused;
    for (std::size_t i = 0; i < times; ++i) refused = openArm();
    return refused;
  }
  /// Opens the arm so often at once, and awaits no answer.
  void askForArm(std::size_t times) {
    control_.run(kPatience, [this, times] {
      wire::Peer::Client robot = peer();
      for (std::size_t i = 0; i < times; ++i) {
        auto request = robot.openRequest();
        request.setComponent("PSM");
        request.setInterface("Arm");
        asked_.push_back(request.send().then([this](auto&& results) {
          if (results.isContract()) opened_.push_back(results.getContract());
          return results.isContract();
        }));
      }
      return robot.pingRequest().send().ignoreResult();
    });
  }
  /// Connects to the arm so often by shared memory, and keeps back the bells that the process
  /// needs.
  void askForSharedArm(std::size_t times) {
    constexpr std::size_t kBatch = 64;  // a slow process has to read each message within seconds
    for (std::size_t asked = 0; asked < times; asked += kBatch) {
      askForSharedArmAtOnce(std::min(kBatch, times - asked));
    }
  }
  void askForSharedArmAtOnce(std::size_t times) {
    control_.run(kPatience, [this, times] {
      wire::Peer::Client robot = peer();
      for (std::size_t i = 0; i < times; ++i) {
        auto request = robot.connectRequest();
        reference::askForArm(request, "test");
        request.setDescription("");
        request.setLane("shm");
        auto shared = request.initBrings().initAs<wire::SharedRequest>();
        shared.setLayout(memoryLayout(interfaceInfo<reference::ArmLike>()).c_str());
        auto bell = kj::newPromiseAndFulfiller<wire::SharedMemory::Client>();
        shared.setBell(kj::mv(bell.promise));
        bells_.push_back(kj::mv(bell.fulfiller));
        asked_.push_back(request.send().then([](auto&& results) { return results.isAccepted(); }));
      }
      return robot.pingRequest().send().ignoreResult();
    });
  }
  /// Gives the process no bell after all.
  void withholdBells() {
    control_.run(kPatience, [this] {
      for (auto& bell : bells_) bell->reject(loop::disconnected("there is no bell"));
    });
  }
  /// Awaits what it asked for no longer.
  void giveUp() {
    control_.run(kPatience, [this] { asked_.clear(); });
  }
  /// Returns how much of what it asked for it has been given.
  std::size_t given() {
    return control_.run(kPatience, [this] {
      auto asked = kj::heapArrayBuilder<kj::Promise<bool>>(asked_.size());
      for (auto& one : asked_) asked.add(kj::mv(one));
      asked_.clear();
      return kj::joinPromises(asked.finish()).then([](kj::Array<bool> answers) {
        return static_cast<std::size_t>(std::count(answers.begin(), answers.end(), true));
      });
    });
  }
  /// Drops all that it has opened.
  void letGo() {
    control_.run(kPatience, [this] { opened_.clear(); });
  }
  /// Returns why the arm is not connected by calls on a socket of that number.
  std::string connect(std::uint32_t socket) {
    return control_.run(kPatience, [&] {
      auto request = peer().connectRequest();
      reference::askForArm(request, "test");
      request.initBrings().initAs<wire::CallsRequest>().setSocket(socket);
      return request.send().then([](auto&& results) -> std::string {
        return results.isDeclined() ? results.getDeclined().cStr() : "";
      });
    });
  }
  /// Asks on a socket for a connection of that number.
  void askForContract(std::uint32_t connection) {
    control_.run(kPatience, [&] {
      return reference::openSecondSocket(control_.port(), provider(), peer())
          .then([this, connection](reference::SecondSocket socket) {
            auto stream = kj::heap<framing::MessageStream>(control_.port(), kj::mv(socket.bytes));
            link_ = kj::heap<framing::Link>(kj::mv(stream), capnp::rpc::twoparty::Side::CLIENT);
            auto request = link_->bootstrap<wire::Calls>().contractRequest();
            request.setConnection(connection);
            return request.send().ignoreResult();
          });
    });
  }

 private:
  std::string openArm() { return open("PSM", "Arm"); }
  kj::Own<framing::Link> link_;
  std::vector<kj::Promise<bool>> asked_;
  std::vector<kj::Own<kj::PromiseFulfiller<wire::SharedMemory::Client>>> bells_;
  std::vector<capnp::Capability::Client> opened_;
};

class BrokenClient : public RemoteArm {
 protected:
  void SetUp() override { begin("tcp://127.0.0.1:0"); }
};

/// A BrokenNeighbour is on the same machine.
class BrokenNeighbour : public RemoteArm {
 protected:
  void SetUp() override { begin(unixAddress()); }
};

TEST_F(BrokenClient, WatchesTooMuch) {
  Client client(manager());
  client.greet();
  client.watch(1024);
  EXPECT_TRUE(contains(refusal([&] { client.watch(1025); }),
                       "more components are watched than can be connected to"));
}

// What a client says of itself is kept for as long as its sessions live, and some of it longer.
TEST_F(BrokenClient, HasNamesWithoutEnd) {
  Client client(manager());
  const std::string longest(256, 'n'), longer(257, 'n');
  const std::string why =
      "': the caller gives a name of 257 bytes, and none may have more than 256. Choose a shorter "
      "one.";
  EXPECT_EQ(client.greetAs(longer, "boot"), "talk to process 'robot" + why);
  EXPECT_EQ(client.greetAs("test", longer), "talk to process 'robot" + why);
  EXPECT_EQ(client.greetAs(longest, longest), "");
  const std::function<void(wire::ConnectRequest::Builder)> changes[] = {
      [&](auto request) { request.setFromProcess(longer.c_str()); },
      [&](auto request) { request.setFromComponent(longer.c_str()); },
      [&](auto request) { request.setRequired(longer.c_str()); },
      [&](auto request) { request.setToComponent(longer.c_str()); },
      [&](auto request) { request.setProvided(longer.c_str()); },
      [&](auto request) { request.setContract(longer.c_str()); },
      [&](auto request) { request.setHash(longer.c_str()); }};
  for (const auto& change : changes) {
    EXPECT_EQ(client.connectAs(change), "talk to process 'robot" + why);
  }
  for (const auto& [component, interface] : {std::pair(longer, longest), {longest, longer}}) {
    EXPECT_EQ(client.open(component, interface), "talk to process 'robot" + why);
    EXPECT_EQ(client.explain(component, interface), "talk to process 'robot" + why);
  }
  EXPECT_EQ(client.connectAs([&](auto request) { request.setRequired(longest.c_str()); }), "");
  client.watch(longest);
  EXPECT_TRUE(contains(refusal([&] { client.watch(longer); }), "a name of 257 bytes"));
}

TEST_F(BrokenClient, AsksForASocketTooEarly) {
  Client client(manager());
  EXPECT_TRUE(contains(refusal([&] { client.openSocket(); }),
                       "a second connection is for whoever has said hello"));
  client.greet();
  client.openSocket();
}

TEST_F(BrokenClient, AsksForContractsBeforeItSaysHello) {
  Client client(manager());
  EXPECT_TRUE(contains(refusal([&] { client.explain("PSM", "Arm"); }),
                       "what there is here is told to whoever has said hello"));
  client.greet();
  EXPECT_EQ(client.explain("PSM", "Arm"), "");
}

TEST_F(BrokenClient, ShowsATokenOfItsOwn) {
  Client client(manager());
  EXPECT_TRUE(
      contains(refusal([&] { client.forge(); }), "nobody awaits a second connection there"));
  const std::string why =
      "open a second connection to process 'robot': it awaits none that shows this token. "
      "Connect anew.";
  EXPECT_TRUE(eventually([&] { return contains(robot->refusals().latest, why); }))
      << robot->refusals().latest;
}

TEST_F(BrokenClient, ConnectsOnAMissingSocket) {
  Client client(manager());
  client.greet();
  EXPECT_EQ(client.connect(77), "the session's calls have ended");
}

TEST_F(BrokenClient, AsksAboutAMissingConnection) {
  Client client(manager());
  client.greet();
  EXPECT_TRUE(contains(refusal([&] { client.askForContract(77); }),
                       "no such connection has been accepted on this socket"));
  EXPECT_EQ(robot->refusals().count, 1u);
  EXPECT_TRUE(contains(robot->refusals().latest, "no such connection has been accepted on this"))
      << robot->refusals().latest;
}

TEST_F(BrokenClient, NeverLetsGoOfWhatItOpens) {
  Client client(manager());
  client.greet();
  EXPECT_EQ(client.openArm(1024), "");
  EXPECT_EQ(client.openArm(1),
            "use 'robot:PSM/Arm': this process has been given 1024 interfaces, and none is given "
            "more. Let go of some.");
}

// The process ends what its client has, and what that awaits.
TEST_F(BrokenClient, AwaitsAProcessThatLeavesEarly) {
  auto starting = std::make_unique<Manager>("starting", manager());
  starting->add("PSM", psmAgain);
  Client client(manager(), "starting");
  client.greet();
  ASSERT_EQ(client.open("PSM", "Arm"), "");
  client.askForAll();
  starting.reset();
  EXPECT_EQ(client.given(), 0u);
}

// Requests that wait for the start of the process are all answered at once when it starts.
TEST_F(BrokenClient, OpensTooMuchTooEarly) {
  Manager starting("starting", manager());
  Client client(manager(), "starting");
  client.greet();
  client.askForArm(1100);
  starting.add("PSM", psmAgain);
  starting.start();
  EXPECT_EQ(client.given(), 1024u);
}

TEST_F(BrokenNeighbour, ConnectsTooOftenAtTheSameTime) {
  Client client(manager());
  client.greet();
  client.askForSharedArm(1024);
  EXPECT_TRUE(contains(client.openArm(1), "has been given 1024 interfaces"));
  client.withholdBells();
  EXPECT_EQ(client.given(), 0u);
  EXPECT_EQ(client.openArm(1), "") << "those that were declined take no place";
}

// A client that comes back to a process that is slow to start asks anew again and again.
TEST_F(BrokenNeighbour, MayConnectAgainAfterGivingUp) {
  Client client(manager());
  client.greet();
  client.askForSharedArm(1024);
  client.giveUp();
  EXPECT_EQ(client.openArm(1), "");
}

// Such a client only drops its capability. That tells the process that nobody uses the interface.
TEST_F(BrokenClient, MayOpenAgainAfterLettingGo) {
  Client client(manager());
  client.greet();
  for (int lap = 0; lap < 1100; ++lap) {
    ASSERT_EQ(client.openArm(1), "") << lap;
    client.letGo();
  }
  client.watch(0);  // the process looks then which connections are over
  client.watch(0);  // the client has been heard since, so it has not left
  EXPECT_TRUE(eventually([&] { return robot->channels().empty(); })) << robot->channels().size();
}

// A client has many sockets, so that its last ping may come after the end of what it sent before.
// Reports keep the sums of a client that has left.
TEST_F(BrokenClient, ALatePingIsReported) {
  {
    Client client(manager());
    client.greet();
    ASSERT_EQ(client.openArm(1), "");
    client.letGo();
    client.watch(0);
  }
  ASSERT_EQ(robot->channels().size(), 1u);
  EXPECT_EQ(robot->channels()[0]->status, ChannelStatus::Closed);
}

}  // namespace
}  // namespace suture::broken_clients
