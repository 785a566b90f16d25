#include <fcntl.h>
#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/manager/manager.h>
#include <suture/record/event_collector.h>
#include <suture/record/json_lines.h>
#include <suture/record/state_collector.h>
#include <suture/rt/state/state_table.h>
#include <suture/standard/lifecycle.suture.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

#include "arm/arm.suture.h"
#include "reference/arm_like.suture.h"
#include "reference/simulated_arm.h"
#include "support/eventually.h"
#include "support/refusal.h"
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
  sink.flush();

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
TEST(StateCollector, RefusesAnUnboundedRead) {
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
  sink.flush();
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
  sink.flush();
  EXPECT_EQ(linesOf(file).at(0), json({{"from", "Collector"},
                                       {"row", 17},
                                       {"stamp", 6},
                                       {"read.row", nullptr},
                                       {"read.event", nullptr}}));
}

/// Lets no file of this process grow beyond `size`, as a disk that is full.
class NoMoreRoom {
 public:
  explicit NoMoreRoom(std::uintmax_t size) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit full{size, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &full);
  }
  ~NoMoreRoom() { setrlimit(RLIMIT_FSIZE, &before_); }
  NoMoreRoom(const NoMoreRoom&) = delete;
  NoMoreRoom& operator=(const NoMoreRoom&) = delete;

 private:
  rlimit before_{};
  void (*const handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

TEST(JsonLines, AFullDiskKeepsWholeLines) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("run.jsonl");
  JsonLines sink(file);
  sink.begin();
  const CollectedInterface a{"A", interfaceInfo<robots::Arm>()}, b{"B", a.contract};
  sink.row(a, 1, fromNanoseconds(1), {});
  sink.settle(a);
  sink.row(a, 2, fromNanoseconds(2), {});
  sink.row(a, 3, fromNanoseconds(3), {});
  sink.missed(a, 4);
  sink.row(b, 1, fromNanoseconds(1), {});
  try {
    const NoMoreRoom full(std::filesystem::file_size(file) + 5);
    sink.settle(a);
    FAIL() << "it had no room";
  } catch (const NotKept& why) {
    EXPECT_EQ(why.collected(), 2u);
    EXPECT_EQ(why.missed(), 4u);
  }
  EXPECT_EQ(linesOf(file).size(), 1u) << "without a torn one";
  sink.row(a, 8, fromNanoseconds(8), {});
  sink.settle(a);
  EXPECT_EQ(linesOf(file).at(1).at("row"), 8);
  try {
    sink.row(b, 2, fromNanoseconds(2), {});
    sink.settle(b);
    FAIL() << "it is not told of what was lost when another settled";
  } catch (const NotKept& why) {
    EXPECT_EQ(why.collected(), 2u) << "in the order of B, one is lost before the other";
  }
  sink.row(b, 3, fromNanoseconds(3), {});
  sink.settle(b);
  EXPECT_EQ(linesOf(file).at(2).at("row"), 3);
}

/// Its disk is full once, at the second look with something.
class OnceFull final : public Sink {
 public:
  explicit OnceFull(const std::string& file) : file_(file), lines_(file) {}

  void begin() override { lines_.begin(); }
  void row(const CollectedInterface& from, std::uint64_t number, Time stamp,
           std::span<const CollectedValue> values) override {
    lines_.row(from, number, stamp, values);
    some_ = true;
  }
  void event(const CollectedInterface& from, std::uint16_t event, Time stamp,
             const std::byte* slot) override {
    lines_.event(from, event, stamp, slot);
    some_ = true;
  }
  void missed(const CollectedInterface& from, std::uint64_t count) override {
    lines_.missed(from, count);
  }
  void settle(const CollectedInterface& from) override {
    std::optional<NoMoreRoom> full;
    if (std::exchange(some_, false) && ++looks_ == 2) {
      full.emplace(std::filesystem::file_size(file_) + 5);
    }
    lines_.settle(from);
  }

 private:
  const std::string file_;
  JsonLines lines_;
  bool some_ = false;
  int looks_ = 0;
};

