#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/names/security.h>
#include <suture/net/tls/key_maker.h>

#include <csignal>
#include <filesystem>
#include <thread>

#include "integration/network/arm.h"
#include "integration/network/console.h"
#include "paths.h"
#include "support/child.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/process_address.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::Mode;

/// Requires something that has the arm's name but not its form.
struct Stranger final : Device {
  struct Other final : RequiredBase {
    explicit Other(Component& owner) : RequiredBase(owner, "Arm", info()) {}
    static const InterfaceInfo& info() {
      static const InterfaceInfo kInfo{.name = "reference::ArmLike",
                                       .hash = "another",
                                       .description = R"({"name": "reference::OtherArm"})",
                                       .commands = interfaceInfo<ArmLike>().commands,
                                       .events = interfaceInfo<ArmLike>().events,
                                       .codec = interfaceInfo<ArmLike>().codec};
      return kInfo;
    }
  };
  Other arm{*this};
};

class NetworkTest : public testing::TestWithParam<const char*> {
 protected:
  NetworkTest()
      : keys_(directory_.path() / "keys"),
        names_(control_, freshAddress("m.sock"), securityOf(tls::kManagerName)) {}

  std::string freshAddress(const std::string& file) const {
    const std::string kind = GetParam();
    return kind == "unix" ? "unix:" + directory_.file(file) : kind + "://127.0.0.1:0";
  }
  /// Returns keys, which are made when they are first needed.
  Security securityOf(const std::string& process) {
    if (std::string(GetParam()) != "tls") return {};
    if (!std::filesystem::exists(keys_ / (process + ".key"))) tls::makeKeys(keys_, {process});
    return {.keys = std::make_shared<const tls::Keys>(keys_, process)};
  }
  Manager process(const std::string& name) { return Manager(name, address(), securityOf(name)); }

  const std::string& address() const { return names_.address(); }
  std::vector<std::string> armHost(const std::string& manager, const std::string& name) {
    std::vector<std::string> line{paths::kArmHost, manager, name};
    if (securityOf(name).keys != nullptr) line.push_back(keys_.string());
    return line;
  }
  std::unique_ptr<Child> host(const std::string& name) {
    auto child = std::make_unique<Child>(armHost(address(), name));
    EXPECT_EQ(child->line(), "ready");
    return child;
  }
  std::string addressOf(const std::string& process) {
    return suture::addressOf(address(), process, securityOf("test").trust());
  }
  TemporaryDirectory directory_;
  const std::filesystem::path keys_;
  loop::ControlThread control_;
  GlobalManager names_;
};

