// A deployment that cannot run is refused in words, with the line of the file.

#include <gtest/gtest.h>
#include <suture/component/device.h>

#include "support/contains.h"
#include "support/refusal.h"
#include "unit/deploy/host_scene.h"

namespace suture::test {
namespace {

struct Shelf final : Device {};

TEST(HostProblems, AnUnknownClassIsNamed) {
  const auto problems =
      problemsOf(deploymentOf("{\"name\": \"PSM\", \"class\": \"SimulatedArn\"}"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0],
            "d.json:2: error: no component class 'SimulatedArn' in this program; it offers "
            "'SimulatedArm', 'Client', 'Throwing', 'Refusing', 'StateCollector' and "
            "'EventCollector'; did you mean 'SimulatedArm'?");
}

TEST(HostProblems, AMisspelledCollectorIsGuessed) {
  const auto problems = problemsOf(deploymentOf("{\"name\": \"L\", \"class\": \"StateColector\"}"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].ends_with("did you mean 'StateCollector'?")) << problems[0];
}

TEST(HostProblems, AnUnknownClassMayNeedALibrary) {
  const auto problems = problemsOf(deploymentOf("{\"name\": \"G\", \"class\": \"Gripper\"}"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].ends_with("one of a shared library needs the key \"library\" too"))
      << problems[0];
}

TEST(HostProblems, WrongParametersAreToldTogether) {
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

TEST(HostProblems, ComponentThatRefusesToExist) {
  const auto problems = problemsOf(deploymentOf("{\"name\": \"R\", \"class\": \"Refusing\"}"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0],
            "d.json:2: error: component 'R' of class 'Refusing' cannot be created: no such device");
}

// The constructor may have thrown because the key that it needs is spelled wrongly.
TEST(HostProblems, UnknownParametersComeFirst) {
  const auto problems = problemsOf(
      deploymentOf("{\"name\": \"R\", \"class\": \"Refusing\", \"parameters\": {\"prot\": 7}}"));
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_TRUE(contains(problems[0], "unknown key 'prot'")) << problems[0];
  EXPECT_TRUE(contains(problems[1], "cannot be created: no such device")) << problems[1];
}

TEST(HostProblems, ComponentThatCannotBeConfigured) {
  const std::array classes{ComponentClass{"Unplugged", createWithoutParameters<Unplugged>}};
  const Deployment deployment = deploymentOf("{\"name\": \"U\", \"class\": \"Unplugged\"}");
  Host host(deployment, "all", classes);
  EXPECT_EQ(refusal([&] { host.start(); }),
            "d.json:2: error: component 'U' of class 'Unplugged' cannot be configured: no answer "
            "on /dev/ttyUSB7");
}

TEST(HostProblems, RequiredInterfaceWithoutAConnection) {
  const auto problems = problemsOf(deploymentOf("{\"name\": \"C\", \"class\": \"Client\"}"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0],
            "d.json:2: error: required interface 'all:C/Arm' (reference::ArmLike) has no provider; "
            "add a connection {\"from\": \"all:C/Arm\", \"to\": ...}");
}

TEST(HostProblems, RequiredInterfaceThatAConnectionMisspells) {
  const std::string components =
      "{\"name\": \"PSM\", \"class\": \"SimulatedArm\"},\n"
      "{\"name\": \"C\", \"class\": \"Client\"}";
  EXPECT_EQ(problemsOf(deploymentOf(components, "{\"from\": \"C/Amr\", \"to\": \"PSM/Arm\"}")),
            std::vector<std::string>{
                "d.json:5: error: asked for the required interface 'all:C/Amr': component 'C' has "
                "required interfaces 'Arm'. Did you mean 'Arm'?"});
  const auto far =
      problemsOf(deploymentOf(components, "{\"from\": \"C/Gripper\", \"to\": \"PSM/Arm\"}"));
  ASSERT_EQ(far.size(), 2u);
  EXPECT_TRUE(contains(far[0], "add a connection {\"from\": \"all:C/Arm\"")) << far[0];
  EXPECT_TRUE(contains(far[1], "component 'C' has required interfaces 'Arm'")) << far[1];
  EXPECT_EQ(problemsOf(deploymentOf(components, "{\"from\": \"PSM/Arm\", \"to\": \"C/Arm\"}")),
            std::vector<std::string>{
                "d.json:5: error: required interface 'all:C/Arm' (reference::ArmLike) has no "
                "provider; it is named as \"to\": exchange \"from\" and \"to\""});
}

// The process of the provider would else wait for ever, and say nothing.
TEST(HostProblems, ItsProvidedInterfaceThatAnotherProcessMisspells) {
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
                "has no required interfaces. It stands at the wrong end: a connection goes from "
                "a required interface to a provided one"});
}

// If the names differed, the declaration would hold for no interface, and nobody would be told.
TEST(HostProblems, AnInterfacesNameMustMatchItsHeader) {
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
                 makeOptional(*client, {"Arm", "Leg"});
                 return client;
               }),
               kProblem);
  EXPECT_PRED2(contains, problemOf([](const JsonReader& in) {
                 std::unique_ptr<Component> client = createWithoutParameters<Client>(in);
                 limitAge(*client, "Leg", 10ms);
                 return client;
               }),
               kProblem);
}

TEST(HostProblems, UnknownInterfaceNamesTheConnection) {
  const auto problems =
      problemsOf(deploymentOf("{\"name\": \"PSM\", \"class\": \"SimulatedArm\"},\n"
                              "{\"name\": \"Client\", \"class\": \"Client\"}",
                              "{\"from\": \"Client/Arm\", \"to\": \"PSM/Amr\"}"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].starts_with("d.json:5: error: ")) << problems[0];
  EXPECT_NE(problems[0].find("Did you mean 'Arm'?"), std::string::npos) << problems[0];
}

TEST(HostProblems, ManagerThatIsNotRunning) {
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

TEST(HostProblems, ADeviceIsNotRestarted) {
  const std::array classes{ComponentClass{"Shelf", createWithoutParameters<Shelf>}};
  const Deployment deployment =
      deploymentOf(R"({"name": "S", "class": "Shelf", "restart": {"most": 1, "per": "1s"}})");
  EXPECT_EQ(refusal([&] { Host(deployment, "all", classes); }),
            "d.json:2: error: component 'S' of class 'Shelf' is to be restarted after faults, but "
            "it is a device, which has no thread to be restarted in; remove 'restart', or make its "
            "class a task");
}

TEST(HostProblems, ABlackBoxWithoutAFolder) {
  const auto problems = problemsOf(boxed("nowhere"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0],
            "d.json:3: error: the black box of process 'all' is to write to 'nowhere', which is no "
            "folder; create it, or name another one");
}

}  // namespace
}  // namespace suture::test
