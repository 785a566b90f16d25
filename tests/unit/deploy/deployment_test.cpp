#include <gtest/gtest.h>
#include <suture/deploy/document/deployment.h>

#include <algorithm>

#include "sound_deployment.h"

namespace {

using namespace std::chrono_literals;
using suture::Deployment;
using suture::DocumentError;
using suture::JsonDocument;
using suture::sound::expectOnly;
using suture::sound::kSound;
using suture::sound::problemsOf;
using suture::sound::with;

TEST(Deployment, ReadsWhatASoundFileSays) {
  const Deployment deployment(JsonDocument::parse(kSound, "d.json"));
  EXPECT_EQ(deployment.manager(), "unix:/tmp/suture.sock");
  ASSERT_EQ(deployment.processes().size(), 2u);
  const auto& teleop = deployment.process("left").components.at(1);
  EXPECT_EQ(teleop.className, "Teleop");
  EXPECT_EQ(teleop.parameters.at("scale"), 0.2);
  EXPECT_EQ(deployment.document().lineOf(teleop.pointer), 8);
  ASSERT_EQ(deployment.connections().size(), 2u);
  EXPECT_EQ(deployment.connections()[0].options.lane, suture::Lane::Auto);
  EXPECT_EQ(deployment.connections()[1].options.lane, suture::Lane::Rpc);
  EXPECT_EQ(deployment.connections()[1].to.toString(), "right:PSM1/Arm");
}

TEST(Deployment, OneProcessNeedsNoManager) {
  const Deployment deployment(JsonDocument::parse(
      R"({"processes": [{"name": "all", "components": [
            {"name": "a", "class": "A"}, {"name": "b", "class": "B"}]}],
          "connections": [{"from": "a/X", "to": "b/Y"}]})",
      "d.json"));
  EXPECT_EQ(deployment.connections()[0].from.toString(), "all:a/X");
}

/// `told` is how the only problem begins.
void expectOneThatBegins(const std::vector<std::string>& problems, const std::string& told) {
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].starts_with(told)) << problems[0];
}

// The global manager, of which the file may know nothing, refuses the same names.
TEST(Deployment, ProcessNamesAreCheckedWithoutAManager) {
  const auto problemsWith = [](const std::string& name) {
    return problemsOf(R"({"processes": [{"name": ")" + name + R"(", "components": []}]})");
  };
  const std::string longest(100, 'a');
  EXPECT_TRUE(problemsWith(longest).empty());
  for (const std::string& name :
       {std::string(), std::string("a b"), std::string("a\\tb"), std::string("a\\nb"),
        std::string("a\\u0000b"), std::string("a\\u001bb"), std::string("a\\u007f"),
        std::string("a:b"), std::string("a/b"), longest + "a"}) {
    SCOPED_TRACE(name);
    expectOneThatBegins(problemsWith(name),
                        "d.json:1: error: 'name': expected a name of 1 to 100 characters, none of "
                        "them ':', '/', a space "
                        "or a control character, given to the program as --process; found string ");
  }
}

// The process would refuse these names when it adds the components.
TEST(Deployment, AComponentsNameMustSuitAProcess) {
  for (const std::string name :
       {"", "a b", "a:b", "a/b", "a->b", "a\\tb", "a\\nb", "a\\n->b", "a\\u0000b", "a\\u001bb"}) {
    SCOPED_TRACE(name);
    expectOneThatBegins(
        problemsOf(R"({"processes": [{"name": "p", "components": [{"class": "C", "name": ")" +
                   name + R"("}]}]})"),
        "d.json:1: error: 'name': expected a name without ':', '/', '->', spaces and control "
        "characters, "
        "unique in its process; found string ");
  }
}

TEST(Deployment, UnknownKeySuggestsTheRightOne) {
  expectOnly(with("\"lane\"", "\"lanes\""),
             "d.json:18: error: unknown key 'lanes'; did you mean 'lane'?");
  expectOnly(with("\"manager\"", "\"x\": 1, \"manager\""),
             "d.json:2: error: unknown key 'x'; known are '$schema', 'connections', 'keys', "
             "'manager', 'policy', "
             "'processes' and 'title'");
}

TEST(Deployment, TheTitleIsOptional) {
  const auto titleOf = [](const std::string& text) {
    return Deployment(JsonDocument::parse(text, "d.json")).title();
  };
  EXPECT_EQ(titleOf(kSound), "");
  EXPECT_EQ(titleOf(with("\"manager\"", "\"title\": \"two arms\", \"manager\"")), "two arms");
}

