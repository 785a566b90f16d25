#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/deploy/host.h>
#include <suture/loop/control_thread.h>
#include <suture/names/global_manager.h>
#include <suture/rt/state/state_table.h>
#include <suture/standard/message_port.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <thread>
#include <utility>

#include "reference/still_arm.h"
#include "support/contains.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/temporary_directory.h"
#include "unit/deploy/host_scene.h"

namespace suture::test {
namespace {

class ThrowsOnce final : public PeriodicTask {
 public:
  ThrowsOnce() : PeriodicTask({.period = 1ms}) {}

 private:
  void run() override {
    if (!std::exchange(thrown_, true)) throw std::runtime_error("once");
  }

  bool thrown_ = false;
};

class BrokenArm final : public PeriodicTask, public StillArm {
 public:
  BrokenArm() : PeriodicTask({.period = 1ms}) {}

 private:
  void run() override { throw std::runtime_error("a cable has torn"); }

  Provided<reference::ArmLike> port_{*this, "Arm", *this};
};

class Talking final : public PeriodicTask {
 public:
  Talking() : PeriodicTask({.period = 1ms}) {}

 private:
  void run() override {
    if (!std::exchange(said_, true)) messages_.warning("the lid is open", 3);
  }

  bool said_ = false;
  MessagePort messages_{*this};
};

/// Waits until the host has troubles, or for kPatience at most.
std::vector<std::string> troublesOf(const Host& host) {
  const auto deadline = now() + kPatience;
  while (host.troubles().empty() && now() < deadline) std::this_thread::yield();
  std::vector<std::string> texts;
  for (const Trouble& trouble : host.troubles()) {
    texts.push_back(trouble.subject + " " + trouble.text);
  }
  return texts;
}

/// Returns the deployment of an arm and of a client that is connected to it.
Deployment armAndClient() {
  return deploymentOf(
      "{\"name\": \"PSM\", \"class\": \"SimulatedArm\"},\n"
      "{\"name\": \"Client\", \"class\": \"Client\"}",
      "{\"from\": \"Client/Arm\", \"to\": \"PSM/Arm\"}");
}

TEST(Host, RunsAndConnectsWhatTheFileSays) {
  const Deployment deployment = armAndClient();
  Host host(deployment, "all", kClasses);
  host.start();
  const auto channels = host.manager().channels();
  ASSERT_EQ(channels.size(), 1u);
  EXPECT_EQ(channels[0]->name(), "all:Client/Arm -> all:PSM/Arm");
  const auto deadline = now() + kPatience;
  while (channels[0]->commands.counters.executed == 0 && now() < deadline) {
    std::this_thread::yield();
  }
  EXPECT_GT(channels[0]->commands.counters.executed, 0u);
  EXPECT_TRUE(host.troubles().empty());
}

TEST(Host, DelaysTheConnectionsThatTheFileNames) {
  const Deployment deployment = deploymentOf(
      "{\"name\": \"PSM\", \"class\": \"SimulatedArm\"},\n"
      "{\"name\": \"Client\", \"class\": \"Client\"}",
      "{\"from\": \"Client/Arm\", \"to\": \"PSM/Arm\", \"delay\": {\"commands\": \"20ms\"}}");
  Host host(deployment, "all", kClasses);
  host.start();
  const auto channels = host.manager().channels();
  ASSERT_EQ(channels.size(), 2u);
  EXPECT_EQ(channels[0]->lane, "local+delay");
  const auto deadline = now() + kPatience;
  while (channels[1]->provider.commandAge->count() == 0 && now() < deadline) {
    std::this_thread::yield();
  }
  EXPECT_GE(channels[1]->provider.commandAge->max(), 20ms);
}

TEST(Host, OptionalInterfaceWithoutAConnection) {
  const auto create = [](const JsonReader& in) {
    std::unique_ptr<Component> client = createWithoutParameters<Client>(in);
    makeOptional(*client, {"Arm"});
    return client;
  };
  const std::array classes{ComponentClass{"Client", create}};
  const Deployment deployment = deploymentOf("{\"name\": \"C\", \"class\": \"Client\"}");
  Host host(deployment, "all", classes);
  host.start();
  EXPECT_TRUE(host.troubles().empty());
}

TEST(Host, ATaskIsRestartedAsConfigured) {
  const Deployment deployment =
      deploymentOf(R"({"name": "T", "class": "Throwing", "restart": {"most": 2, "per": "1000s"}})");
  Host host(deployment, "all", kClasses);
  host.start();
  EXPECT_EQ(troublesOf(host),
            (std::vector<std::string>{
                "component 'all:T' is parked, its code threw: the encoder says nonsense. It is "
                "restarted no more. Correct the cause and start the process anew"}));
  EXPECT_EQ(host.manager().directory().component("T").faults(), 3u);
}

TEST(Host, ARestartIsNews) {
  const std::array classes{ComponentClass{"ThrowsOnce", createWithoutParameters<ThrowsOnce>}};
  const Deployment deployment =
      deploymentOf(R"({"name": "T", "class": "ThrowsOnce", "restart": {"most": 1, "per": "1s"}})");
  Host host(deployment, "all", classes);
  host.start();
  EXPECT_EQ(newsOf(host), (std::vector<std::string>{
                              "component 'all:T' runs again after fault 1: its code threw: once"}));
  EXPECT_TRUE(host.news().empty());
  EXPECT_TRUE(host.troubles().empty());
}

TEST(Host, AStoppedProviderHereIsNamed) {
  const Deployment deployment = armAndClient();
  Host host(deployment, "all", kClasses);
  host.start();
  dynamic_cast<reference::SimulatedArm&>(host.manager().directory().component("PSM")).stop();
  EXPECT_EQ(
      troublesOf(host),
      (std::vector<std::string>{
          "connection 'all:Client/Arm -> all:PSM/Arm' is lost: its provider has been stopped, "
          "or the process at its other end is gone. Start it again"}));
}

TEST(Host, AFaultedProviderBringsNothing) {
  const std::array classes{ComponentClass{"Client", createWithoutParameters<Client>},
                           ComponentClass{"Broken", createWithoutParameters<BrokenArm>}};
  const Deployment deployment = deploymentOf(
      "{\"name\": \"PSM\", \"class\": \"Broken\"},\n"
      "{\"name\": \"Client\", \"class\": \"Client\"}",
      "{\"from\": \"Client/Arm\", \"to\": \"PSM/Arm\"}");
  Host host(deployment, "all", classes);
  host.start();
  eventually([&] { return host.troubles().size() == 2; });
  const std::vector<std::string> troubles = troublesOf(host);
  ASSERT_EQ(troubles.size(), 2u);
  EXPECT_EQ(troubles[1],
            "connection 'all:Client/Arm -> all:PSM/Arm' brings nothing until its provider is "
            "restarted, which has faulted");
}

TEST(Host, PromisesNoConnectionToAStoppedComponent) {
  const TemporaryDirectory directory;
  loop::ControlThread control;
  const GlobalManager names(control, "unix:" + directory.file("m.sock"));
  reference::SimulatedArm arm(reference::SimulatedArmParameters{});
  Manager robot("robot", names.address());
  robot.add("PSM", arm);
  robot.start();
  const Deployment deployment(JsonDocument::parse("{\"manager\": \"" + names.address() + "\"," +
                                                      R"("processes": [
          {"name": "robot", "components": [{"name": "PSM", "class": "SimulatedArm"}]},
          {"name": "console", "components": [{"name": "Client", "class": "Client"}]}],
          "connections": [{"from": "console:Client/Arm", "to": "robot:PSM/Arm"}]})",
                                                  "d.json"));
  Host console(deployment, "console", kClasses);
  console.start();
  arm.stop();
  const std::vector<std::string> troubles = troublesOf(console);
  ASSERT_EQ(troubles.size(), 1u);
  EXPECT_TRUE(contains(troubles[0], "is lost, ended: its component has been stopped"))
      << troubles[0];
  EXPECT_TRUE(contains(troubles[0], "restart either process")) << troubles[0];
}

