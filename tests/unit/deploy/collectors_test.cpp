// A deployment file asks for these collectors.

#include <gtest/gtest.h>
#include <suture/deploy/host.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reference/simulated_arm.suture.h"
#include "support/eventually.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

const std::array kClasses{componentClass<reference::SimulatedArm>()};

/// An arm and a collector, of a file in `folder`; the collector is in line 2, its connection in 4.
Deployment deploymentOf(const std::string& folder, const std::string& collector,
                        const std::string& to) {
  return Deployment(JsonDocument::parse(
      "{\"processes\": [{\"name\": \"all\", \"components\": [\n" + collector + ",\n" +
          R"({"name": "PSM", "class": "SimulatedArm"}]}], "connections": [)" +
          (to.empty() ? "" : "\n{\"from\": \"Log/Source\", \"to\": \"" + to + "\"}") + "]}",
      folder + "d.json"));
}

std::string logOf(const std::string& className, const std::string& parameters) {
  return R"({"name": "Log", "class": ")" + className + R"(", "parameters": )" + parameters + "}";
}

std::string problemOf(const std::string& collector, const std::string& to) {
  const Deployment deployment = deploymentOf("", collector, to);
  try {
    Host host(deployment, "all", kClasses);
  } catch (const DocumentError& error) {
    return error.what();
  }
  return "none";
}

std::vector<nlohmann::json> linesOf(const std::string& file) {
  std::ifstream in(file);
  std::vector<nlohmann::json> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

/// Collects every second state of the arm into arm.jsonl of `folder`.
Deployment everySecondState(const std::string& folder) {
  return deploymentOf(
      folder,
      logOf("StateCollector", R"({"file": "arm.jsonl", "reads": ["component_state"], "every": 2})"),
      "PSM/component");
}

TEST(DeployedCollectors, RowsComeToTheFile) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("arm.jsonl");
  const Deployment deployment = everySecondState(directory.file(""));
  Host host(deployment, "all", kClasses);
  host.start();
  // The states are in the file while the collector runs, not only at its end.
  EXPECT_TRUE(eventually([&] {
    std::ifstream in(file);
    std::string line;
    int lines = 0;
    while (std::getline(in, line)) ++lines;
    return lines > 30;
  }));
  EXPECT_TRUE(host.troubles().empty());
}

TEST(DeployedCollectors, RowsAreThoseAskedFor) {
  const TemporaryDirectory directory;
  const Deployment deployment = everySecondState(directory.file(""));
  {
    Host host(deployment, "all", kClasses);
    host.start();
    const auto& cycles =
        dynamic_cast<Task&>(host.manager().directory().component("PSM")).statistics().cycles;
    EXPECT_TRUE(eventually([&] { return cycles > 200; }));
  }
  std::uint64_t last = 0;
  int rows = 0;
  for (const auto& line : linesOf(directory.file("arm.jsonl"))) {
    if (line.contains("missed")) continue;
    EXPECT_EQ(line.at("from"), "Log");
    EXPECT_EQ(line.at("component_state"), "Running");
    const std::uint64_t row = line.at("row");
    EXPECT_TRUE(rows == 0 || row >= last + 2) << row << " after " << last;
    last = row;
    ++rows;
  }
  EXPECT_GT(rows, 20);
}

TEST(DeployedCollectors, LifeCycleEventsReachTheFile) {
  const TemporaryDirectory directory;
  const Deployment deployment = deploymentOf(
      directory.file(""), logOf("EventCollector", R"({"file": "life.jsonl"})"), "PSM/component");
  {
    Host host(deployment, "all", kClasses);
    host.start();
    EXPECT_TRUE(eventually([&] { return !linesOf(directory.file("life.jsonl")).empty(); }));
  }
  EXPECT_EQ(linesOf(directory.file("life.jsonl")).front().at("value").at("state"), "Running");
}

