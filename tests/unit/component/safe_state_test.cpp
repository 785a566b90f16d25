// A task that has been faulted goes to its safe state, and is restarted.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/task/callback_task.h>
#include <suture/wiring/connect.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "support/refusal.h"
#include "unit/component/driven_arm.h"
#include "unit/component/living.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

/// Throws when it is told to, and tells its arm to hold when that has happened.
struct Surgeon final : Task {
  void start() override {
    prepare();
    enter();
  }
  void stop() override { leave(); }
  using Task::cycle;

  void run() override {
    ++runs;
    if (broken) throw std::runtime_error("lost the needle");
  }
  void onFault() override {
    ++safeStates;
    held = slave.hold().has_value();
    if (safeStateBroken) throw std::runtime_error("no brake");
  }
  void onRestart() override {
    if (restartBroken) throw std::runtime_error("no second needle");
    broken = false;
  }

  Required<reference::ArmLike> slave{*this, "Slave"};
  bool broken = false, restartBroken = false, safeStateBroken = false, held = false;
  int runs = 0, safeStates = 0;
};

class SafeState : public testing::Test {
 protected:
  SafeState() {
    arm_.configure();
    arm_.start();
  }

  void begin(const RestartBudget& budget) {
    surgeon_.restartAfterFaults(budget);
    surgeon_.start();
    connectLocally(surgeon_.slave, arm_.automaticPort, "Surgeon/Slave -> PSM/Arm");
    surgeon_.cycle();
  }
  void breakDown() {
    surgeon_.broken = true;
    surgeon_.cycle();
  }
  bool faulted() const { return surgeon_.state() == ComponentState::Faulted; }

  DrivenArm arm_;
  Surgeon surgeon_;
};

TEST_F(SafeState, IsEnteredOnceAndReachesTheArm) {
  begin({});
  breakDown();
  surgeon_.cycle();
  EXPECT_TRUE(faulted());
  EXPECT_EQ(surgeon_.safeStates, 1);
  EXPECT_TRUE(surgeon_.held);
  EXPECT_EQ(surgeon_.runs, 2) << "it ran on";
}

TEST_F(SafeState, IsFollowedByRestartsWithinTheBudget) {
  begin({.most = 2, .per = 24h});
  for (int restart = 0; restart < 2; ++restart) {
    breakDown();
    EXPECT_FALSE(faulted());
    EXPECT_EQ(surgeon_.fault(), "lost the needle");
  }
  breakDown();
  EXPECT_TRUE(faulted());
  EXPECT_EQ(surgeon_.faults(), 3u);
  EXPECT_EQ(surgeon_.safeStates, 3);
  EXPECT_EQ(surgeon_.faultCause(), FaultCause::Code);
  EXPECT_EQ(surgeon_.whyFaulted(), "its code threw: lost the needle");
}

TEST_F(SafeState, TheBudgetFillsUpAgain) {
  begin({.most = 1, .per = 1ns});
  for (int restart = 0; restart < 5; ++restart) {
    pass(1ms);
    breakDown();
    EXPECT_FALSE(faulted());
  }
}

TEST_F(SafeState, ASuspendOutlivesTheRestart) {
  begin({.most = 1, .per = 24h});
  surgeon_.request(Transition::Suspend);
  breakDown();
  EXPECT_EQ(surgeon_.state(), ComponentState::Suspended);
  EXPECT_EQ(surgeon_.faults(), 1u);
  EXPECT_EQ(surgeon_.safeStates, 1);
}

TEST_F(SafeState, AFailedRestartIsAFaultToo) {
  begin({.most = 3, .per = 24h});
  surgeon_.restartBroken = true;
  breakDown();
  EXPECT_TRUE(faulted());
  EXPECT_EQ(surgeon_.faults(), 4u);
  EXPECT_EQ(surgeon_.fault(), "no second needle");
}

TEST_F(SafeState, OneThatThrowsEndsTheRestarts) {
  begin({.most = 3, .per = 24h});
  surgeon_.safeStateBroken = true;
  breakDown();
  EXPECT_TRUE(faulted());
  EXPECT_EQ(surgeon_.fault(), "lost the needle");
}

/// Its restart fails for ever, or until it is asked to stop.
struct Hopeless final : Task {
  void start() override {
    prepare();
    enter();
  }
  void stop() override { leave(); }
  using Task::cycle;
  void run() override { throw std::runtime_error("lost the needle"); }
  void onFault() override { ++safeStates; }
  void onRestart() override {
    pass(1ms);
    ++restarts;
    if (restarts == 3) setEnding(true);
    if (restarts < 100) throw std::runtime_error("no second needle");
  }
  int restarts = 0, safeStates = 0;
};

TEST(Restart, NoneFollowsAStopRequest) {
  Hopeless task;
  task.restartAfterFaults({.most = 1, .per = 1ns});
  task.start();
  task.cycle();
  EXPECT_EQ(task.restarts, 3);
  EXPECT_EQ(task.safeStates, 4) << "the last fault has a safe state too";
  EXPECT_TRUE(task.staysFaulted());
}

