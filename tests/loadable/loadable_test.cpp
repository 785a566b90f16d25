// These deployments create components from a shared library.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/factory/component_library.h>
#include <suture/deploy/host.h>
#include <suture/rt/counter.h>

#include <chrono>

#include <memory>
#include <string>
#include <vector>

#include "paths.h"
#include "support/eventually.h"
#include "support/stepped.h"

namespace suture {
namespace {

const std::string kLibraries = paths::kLibraries;

/// A deployment file in the folder of the libraries.
Deployment deploymentOf(const std::string& components, const std::string& connections = "") {
  return Deployment(JsonDocument::parse("{\"processes\": [{\"name\": \"all\", \"components\": [\n" +
                                            components + "]}],\n\"connections\": [\n" +
                                            connections + "]}",
                                        kLibraries + "/d.json"));
}

std::string component(const std::string& name, const std::string& type,
                      const std::string& library) {
  return R"({"name": ")" + name + R"(", "class": ")" + type + R"(", "library": ")" + library +
         "\"}";
}

std::vector<std::string> problemsOf(const Deployment& deployment) {
  try {
    Host host(deployment, "all", {});
    host.start();
  } catch (const DocumentError& error) {
    return error.problems();
  }
  return {};
}

/// Returns what is said of a deployment with that one component.
std::string problemOf(const std::string& type, const std::string& library) {
  const auto problems = problemsOf(deploymentOf(component("P", type, library)));
  return problems.size() == 1 ? problems[0] : std::to_string(problems.size()) + " problems";
}

const std::string kError = kLibraries + "/d.json:2: error: ";

TEST(Loadable, TheHeaderNamesThisRelease) { EXPECT_STREQ(kVersion, SUTURE_VERSION); }

TEST(Loadable, SeveralInstancesAreConnectedAndRun) {
  const Deployment deployment = deploymentOf(
      component("Left", "Platter", LOADABLE) + ",\n" + component("Right", "Platter", LOADABLE) +
          ",\n" + component("LeftHand", "Hand", LOADABLE) + ",\n" +
          component("RightHand", "Hand", kLibraries + "/" LOADABLE),
      "{\"from\": \"LeftHand/Turntable\", \"to\": \"Left/Turntable\"},\n"
      "{\"from\": \"RightHand/Turntable\", \"to\": \"Right/Turntable\"}");
  Host host(deployment, "all", {});
  host.start();
  const auto channels = host.manager().channels();
  ASSERT_EQ(channels.size(), 2u);
  for (const auto& channel : channels) {
    EXPECT_TRUE(eventually([&] { return channel->commands.counters.executed > 3; }))
        << channel->name();
  }
  // The runtime within the library obeys the clock of this program: its hand acts each millisecond.
  const auto executed = [&] { return rt::count(channels[0]->commands.counters.executed); };
  const std::uint64_t before = executed();
  clockOfTest().advance(std::chrono::milliseconds(10));
  EXPECT_EQ(executed(), before + 10);
  EXPECT_TRUE(host.troubles().empty());
}

TEST(Loadable, ParametersAreReadAsAlways) {
  const std::string platter = component("P", "Platter", LOADABLE);
  const auto problems = problemsOf(
      deploymentOf(platter.substr(0, platter.size() - 1) + ",\n\"parameters\": {\"angel\": 1}}"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0],
            kLibraries +
                "/d.json:3: error: parameters of 'P' (Platter): unknown key 'angel'; did you mean "
                "'angle'?");
}

TEST(Loadable, AClassThatIsMissingIsNamed) {
  EXPECT_EQ(problemOf("Plater", LOADABLE),
            kError + "no component class 'Plater' in library '" + kLibraries +
                "/" LOADABLE
                "'; it offers 'Platter', 'Hand' and 'Spindle'; did you mean 'Platter'?");
}

TEST(Loadable, NoSuchFile) {
  EXPECT_EQ(problemOf("Platter", "libnone.so"),
            kError + "loading components from '" + kLibraries +
                "/libnone.so': there is no such file. Give the path of a shared library, "
                "absolute or from the deployment's folder");
}

TEST(Loadable, ANonLibraryIsAnError) {
  const std::string problem = problemOf("Platter", "CTestTestfile.cmake");
  EXPECT_TRUE(problem.starts_with(kError + "loading components from '")) << problem;
  EXPECT_NE(problem.find("invalid ELF header. Build it for this machine"), std::string::npos)
      << problem;
}

TEST(Loadable, NoEntryPoint) {
  EXPECT_EQ(problemOf("Platter", NOT_LOADABLE),
            kError + "loading components from '" + kLibraries +
                "/" NOT_LOADABLE
                "': it has no function suture_components(). Build it with "
                "suture_generate(TARGET ... LOADABLE HEADERS ...)");
}

TEST(Loadable, ALibraryOfAnotherReleaseIsRefused) {
  EXPECT_EQ(problemOf("Platter", OLD_LOADABLE),
            kError + "loading components from '" + kLibraries +
                "/" OLD_LOADABLE
                "': it was built with Suture 0.0.9, this program with " SUTURE_VERSION
                ". Build both with the same release");
}

TEST(Loadable, EveryWrongLibraryIsToldAtOnce) {
  EXPECT_EQ(problemsOf(deploymentOf(component("A", "Platter", "a.so") + ",\n" +
                                    component("B", "Platter", "b.so")))
                .size(),
            2u);
}

}  // namespace
}  // namespace suture
