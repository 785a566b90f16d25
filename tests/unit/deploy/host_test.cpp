#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
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

#include "reference/simulated_arm.suture.h"
#include "support/contains.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/temporary_directory.h"

namespace {

using namespace std::chrono_literals;
using suture::Component;
using suture::ComponentClass;
using suture::contains;
using suture::Deployment;
using suture::DocumentError;
using suture::Host;
using suture::JsonDocument;
using suture::JsonReader;
using suture::kPatience;

/// Sends its arm forward each cycle.
class Client final : public suture::PeriodicTask {
 public:
  Client() : PeriodicTask({.period = 1ms}) {}

 private:
  void run() override {
    reference::PoseStamped goal;
    goal.valid = true;
    (void)arm_.servo_cp(goal);
  }

  suture::Required<reference::ArmLike> arm_{*this, "Arm"};
};

class Throwing final : public suture::PeriodicTask {
 public:
  Throwing() : PeriodicTask({.period = 1ms}) {}

 private:
  void run() override { throw std::runtime_error("the encoder says nonsense"); }
};

class ThrowsOnce final : public suture::PeriodicTask {
 public:
  ThrowsOnce() : PeriodicTask({.period = 1ms}) {}

 private:
  void run() override {
    if (!std::exchange(thrown_, true)) throw std::runtime_error("once");
  }

  bool thrown_ = false;
};

class Talking final : public suture::PeriodicTask {
 public:
  Talking() : PeriodicTask({.period = 1ms}) {}

 private:
  void run() override {
    if (!std::exchange(said_, true)) messages_.warning("the lid is open", 3);
  }

  bool said_ = false;
  suture::MessagePort messages_{*this};
};

struct Shelf final : suture::Device {};

class Refusing final : public suture::PeriodicTask {
 public:
  Refusing() : PeriodicTask({.period = 1ms}) { throw std::invalid_argument("no such device"); }

 private:
  void run() override {}
};

template <class T>
std::unique_ptr<Component> createWithoutParameters(const JsonReader& in) {
  in.finish();
  return std::make_unique<T>();
}

const std::array kClasses{
    suture::componentClass<reference::SimulatedArm>(),
    ComponentClass{"Client", createWithoutParameters<Client>},
    ComponentClass{"Throwing", createWithoutParameters<Throwing>},
    ComponentClass{"Refusing", createWithoutParameters<Refusing>},
};

Deployment deploymentOf(const std::string& components, const std::string& connections = "") {
  return Deployment(JsonDocument::parse("{\"processes\": [{\"name\": \"all\", \"components\": [\n" +
                                            components + "]}],\n\"connections\": [\n" +
                                            connections + "]}",
                                        "d.json"));
}

/// Deploys one component that throws and one that does not, under a black box.
Deployment boxed(const std::string& folder, const std::string& more = "") {
  return Deployment(
      JsonDocument::parse("{\"processes\": [{\"name\": \"all\",\n"
                          "\"black_box\": {\n\"folder\": \"" +
                              folder + "\"" + more + "},\n" +
                              R"("components": [{"name": "T", "class": "Throwing"},
                            {"name": "PSM", "class": "SimulatedArm"}]}]})",
                          "d.json"));
}

std::vector<std::string> problemsOf(const Deployment& deployment) {
  try {
    Host host(deployment, "all", kClasses);
    host.start();
  } catch (const DocumentError& error) {
    return error.problems();
  }
  return {};
}

/// Waits until the host has troubles, or for kPatience at most.
std::vector<std::string> troublesOf(const Host& host) {
  const auto deadline = suture::now() + kPatience;
  while (host.troubles().empty() && suture::now() < deadline) std::this_thread::yield();
  std::vector<std::string> texts;
  for (const suture::Trouble& trouble : host.troubles()) {
    texts.push_back(trouble.subject + " " + trouble.text);
  }
  return texts;
}

/// Waits until the host has news, or for kPatience at most.
std::vector<std::string> newsOf(Host& host) {
  std::vector<std::string> news;
  suture::eventually([&] { return !(news = host.news()).empty(); });
  return news;
}

