// Processes say who they are, and a provider's policy says what they may do. Managers within this
// process are processes to each other: they share nothing but the sockets.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/loop/control_thread.h>
#include <suture/loop/failure.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/names/manager_link.h>
#include <suture/names/security.h>
#include <suture/net/tls/key_maker.h>
#include <suture/observe/observe.h>
#include <suture/peer.capnp.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "integration/network/arm.h"
#include "integration/network/console.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using capnp::rpc::twoparty::Side;
using reference::Mode;

class SecurityTest : public testing::Test {
 protected:
  SecurityTest()
      : keys_(makeKeys()), names_(control_, "tls://127.0.0.1:0", securityOf(tls::kManagerName)) {}

  Security securityOf(const std::string& process, Policy policy = {}) const {
    return {.keys = std::make_shared<const tls::Keys>(keys_, process), .policy = std::move(policy)};
  }
  Manager process(const std::string& name, Policy policy = {}) const {
    return Manager(name, names_.address(), securityOf(name, std::move(policy)));
  }
  /// Returns what process 'robot' answers a caller with the certificate of `holder`; `ask(peer,
  /// answer)` sends one request.
  template <class Ask>
  std::string robotsAnswer(const std::string& holder, Ask ask) {
    loop::ControlThread control;
    const auto manager = net::Address::parse(names_.address());
    return control.run(kPatience, [&control, manager, ask, trust = securityOf(holder).trust()] {
      auto link = kj::heap<ManagerLink>(control, std::vector{manager}, "test", trust);
      auto& held = *link;
      return held.open(kPatience)
          .then([&held] { return held.resolve("robot", kPatience); })
          .then([&held](const ProcessRecord& robot) { return held.reach(robot, kPatience); })
          .then([&control, ask](net::ByteStream bytes) {
            // A robot on a busy machine may take any time for its first answer.
            const framing::StreamLimits patient{.firstMilliseconds = 0};
            auto stream = kj::heap<framing::MessageStream>(control.port(), kj::mv(bytes), patient);
            auto connection = kj::heap<framing::Link>(kj::mv(stream), Side::CLIENT);
            return ask(connection->bootstrap<wire::Peer>()).attach(kj::mv(connection));
          })
          .catch_([](kj::Exception&& error) { return loop::describe(error); })
          .attach(kj::mv(link));
    });
  }
  static kj::Promise<std::string> sayHello(wire::Peer::Client peer, const std::string& as) {
    auto request = peer.helloRequest();
    request.setVersion(wire::PROTOCOL_VERSION);
    request.setProcess(as.c_str());
    return request.send().then([](auto&& results) {
      return std::string(results.isRefused() ? results.getRefused().getText().cStr() : "accepted");
    });
  }
  static kj::Promise<std::string> openArm(wire::Peer::Client peer) {
    auto request = peer.openRequest();
    request.setComponent("PSM");
    request.setInterface("Arm");
    return request.send().then([](auto&& results) {
      return std::string(results.isRefused() ? results.getRefused().getText().cStr() : "opened");
    });
  }

  TemporaryDirectory directory_;
  const std::filesystem::path keys_;
  loop::ControlThread control_;
  GlobalManager names_;

 private:
  std::filesystem::path makeKeys() const {
    auto folder = directory_.path() / "keys";
    tls::makeKeys(folder, {tls::kManagerName, "robot", "console", "viewer", "stranger"});
    return folder;
  }
};

const Role kEverything{.full = {"*/*"}, .read = {}};
const Role kLooksAtArms{.full = {}, .read = {"PSM/Arm"}};

/// This is a process 'robot' with an arm.
struct Robot {
  explicit Robot(const std::function<Manager()>& make) : manager(make()) {
    manager.add("PSM", arm);
    manager.start();
  }
  reference::HostedArm arm;
  Manager manager;
};

TEST_F(SecurityTest, ATakenNameIsNotGivenAway) {
  const std::string error =
      refusal([&] { Manager("robot", names_.address(), securityOf("stranger")); });
  EXPECT_TRUE(contains(error,
                       "register process 'robot': the caller has the certificate of "
                       "process 'stranger'"))
      << error;
}

TEST_F(SecurityTest, NoProcessGetsInWithoutKeys) {
  const std::string error = refusal([&] { Manager("robot", names_.address()); });
  EXPECT_TRUE(contains(error, "this process has no keys")) << error;
}

TEST_F(SecurityTest, AManagerIsStartedWithKeys) {
  const std::string error =
      refusal([&] { Manager("robot", "tls://127.0.0.1:1", securityOf("robot"), 20ms); });
  EXPECT_TRUE(contains(error, "suture-manager --listen tls://127.0.0.1:1 --keys FOLDER")) << error;
}