TEST(Host, ABlackBoxFollowsTheFile) {
  const TemporaryDirectory directory;
  const Deployment deployment = boxed(directory.file(""), R"(, "rows": 1024, "components": ["T"])");
  Host host(deployment, "all", kClasses);
  host.start();
  const auto& all = host.manager().directory();
  EXPECT_EQ(all.component("T").provided().front()->state()->capacity(), 1024u);
  EXPECT_LT(all.component("PSM").provided().front()->state()->capacity(), 1024u);
  const auto news = newsOf(host);
  ASSERT_EQ(news.size(), 1u);
  EXPECT_TRUE(
      news[0].starts_with("black box: component 'T' faulted: the encoder says nonsense. "
                          "Its last state is in " +
                          directory.file("all.")))
      << news[0];
  EXPECT_TRUE(std::filesystem::exists(news[0].substr(news[0].rfind(' ') + 1))) << news[0];
}

// A process that ends while a file is written told of the fault, and not where its state is.
TEST(Host, TellsThatABlackBoxEnded) {
  const TemporaryDirectory directory;
  const Deployment deployment = boxed(directory.file(""));
  Host host(deployment, "all", kClasses);
  host.start();
  EXPECT_EQ(troublesOf(host).size(), 1u);
  host.endBlackBox();
  const auto news = host.news();
  ASSERT_EQ(news.size(), 1u);
  EXPECT_TRUE(news[0].starts_with("black box: component 'T' faulted: ")) << news[0];
}

TEST(Host, TellsWhatComponentsSay) {
  const std::array classes{ComponentClass{"Talking", createWithoutParameters<Talking>}};
  const Deployment deployment = deploymentOf(R"({"name": "T", "class": "Talking"})");
  Host silent(deployment, "all", classes);
  silent.start();
  Host host(deployment, "all", classes);
  host.listenToMessages();
  host.start();
  EXPECT_EQ(newsOf(host),
            (std::vector<std::string>{"T/Messages warning: the lid is open (code 3)"}));
  EXPECT_TRUE(silent.news().empty());
}

TEST(Host, AThrowingComponentIsNamed) {
  const Deployment deployment = deploymentOf(
      "{\"name\": \"T\", \"class\": \"Throwing\"},\n"
      "{\"name\": \"PSM\", \"class\": \"SimulatedArm\"}");
  Host host(deployment, "all", kClasses);
  host.start();
  EXPECT_EQ(troublesOf(host), (std::vector<std::string>{
                                  "component 'all:T' is parked, its code threw: the encoder says "
                                  "nonsense. Correct the cause and start the process anew"}));
}

}  // namespace
}  // namespace suture::test