TEST(Host, RunsAndConnectsWhatTheFileSays) {
  const Deployment deployment = deploymentOf(
      "{\"name\": \"PSM\", \"class\": \"SimulatedArm\"},\n"
      "{\"name\": \"Client\", \"class\": \"Client\"}",
      "{\"from\": \"Client/Arm\", \"to\": \"PSM/Arm\"}");
  Host host(deployment, "all", kClasses);
  host.start();
  const auto channels = host.manager().channels();
  ASSERT_EQ(channels.size(), 1u);
  EXPECT_EQ(channels[0]->name(), "all:Client/Arm -> all:PSM/Arm");
  const auto deadline = suture::now() + kPatience;
  while (channels[0]->commands.counters.executed == 0 && suture::now() < deadline) {
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
  const auto deadline = suture::now() + kPatience;
  while (channels[1]->provider.commandAge->count() == 0 && suture::now() < deadline) {
    std::this_thread::yield();
  }
  EXPECT_GE(channels[1]->provider.commandAge->max(), 20ms);
}

TEST(Host, UnknownClass) {
  const auto problems =
      problemsOf(deploymentOf("{\"name\": \"PSM\", \"class\": \"SimulatedArn\"}"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0],
            "d.json:2: error: no component class 'SimulatedArn' in this program; it offers "
            "'SimulatedArm', 'Client', 'Throwing', 'Refusing', 'StateCollector' and "
            "'EventCollector'; did you mean 'SimulatedArm'?");
}

TEST(Host, ACollectorThatIsSpelledWronglyIsGuessed) {
  const auto problems = problemsOf(deploymentOf("{\"name\": \"L\", \"class\": \"StateColector\"}"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].ends_with("did you mean 'StateCollector'?")) << problems[0];
}

TEST(Host, AClassOfNobodyMayBeOneOfALibrary) {
  const auto problems = problemsOf(deploymentOf("{\"name\": \"G\", \"class\": \"Gripper\"}"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].ends_with("one of a shared library needs the key \"library\" too"))
      << problems[0];
}

TEST(Host, WrongParametersOfAllComponentsAreToldAtOnce) {
  const auto problems = problemsOf(deploymentOf(
      "{\"name\": \"A\", \"class\": \"SimulatedArm\",\n"
      "\"parameters\": {\"perod\": 0.001,\n"
      "\"home\": 3}},\n"
      "{\"name\": \"B\", \"class\": \"SimulatedArm\", \"parameters\": {\"period\": 7}}"));
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_EQ(problems[0],
            "d.json:3: error: parameters of 'A' (SimulatedArm): unknown key 'perod'; did you mean "
            "'period'?");
  EXPECT_EQ(problems[1],
            "d.json:4: error: parameters of 'A' (SimulatedArm): 'home': expected a list of 3, "
            "found number 3");
  EXPECT_TRUE(problems[2].starts_with(
      "d.json:5: error: parameters of 'B' (SimulatedArm): 'period': expected a number"))
      << problems[2];
}

TEST(Host, ComponentThatRefusesToExist) {
  const auto problems = problemsOf(deploymentOf("{\"name\": \"R\", \"class\": \"Refusing\"}"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0],
            "d.json:2: error: component 'R' of class 'Refusing' cannot be created: no such device");
}

// The constructor may have thrown because the key that it needs is spelled wrongly.
TEST(Host, UnknownParametersComeBeforeWhatAConstructorThrew) {
  const auto problems = problemsOf(
      deploymentOf("{\"name\": \"R\", \"class\": \"Refusing\", \"parameters\": {\"prot\": 7}}"));
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_TRUE(contains(problems[0], "unknown key 'prot'")) << problems[0];
  EXPECT_TRUE(contains(problems[1], "cannot be created: no such device")) << problems[1];
}

/// Is a gripper that is not there.
class Unplugged final : public suture::PeriodicTask {
 public:
  Unplugged() : PeriodicTask({.period = 1ms}) {}

 private:
  void onConfigure() override { throw std::runtime_error("no answer on /dev/ttyUSB7"); }
  void run() override {}
};

TEST(Host, ComponentThatCannotBeConfigured) {
  const std::array classes{ComponentClass{"Unplugged", createWithoutParameters<Unplugged>}};
  const Deployment deployment = deploymentOf("{\"name\": \"U\", \"class\": \"Unplugged\"}");
  Host host(deployment, "all", classes);
  try {
    host.start();
    FAIL();
  } catch (const DocumentError& error) {
    EXPECT_STREQ(error.what(),
                 "d.json:2: error: component 'U' of class 'Unplugged' cannot be configured: no "
                 "answer on /dev/ttyUSB7");
  }
}

TEST(Host, RequiredInterfaceWithoutAConnection) {
  const auto problems = problemsOf(deploymentOf("{\"name\": \"C\", \"class\": \"Client\"}"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0],
            "d.json:2: error: required interface 'all:C/Arm' (reference::ArmLike) has no provider; "
            "add a connection {\"from\": \"all:C/Arm\", \"to\": ...}");
}

TEST(Host, RequiredInterfaceThatAConnectionMisspells) {
  const std::string components =
      "{\"name\": \"PSM\", \"class\": \"SimulatedArm\"},\n"
      "{\"name\": \"C\", \"class\": \"Client\"}";
  EXPECT_EQ(problemsOf(deploymentOf(components, "{\"from\": \"C/Amr\", \"to\": \"PSM/Arm\"}")),
            std::vector<std::string>{
                "d.json:5: error: required interface 'all:C/Arm' (reference::ArmLike) has no "
                "provider; write it as \"from\" in the place of 'all:C/Amr', which there is not"});
  EXPECT_EQ(problemsOf(deploymentOf(components, "{\"from\": \"PSM/Arm\", \"to\": \"C/Arm\"}")),
            std::vector<std::string>{
                "d.json:5: error: required interface 'all:C/Arm' (reference::ArmLike) has no "
                "provider; it is named as \"to\": exchange \"from\" and \"to\""});
}

// The process of the provider would else wait for ever, and say nothing.
TEST(Host, ItsProvidedInterfaceThatAnotherProcessMisspells) {
  const auto remote = [](const std::string& connection) {
    return problemsOf(Deployment(JsonDocument::parse(
        R"({"processes": [
{"name": "all", "components": [{"name": "PSM", "class": "SimulatedArm"}]},
{"name": "far", "components": [{"name": "C", "class": "Client"}]}],
"manager": "unix:/tmp/suture-nobody-asks-it.sock",
"connections": [
)" + connection +
            "]}",
        "d.json")));
  };
  EXPECT_EQ(remote(R"({"from": "far:C/Arm", "to": "all:PSM/Amr"})"),
            std::vector<std::string>{
                "d.json:6: error: asked for the provided interface 'all:PSM/Amr': component 'PSM' "
                "has provided interfaces 'Arm'. Did you mean 'Arm'?"});
  EXPECT_EQ(remote(R"({"from": "all:PSM/Arm", "to": "far:C/Arm"})"),
            std::vector<std::string>{
                "d.json:6: error: asked for the required interface 'all:PSM/Arm': component 'PSM' "
                "has required interfaces none. It stands at the wrong end: a connection goes from "
                "a required interface to a provided one"});
}