TEST_F(SecurityTest, TheManagersAddressIsNotItsName) {
  const GlobalManager impostor(control_, "tls://127.0.0.1:0", securityOf("stranger"));
  const std::string error =
      refusal([&] { Manager("robot", impostor.address(), securityOf("robot")); });
  EXPECT_TRUE(contains(error,
                       "it has the certificate of process 'stranger', and "
                       "'suture-manager' is expected there"))
      << error;
}

TEST_F(SecurityTest, ACertificateNamesItsProcess) {
  const Robot robot([&] { return process("robot"); });
  const auto hello = [](const char* as) {
    return [as](wire::Peer::Client peer) { return sayHello(peer, as); };
  };
  EXPECT_EQ(robotsAnswer("console", hello("console")), "accepted");
  const std::string refused = robotsAnswer("stranger", hello("console"));
  EXPECT_TRUE(contains(refused,
                       "the caller says that it is 'console' and has the certificate of "
                       "process 'stranger'"))
      << refused;
  const auto connect = [](wire::Peer::Client peer) -> kj::Promise<std::string> {
    auto request = peer.connectRequest();
    request.setFromProcess("console");
    request.setToComponent("PSM");
    request.setProvided("Arm");
    return request.send().then([](auto&& results) {
      return std::string(results.isRefused() ? results.getRefused().getText().cStr() : "accepted");
    });
  };
  const std::string connected = robotsAnswer("stranger", connect);
  EXPECT_TRUE(contains(connected, "the caller says that it is 'console'")) << connected;
}

TEST_F(SecurityTest, ARegisteredAddressStaysWithinTls) {
  loop::ControlThread control;
  std::unique_ptr<ManagerLink> link;
  const auto manager = net::Address::parse(names_.address());
  control.run(kPatience, [&, trust = securityOf("robot").trust()] {
    link = std::make_unique<ManagerLink>(control, std::vector{manager}, "robot", trust);
    return link->open(kPatience).then([&link] {
      return link->enrol({.name = "robot",
                          .addresses = {"tcp://127.0.0.1:9"},
                          .pid = 1,
                          .host = "",
                          .components = {},
                          .generation = 0});
    });
  });
  Console console;
  Manager client = process("console");
  client.add("Console", console);
  const std::string error = refusal([&] { client.connect("Console/Arm", "robot:PSM/Arm"); });
  EXPECT_TRUE(contains(error,
                       "it listens at tcp://127.0.0.1:9, and the global manager is reached "
                       "at tls://"))
      << error;
  control.run(kPatience, [&] { link.reset(); });
}

TEST_F(SecurityTest, AReadOnlyRoleCommandsNothing) {
  const Policy policy({{"process:viewer", kLooksAtArms}, {"process:console", kEverything}});
  const Robot robot([&] { return process("robot", policy); });
  Console surgeon, onlooker;
  Manager console = process("console"), viewer = process("viewer");
  console.add("Console", surgeon);
  viewer.add("Console", onlooker);
  console.start();
  viewer.start();
  console.connect("Console/Arm", "robot:PSM/Arm");
  viewer.connect("Console/Arm", "robot:PSM/Arm");

  ASSERT_TRUE(reaches(surgeon, 3));
  EXPECT_TRUE(eventually([&] {  // state
    const auto pose = onlooker.arm.measured_cp();
    return pose && pose->pose.translation().x() == 3;
  }));
  const auto distance =
      onlooker.arm.distance.start(poseAt(5)).within(kPatience);  // a qualified read
  ASSERT_TRUE(distance);
  EXPECT_DOUBLE_EQ(*distance, 2);
  ASSERT_TRUE(surgeon.arm.set_mode.start(Mode::Enabled).within(kPatience));
  EXPECT_TRUE(eventually([&] {  // events
    onlooker.processEvents();
    return onlooker.modes == std::vector<Mode>{Mode::Enabled};
  }));

  const auto mode = onlooker.arm.set_mode.start(Mode::Disabled).within(kPatience);
  EXPECT_EQ(mode.error(), Errc::NotPermitted);
  EXPECT_EQ(onlooker.arm.servo_cp.start(poseAt(9)).within(kPatience).error(), Errc::NotPermitted);
  EXPECT_EQ(onlooker.arm.move.start(poseAt(9), 1, "").within(kPatience).error(),
            Errc::NotPermitted);
  EXPECT_EQ(onlooker.arm.reset.start().within(kPatience).error(), Errc::NotPermitted);
  const auto refused = [&] { return observe(viewer, {}).connections.at(0).refused; };
  const auto before = refused();
  ASSERT_TRUE(onlooker.arm.hold());  // the answer of this one is not awaited
  EXPECT_TRUE(eventually([&] { return refused() > before; })) << "but it is counted";
  surgeon.processEvents();
  onlooker.processEvents();
  EXPECT_EQ(surgeon.modes, std::vector<Mode>{Mode::Enabled}) << "and nothing happened";
  EXPECT_DOUBLE_EQ(surgeon.arm.measured_cp()->pose.translation().x(), 3);
  EXPECT_TRUE(reaches(surgeon, 4)) << "who may command still does";
}

