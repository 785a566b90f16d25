// A deployment says what it wants of scheduling and locked memory, and a process makes something of
// it.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/deploy/host.h>

#include <array>
#include <memory>

#include "reference/simulated_arm.suture.h"
#include "unit/deploy/document_problems.h"

namespace suture {
namespace {

struct Cupboard final : Device {};

const std::array kOffered{
    componentClass<reference::SimulatedArm>(),
    ComponentClass{"Cupboard", [](const JsonReader& in) -> std::unique_ptr<Component> {
                     in.finish();
                     return std::make_unique<Cupboard>();
                   }}};

/// Deploys a process with one component: `processKeys` stand on line 2, `componentKeys` on line 4.
Deployment deploymentWith(const std::string& processKeys, const std::string& componentKeys,
                          const std::string& className = "SimulatedArm") {
  return Deployment(JsonDocument::parse("{\"processes\": [{\"name\": \"all\",\n" + processKeys +
                                            "\n\"components\": [{\"name\": \"One\", \"class\": \"" +
                                            className + "\"\n" + componentKeys + "}]}]}",
                                        "d.json"));
}

TEST(RealTime, IsReadForTasksAndProcesses) {
  const Deployment without = deploymentWith("", "");
  EXPECT_FALSE(without.process("all").scheduling);
  EXPECT_FALSE(without.process("all").lockMemory);
  EXPECT_FALSE(without.process("all").realTimeRequired);
  EXPECT_FALSE(without.process("all").components[0].scheduling);
  const Deployment with = deploymentWith(
      R"("scheduling": {"policy": "round_robin", "priority": 1}, "lock_memory": true, "real_time": "required",)",
      R"(, "scheduling": {"policy": "fifo", "priority": 80, "processor": 1})");
  const ProcessEntry& process = with.process("all");
  EXPECT_EQ(process.scheduling, (rt::Scheduling{rt::Policy::RoundRobin, 1}));
  EXPECT_TRUE(process.lockMemory);
  EXPECT_TRUE(process.realTimeRequired);
  EXPECT_EQ(process.components[0].scheduling, (rt::Scheduling{rt::Policy::Fifo, 80, 1}));
}

TEST(RealTime, InvalidSchedulingIsAnError) {
  const auto problemWith = [](const std::string& value) {
    const Texts problems =
        problemsOf([&] { (void)deploymentWith("", ", \"scheduling\": " + value); });
    return problems.size() == 1 ? problems[0] : std::to_string(problems.size()) + " problems";
  };
  const std::string line = "d.json:4: error: ";
  EXPECT_EQ(problemWith(R"({"policy": "fifo"})"),
            line + "a policy needs a priority; add for example \"priority\": 80");
  EXPECT_EQ(problemWith(R"({"priority": 80})"),
            line + "a priority needs a policy; add for example \"policy\": \"fifo\"");
  for (const char* priority : {"0", "100", "2.5", "\"3\""}) {
    EXPECT_TRUE(problemWith(std::string(R"({"policy": "fifo", "priority": )") + priority + "}")
                    .starts_with(line + "'scheduling.priority': expected the priority under that "
                                        "policy, 1 to 99, the most urgent; found "))
        << priority;
  }
  EXPECT_TRUE(problemWith(R"({"policy": "realtime", "priority": 1})").starts_with(line));
  EXPECT_TRUE(problemWith("{}").starts_with(line));
}

TEST(RealTime, ADeviceHasNoSchedulableThread) {
  const Deployment deployment =
      deploymentWith("", ", \"scheduling\": {\"processor\": 0}", "Cupboard");
  EXPECT_EQ(problemsOf([&] { const Host host(deployment, "all", kOffered); }),
            Texts{"d.json:4: error: component 'One' of class 'Cupboard' is to be scheduled, but it "
                  "has no thread of its own; remove 'scheduling', or schedule the component in "
                  "whose thread it runs"});
}

TEST(RealTime, MissingRightsWarnOrFail) {
  const auto withFarProcessors = [](const std::string& key) {
    return deploymentWith(key + "\"scheduling\": {\"processor\": 1000},",
                          ", \"scheduling\": {\"processor\": 1001}");
  };
  const std::string task =
      "cannot pin the thread of component 'One' to processor 1001: Invalid argument. Choose a "
      "processor that this process may use (nproc)";
  const std::string process =
      "cannot pin the thread of the connections of process 'all' to processor 1000: Invalid "
      "argument. Choose a processor that this process may use (nproc)";
  const Deployment preferred = withFarProcessors("");
  Host host(preferred, "all", kOffered);
  EXPECT_EQ(host.news(), (Texts{"d.json:4: warning: " + task + "; it runs without",
                                "d.json:2: warning: " + process + "; it runs without"}));
  host.start();
  EXPECT_TRUE(host.news().empty());
  const Deployment required = withFarProcessors("\"real_time\": \"required\", ");
  EXPECT_EQ(problemsOf([&] { const Host refused(required, "all", kOffered); }),
            (Texts{"d.json:4: error: " + task, "d.json:2: error: " + process}));
}

}  // namespace
}  // namespace suture
