// A whole deployment file is judged without a start of any of its processes.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/deploy/check.h>
#include <suture/net/tls/key_maker.h>

#include <array>
#include <fstream>
#include <memory>
#include <string>

#include "support/contains.h"
#include "support/temporary_directory.h"
#include "unit/deploy/document_problems.h"
#include "unit/deploy/host_scene.h"

namespace suture::test {
namespace {

constexpr char kArm[] = R"({"name": "PSM", "class": "SimulatedArm"})";
constexpr char kClient[] = R"({"name": "C", "class": "Client"})";
constexpr char kConnection[] = R"({"from": "near:C/Arm", "to": "far:PSM/Arm")";

/// Requires an arm whose commands might have values without a bound.
class Archivist final : public Device {
 private:
  struct Unbounded : RequiredBase {
    explicit Unbounded(Component& owner) : RequiredBase(owner, "Arm", info()) {}
    static const InterfaceInfo& info() {
      static const InterfaceInfo bounded = interfaceInfo<reference::ArmLike>();
      static std::vector<CommandInfo> commands(bounded.commands.begin(), bounded.commands.end());
      commands.front().sharedArguments = true;
      static InterfaceInfo unbounded = bounded;
      unbounded.commands = commands;
      return unbounded;
    }
  };

  Unbounded arm_{*this};
};

class CheckDeployment : public testing::Test {
 protected:
  /// Process 'near' has its components on line 2, process 'far' on line 3, connections begin on
  /// line 5; nobody listens at the address of the manager.
  Checked check(const std::string& near, const std::string& far, const std::string& connections,
                const std::string& more = "", const std::string& process = "") const {
    const std::string at =
        more.find("\"manager\"") == std::string::npos ? R"("manager": "unix:nobody.sock", )" : "";
    return checkText("{" + at + more + "\"processes\": [\n{\"name\": \"near\", \"components\": [" +
                         near + "]},\n{\"name\": \"far\", \"components\": [" + far +
                         "]}],\n\"connections\": [\n" + connections + "]}",
                     process);
  }
  Checked checkText(const std::string& text, const std::string& process = "") const {
    std::ofstream(file_) << text;
    return checkDeployment(file_, process, kOffered);
  }
  std::string line(int number) const { return file_ + ":" + std::to_string(number) + ": error: "; }

  inline static const std::array kOffered{
      componentClass<reference::SimulatedArm>(),
      ComponentClass{"Client", createWithoutParameters<Client>},
      ComponentClass{"Refusing", createWithoutParameters<Refusing>},
      ComponentClass{"Unplugged", createWithoutParameters<Unplugged>},
      ComponentClass{"Archivist", createWithoutParameters<Archivist>}};
  const TemporaryDirectory folder_;
  const std::string file_ = folder_.file("d.json");
};

TEST_F(CheckDeployment, ASoundFileIsSound) {
  const Checked found = check(kClient, kArm, kConnection + std::string("}"));
  EXPECT_EQ(found.problems, Texts{});
  EXPECT_EQ(found.warnings, Texts{});
  EXPECT_EQ(found.subject, "2 processes, 2 components and 1 connection");
}

TEST_F(CheckDeployment, ATooLongPathIsAMistake) {
  const auto problemsOf = [&](std::size_t room) {
    const std::size_t others = folder_.file("").size() + std::string(".4194304.sock").size();
    const std::string name(room - others, 'p');
    return checkText(R"({"manager": "unix:nobody.sock", "processes": [
{"name": ")" + name + R"(", "components": []}, {"name": "q", "components": []}]})")
        .problems;
  };
  EXPECT_EQ(problemsOf(107), Texts{});
  const Texts problems = problemsOf(108);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].starts_with(line(2) + "use the address 'unix:" + folder_.file("ppp")));
  EXPECT_TRUE(contains(problems[0], "its path has 108 characters and a socket's may have 107"));
}

TEST_F(CheckDeployment, NothingIsConfigured) {
  EXPECT_EQ(check("{\"name\": \"U\", \"class\": \"Unplugged\"}", "", "").problems, Texts{});
}

TEST_F(CheckDeployment, MistakesOfAllProcessesAreTold) {
  const Checked found =
      check(R"({"name": "C", "class": "Client", "restart": {"most": 1, "per": "0s"}})",
            R"({"name": "A", "class": "SimulatedArn"}, {"name": "R", "class": "Refusing"},
{"name": "PSM", "class": "SimulatedArm", "parameters": {"perod": 1},
"frames": {"Amr": {"reference": "base"}}}, {"name": "PSM2", "class": "SimulatedArm",
"frames": {"Amr": {"reference": "base"}}})",
            R"({"from": "near:C/Arm", "to": "fra:PSM/Arm"},
{"from": "far:PSM2/Master", "to": "near:C/Arm"})");
  const auto has = [&](const std::string& beginning) {
    for (const std::string& problem : found.problems) {
      if (problem.starts_with(beginning)) return true;
    }
    return false;
  };
  EXPECT_EQ(found.problems.size(), 8u) << testing::PrintToString(found.problems);
  EXPECT_TRUE(has(line(2) + "a time of 0s is no time at all"));
  EXPECT_TRUE(has(line(3) + "no component class 'SimulatedArn'"));
  EXPECT_TRUE(has(line(3) + "component 'R' of class 'Refusing' cannot be created"));
  EXPECT_TRUE(has(line(4) + "parameters of 'PSM' (SimulatedArm): unknown key 'perod'"));
  EXPECT_TRUE(has(line(6) + "component 'PSM2': declaring the frames of interface 'Amr'"));
  EXPECT_TRUE(has(line(8) + "'fra:PSM/Arm' is in an unknown process 'fra'"));
  EXPECT_TRUE(has(line(9) + "asked for the required interface 'far:PSM2/Master'"));
  EXPECT_TRUE(has(line(9) + "asked for the provided interface 'near:C/Arm'"));
}

