// A process tells people on standard error what becomes of its components and connections.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/task/periodic_task.h>
#include <suture/manager/manager.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <optional>
#include <stdexcept>
#include <string>

#include "reference/still_arm.h"
#include "support/contains.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "unit/manager/two_processes.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

struct BreakingArm final : PeriodicTask, StillArm {
  explicit BreakingArm(std::uint32_t restarts = 0) : PeriodicTask({.period = 1ms}) {
    if (restarts > 0) restartAfterFaults({.most = restarts, .per = 24h});
  }
  ~BreakingArm() override { stop(); }
  void run() override {
    if (broken.exchange(false)) throw std::runtime_error("the encoder says nonsense");
  }
  std::atomic<bool> broken{false};
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

struct Listener final : Device {
  Required<reference::ArmLike> slave{*this, "Slave"};
};

/// Returns what is told on standard error while `run` runs.
template <class Run>
std::string toldBy(const Run& run) {
  testing::internal::CaptureStderr();
  run();
  return testing::internal::GetCapturedStderr();
}

void breakOnce(BreakingArm& arm) {
  arm.broken = true;
  EXPECT_TRUE(eventually([&] { return arm.faults() == 1; }));
}

TEST(Telling, AFaultIsToldWithItsReason) {
  EXPECT_EQ(toldBy([] {
              BreakingArm arm;
              Manager manager("here");
              manager.add("PSM", arm);
              manager.start();
              breakOnce(arm);
            }),
            "here: component 'PSM' has faulted, its code threw: the encoder says nonsense\n");
}

TEST(Telling, ARestartIsTold) {
  EXPECT_EQ(toldBy([] {
              BreakingArm arm(1);
              Manager manager("here");
              manager.add("PSM", arm);
              manager.start();
              breakOnce(arm);
              EXPECT_TRUE(eventually([&] { return arm.state() == ComponentState::Running; }));
              manager.stop();
            }),
            "here: component 'PSM' has faulted, its code threw: the encoder says nonsense\n"
            "here: component 'PSM' runs again after its fault\n");
}

TEST(Telling, AProgramTakesTheLinesOrNone) {
  std::promise<std::string> line;
  EXPECT_EQ(toldBy([&] {
              for (const bool taken : {true, false}) {
                BreakingArm arm;
                Manager manager("here");
                manager.tellBy(taken ? [&](const std::string& told) { line.set_value(told); }
                                     : Telling::Taker());
                manager.add("PSM", arm);
                manager.start();
                breakOnce(arm);
              }
            }),
            "");
  EXPECT_EQ(line.get_future().get(),
            "component 'PSM' has faulted, its code threw: the encoder says nonsense");
}

/// Returns what is told when a connection of `here` is lost and there again, after `prepare`.
template <class Prepare>
std::string toldOfALoss(const Prepare& prepare) {
  return toldBy([&] {
    TemporaryDirectory directory;
    loop::ControlThread control;
    GlobalManager global(control, "unix:" + directory.file("manager.sock"));
    BreakingArm arm, again;
    Listener listener;
    auto there = std::make_optional<Manager>("there", global.address());
    Manager here("here", global.address());
    prepare(here);
    there->add("PSM", arm);
    here.add("Teleop", listener);
    there->start();
    here.start();
    here.connect("Teleop/Slave", "there:PSM/Arm");
    there.reset();
    EXPECT_TRUE(eventually([&] { return !here.whyLost().empty(); }));
    const auto lost = here.channels();
    there.emplace("there", global.address());
    there->add("PSM", again);
    there->start();
    EXPECT_TRUE(eventually([&] { return here.channels() != lost; }));
    here.stop();
  });
}

void expectLossAndReturn(const std::string& told) {
  const std::string connection = "here: connection 'here:Teleop/Slave -> there:PSM/Arm' ";
  EXPECT_TRUE(contains(told, connection + "is lost, ")) << told;
  EXPECT_TRUE(contains(told, connection + "is there again\n")) << told;
}

TEST(Telling, ALossAndAReturnAreTold) {
  expectLossAndReturn(toldOfALoss([](Manager&) {}));
}

/// A process goes on with its connections even if it cannot tell of them.
TEST(Telling, AThrowingTakersLineIsTold) {
  expectLossAndReturn(toldOfALoss([](Manager& here) {
    here.tellBy([](const std::string&) { throw std::runtime_error("its disk is full"); });
  }));
}

TEST(Telling, TheManagersEndAndReturnAreTold) {
  TemporaryDirectory directory;
  const std::string address = "unix:" + directory.file("manager.sock");
  const std::string told = toldBy([&] {
    loop::ControlThread control;
    auto global = std::make_optional<GlobalManager>(control, address);
    Manager here("here", address);
    global.reset();
    EXPECT_TRUE(eventually([&] { return !here.missingGlobalManager().empty(); }));
    global.emplace(control, address);
    EXPECT_TRUE(eventually([&] { return here.missingGlobalManager().empty(); }));
  });
  const std::string manager = "here: the global manager at " + address;
  EXPECT_EQ(told, manager +
                      " does not answer: connections live on, new ones have to wait for one that "
                      "does. Start it again\n" +
                      manager + " is there again\n");
}

TEST(Telling, AnotherHolderOfItsNameIsTold) {
  const TemporaryDirectory directory, another;  // for two processes of one name and one id
  const std::string first = "unix:" + directory.file("first.sock"),
                    later = directory.file("later.sock");
  const std::string told = toldBy([&] {
    loop::ControlThread control;
    const GlobalManager one(control, first), other(control, "unix:" + another.file("other.sock"));
    auto holder = std::make_optional<Manager>("here", other.address());
    Manager here("here", first + ",unix:" + later);
    std::filesystem::create_symlink(another.file("other.sock"),
                                    later);  // it is there from now on
    const auto refused = [&] {
      const auto why = here.whyNoGlobalManager();
      return why.contains("unix:" + later) &&
             contains(why.at("unix:" + later), "the name is held by");
    };
    EXPECT_TRUE(eventually(refused));
    holder.reset();
    EXPECT_TRUE(eventually([&] { return here.missingGlobalManager().empty(); }));
  });
  const std::string manager = "here: the global manager at unix:" + later;
  EXPECT_TRUE(contains(told, manager +
                                 " cannot be used: register process 'here': the name is held by "
                                 "process " +
                                 std::to_string(getpid()) + " on "))
      << told;
  EXPECT_TRUE(contains(told, manager + " is there again\n")) << told;
}

TEST(Telling, ASecondManagerTellsOfItsComponents) {
  std::string told;
  BreakingArm arm;
  {
    Manager first("first");
    first.tellBy([](const std::string& line) { ADD_FAILURE() << "its program is gone: " << line; });
    first.add("PSM", arm);
  }
  Manager second("second");
  second.tellBy([&](const std::string& line) { told += line; });
  second.add("PSM", arm);
  second.start();
  breakOnce(arm);
  second.stop();
  EXPECT_EQ(told, "component 'PSM' has faulted, its code threw: the encoder says nonsense");
}

}  // namespace
}  // namespace suture