TEST(Host, OptionalInterfaceWithoutAConnection) {
  const auto create = [](const JsonReader& in) {
    std::unique_ptr<Component> client = createWithoutParameters<Client>(in);
    suture::makeOptional(*client, {"Arm"});
    return client;
  };
  const std::array classes{ComponentClass{"Client", create}};
  const Deployment deployment = deploymentOf("{\"name\": \"C\", \"class\": \"Client\"}");
  Host host(deployment, "all", classes);
  host.start();
  EXPECT_TRUE(host.troubles().empty());
}

// What the header says would else hold for no interface, and nobody would be told.
TEST(Host, InterfaceThatHasAnotherNameThanInTheHeader) {
  const auto problemOf = [](std::unique_ptr<Component> (*create)(const JsonReader&)) {
    const std::array classes{ComponentClass{"Client", create}};
    const Deployment deployment = deploymentOf("{\"name\": \"C\", \"class\": \"Client\"}");
    try {
      const Host host(deployment, "all", classes);
    } catch (const DocumentError& error) {
      return error.problems().front();
    }
    return std::string();
  };
  constexpr char kProblem[] =
      "its header declares a required interface 'Leg' that is optional() or has a max_age()";
  EXPECT_PRED2(contains, problemOf([](const JsonReader& in) {
                 std::unique_ptr<Component> client = createWithoutParameters<Client>(in);
                 suture::makeOptional(*client, {"Arm", "Leg"});
                 return client;
               }),
               kProblem);
  EXPECT_PRED2(contains, problemOf([](const JsonReader& in) {
                 std::unique_ptr<Component> client = createWithoutParameters<Client>(in);
                 suture::limitAge(*client, "Leg", 10ms);
                 return client;
               }),
               kProblem);
}