TEST(DeployedCollectors, MistakesAreNamed) {
  const std::string sound = logOf("StateCollector", R"({"file": "/dev/null"})");
  EXPECT_EQ(problemOf(sound, "PSM/Arm"), "none");
  EXPECT_EQ(problemOf(sound, ""),
            "d.json:2: error: collector 'Log' has nothing to collect; add a connection {\"from\": "
            "\"all:Log/Source\", \"to\": ...}");
  EXPECT_EQ(problemOf(sound, "PSM/Amr"),
            "d.json:4: error: component 'PSM' has no provided interface 'Amr'; it has 'component' "
            "and 'Arm'; did you mean 'Arm'?");
  EXPECT_EQ(
      problemOf(sound, "Log/Collecting"),
      "d.json:4: error: collector 'Log' is to collect another collector, 'Log'; connect it to "
      "what that one collects");
  EXPECT_EQ(problemOf(logOf("StateCollector", "{}"), "PSM/Arm"),
            "d.json:2: error: parameters of 'Log' (StateCollector): key 'file' is missing; it is "
            "the file to write to, from the deployment's folder");
  EXPECT_EQ(problemOf(logOf("StateCollector", R"({"file": "/dev/null", "read": []})"), "PSM/Arm"),
            "d.json:2: error: parameters of 'Log' (StateCollector): unknown key 'read'; did you "
            "mean 'reads'?");
  EXPECT_EQ(
      problemOf(logOf("EventCollector", R"({"file": "/dev/null", "events": ["mod"]})"), "PSM/Arm"),
      "d.json:2: error: component 'Log' of class 'EventCollector' cannot be created: collecting "
      "the event 'mod': reference::ArmLike has 'mode', 'arrived', 'stopped' and 'moved'. Did you "
      "mean 'mode'?");
  EXPECT_TRUE(problemOf(logOf("StateCollector", R"({"file": "/dev/null", "every": 0})"), "PSM/Arm")
                  .starts_with("d.json:2: error: parameters of 'Log' (StateCollector): "));
  EXPECT_TRUE(problemOf(logOf("StateCollector", R"({"file": "/nowhere/a.jsonl"})"), "PSM/Arm")
                  .ends_with("Name a file in an existing folder that you may write to"));
}

TEST(DeployedCollectors, ARefusedStartLeavesTheFile) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("arm.jsonl");
  std::ofstream(file) << "{\"kept\": 1}\n";
  const Deployment wrong = deploymentOf(
      directory.file(""),
      logOf("StateCollector", R"({"file": "arm.jsonl"})") +
          R"(, {"name": "Other", "class": "StateCollector", "parameters": {"file": "b.jsonl"}})",
      "PSM/Arm");
  EXPECT_THROW(Host(wrong, "all", kClasses), DocumentError);
  EXPECT_EQ(linesOf(file).size(), 1u);
  EXPECT_FALSE(std::filesystem::exists(directory.file("b.jsonl")));
  const Deployment sound = everySecondState(directory.file(""));
  { const Host neverStarted(sound, "all", kClasses); }
  EXPECT_EQ(linesOf(file).size(), 1u);
}

TEST(DeployedCollectors, AnotherRunsRecordingIsLeftAlone) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("arm.jsonl");
  const Deployment deployment = everySecondState(directory.file(""));
  {
    Host first(deployment, "all", kClasses);
    first.start();
    ASSERT_TRUE(eventually([&] { return std::filesystem::file_size(file) > 0; }));
    Host second(deployment, "all", kClasses);
    const std::string told = refusal([&] { second.start(); });
    EXPECT_NE(told.find("d.json:2: error: component 'Log' of class 'StateCollector' cannot be "
                        "configured: recording to "),
              std::string::npos)
        << told;
    EXPECT_NE(told.find("another recording is being written to it"), std::string::npos) << told;
    const auto size = std::filesystem::file_size(file);
    EXPECT_TRUE(eventually([&] { return std::filesystem::file_size(file) > size; }));
  }
  EXPECT_EQ(linesOf(file).front().at("from"), "Log");
}