TEST(Deployment, EveryUnknownKeyIsTold) {
  EXPECT_EQ(
      problemsOf(with("\"class\": \"Mtm\"", "\"class\": \"Mtm\", \"clas\": 1, \"nme\": 2")).size(),
      2u);
}

TEST(Deployment, MissingKeySaysWhatItIs) {
  expectOnly(with(", \"class\": \"Mtm\"", ""),
             "d.json:7: error: key 'class' is missing; it is the name of a C++ class that the "
             "program or the library offers, without its namespace");
}

TEST(Deployment, WrongTypeSaysWhatWasFound) {
  expectOnly(with("{\"scale\": 0.2}", "[1, 2]"),
             "d.json:8: error: 'parameters': expected the parameters of that class; what is absent "
             "keeps its default; found array [1,2]");
}

// Its program may have brought the lane, so the file alone cannot tell.
TEST(Deployment, ALaneIsAName) {
  EXPECT_EQ(Deployment(JsonDocument::parse(with("\"rpc\"", "\"pipe\""), "d.json"))
                .connections()[1]
                .options.lane,
            suture::Lane{"pipe"});
  expectOnly(
      with("\"rpc\"", "\"\""),
      "d.json:18: error: 'lane': expected \"auto\": the fastest lane that fits; or the name of one "
      "(docs/lanes.md), even within a process; found string \"\"");
}

TEST(Deployment, ALaneMayBeRequired) {
  const auto required = [](const std::string& text) {
    return Deployment(JsonDocument::parse(text, "d.json")).connections()[1].options.laneRequired;
  };
  EXPECT_FALSE(required(kSound));
  EXPECT_TRUE(required(with("\"rpc\"", "\"rpc\", \"lane_required\": true")));
}

suture::ConnectionDelay delayOf(const std::string& value) {
  const std::string text = with("\"lane\": \"rpc\"", "\"delay\": " + value);
  return Deployment(JsonDocument::parse(text, "d.json")).connections()[1].options.delay;
}

TEST(Deployment, DelaysOfAConnection) {
  EXPECT_FALSE(
      Deployment(JsonDocument::parse(kSound, "d.json")).connections()[1].options.delay.any());
  EXPECT_EQ(delayOf("\"5ms\"").commands, 5ms);
  EXPECT_EQ(delayOf("\"5ms\"").answers, 5ms);
  EXPECT_EQ(delayOf("\"0.25s\"").answers, 250ms);
  EXPECT_EQ(delayOf("{\"commands\": \"70us\"}").commands, 70us);
  EXPECT_EQ(delayOf("{\"commands\": \"70us\"}").answers, 0ns);
  EXPECT_EQ(delayOf("{\"answers\": \"3ns\"}").answers, 3ns);
}

suture::FaultPlan faultsOf(const std::string& value) {
  const std::string text = with("\"lane\": \"rpc\"", "\"faults\": " + value);
  return Deployment(JsonDocument::parse(text, "d.json")).connections()[1].options.delay.faults;
}

TEST(Deployment, FaultsOfAConnection) {
  EXPECT_FALSE(
      Deployment(JsonDocument::parse(kSound, "d.json")).connections()[1].options.delay.any());
  EXPECT_FALSE(faultsOf("{\"seed\": 3}").any());
  const suture::FaultPlan all = faultsOf(
      R"({"seed": 7, "loss": 0.01, "burst": 0.02, "burst_length": 3, "duplicate": 0.03,
          "reorder": 0.04, "hold_back": "2ms", "delay": 0.05, "delay_length": "3ms",
          "delay_again": 0.07,
          "jitter": "4ms", "ordered": true, "stall": 0.06, "stall_length": "5ms"})");
  EXPECT_EQ(all.seed, 7u);
  EXPECT_EQ(all.loss, 0.01);
  EXPECT_EQ(all.burst, 0.02);
  EXPECT_EQ(all.burstLength, 3u);
  EXPECT_EQ(all.duplicate, 0.03);
  EXPECT_EQ(all.reorder, 0.04);
  EXPECT_EQ(all.holdBack, 2ms);
  EXPECT_EQ(all.delay, 0.05);
  EXPECT_EQ(all.delayLength, 3ms);
  EXPECT_EQ(all.delayAgain, 0.07);
  EXPECT_EQ(all.jitter, 4ms);
  EXPECT_TRUE(all.ordered);
  EXPECT_EQ(all.stall, 0.06);
  EXPECT_EQ(all.stallLength, 5ms);
}

TEST(Deployment, AChanceIsAtMostOne) {
  expectOnly(
      with("\"lane\": \"rpc\"", "\"faults\": {\"loss\": 5}"),
      "d.json:18: error: 'faults.loss': expected chance of a message to be lost, from 0 to 1; "
      "found number 5");
}

