#include <gtest/gtest.h>
#include <poll.h>
#include <suture/component/channel.h>
#include <suture/component/device.h>
#include <suture/manager/global_manager.h>
#include <suture/manager/manager.h>
#include <suture/manager/manager_link.h>
#include <suture/transport/rpc/control_thread.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "integration/network/arm.h"
#include "support/eventually.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::Mode;
using reference::PoseStamped;

/// A child process with what it prints.
class Child {
 public:
  explicit Child(std::vector<std::string> arguments) {
    std::vector<char*> raw;
    for (auto& argument : arguments) raw.push_back(argument.data());
    raw.push_back(nullptr);
    int out[2];
    if (pipe(out) != 0) std::abort();
    pid_ = fork();
    if (pid_ == 0) {
      dup2(out[1], STDOUT_FILENO);
      execv(raw[0], raw.data());
      _exit(127);
    }
    close(out[1]);
    output_ = out[0];
  }
  ~Child() {
    if (pid_ > 0) end(SIGKILL);
    close(output_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  std::string line() {
    std::string text;
    char one;
    pollfd readable{output_, POLLIN, 0};
    while (poll(&readable, 1, 60'000) > 0 && read(output_, &one, 1) == 1 && one != '\n')
      text += one;
    return text;
  }
  void signal(int number) const { kill(pid_, number); }
  int end(int number) {
    if (number != 0) signal(number);
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  pid_t pid_ = 0;
  int output_ = -1;
};

struct Console final : Device {
  Console() {
    arm.on().mode([this](const Mode& mode) { modes.push_back(mode); });
  }
  Required<ArmLike> arm{*this, "Arm"};
  std::vector<Mode> modes;
};

/// Requires something that has the arm's name but not its form.
struct Stranger final : Device {
  struct Other final : RequiredBase {
    explicit Other(Component& owner) : RequiredBase(owner, "Arm", info()) {}
    static const InterfaceInfo& info() {
      static const InterfaceInfo kInfo{.name = "reference::ArmLike",
                                       .hash = "another",
                                       .description = R"({"name": "reference::OtherArm"})",
                                       .commands = {},
                                       .events = {},
                                       .binding = nullptr};
      return kInfo;
    }
  };
  Other arm{*this};
};

PoseStamped poseAt(double x) {
  PoseStamped pose;
  pose.pose.translation().x() = x;
  pose.stamp = now();
  pose.valid = true;
  return pose;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class NetworkTest : public testing::TestWithParam<const char*> {
 protected:
  NetworkTest()
      : names_(control_, std::string(GetParam()) == "unix" ? "unix:" + directory_.file("m.sock")
                                                           : "tcp://127.0.0.1:0") {}

  const std::string& address() const { return names_.address(); }
  std::unique_ptr<Child> host(const std::string& name) const {
    auto child = std::make_unique<Child>(std::vector<std::string>{ARM_HOST, address(), name});
    EXPECT_EQ(child->line(), "ready");
    return child;
  }
  /// Where a process listens, as the manager knows it.
  std::string addressOf(const std::string& process) {
    rpc::ControlThread control;
    const auto manager = rpc::Address::parse(address());
    return control.run(20s, [&control, manager, process] {
      auto link = kj::heap<ManagerLink>(control, manager, "test");
      auto& held = *link;
      return held.open(5s)
          .then([&held, process] { return held.resolve(process, 5s); })
          .then([](ProcessRecord record) { return record.addresses.at(0); })
          .attach(kj::mv(link));
    });
  }
  static bool reaches(Console& console, double x) {
    return console.arm.servo_cp.start(poseAt(x)).within(5s).has_value() && eventually([&] {
             const auto pose = console.arm.measured_cp();
             return pose && pose->pose.translation().x() == x;
           });
  }

  TemporaryDirectory directory_;
  rpc::ControlThread control_;
  GlobalManager names_;
};

INSTANTIATE_TEST_SUITE_P(Sockets, NetworkTest, testing::Values("unix", "tcp"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(NetworkTest, AKilledPeerIsLostAndItsSuccessorFound) {
  auto child = host("left");
  Console console;
  Manager manager("right", address());
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
  EXPECT_TRUE(console.arm.set_mode.start(Mode::Enabled).within(5s));
  EXPECT_TRUE(eventually([&] {
    console.processEvents();
    return console.modes == std::vector<Mode>{Mode::Enabled};
  }));
}

TEST_P(NetworkTest, AStoppedPeerIsLostAndComesBack) {
  auto child = host("left");
  Console console;
  Manager manager("right", address());
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

TEST_P(NetworkTest, TheConnectionLivesOnWithoutTheGlobalManager) {
  auto names = std::make_unique<GlobalManager>(
      control_, std::string(GetParam()) == "unix" ? "unix:" + directory_.file("other.sock")
                                                  : "tcp://127.0.0.1:0");
  Child child({ARM_HOST, names->address(), "left"});
  ASSERT_EQ(child.line(), "ready");
  Console console;
  Manager manager("right", names->address());
  manager.add("Console", console);
  manager.start();
  manager.connect("Console/Arm", "left:PSM/Arm");
  ASSERT_TRUE(reaches(console, 1));
  EXPECT_EQ(manager.missingGlobalManager(), "");
  const std::string asked = names->address();
  names.reset();
  EXPECT_TRUE(reaches(console, 2));
  EXPECT_TRUE(eventually([&] { return manager.missingGlobalManager() == asked; }));

  const GlobalManager successor(control_, asked);
  EXPECT_TRUE(eventually([&] { return manager.missingGlobalManager().empty(); }));
  Console another;
  Manager third("third", asked);
  third.add("Console", another);
  third.start();
  third.connect("Console/Arm", "left:PSM/Arm");
  EXPECT_TRUE(reaches(another, 3)) << "it has learned again who is there";
}

TEST_P(NetworkTest, StartingAndKillingOverAndOver) {
  Console console;
  Manager manager("right", address());
  manager.add("Console", console);
  manager.start();
  for (int round = 0; round < 10; ++round) {
    const auto child = host("left" + std::to_string(round));
    Console another;
    Manager local("round" + std::to_string(round), address());
    local.add("Console", another);
    local.start();
    local.connect("Console/Arm", "left" + std::to_string(round) + ":PSM/Arm");
    EXPECT_TRUE(reaches(another, round + 1)) << round;
    child->end(SIGKILL);
  }
}

TEST_P(NetworkTest, WhatDoesNotExistIsRefusedWithWhatDoes) {
  const auto child = host("left");
  Console console;
  Manager manager("right", address());
  manager.add("Console", console);
  manager.start();
  const auto answer = [&](const char* provided) {
    return refusal([&] { manager.connect("Console/Arm", provided, Lane::Auto, 100ms); });
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
  Manager manager("right", address());
  manager.add("Stranger", stranger);
  manager.start();
  const std::string error = refusal([&] { manager.connect("Stranger/Arm", "left:PSM/Arm"); });
  EXPECT_TRUE(contains(error, "right:Stranger/Arm -> left:PSM/Arm")) << error;
  EXPECT_TRUE(contains(error, "reference::OtherArm")) << error;
}

TEST_P(NetworkTest, ATakenProcessNameIsRefused) {
  const auto child = host("left");
  const std::string error = refusal([&] { Manager second("left", address()); });
  EXPECT_TRUE(contains(error, "register process 'left'")) << error;
}

TEST_P(NetworkTest, TwoProcessesThatRequireEachOtherStartInAnyOrder) {
  reference::HostedArm leftArm, rightArm;
  Console leftConsole, rightConsole;
  std::thread other([&] {
    Manager left("left", address());
    left.add("PSM", leftArm);
    left.add("Console", leftConsole);
    left.connect("Console/Arm", "right:PSM/Arm");
    left.start();
    EXPECT_TRUE(reaches(leftConsole, 3));
  });
  Manager right("right", address());
  right.add("PSM", rightArm);
  right.add("Console", rightConsole);
  right.connect("Console/Arm", "left:PSM/Arm");
  right.start();
  other.join();
}

TEST_P(NetworkTest, APlainCapnpClientReadsAndCommandsAnArm) {
  const auto arm = host("left");
  std::string peer = addressOf("left");
  if (peer.starts_with("tcp://")) peer = peer.substr(6);
  Child client({PLAIN_CLIENT, peer});
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

TEST(Network, AManagerThatIsNotRunningIsAnErrorThatSaysHowToStartOne) {
  const TemporaryDirectory directory;
  const std::string address = "unix:" + directory.file("none.sock");
  const std::string error = refusal([&] { Manager manager("left", address, 50ms); });
  EXPECT_TRUE(contains(error, "suture-manager --listen " + address)) << error;
}

}  // namespace
}  // namespace suture