/// Two collectors that spell one file differently share its writer, so that all lines stay whole.
TEST(DeployedCollectors, AFileMayBeSpelledDifferently) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("arm.jsonl");
  std::filesystem::create_symlink(directory.file(""), directory.file("also"));
  const Deployment deployment(JsonDocument::parse(
      R"({"processes": [{"name": "all", "components": [
            {"name": "PSM", "class": "SimulatedArm"},
            {"name": "A", "class": "EventCollector", "parameters": {"file": "also/arm.jsonl"}},
            {"name": "B", "class": "EventCollector", "parameters": {"file": ")" +
          file + R"("}}]}],
          "connections": [{"from": "A/Source", "to": "PSM/component"},
                          {"from": "B/Source", "to": "PSM/component"}]})",
      directory.file("d.json")));
  {
    Host host(deployment, "all", kClasses);
    host.start();
    EXPECT_TRUE(eventually([&] { return linesOf(file).size() == 2; }));
  }
  std::map<std::string, int> lines;
  for (const auto& line : linesOf(file)) ++lines[line.at("from")];
  EXPECT_EQ(lines, (std::map<std::string, int>{{"A", 2}, {"B", 2}}));  // Running and Stopped
}

TEST(DeployedCollectors, TheDeploymentIsNoRecording) {
  const TemporaryDirectory directory;
  std::ofstream(directory.file("d.json")) << "{}";
  const Deployment deployment = deploymentOf(
      directory.file(""), logOf("StateCollector", R"({"file": "./d.json"})"), "PSM/Arm");
  const std::string told = refusal([&] { Host(deployment, "all", kClasses); });
  EXPECT_TRUE(
      told.ends_with("d.json:2: error: './d.json' is this deployment file itself, which a "
                     "recording would replace; name another file"))
      << told;
  EXPECT_EQ(std::filesystem::file_size(directory.file("d.json")), 2u);
}

TEST(DeployedCollectors, AnotherProcessHasItsOwn) {
  const Deployment deployment(JsonDocument::parse(
      R"({"manager": "unix:/tmp/suture-nobody-listens-here.sock", "processes": [
          {"name": "here", "components": [
             {"name": "Log", "class": "StateCollector", "parameters": {"file": "/dev/null"}}]},
          {"name": "there", "components": [{"name": "PSM", "class": "SimulatedArm"}]}],
          "connections": [{"from": "here:Log/Source", "to": "there:PSM/Arm"}]})",
      "d.json"));
  try {
    Host host(deployment, "here", kClasses);
    FAIL();
  } catch (const DocumentError& error) {
    EXPECT_STREQ(error.what(),
                 "d.json:5: error: collector 'Log' is to collect 'there:PSM/Arm' of another "
                 "process; put it into process 'there', where nothing is lost on the way to it");
  }
}

TEST(DeployedCollectors, ProcessesDoNotShareAFile) {
  const Deployment deployment(JsonDocument::parse(
      R"({"manager": "unix:/tmp/suture-nobody-listens-here.sock", "processes": [
          {"name": "left", "components": [{"name": "PSM", "class": "SimulatedArm"},
             {"name": "Log", "class": "StateCollector", "parameters": {"file": "nowhere/a.jsonl"}},
             {"name": "Said", "class": "EventCollector", "parameters": {"file": "nowhere/a.jsonl"}}]},
          {"name": "right", "components": [{"name": "PSM", "class": "SimulatedArm"},
             {"name": "Log", "class": "StateCollector", "parameters": {"file": "nowhere/./a.jsonl"}}]}],
          "connections": [{"from": "left:Log/Source", "to": "left:PSM/Arm"},
             {"from": "left:Said/Source", "to": "left:PSM/Arm"},
             {"from": "right:Log/Source", "to": "right:PSM/Arm"}]})",
      "d.json"));
  for (const char* process : {"left", "right"}) {
    try {
      Host host(deployment, process, kClasses);
      FAIL();
    } catch (const DocumentError& error) {
      EXPECT_TRUE(std::string(error.what())
                      .starts_with("d.json:6: error: 'nowhere/./a.jsonl' is written by process "
                                   "'left' already, on line 3; only collectors of one process may "
                                   "share a file: name another one"))
          << error.what();
    }
  }
}

}  // namespace
}  // namespace suture
