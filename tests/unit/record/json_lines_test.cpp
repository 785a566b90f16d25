#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/record/json_lines.h>
#include <suture/record/state_collector.h>

#include <fstream>

#include "arm/arm.suture.h"
#include "reference/arm_like.suture.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using nlohmann::json;

std::vector<json> linesOf(const std::string& file) {
  std::vector<json> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) lines.push_back(json::parse(line));
  return lines;
}

TEST(JsonLines, WritesOneObjectALine) {
  using Command = robots::ArmCommand;
  const TemporaryDirectory directory;
  const std::string file = directory.file("run.jsonl");
  JsonLines sink(file);
  sink.begin();
  const CollectedInterface from{"Collector", interfaceInfo<robots::Arm>()};

  robots::PoseStamped pose;
  pose.pose.translation().x() = 0.25;
  pose.stamp = fromNanoseconds(5);
  pose.valid = true;
  robots::PoseStampedSlot slot{};
  ASSERT_TRUE(store(pose, slot));
  const CollectedValue values[] = {{Command::measured_cp, reinterpret_cast<std::byte*>(&slot)},
                                   {Command::measured_js, nullptr}};
  sink.row(from, 17, fromNanoseconds(6), values);
  sink.missed(from, 3);
  const std::uint8_t reached = 1;
  sink.event(from, robots::ArmEvent::goal_reached, fromNanoseconds(7),
             reinterpret_cast<const std::byte*>(&reached));
  ASSERT_TRUE(sink.flush());

  const std::vector<json> lines = linesOf(file);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0]["from"], "Collector");
  EXPECT_EQ(lines[0]["row"], 17);
  EXPECT_EQ(lines[0]["stamp"], 6);
  EXPECT_EQ(lines[0]["measured_cp"]["pose"]["m00"], 1.0);
  EXPECT_EQ(lines[0]["measured_cp"]["pose"]["x"], 0.25);
  EXPECT_EQ(lines[0]["measured_cp"]["stamp"], 5);
  EXPECT_EQ(lines[0]["measured_cp"]["valid"], true);
  EXPECT_EQ(lines[0]["measured_js"], nullptr);
  EXPECT_EQ(lines[1], json({{"from", "Collector"}, {"missed", 3}}));
  EXPECT_EQ(lines[2]["event"], "goal_reached");
  EXPECT_EQ(lines[2]["value"], true);
}

/// A collector is a task, whose thread allocates nothing.
TEST(StateCollector, RefusesAContractWithAReadWithoutBounds) {
  InterfaceInfo contract = interfaceInfo<robots::Arm>();
  std::vector<CommandInfo> commands(contract.commands.begin(), contract.commands.end());
  commands[robots::ArmCommand::measured_js].sharedResult = true;
  contract.commands = commands;
  const TemporaryDirectory directory;
  JsonLines sink(directory.file("run.jsonl"));
  EXPECT_THROW(StateCollector(contract, {.reads = {"measured_cp"}}, sink), SetupError);
}

TEST(JsonLines, EventValuesAreNamed) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("run.jsonl");
  JsonLines sink(file);
  sink.begin();
  const CollectedInterface from{"Collector", interfaceInfo<reference::ArmLike>()};
  reference::ArmLikeMovedPayload moved{};
  moved.value2 = 1.5;
  sink.event(from, reference::ArmLikeEvent::moved, fromNanoseconds(1),
             reinterpret_cast<const std::byte*>(&moved));
  sink.event(from, reference::ArmLikeEvent::stopped, fromNanoseconds(2), nullptr);
  ASSERT_TRUE(sink.flush());
  const std::vector<json> lines = linesOf(file);
  EXPECT_EQ(lines.at(0)["value"]["value2"], 1.5);
  EXPECT_EQ(lines.at(0)["value"]["value"]["pose"]["x"], 0);
  EXPECT_FALSE(lines.at(0)["value"].contains("stamp"));
  EXPECT_EQ(lines.at(1), json({{"from", "Collector"}, {"event", "stopped"}, {"stamp", 2}}));
}

TEST(JsonLines, AReadAvoidsTheLinesOwnKeys) {
  InterfaceInfo contract = interfaceInfo<robots::Arm>();
  std::vector<CommandInfo> commands(contract.commands.begin(), contract.commands.end());
  const std::size_t read = robots::ArmCommand::measured_cp;
  const std::size_t other = robots::ArmCommand::measured_js;
  commands[read].name = "row";
  commands[other].name = "event";
  contract.commands = commands;
  const TemporaryDirectory directory;
  const std::string file = directory.file("run.jsonl");
  JsonLines sink(file);
  sink.begin();
  const CollectedValue values[] = {{static_cast<std::uint16_t>(read), nullptr},
                                   {static_cast<std::uint16_t>(other), nullptr}};
  sink.row({"Collector", contract}, 17, fromNanoseconds(6), values);
  ASSERT_TRUE(sink.flush());
  EXPECT_EQ(linesOf(file).at(0), json({{"from", "Collector"},
                                       {"row", 17},
                                       {"stamp", 6},
                                       {"read.row", nullptr},
                                       {"read.event", nullptr}}));
}

TEST(JsonLines, RefusesAFileThatCannotBeWritten) {
  const TemporaryDirectory directory;
  EXPECT_THROW(JsonLines(directory.file("missing/run.jsonl")), SetupError);
}

}  // namespace
}  // namespace suture