suture::ConnectionContract contractOf(const std::string& value) {
  const std::string text = with("\"lane\": \"rpc\"", "\"contract\": " + value);
  return Deployment(JsonDocument::parse(text, "d.json")).connections()[1].options.contract;
}

TEST(Deployment, ReadsTheContractsOfConnections) {
  using suture::ConnectionContract, suture::Fallback, suture::Resume;
  EXPECT_EQ(Deployment(JsonDocument::parse(kSound, "d.json")).connections()[1].options.contract,
            ConnectionContract{});
  // A contract of usual terms alone is one as well: its connection has a watch, and a report.
  EXPECT_EQ(contractOf("{}"), ConnectionContract{.silence = ConnectionContract::kDefaultSilence});
  EXPECT_NE(contractOf(R"({"on_loss": "hold", "silence": "0s"})"), ConnectionContract{});
  const ConnectionContract expected{.maxAge = 10ms,
                                    .deadline = 50ms,
                                    .onStale = Fallback::Zero,
                                    .onLoss = Fallback::Fault,
                                    .resume = Resume::Operator,
                                    .silence = 100ms};
  EXPECT_EQ(contractOf(R"({"max_age": "10ms", "deadline": "50ms", "on_stale": "zero",
                           "on_loss": "fault", "resume": "operator", "silence": "100ms"})"),
            expected);
  EXPECT_EQ(contractOf(R"({"on_stale": "last"})").onStale, Fallback::Last);
}

TEST(Deployment, ContractsThatAreNone) {
  const auto problemsWith = [](const char* value) {
    return problemsOf(with("\"lane\": \"rpc\"", std::string("\"contract\": ") + value));
  };
  EXPECT_EQ(problemsWith(R"({"max_age": "61s"})"),
            std::vector<std::string>{"d.json:18: error: a time of 61s is longer than 60s, which is "
                                     "the longest; shorten it"});
  for (const char* value : {R"({"on_stale": "hope"})", R"({"resume": "never"})", R"({"age": 1})"}) {
    EXPECT_EQ(problemsWith(value).size(), 1u) << value;
  }
}

TEST(Deployment, AUnitlessTimeNamesItsKey) {
  const auto problemsWith = [](const char* key) {
    return problemsOf(with("\"lane\": \"rpc\"", key));
  };
  EXPECT_EQ(problemsWith(R"("contract": {"max_age": "200"})"),
            std::vector<std::string>{"d.json:18: error: 'contract.max_age': expected a time with "
                                     "its unit, such as \"10ms\"; found string \"200\""});
  EXPECT_EQ(problemsWith(R"("delay": {"answers": 5})"),
            std::vector<std::string>{"d.json:18: error: 'delay.answers': expected a time with its "
                                     "unit, such as \"10ms\"; found number 5"});
}

TEST(Deployment, AnUnknownWordsMessageListsTheKnown) {
  const auto problemsWith = [](const char* value) {
    return problemsOf(with("\"lane\": \"rpc\"", std::string("\"contract\": ") + value));
  };
  EXPECT_EQ(
      problemsWith(R"({"resume": "manual"})"),
      std::vector<std::string>{
          "d.json:18: error: 'contract.resume': expected who lets commands through again after a "
          "loss or a stale read: \"automatic\" or \"operator\"; found string \"manual\""});
  for (const char* key : {"on_stale", "on_loss"}) {
    const auto problems = problemsWith(("{\"" + std::string(key) + "\": \"hope\"}").c_str());
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_NE(problems[0].find("\"hold\", \"zero\", \"last\" or \"fault\""), std::string::npos)
        << problems[0];
  }
}

/// Returns kSound with one key more in PSM1.
std::string psmWith(const std::string& key) {
  return with("\"class\": \"Psm\"", "\"class\": \"Psm\", " + key);
}
/// Returns kSound with one key more in the process "right".
std::string rightWith(const std::string& key) {
  return with("\"name\": \"right\"", "\"name\": \"right\", " + key);
}

TEST(Deployment, ReadsTheRestartsOfComponents) {
  const auto restartOf = [](const std::string& text) {
    return Deployment(JsonDocument::parse(text, "d.json")).process("right").components[0].restart;
  };
  EXPECT_FALSE(restartOf(kSound));
  const auto budget = restartOf(psmWith(R"("restart": {"most": 3, "per": "3600s"})"));
  ASSERT_TRUE(budget);
  EXPECT_EQ(budget->most, 3u);
  EXPECT_EQ(budget->per, 1h);
}

