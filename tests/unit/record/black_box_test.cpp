// A black box leaves a component's last seconds when it has been faulted.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/provided.h>
#include <suture/component/task/periodic_task.h>
#include <suture/manager/handle.h>
#include <suture/manager/manager.h>
#include <suture/record/black_box.h>
#include <suture/rt/state/state_table.h>
#include <suture/standard/lifecycle.suture.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/eventually.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

/// Throws when it is told to. Provides the one contract of the runtime's own.
struct Arm final : PeriodicTask, Lifecycle {
  Arm() : PeriodicTask({.period = 1ms}) { port.keepState({.rows = 256}); }
  ~Arm() override { stop(); }
  void run() override {
    if (broken == 0) return;
    broken -= 1;
    throw std::runtime_error("the drive did not answer");
  }
  bool suspend() override { return false; }
  bool resume() override { return false; }
  ResumeOutcome resume_connection(const std::string&) override {
    return ResumeOutcome::NoSuchInterface;
  }
  ComponentState component_state() const override { return state(); }

  std::atomic<int> broken{0};  // so many cycles
  Provided<Lifecycle> port{*this, "Arm", *this};
};

class Boxed : public testing::Test {
 protected:
  void begin(const std::filesystem::path& folder, Duration last = 10s, Duration period = 10ms) {
    manager_.add("PSM", arm_);
    box_.emplace(
        manager_.directory().components(),
        BlackBoxOptions{
            .folder = folder, .last = last, .period = period, .tell = [this](const auto& text) {
              const std::lock_guard lock(mutex_);
              told_.push_back(text);
            }});
    manager_.start();
    EXPECT_TRUE(eventually([this] { return arm_.port.state()->rows() > 300; }));
  }
  std::string toldAfterFault() {
    const std::size_t before = count();
    arm_.broken = 1;
    EXPECT_TRUE(eventually([&] { return count() > before; }));
    return lastTold();
  }
  std::string lastTold() {
    const std::lock_guard lock(mutex_);
    return told_.empty() ? "" : told_.back();
  }
  static std::vector<nlohmann::json> lines(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::vector<nlohmann::json> all;
    for (std::string line; std::getline(in, line);) all.push_back(nlohmann::json::parse(line));
    return all;
  }

  TemporaryDirectory directory_;
  Arm arm_;
  Manager manager_{"here"};

 private:
  std::size_t count() {
    const std::lock_guard lock(mutex_);
    return told_.size();
  }

  std::mutex mutex_;
  std::vector<std::string> told_;

 protected:
  std::optional<BlackBox> box_;
};

TEST_F(Boxed, AFaultLeavesTheLastRowsBehind) {
  begin(directory_.file(""));
  const std::string file = directory_.file("PSM.1.jsonl");
  EXPECT_EQ(toldAfterFault(),
            "component 'PSM' faulted: the drive did not answer. Its last state "
            "is in " +
                file);
  auto rows = lines(file);
  std::erase_if(rows, [](const auto& row) { return row.at("from") != "PSM/Arm"; });
  ASSERT_GT(rows.size(), 200u);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].at("row"), rows[i - 1].at("row").get<int>() + 1);
  }
  EXPECT_EQ(rows.front().at("component_state"), "Running");
}

TEST_F(Boxed, NoFurtherBackThanAsked) {
  begin(directory_.file(""), 0ns);
  toldAfterFault();
  const auto written = lines(directory_.file("PSM.1.jsonl"));
  ASSERT_EQ(written.size(), 1u);
  EXPECT_EQ(written.front().dump(),
            R"({"fault":"the drive did not answer","first":1,"from":"PSM","last":1})");
}

TEST_F(Boxed, EveryFaultHasItsFile) {
  arm_.restartAfterFaults({.most = 1, .per = 24h});
  begin(directory_.file(""));
  toldAfterFault();
  EXPECT_TRUE(eventually([&] { return arm_.state() == ComponentState::Running; }));
  toldAfterFault();
  EXPECT_TRUE(std::filesystem::exists(directory_.file("PSM.1.jsonl")));
  EXPECT_TRUE(std::filesystem::exists(directory_.file("PSM.2.jsonl")));
}