/// Returns what was produced according to a file.
CollectedCounts countsOf(const std::string& file) {
  CollectedCounts counts;
  for (const json& line : linesOf(file)) {
    if (line.contains("missed")) {
      counts.missed += line.at("missed").get<std::uint64_t>();
    } else {
      ++counts.collected;
    }
  }
  return counts;
}

TEST(JsonLines, ARestartedStateCollectorCountsItsLosses) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("run.jsonl");
  OnceFull sink(file);
  reference::SimulatedArm arm{{}};
  StateCollector collector(interfaceInfo<reference::ArmLike>(), {}, sink);
  collector.restartAfterFaults({.most = 1, .per = std::chrono::hours(1)});
  Manager manager("here");
  manager.add("PSM", arm);
  manager.add("Log", collector);
  manager.connect("Log/Source", "PSM/Arm");
  manager.start();
  ASSERT_TRUE(eventually([&] { return collector.faults() == 1; }));
  const auto cycles = collector.statistics().cycles.load();
  ASSERT_TRUE(eventually([&] { return collector.statistics().cycles > cycles + 2; }));
  manager.stop();
  EXPECT_EQ(collector.state(), ComponentState::Stopped);
  EXPECT_EQ(collector.counts().produced(), arm.provided().front()->state()->rows());
  EXPECT_GT(countsOf(file).missed, 0u);
  EXPECT_EQ(countsOf(file).collected, collector.counts().collected);
  EXPECT_EQ(countsOf(file).missed, collector.counts().missed);
}

TEST(JsonLines, ARestartedEventCollectorCountsItsLosses) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("run.jsonl");
  OnceFull sink(file);
  reference::SimulatedArm arm{{}};
  EventCollector collector(interfaceInfo<Lifecycle>(), {}, sink);
  collector.restartAfterFaults({.most = 1, .per = std::chrono::hours(1)});
  Manager manager("here");
  manager.add("PSM", arm);
  manager.add("Log", collector);
  manager.connect("Log/Source", "PSM/component");
  manager.start();
  ASSERT_TRUE(eventually([&] { return collector.counts().collected == 1; }));
  manager.suspend("PSM");
  ASSERT_TRUE(eventually([&] { return collector.faults() == 1; }));
  manager.resume("PSM");
  manager.stop();
  EXPECT_EQ(countsOf(file).collected, 3u);
  EXPECT_EQ(countsOf(file).missed, 1u);
  EXPECT_EQ(collector.counts().collected, 3u);
  EXPECT_EQ(collector.counts().missed, 1u);
}

TEST(JsonLines, RefusesAFileThatCannotBeWritten) {
  const TemporaryDirectory directory;
  EXPECT_THROW(JsonLines(directory.file("missing/run.jsonl")), SetupError);
}

/// Makes a named pipe.
std::string pipeIn(const TemporaryDirectory& directory) {
  std::string pipe = directory.file("pipe");
  EXPECT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  return pipe;
}

TEST(JsonLines, RefusesAPipeThatNobodyReads) {
  const TemporaryDirectory directory;
  const std::string pipe = pipeIn(directory);
  JsonLines sink(pipe);
  EXPECT_EQ(refusal([&] { sink.begin(); }),
            "recording to " + pipe +
                ": it is a pipe that nobody reads. Start its reader first, or name a file");
}

TEST(JsonLines, APipeWithoutReaderRaisesNoSignal) {
  const TemporaryDirectory directory;
  const std::string pipe = pipeIn(directory);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(reader, 0);
  JsonLines sink(pipe);
  sink.begin();
  const CollectedInterface from{"Collector", interfaceInfo<robots::Arm>()};
  sink.missed(from, 3);
  sink.flush();
  char line[64] = {};
  EXPECT_GT(read(reader, line, sizeof(line)), 0);
  EXPECT_EQ(json::parse(line), json({{"from", "Collector"}, {"missed", 3}}));
  close(reader);
  sink.missed(from, 4);
  EXPECT_THROW(sink.flush(), SetupError);
  sigset_t pending;
  sigpending(&pending);
  EXPECT_EQ(sigismember(&pending, SIGPIPE), 0);
}

}  // namespace
}  // namespace suture