TEST_F(SecurityTest, ARoleRefusesWhatItOmits) {
  const Policy policy({{"process:viewer", kLooksAtArms}});
  const Robot robot([&] { return process("robot", policy); });
  Console onlooker, other;
  Manager viewer = process("viewer"), stranger = process("stranger");
  viewer.add("Console", onlooker);
  viewer.start();
  std::string error = refusal([&] { viewer.connect("Console/Arm", "robot:PSM/component"); });
  EXPECT_TRUE(contains(error,
                       "use 'robot:PSM/component': the policy of process 'robot' does not "
                       "give it to process 'viewer'"))
      << error;
  stranger.add("Console", other);
  stranger.start();
  error = refusal([&] { stranger.connect("Console/Arm", "robot:PSM/Arm"); });
  EXPECT_TRUE(contains(error, "its policy has no rule for process 'stranger'")) << error;
  EXPECT_EQ(robot.manager.refusals().count, 2u);
  EXPECT_TRUE(contains(robot.manager.refusals().latest, "no rule for process 'stranger'"))
      << robot.manager.refusals().latest;
}

TEST_F(SecurityTest, APlainClientObeysThePolicyToo) {
  const Policy policy(
      {{"process:console", kEverything}, {"process:viewer", {.full = {"ECM/*"}, .read = {}}}});
  const Robot robot([&] { return process("robot", policy); });
  EXPECT_EQ(robotsAnswer("console", openArm), "opened");
  std::string answer = robotsAnswer("viewer", openArm);
  EXPECT_TRUE(contains(answer, "does not give it to process 'viewer'")) << answer;
  answer = robotsAnswer("stranger", openArm);
  EXPECT_TRUE(contains(answer, "its policy has no rule for process 'stranger'")) << answer;
}

TEST_F(SecurityTest, ASessionsInterfacesAreBounded) {
  const Robot robot([&] { return process("robot"); });
  const auto openMany = [](wire::Peer::Client peer) {
    auto opened = kj::heapArrayBuilder<kj::Promise<std::string>>(1025);
    for (int i = 0; i < 1025; ++i) opened.add(openArm(peer));
    return kj::joinPromises(opened.finish()).then([](kj::Array<std::string> answers) {
      EXPECT_EQ(std::count(answers.begin(), answers.end(), "opened"), 1024);
      return answers.back();
    });
  };
  const std::string last = robotsAnswer("console", openMany);
  EXPECT_TRUE(contains(last, "none is given more")) << last;
}

class PlainSecurityTest : public testing::TestWithParam<const char*> {
 protected:
  std::string address() const {
    return std::string(GetParam()) == "tcp" ? "tcp://127.0.0.1:0"
                                            : "unix:" + directory_.file("m.sock");
  }
  TemporaryDirectory directory_;
  loop::ControlThread control_;
};
INSTANTIATE_TEST_SUITE_P(Sockets, PlainSecurityTest, testing::Values("unix", "tcp"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(PlainSecurityTest, WithoutACertificateTheSocketsRuleHolds) {
  const GlobalManager names(control_, address());
  const std::string fits = std::string(GetParam()) == "tcp" ? "tcp" : "user:same";
  const std::string other = fits == "tcp" ? "user:same" : "tcp";
  for (const std::string& who : {fits, other}) {
    const Policy policy({{who, kEverything}, {"process:*", kEverything}});
    const Robot robot([&] {
      return Manager("robot", names.address(), Security{.keys = nullptr, .policy = policy});
    });
    Console console;
    Manager client("console", names.address());
    client.add("Console", console);
    client.start();
    const std::string error = refusal([&] { client.connect("Console/Arm", "robot:PSM/Arm"); });
    if (who == fits) {
      EXPECT_EQ(error, "");
      EXPECT_TRUE(reaches(console, 2));
    } else {
      EXPECT_TRUE(contains(error, "its policy has no rule for")) << error;
    }
  }
}

}  // namespace
}  // namespace suture