INSTANTIATE_TEST_SUITE_P(Sockets, NetworkTest, testing::Values("unix", "tcp", "tls"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(NetworkTest, AKilledPeersSuccessorIsFound) {
  auto child = host("left");
  Console console;
  Manager manager = process("right");
  manager.add("Console", console);
  manager.start();
  manager.connect("Console/Arm", "left:PSM/Arm");
  ASSERT_TRUE(reaches(console, 1));

  child->end(SIGKILL);
  EXPECT_TRUE(eventually([&] {
    const auto sent = console.arm.hold();
    return !sent && sent.error() == Errc::Lost;
  }));
  EXPECT_EQ(console.arm.measured_cp().error(), Errc::Lost);
  EXPECT_EQ(manager.channels().at(0)->status, ChannelStatus::Lost);

  child = host("left");
  EXPECT_TRUE(eventually([&] { return console.arm.connected(); }));
  ASSERT_EQ(manager.channels().size(), 1u);
  EXPECT_EQ(manager.channels()[0]->status, ChannelStatus::Connected) << "reports tell of the new";
  EXPECT_TRUE(reaches(console, 2));
  EXPECT_TRUE(console.arm.set_mode.start(Mode::Enabled).within(kPatience));
  EXPECT_TRUE(eventually([&] {
    console.processEvents();
    return console.modes == std::vector<Mode>{Mode::Enabled};
  }));
}

TEST_P(NetworkTest, AStoppedPeerIsLostAndReturns) {
  auto child = host("left");
  Console console;
  Manager manager = process("right");
  manager.add("Console", console);
  manager.start();
  manager.connect("Console/Arm", "left:PSM/Arm");
  ASSERT_TRUE(reaches(console, 1));
  child->signal(SIGSTOP);
  EXPECT_TRUE(eventually([&] { return !console.arm.connected(); }));
  child->signal(SIGCONT);
  EXPECT_TRUE(eventually([&] { return console.arm.connected(); }));
  EXPECT_TRUE(reaches(console, 2));
}

TEST_P(NetworkTest, TheConnectionOutlivesTheGlobalManager) {
  auto names = std::make_unique<GlobalManager>(control_, freshAddress("other.sock"),
                                               securityOf(tls::kManagerName));
  Child child(armHost(names->address(), "left"));
  ASSERT_EQ(child.line(), "ready");
  Console console;
  Manager manager("right", names->address(), securityOf("right"));
  manager.add("Console", console);
  manager.start();
  manager.connect("Console/Arm", "left:PSM/Arm");
  ASSERT_TRUE(reaches(console, 1));
  EXPECT_EQ(manager.missingGlobalManager(), "");
  const std::string asked = names->address();
  names.reset();
  EXPECT_TRUE(reaches(console, 2));
  EXPECT_TRUE(eventually([&] { return manager.missingGlobalManager() == asked; }));

  const GlobalManager successor(control_, asked, securityOf(tls::kManagerName));
  EXPECT_TRUE(eventually([&] { return manager.missingGlobalManager().empty(); }));
  Console another;
  Manager third("third", asked, securityOf("third"));
  third.add("Console", another);
  third.start();
  third.connect("Console/Arm", "left:PSM/Arm");
  EXPECT_TRUE(reaches(another, 3)) << "it has learned again who is there";
}

TEST_P(NetworkTest, StartingAndKillingOverAndOver) {
  Console console;
  Manager manager = process("right");
  manager.add("Console", console);
  manager.start();
  for (int round = 0; round < 10; ++round) {
    const auto child = host("left" + std::to_string(round));
    Console another;
    Manager local = process("round" + std::to_string(round));
    local.add("Console", another);
    local.start();
    local.connect("Console/Arm", "left" + std::to_string(round) + ":PSM/Arm");
    EXPECT_TRUE(reaches(another, round + 1)) << round;
    child->end(SIGKILL);
  }
}

TEST_P(NetworkTest, ARefusalNamesWhatExists) {
  const auto child = host("left");
  Console console;
  Manager manager = process("right");
  manager.add("Console", console);
  manager.start();
  const auto answer = [&](const char* provided) {
    return refusal([&] { manager.connect("Console/Arm", provided, {.patience = 100ms}); });
  };
  std::string error = answer("laft:PSM/Arm");
  EXPECT_TRUE(contains(error, "Did you mean 'left'?")) << error;
  error = answer("left:PSN/Arm");
  EXPECT_TRUE(contains(error, "Did you mean 'PSM'?")) << error;
  error = answer("left:PSM/Am");
  EXPECT_TRUE(contains(error, "provided interfaces 'Arm'")) << error;
  EXPECT_TRUE(contains(error, "Did you mean 'Arm'?")) << error;
  EXPECT_FALSE(contains(error, ".cpp")) << error;
  manager.connect("Console/Arm", "left:PSM/Arm");  // and nothing is left behind
  EXPECT_TRUE(reaches(console, 1));
  error = answer("left:PSM/Arm");
  EXPECT_TRUE(contains(error, "already connected")) << error;
}

TEST_P(NetworkTest, AnotherContractIsRefusedWithTheDifference) {
  const auto child = host("left");
  Stranger stranger;
  Manager manager = process("right");
  manager.add("Stranger", stranger);
  manager.start();
  const std::string error = refusal([&] { manager.connect("Stranger/Arm", "left:PSM/Arm"); });
  EXPECT_TRUE(contains(error, "right:Stranger/Arm -> left:PSM/Arm")) << error;
  EXPECT_TRUE(contains(error, "reference::OtherArm")) << error;
}

TEST_P(NetworkTest, ATakenProcessNameIsRefused) {
  const auto child = host("left");
  const std::string error = refusal([&] { Manager second = process("left"); });
  EXPECT_TRUE(contains(error, "register process 'left'")) << error;
}

TEST_P(NetworkTest, ProcessesThatRequireEachOtherStart) {
  reference::HostedArm leftArm, rightArm;
  Console leftConsole, rightConsole;
  std::thread other([&] {
    Manager left = process("left");
    left.add("PSM", leftArm);
    left.add("Console", leftConsole);
    left.connect("Console/Arm", "right:PSM/Arm");
    left.start();
    EXPECT_TRUE(reaches(leftConsole, 3));
  });
  Manager right = process("right");
  right.add("PSM", rightArm);
  right.add("Console", rightConsole);
  right.connect("Console/Arm", "left:PSM/Arm");
  right.start();
  other.join();
}

class PlainNetworkTest : public NetworkTest {};
INSTANTIATE_TEST_SUITE_P(Sockets, PlainNetworkTest, testing::Values("unix", "tcp"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(PlainNetworkTest, APlainCapnpClientCommandsAnArm) {
  const auto arm = host("left");
  std::string peer = addressOf("left");
  if (peer.starts_with("tcp://")) peer = peer.substr(6);
  Child client({paths::kPlainClient, peer});
  EXPECT_EQ(client.line(), "x: 0.25");
  EXPECT_EQ(client.line(), "distance: 1.00");
  EXPECT_EQ(client.line(), "heard: stopped");
  for (const char* nonsense : {"no goal", "not a number"}) {
    const std::string line = client.line();
    EXPECT_TRUE(contains(line, nonsense) && contains(line, toString(Errc::Invalid))) << line;
    EXPECT_FALSE(contains(line, ".cpp") || contains(line, "/")) << line;
  }
  const std::string refused = client.line();
  EXPECT_TRUE(contains(refused, "Did you mean 'PSM'?")) << refused;
  EXPECT_EQ(client.end(0), 0);
}

TEST(Network, TheErrorSaysHowToStartOne) {
  const TemporaryDirectory directory;
  const std::string address = "unix:" + directory.file("none.sock");
  const std::string error = refusal([&] { Manager manager("left", address, 50ms); });
  EXPECT_TRUE(contains(error, "suture-manager --listen " + address)) << error;
}

}  // namespace
}  // namespace suture