TEST(Host, UnknownInterfaceNamesTheConnection) {
  const auto problems =
      problemsOf(deploymentOf("{\"name\": \"PSM\", \"class\": \"SimulatedArm\"},\n"
                              "{\"name\": \"Client\", \"class\": \"Client\"}",
                              "{\"from\": \"Client/Arm\", \"to\": \"PSM/Amr\"}"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].starts_with("d.json:5: error: ")) << problems[0];
  EXPECT_NE(problems[0].find("Did you mean 'Arm'?"), std::string::npos) << problems[0];
}

TEST(Host, ManagerThatIsNotRunning) {
  const Deployment deployment(
      JsonDocument::parse("{\n\"manager\": \"unix:/tmp/suture-nobody-listens-here.sock\",\n"
                          "\"processes\": [{\"name\": \"all\", \"components\": []}]}",
                          "d.json"));
  try {
    const Host host(deployment, "all", kClasses, 100ms);
    FAIL();
  } catch (const DocumentError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("d.json:2: error: ")) << error.what();
    EXPECT_NE(std::string(error.what()).find("suture-nobody-listens-here"), std::string::npos);
  }
}

TEST(Host, ATaskIsRestartedAsTheFileSays) {
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

TEST(Host, DoesNotPromiseThatAStoppedComponentIsConnectedAnew) {
  const suture::TemporaryDirectory directory;
  suture::rpc::ControlThread control;
  const suture::GlobalManager names(control, "unix:" + directory.file("m.sock"));
  reference::SimulatedArm arm(reference::SimulatedArmParameters{});
  suture::Manager robot("robot", names.address());
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

TEST(Host, ADeviceIsNotRestarted) {
  const std::array classes{ComponentClass{"Shelf", createWithoutParameters<Shelf>}};
  const Deployment deployment =
      deploymentOf(R"({"name": "S", "class": "Shelf", "restart": {"most": 1, "per": "1s"}})");
  try {
    Host host(deployment, "all", classes);
    FAIL();
  } catch (const DocumentError& error) {
    EXPECT_STREQ(error.what(),
                 "d.json:2: error: component 'S' of class 'Shelf' is to be restarted after faults, "
                 "but it is a device, which has no thread to be restarted in; remove 'restart', or "
                 "make its class a task");
  }
}

TEST(Host, ABlackBoxWithoutAFolder) {
  const auto problems = problemsOf(boxed("nowhere"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0],
            "d.json:3: error: the black box of process 'all' is to write to 'nowhere', which is no "
            "folder; create it, or name another one");
}

TEST(Host, ABlackBoxKeepsWhatTheFileSays) {
  const suture::TemporaryDirectory directory;
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
TEST(Host, HasTheNewsOfABlackBoxThatHasEnded) {
  const suture::TemporaryDirectory directory;
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

TEST(Host, ComponentThatThrowsIsNamedAndTheOthersGoOn) {
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
