// A global manager and processes that talk to it over real sockets; every process is a control
// thread.

#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/loop/control_thread.h>
#include <suture/loop/failure.h>
#include <suture/names/global_manager.h>
#include <suture/names/manager_link.h>
#include <suture/names/manager_session.h>
#include <suture/net/dialer.h>

#include <memory>
#include <string>

#include "support/eventually.h"
#include "support/pass.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

/// A Peer is a process as the manager sees it.
class Peer {
 public:
  Peer(const std::string& name, const std::string& manager)
      : link_(control_.run(kPatience,
                           [this, name, manager] {
                             return std::make_unique<ManagerLink>(
                                 control_, net::parseAddresses(manager), name);
                           })),
        name_(name) {}
  ~Peer() {
    control_.run(kPatience, [this] {
      waits_.clear();
      awaited_ = nullptr;
      link_.reset();
    });
  }

  void open(Duration patience = 5s) {
    control_.run(kPatience, [this, patience] { return link_->open(patience); });
  }
  void enrol() {
    control_.run(kPatience, [this] { return link_->enrol(self()); });
  }
  /// Registers, and tells of other components before the manager has answered.
  void enrolAndUpdate(const std::vector<ComponentRecord>& components) {
    control_.run(kPatience, [this, components] {
      auto enrolled = link_->enrol(self());
      link_->update(components);
      return enrolled;
    });
  }
  void update(const std::vector<ComponentRecord>& components) {
    control_.run(kPatience, [this, components] { link_->update(components); });
  }
  ProcessRecord resolve(const std::string& name, Duration wait = 0s) {
    return control_.run(wait + 10s, [this, name, wait] { return link_->resolve(name, wait); });
  }
  /// Waits so often for a process that nobody starts, until stopWaiting().
  void wait(std::size_t times) {
    control_.run(kPatience, [this, times] {
      for (std::size_t i = 0; i < times; ++i) waits_.add(link_->resolve("nobody", 60s));
      return link_->list().ignoreResult();  // the manager has heard all of that by then
    });
  }
  void stopWaiting() {
    control_.run(kPatience, [this] { waits_.clear(); });
  }
  /// Asks for a name, and returns when the manager has heard that: it takes what a link brings in
  /// its order. await() then waits for the answer.
  void beginToResolve(const std::string& name) {
    control_.run(kPatience, [this, name] {
      awaited_ = link_->resolve(name, kPatience)
                     .then([this](const ProcessRecord& found) { found_ = found.name; })
                     .eagerlyEvaluate(nullptr);
      return link_->list().ignoreResult();
    });
  }
  /// Returns when it has tried once; await() then waits for a manager.
  void beginToOpen() {
    control_.run(kPatience, [this] {
      awaited_ = link_->open(kPatience).eagerlyEvaluate(nullptr);
      return kj::evalLast([] {});
    });
  }
  void await() {
    control_.run(kPatience, [this] { return kj::mv(awaited_); });
  }
  /// Returns the name of the process that it has found so.
  const std::string& found() const { return found_; }
  std::vector<ProcessRecord> list() {
    return control_.run(kPatience, [this] { return link_->list(); });
  }
  bool knows(const std::string& name) {
    for (const auto& process : list()) {
      if (process.name == name) return true;
    }
    return false;
  }

 private:
  ProcessRecord self() const {
    ProcessRecord self;
    self.name = name_;
    self.addresses = {"unix:/tmp/" + name_};
    self.pid = 1;
    return self;
  }

  loop::ControlThread control_;
  std::unique_ptr<ManagerLink> link_;
  kj::Vector<kj::Promise<ProcessRecord>> waits_;
  kj::Promise<void> awaited_ = nullptr;
  std::string found_;
  const std::string name_;
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class GlobalManagerTest : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    start(std::string(GetParam()) == "unix" ? "unix:" + directory_.file("m.sock")
                                            : "tcp://127.0.0.1:0");
  }
  void start(const std::string& address) {
    manager_ = std::make_unique<GlobalManager>(control_, address);
    address_ = manager_->address();
  }
  std::unique_ptr<Peer> enrolled(const std::string& name) {
    auto peer = std::make_unique<Peer>(name, address_);
    peer->open();
    peer->enrol();
    return peer;
  }

  TemporaryDirectory directory_;
  loop::ControlThread control_;
  std::unique_ptr<GlobalManager> manager_;
  std::string address_;
};