TEST(Deployment, RestartsThatAreNone) {
  const auto problemWith = [](const std::string& value) {
    const auto problems = problemsOf(psmWith("\"restart\": " + value));
    return problems.size() == 1 ? problems[0] : std::to_string(problems.size()) + " problems";
  };
  const std::string line = "d.json:13: error: ";
  for (const char* most : {"0", "17", "2.5", "\"3\""}) {
    EXPECT_TRUE(
        problemWith(std::string(R"({"per": "60s", "most": )") + most + "}")
            .starts_with(line + "'restart.most': expected the number of restarts, 1 to 16; found "))
        << most;
  }
  EXPECT_EQ(problemWith(R"({"most": 3})"),
            line +
                "key 'per' is missing; it is the length of any time in which there are so many: "
                "for example \"60s\"");
  EXPECT_EQ(problemWith(R"({"most": 3, "pre": "1s", "per": "1s"})"),
            line + "unknown key 'pre'; did you mean 'per'?");
  EXPECT_EQ(problemWith(R"({"most": 3, "per": "0ms"})"),
            line + "a time of 0ms is no time at all; give a longer one");
  EXPECT_EQ(problemWith(R"({"most": 3, "per": "86401s"})"),
            line + "a time of 86401s is longer than 86400s, which is the longest; shorten it");
  const std::string digits(400, '9');
  EXPECT_EQ(
      problemWith(R"({"most": 3, "per": ")" + digits + "s\"}"),
      line + "a time of " + digits + "s is longer than 86400s, which is the longest; shorten it");
}

TEST(Deployment, ReadsTheBlackBoxesOfProcesses) {
  const auto boxOf = [](const std::string& text) {
    return Deployment(JsonDocument::parse(text, "folder/d.json")).process("right").blackBox;
  };
  EXPECT_FALSE(boxOf(kSound));
  const auto least = boxOf(rightWith(R"("black_box": {"folder": "faults"})"));
  ASSERT_TRUE(least);
  EXPECT_EQ(least->folder, "folder/faults");
  EXPECT_EQ(least->last, 10s);
  EXPECT_EQ(least->period, 10ms);
  EXPECT_EQ(least->rows, 0u);
  EXPECT_TRUE(least->components.empty());
  const auto all = boxOf(rightWith(
      R"("black_box": {"folder": "/var/faults", "last": "90s", "rows": 4096, "period": "2ms",
                       "components": ["PSM1"]})"));
  ASSERT_TRUE(all);
  EXPECT_EQ(all->folder, "/var/faults");
  EXPECT_EQ(all->last, 90s);
  EXPECT_EQ(all->period, 2ms);
  EXPECT_EQ(all->rows, 4096u);
  EXPECT_EQ(all->components, std::vector<std::string>{"PSM1"});
}

TEST(Deployment, BlackBoxesThatAreNone) {
  const auto problemWith = [](const std::string& value) {
    const auto problems = problemsOf(rightWith("\"black_box\": " + value));
    return problems.size() == 1 ? problems[0] : std::to_string(problems.size()) + " problems";
  };
  const std::string line = "d.json:12: error: ";
  EXPECT_EQ(problemWith("{}"), line +
                                   "key 'folder' is missing; it is the path of an existing folder "
                                   "for its files, from the folder of this file");
  EXPECT_TRUE(problemWith(R"({"folder": "f", "rows": 0})")
                  .starts_with(line + "'black_box.rows': expected how many rows of the past"));
  EXPECT_EQ(problemWith(R"({"folder": "f", "last": "0s"})"),
            line + "a time of 0s is no time at all; give a longer one");
  EXPECT_EQ(problemWith(R"({"folder": "f", "components": ["PSM2"]})"),
            line + "process 'right' has no component 'PSM2'; it has 'PSM1'; did you mean 'PSM1'?");
  EXPECT_EQ(problemWith(R"({"folder": "f", "components": ["PSM1", "PSM1"]})"),
            line + "'PSM1' is named twice; name it once");
}

TEST(Deployment, DelaysThatAreNone) {
  const auto problemsWith = [](const char* value) {
    return problemsOf(with("\"lane\": \"rpc\"", std::string("\"delay\": ") + value));
  };
  for (const char* value : {"5", "\"5\"", "\"-5ms\"", "\"5 ms\"", "\"fast\""}) {
    const auto problems = problemsWith(value);
    ASSERT_EQ(problems.size(), 1u) << value;
    EXPECT_TRUE(problems[0].starts_with("d.json:18: error: 'delay': expected a time with its unit"))
        << problems[0];
  }
  EXPECT_EQ(problemsWith("{\"command\": \"5ms\"}"),
            std::vector<std::string>{
                "d.json:18: error: unknown key 'command'; did you mean 'commands'?"});
  EXPECT_EQ(problemsWith("\"61s\""),
            std::vector<std::string>{"d.json:18: error: a time of 61s is longer than 60s, which is "
                                     "the longest; shorten it"});
}