TEST_F(CheckDeployment, OneProcessCanBeJudgedAlone) {
  const std::string other = R"({"name": "A", "class": "OfAnotherProgram"})";
  const Checked found =
      check(kClient, other + "," + kArm, kConnection + std::string("}"), "", "near");
  EXPECT_EQ(found.problems, Texts{});
  EXPECT_EQ(found.subject, "1 process, 1 component and 1 connection");
  EXPECT_EQ(check("", "", "", "", "nera").problems,
            Texts{line(1) + "no process 'nera' here; there are 'near' and 'far'; did you mean "
                            "'near'?"});
}

TEST_F(CheckDeployment, ContractsOfTwoProcessesAreCompared) {
  EXPECT_EQ(check(kClient, kArm, R"({"from": "near:C/Arm", "to": "far:PSM/component"})").problems,
            Texts{line(5) + "connecting near:C/Arm -> far:PSM/component: it requires "
                            "reference::ArmLike and is offered suture::Lifecycle. Connect "
                            "interfaces of the same contract"});
}

TEST_F(CheckDeployment, FramesOfTwoProcessesAreCompared) {
  const Texts problems =
      check(R"({"name": "C", "class": "Client", "frames": {"Arm": {"reference": "a"}}})",
            R"({"name": "PSM", "class": "SimulatedArm", "frames": {"Arm": {"reference": "b"}}})",
            kConnection + std::string("}"))
          .problems;
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_PRED2(contains, problems[0], line(5) + "connecting near:C/Arm -> far:PSM/Arm: it expects");
}

TEST_F(CheckDeployment, ARequiredLaneMustBePossible) {
  const Texts problems =
      check(kClient, kArm, kConnection + std::string(R"(, "lane": "shm", "lane_required": true})"),
            R"("manager": "tcp://127.0.0.1:7701", )")
          .problems;
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_PRED2(contains, problems[0],
               line(5) +
                   "connecting near:C/Arm -> far:PSM/Arm: lane 'shm' is required and cannot "
                   "carry it: ");
}

TEST_F(CheckDeployment, AContractWithoutBoundsHasNoFrames) {
  const Texts problems =
      check(R"({"name": "C", "class": "Archivist"})", kArm,
            kConnection + std::string(R"(, "lane": "frame", "lane_required": true})"))
          .problems;
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_PRED2(contains, problems[0], "lane 'frame' is required and cannot carry it: command ");
}

TEST_F(CheckDeployment, AnUnknownLaneIsTheClientsMistake) {
  const std::string connection = kConnection + std::string(R"(, "lane": "smh"})");
  const Texts told{
      line(5) +
      "connecting near:C/Arm -> far:PSM/Arm: this process has no lane 'smh'; it has "
      "'shm', 'frame' and 'rpc'. Ask for one of these, or add it with addLane() first"};
  EXPECT_EQ(check(kClient, kArm, connection).problems, told);
  EXPECT_EQ(check(kClient, kArm, connection, "", "near").problems, told);
  EXPECT_EQ(check(kClient, kArm, connection, "", "far").problems, Texts{});
}

TEST_F(CheckDeployment, ADelayNeedsAContractWithBounds) {
  const Texts problems = check(R"({"name": "C", "class": "Archivist"})", kArm,
                               kConnection + std::string(R"(, "delay": "1ms"})"))
                             .problems;
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_PRED2(contains, problems[0], line(5) + "a delay on a connection of reference::ArmLike");
}

TEST_F(CheckDeployment, EachProcessNeedsItsKeys) {
  tls::makeKeys(folder_.path() / "keys", {"near"}, {.lasts = std::chrono::days(29)});
  const Checked found = check("", "", "", "\"keys\": \"keys\", ");
  ASSERT_EQ(found.problems.size(), 1u) << testing::PrintToString(found.problems);
  EXPECT_TRUE(contains(found.problems[0], line(1)) && contains(found.problems[0], "far.crt"));
  ASSERT_EQ(found.warnings.size(), 1u);
  EXPECT_PRED2(contains, found.warnings[0], "d.json:1: warning: the certificate ");
}

TEST_F(CheckDeployment, AnUnreadablePolicyIsToldOnce) {
  std::ofstream(folder_.file("policy.json")) << R"({"roles": [], "rules": []})";
  EXPECT_EQ(check("", "", "", "\"policy\": \"policy.json\", ").problems.size(), 1u);
}

TEST_F(CheckDeployment, WhatIsNoDeploymentIsTold) {
  EXPECT_EQ(checkText("{").problems.size(), 1u);
  EXPECT_PRED2(contains, checkText("{}").problems.at(0), "key 'processes' is missing");
}

}  // namespace
}  // namespace suture::test