INSTANTIATE_TEST_SUITE_P(Sockets, GlobalManagerTest, testing::Values(SOCKET),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(GlobalManagerTest, TellsAProcesssAddressAndInterfaces) {
  auto left = enrolled("left"), right = enrolled("right");
  right->update({{"PSM",
                  {{"Arm", "robots::Arm", "abc", {"base", "tip"}}},
                  {{"Camera", "robots::Camera", "def", {}}}}});
  ASSERT_TRUE(eventually([&] { return !left->resolve("right").components.empty(); }));
  const ProcessRecord found = left->resolve("right");
  EXPECT_EQ(found.addresses, std::vector<std::string>{"unix:/tmp/right"});
  EXPECT_EQ(found.components[0].name, "PSM");
  EXPECT_EQ(found.components[0].provided[0].contract, "robots::Arm");
  EXPECT_EQ(found.components[0].provided[0].frames, (Frames{"base", "tip"}));
  EXPECT_EQ(found.components[0].provided[0].hash, "abc");
  EXPECT_EQ(found.components[0].required[0].name, "Camera");
  EXPECT_EQ(left->list().size(), 2u);
}

// A process publishes while a manager that has just come registers it.
TEST_P(GlobalManagerTest, IsToldOfComponentsThatChangeMeanwhile) {
  auto left = enrolled("left");
  Peer right("right", address_);
  right.open();
  right.enrolAndUpdate({{"PSM", {}, {}}});
  EXPECT_TRUE(eventually([&] { return !left->resolve("right").components.empty(); }));
}

TEST_P(GlobalManagerTest, AProcessThatEndsIsForgotten) {
  auto left = enrolled("left"), right = enrolled("right");
  EXPECT_TRUE(left->knows("right"));
  right.reset();
  EXPECT_TRUE(eventually([&] { return !left->knows("right"); }));
  right = enrolled("right");  // and its name is free
  EXPECT_TRUE(left->knows("right"));
}

TEST_P(GlobalManagerTest, ATakenNameIsRefused) {
  auto left = enrolled("left");
  Peer second("left", address_);
  second.open();
  const std::string error = refusal([&] { second.enrol(); });
  EXPECT_TRUE(contains(error, "register process 'left'")) << error;
  EXPECT_TRUE(contains(error, "process 1 on")) << error;
}

TEST_P(GlobalManagerTest, RefusingAnUnknownProcessNamesTheKnown) {
  auto left = enrolled("left");
  const std::string error = refusal([&] { left->resolve("laft"); });
  EXPECT_TRUE(contains(error, "Did you mean 'left'?")) << error;
  EXPECT_FALSE(contains(error, ".cpp")) << error;
}

TEST_P(GlobalManagerTest, ResolvingWaitsForAProcessToAppear) {
  auto left = enrolled("left");
  left->beginToResolve("right");
  const auto right = enrolled("right");
  left->await();
  EXPECT_EQ(left->found(), "right");
}

TEST_P(GlobalManagerTest, ResolvingWaitsNoLongerThanAsked) {
  auto left = enrolled("left");
  const std::string error = refusal([&] { left->resolve("right", 30ms); });
  EXPECT_TRUE(contains(error, "has waited 30 ms")) << error;
}

// All peers here are of one user at a Unix socket; by TCP, nobody knows of whom they are.
TEST_P(GlobalManagerTest, WaitersAreBounded) {
  const bool isUser = address_.starts_with("unix:");
  const std::size_t most = isUser ? NameService::kMostWaitingOfAPeer : NameService::kMostWaiting;
  std::vector<std::unique_ptr<Peer>> all;
  for (std::size_t i = 0; i < most / NameService::kMostWaitingOfALink; ++i) {
    all.push_back(enrolled("left" + std::to_string(i)));
    all.back()->wait(NameService::kMostWaitingOfALink);
  }
  auto peer = enrolled("peer");
  testing::internal::CaptureStderr();
  const std::string answer = refusal([&] { peer->resolve("nobody", 60s); });
  const std::string told = testing::internal::GetCapturedStderr();
  const std::string limit =
      std::string("find process 'nobody': ") +
      (isUser
           ? "2048 of this user, or with this certificate, wait for names, and no more of one may"
           : "4096 wait for names here, and no more may");
  EXPECT_TRUE(contains(answer, limit)) << answer;
  EXPECT_TRUE(contains(told, "suture-manager: refused ") && contains(told, limit)) << told;
  all.front()->stopWaiting();
  EXPECT_TRUE(eventually(
      [&] { return contains(refusal([&] { peer->resolve("nobody", 1ms); }), "has waited 1 ms"); }));
}

TEST_P(GlobalManagerTest, ManyWaitsLeaveRoomToOthers) {
  auto greedy = enrolled("greedy");
  greedy->wait(NameService::kMostWaitingOfALink);
  const std::string answer = refusal([&] { greedy->resolve("nobody", 60s); });
  EXPECT_TRUE(contains(answer, "256 of this link wait for names, and no more of one link may"))
      << answer;
  auto peer = enrolled("left");
  peer->beginToResolve("late");
  const auto late = enrolled("late");
  peer->await();
}

// It would be kept as long as the answer is awaited, and compared with all names that there are.
TEST_P(GlobalManagerTest, ResolvesNoNameThatIsTooLong) {
  auto peer = enrolled("left");
  const std::string longest(100, 'n'), longer(std::size_t{1} << 20, 'n');
  EXPECT_TRUE(contains(refusal([&] { peer->resolve(longest); }), "the manager knows 'left'"));
  EXPECT_TRUE(
      contains(refusal([&] { peer->resolve(longer, kPatience); }),
               "find a process by a name of 1048576 bytes: a name has 1 to 100 characters"));
}

TEST_P(GlobalManagerTest, ARestartedManagerRelearnsItsProcesses) {
  auto left = enrolled("left"), right = enrolled("right");
  manager_.reset();
  ASSERT_TRUE(eventually([&] {
    return contains(refusal([&] { left->list(); }), "list processes: the global manager at " +
                                                        address_ + " is gone. Start it again.");
  }));
  start(address_);
  EXPECT_TRUE(eventually([&] {
    try {
      return left->knows("right") && right->knows("left");
    } catch (const std::runtime_error&) {
      return false;
    }
  }));
}

TEST_P(GlobalManagerTest, AnotherVersionIsRefusedInWords) {
  loop::ControlThread other;
  const std::string answer = other.run(kPatience, [&other, address = address_] {
    return net::dial(other.port(), net::Address::parse(address), kPatience)
        .then([&other](kj::AutoCloseFd socket) {
          auto link = kj::heap<framing::Link>(
              kj::heap<framing::MessageStream>(other.port(), kj::mv(socket)),
              capnp::rpc::twoparty::Side::CLIENT);
          auto request = link->bootstrap<wire::GlobalManager>().helloRequest();
          request.setVersion(999);
          request.setProgram("ancient");
          return request.send()
              .then([](auto&& results) {
                return results.isRefused() ? fromWire(results.getRefused()).text
                                           : std::string("accepted");
              })
              .attach(kj::mv(link));
        });
  });
  EXPECT_TRUE(contains(answer, "version 999")) << answer;
  EXPECT_TRUE(contains(answer, "'ancient'")) << answer;
}

TEST_P(GlobalManagerTest, ASecondManagerIsRefused) {
  const std::string error = refusal([&] { GlobalManager second(control_, address_); });
  EXPECT_TRUE(contains(error, address_)) << error;
  EXPECT_TRUE(contains(error, "another process listens there")) << error;
}

TEST(ManagerLink, SaysHowToStartAManager) {
  const TemporaryDirectory directory;
  const std::string address = "unix:" + directory.file("none.sock");
  Peer left("left", address);
  const std::string error = refusal([&] { left.open(20ms); });
  EXPECT_TRUE(contains(error, "there is no such socket")) << error;
  EXPECT_TRUE(contains(error, "suture-manager --listen " + address)) << error;
}

TEST(ManagerLink, AProcessWithoutAddressIsUnreachable) {
  const TemporaryDirectory directory;
  loop::ControlThread control;
  const GlobalManager manager(control, "unix:" + directory.file("manager.sock"));
  const std::string error = refusal([&] {
    control.run(kPatience, [&] {
      auto link = kj::heap<ManagerLink>(control, net::parseAddresses(manager.address()), "test");
      ProcessRecord homeless;
      homeless.name = "robot";
      auto opened = link->open(kPatience).then(
          [&link = *link, homeless] { return link.reach(homeless, kPatience).ignoreResult(); });
      return opened.attach(kj::mv(link));
    });
  });
  EXPECT_TRUE(contains(error, "reach process 'robot': it has no address. Restart it.")) << error;
}

TEST(ManagerLink, WaitsForAManagerToStart) {
  const TemporaryDirectory directory;
  const std::string address = "unix:" + directory.file("late.sock");
  loop::ControlThread control;
  Peer left("left", address);
  left.beginToOpen();
  const GlobalManager manager(control, address);
  left.await();
  left.enrol();
  EXPECT_TRUE(left.knows("left"));
}

// Several may share a control thread, which one of them can keep busy for longer than that waits.
TEST(GlobalManagerOfABusyThread, WaitsForItsControlThread) {
  const TemporaryDirectory directory;
  loop::ControlThread control;
  auto names = std::make_unique<GlobalManager>(control, "unix:" + directory.file("m.sock"));
  testing::internal::CaptureStderr();
  control.post([] { pass(30s); });
  names.reset();
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_NE(told.find("suture-manager: waits to end: the control thread hangs"), std::string::npos)
      << told;
}

}  // namespace
}  // namespace suture