TEST(Restart, FollowsNoFaultOfOtherTransitions) {
  for (const char* const hook : {"configure", "start", "suspend"}) {
    Living<CallbackTask> task;
    task.throwing = hook;
    task.restartAfterFaults({.most = 3, .per = 24h});
    task.start();
    task.trigger();
    if (task.state() == ComponentState::Running) task.request(Transition::Suspend);
    task.trigger();
    EXPECT_EQ(task.state(), ComponentState::Faulted) << hook;
    EXPECT_TRUE(task.staysFaulted()) << hook;
    EXPECT_EQ(task.faults(), 1u) << hook;
    EXPECT_EQ(task.cycles, hook == std::string("suspend") ? 2 : 0) << hook;
  }
}

TEST(Restart, FollowsAResumeThatThrows) {
  Living<CallbackTask> task;
  task.throwing = "resume";
  task.restartAfterFaults({.most = 3, .per = 24h});
  task.start();
  task.request(Transition::Suspend);
  task.trigger();
  task.request(Transition::Resume);
  task.trigger();
  EXPECT_EQ(task.state(), ComponentState::Running);
  EXPECT_EQ(task.faults(), 1u);
}

TEST(Restart, FollowsNoFaultOfAnotherStart) {
  Living<CallbackTask> task;
  task.restartAfterFaults({.most = 3, .per = 24h});
  task.start();
  task.trigger();
  task.stop();
  task.throwing = "start";
  task.start();
  EXPECT_EQ(task.state(), ComponentState::Faulted);
  EXPECT_TRUE(task.staysFaulted());
}

/// Faults when it is asked to hold.
struct FragileArm final : CountingArm {
  void hold() override { throw std::runtime_error("the drive did not answer"); }
};

struct RestartedArm final : Task {
  void start() override {
    prepare();
    enter();
  }
  void stop() override { leave(); }
  using Task::cycle;
  void run() override {}
  FragileArm arm;
  Provided<reference::ArmLike> port{*this, "Arm", arm};
};

TEST(Restart, ClientsReachTheComponentAgain) {
  RestartedArm arm;
  arm.restartAfterFaults({.most = 1, .per = 24h});
  arm.start();
  Surgeon surgeon;
  surgeon.start();
  const auto watch = std::make_shared<ConnectionWatch>(ConnectionContract{.maxAge = 24h});
  const auto channel = connectLocally(surgeon.slave, arm.port, "Surgeon/Slave -> PSM/Arm", watch);
  surgeon.cycle();
  EXPECT_TRUE(surgeon.slave.hold());
  EXPECT_TRUE(surgeon.slave.hold());
  arm.cycle();
  EXPECT_EQ(channel->status, ChannelStatus::Connected);
  arm.cycle();
  surgeon.cycle();
  EXPECT_EQ(watch->losses, 1u) << "restarted before the client looked";
  EXPECT_EQ(arm.faults(), 1u) << "what was sent before the fault has been executed after it";
  EXPECT_TRUE(surgeon.slave.hold());
  arm.cycle();
  EXPECT_EQ(surgeon.slave.hold().error(), Errc::Faulted);
  surgeon.cycle();
  EXPECT_EQ(watch->losses, 2u);
}

TEST(Faults, AHandlerServedAlwaysMayThrow) {
  RestartedArm arm;
  arm.port.serveInEveryState();
  arm.restartAfterFaults({.most = 3, .per = 24h});
  arm.start();
  Surgeon surgeon;
  surgeon.start();
  const auto channel = connectLocally(surgeon.slave, arm.port, "Surgeon/Slave -> PSM/Arm");
  surgeon.cycle();
  arm.request(Transition::Suspend);
  arm.cycle();
  for (std::uint64_t failed = 1; failed <= 2; ++failed) {  // suspended, then faulted
    EXPECT_TRUE(surgeon.slave.hold());
    arm.cycle();
    EXPECT_EQ(arm.state(), ComponentState::Faulted) << "nobody has resumed it";
    EXPECT_EQ(channel->commands.counters.failed, failed);
  }
  EXPECT_EQ(arm.fault(), "the drive did not answer");
  EXPECT_EQ(arm.faults(), 1u);
}

TEST(Restart, ABudgetWithoutATimeIsRefused) {
  Surgeon surgeon;
  for (const Duration per : {Duration{0}, Duration{-1}}) {
    EXPECT_EQ(refusal([&] { surgeon.restartAfterFaults({.most = 3, .per = per}); }),
              "restarting '(unnamed)' after faults: 3 restarts in any time of " +
                  std::to_string(per.count()) + " ns. Give a time greater than zero");
  }
  surgeon.restartAfterFaults({});
}

TEST(Restart, ABudgetBeyondReasonIsRefused) {
  Surgeon surgeon;
  EXPECT_EQ(refusal([&] { surgeon.restartAfterFaults({.most = 17, .per = 1s}); }),
            "restarting '" + surgeon.name() + "' after faults: 17 restarts. Allow at most 16");
}

}  // namespace
}  // namespace suture