TEST_F(Boxed, FaultsBetweenTwoLooksShareAFile) {
  arm_.restartAfterFaults({.most = 2, .per = 24h});
  begin(directory_.file(""), 10s, 1h);
  arm_.broken = 3;
  EXPECT_TRUE(eventually([&] { return arm_.staysFaulted(); }));
  box_.reset();  // looks a last time
  const std::string file = directory_.file("PSM.3.jsonl");
  const nlohmann::json first = lines(file).at(0);
  EXPECT_EQ(first.at("first"), 1);
  EXPECT_EQ(first.at("last"), 3);
  EXPECT_EQ(lastTold(),
            "component 'PSM' faulted (faults 1 to 3): the drive did not answer. Its "
            "last state is in " +
                file);
  EXPECT_FALSE(std::filesystem::exists(directory_.file("PSM.1.jsonl")));
}

TEST_F(Boxed, AMissingFolderIsTold) {
  begin(directory_.file("nowhere"));
  EXPECT_NE(toldAfterFault().find("Its last state is not kept: recording to "), std::string::npos);
}

TEST_F(Boxed, AFullDiskIsTold) {
  std::filesystem::create_symlink("/dev/full", directory_.file("PSM.1.jsonl"));
  begin(directory_.file(""));
  EXPECT_NE(toldAfterFault().find("the file system did not take all of it"), std::string::npos);
}

TEST(BlackBox, TellsStandardErrorWithoutListeners) {
  const TemporaryDirectory directory;
  Arm arm;
  Manager manager("here");
  manager.tellBy(nullptr);
  manager.add("PSM", arm);
  testing::internal::CaptureStderr();
  {
    const BlackBox box({&arm}, {.folder = directory.file("")});
    manager.start();
    arm.broken = 1;
    EXPECT_TRUE(eventually([&] { return arm.state() == ComponentState::Faulted; }));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "black box: component 'PSM' faulted: the drive did not answer. Its last state is in " +
                directory.file("PSM.1.jsonl") + "\n");
  manager.stop();
}

TEST(BlackBox, RefusesMoreRowsThanAreOfUse) {
  Arm arm;
  EXPECT_EQ(refusal([&] { BlackBox({&arm}, {.folder = "/tmp", .rows = 3'000'000'000}); }),
            "a black box: 3000000000 rows. Keep at most 1048576");
  EXPECT_EQ(arm.port.state()->capacity(), 256u);
}

TEST(BlackBox, RefusesToLookWithoutAPause) {
  EXPECT_EQ(refusal([] { BlackBox({}, {.folder = "/tmp", .period = Duration{0}}); }),
            "a black box: a period of 0 ns. Give a period greater than zero");
  EXPECT_EQ(refusal([] { BlackBox({}, {.folder = "/tmp", .period = Duration{-1}}); }),
            "a black box: a period of -1 ns. Give a period greater than zero");
}

TEST_F(Boxed, MayLookAtTheEndAlone) {
  begin(directory_.file(""), 10s, Duration::max());
  arm_.broken = 1;
  EXPECT_TRUE(eventually([&] { return arm_.state() == ComponentState::Faulted; }));
  pass(30ms);
  EXPECT_EQ(lastTold(), "");
  box_.reset();
  EXPECT_NE(lastTold().find("Its last state is in"), std::string::npos);
}

/// A command parks this device, and its caller's thread executes it.
struct BrokenDevice final : Device, Lifecycle {
  bool suspend() override { throw std::runtime_error("the drive did not answer"); }
  bool resume() override { return false; }
  ResumeOutcome resume_connection(const std::string&) override {
    return ResumeOutcome::NoSuchInterface;
  }
  ComponentState component_state() const override { return state(); }

  Provided<Lifecycle> port{*this, "Drive", *this};
};

TEST(BlackBox, SaysThatADeviceKeepsNoRows) {
  const TemporaryDirectory directory;
  BrokenDevice device;
  Manager manager("here");
  manager.add("Drives", device);
  std::string told;
  {
    BlackBox box({&device}, {.folder = directory.file(""),
                             .tell = [&](const std::string& text) { told = text; }});
    manager.start();
    Handle<Lifecycle> handle(manager, "Main/Drive", "Drives/Drive");
    EXPECT_FALSE(handle.suspend.start().within(1s));
    EXPECT_EQ(device.state(), ComponentState::Faulted);
  }
  manager.stop();
  EXPECT_EQ(told,
            "component 'Drives' faulted: the drive did not answer. It is a device, of which "
            "no rows are kept; the fault alone is in " +
                directory.file("Drives.1.jsonl"));
}

}  // namespace
}  // namespace suture