TEST(Deployment, ProblemsOfSeveralPlacesAreToldTogether) {
  std::string text = with("\"lane\"", "\"lanes\"");
  text.replace(text.find("\"components\""), 12, "\"component\"");
  EXPECT_EQ(problemsOf(text).size(), 3u);  // unknown, missing, unknown
}

TEST(Deployment, ConnectionMistakesAreToldFirst) {
  std::string text = with("\"lane\": \"rpc\"", R"("contract": {"silence": "5ms"})");
  text.replace(text.find("MTML/Arm\""), 9, "MTML/Arm\", \"lane_required\": true");
  EXPECT_EQ(problemsOf(text),
            (std::vector<std::string>{
                "d.json:17: error: it requires a lane and names none; name one, for example "
                "\"lane\": \"shm\", or remove lane_required",
                "d.json:18: error: a longest silence of 5ms is too short for the heartbeats that "
                "have to fit into it; allow at least 10ms"}));
  EXPECT_EQ(problemsOf(with("\"lane\": \"rpc\"", R"("contract": {"silence": "10ms"})")).size(), 0u);
}

TEST(Deployment, ATooLongTextIsRefused) {
  const std::string name(200000, 'x');
  expectOnly(with("\"name\": \"left\"", "\"name\": \"" + name + "\""),
             "d.json:5: error: a text of 200000 characters is longer than 1024, which is the most "
             "here; shorten it");
  expectOnly(with("\"lane\": \"rpc\"", "\"contract\": {\"silence\": \"" + name + "\"}"),
             "d.json:18: error: a text of 200000 characters is longer than 1024, which is the most "
             "here; shorten it");
  expectOnly(with("\"lane\": \"rpc\"", "\"delay\": {\"answers\": \"" + name + "\"}"),
             "d.json:18: error: a text of 200000 characters is longer than 1024, which is the most "
             "here; shorten it");
  EXPECT_TRUE(problemsOf(with("\"scale\": 0.2", "\"note\": \"" + name + "\"")).empty());
}

TEST(Deployment, AnUnknownProcessIsNamed) {
  expectOnly(with("right:PSM1/Arm", "rigth:PSM1/Arm"),
             "d.json:18: error: 'rigth:PSM1/Arm' is in an unknown process 'rigth'; there are "
             "'left' and 'right'; did you mean 'right'?");
}

TEST(Deployment, AnUnknownComponentIsNamed) {
  expectOnly(with("left:MTML/Arm", "left:MTMR/Arm"),
             "d.json:17: error: process 'left' has no component 'MTMR'; it has 'MTML' and "
             "'Teleop'; did you mean 'MTML'?");
}

TEST(Deployment, OneOfTwoProcessesMustBeNamed) {
  expectOnly(with("left:MTML/Arm", "MTML/Arm"),
             "d.json:17: error: 'MTML/Arm' does not say in which process; write \"left:MTML/Arm\" "
             "or another of 'left' and 'right'");
}

TEST(Deployment, DuplicateNamesAreRefused) {
  expectOnly(
      with("\"name\": \"Teleop\"",
           "\"name\": \"MTML\", \"parameters\": {}, \"class\": \"T\"}, {\"name\": \"Teleop\""),
      "d.json:8: error: process 'left' has another component 'MTML'; give each its own name");
  const auto twice = problemsOf(with("\"name\": \"right\"", "\"name\": \"left\""));
  EXPECT_TRUE(std::any_of(twice.begin(), twice.end(), [](const std::string& problem) {
    return problem == "d.json:12: error: there is another process 'left'; give each its own name";
  }));
}

TEST(Deployment, TwoProvidersForOneRequiredInterface) {
  expectOnly(with("left:Teleop/Master", "left:Teleop/Slave"),
             "d.json:18: error: 'left:Teleop/Slave' is connected already, on line 17, to "
             "'left:MTML/Arm'; a required interface has one provider: remove one of the two");
}

TEST(Deployment, AnAbsentProcessIsAnError) {
  const Deployment deployment(JsonDocument::parse(kSound, "d.json"));
  try {
    deployment.process("lift");
    FAIL();
  } catch (const DocumentError& error) {
    EXPECT_STREQ(error.what(),
                 "d.json:3: error: no process 'lift' here; there are 'left' and 'right'; did you "
                 "mean 'left'?");
  }
}

}  // namespace
