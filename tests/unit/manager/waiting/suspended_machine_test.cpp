// The stamps of commands and the steady clock stand still while the machine is suspended. What has
// waited meanwhile is old all the same.

#include <gtest/gtest.h>

#include <atomic>
#include <initializer_list>
#include <vector>

#include "support/pass.h"
#include "support/stepped.h"
#include "unit/manager/waiting/waiting_commands.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

constexpr Duration kSilence = 2s;

class SuspendedMachine : public WaitingCommands {
 protected:
  static void suspend(Duration duration) { clockOfTest().suspend(duration); }
  /// Keeps the arm in one long cycle while the commands arrive. The machine sleeps at the end of
  /// that cycle, before the arm executes them.
  void sleepBeforeTheDrain(SlowArm& arm, std::initializer_list<Duration> sleeps) {
    client_.wanted = 0;
    arm.inRun = [this, &arm, sleeps = std::vector<Duration>(sleeps)] {
      if (client_.wanted > 0 || arm.port.channels().empty()) return;
      client_.wanted = 1;
      while (client_.sent == 0) pass(1ms);
      pass(20ms);
      for (const Duration sleep : sleeps) suspend(sleep);
    };
  }
};

class SuspendedRemotely : public SuspendedMachine {};

INSTANTIATE_TEST_SUITE_P(Lanes, SuspendedMachine, testing::ValuesIn(allWays()), nameOfWay);
INSTANTIATE_TEST_SUITE_P(Lanes, SuspendedRemotely, testing::ValuesIn(waysBetweenProcesses()),
                         nameOfWay);

TEST_P(SuspendedMachine, MakesWaitingCommandsTooOld) {
  SlowArm arm([] {});
  sleepBeforeTheDrain(arm, {kTtl});
  send(arm);
  EXPECT_EQ(arm.limits, 1);
  EXPECT_EQ(arm.servos, 0);
  EXPECT_EQ(late_, 1u);
  EXPECT_GE(oldest_, kTtl) << "the reports tell the time for which a command waited";
}

TEST_P(SuspendedMachine, MakesCommandsTooOldInTwoSleeps) {
  SlowArm arm([] {});
  sleepBeforeTheDrain(arm, {kTtl / 2, kTtl / 2});
  send(arm);
  EXPECT_EQ(arm.servos, 0);
}

TEST_P(SuspendedMachine, MakesCommandsTooOldBehindAHandler) {
  SlowArm arm([] { suspend(kTtl + 1ms); });
  send(arm);
  EXPECT_EQ(arm.servos, 0);
  EXPECT_EQ(late_, 1u);
  EXPECT_GT(oldest_, kTtl);
}

TEST_P(SuspendedMachine, LeavesCommandsThatBearIt) {
  SlowArm arm([] {});
  sleepBeforeTheDrain(arm, {kTtl - 100ms});
  send(arm);
  EXPECT_EQ(arm.servos, 1);
  EXPECT_EQ(late_, 0u);
}

// A command that was sent just before a sleep looks like one that was sent just after it, so the
// cycle that notices the sleep takes all that it finds for old.
TEST_P(SuspendedMachine, LeavesCommandsSentAfterItWasNoticed) {
  int calls = 0;
  SlowArm arm([&calls] {
    if (++calls == 1) suspend(kTtl + 1ms);
  });
  std::atomic<int> cyclesSince{0};
  arm.inRun = [&] { ++cyclesSince; };
  send(arm, [&] {
    if (arm.holds < client_.wanted) {
      cyclesSince = 0;
    } else if (cyclesSince > 2 && client_.wanted < 3) {
      ++client_.wanted;
    }
    return arm.holds == 3;
  });
  EXPECT_EQ(arm.servos, 2);
  EXPECT_EQ(late_, 1u);
}

// The client takes the provider for lost after such a sleep, so none of its commands may run.
TEST_P(SuspendedRemotely, EndsTheLeaseBeforeTheDrain) {
  SlowArm arm([] {});
  sleepBeforeTheDrain(arm, {kSilence});
  send(arm, [&] { return client_.lost.load(); }, {.silence = kSilence});
  EXPECT_EQ(arm.limits + arm.servos + arm.holds, 0);
  EXPECT_EQ(refused_, 3u);
}

TEST_P(SuspendedRemotely, EndsTheLeaseBehindAHandler) {
  SlowArm arm([] { suspend(kSilence); });
  send(arm, [&] { return client_.lost.load(); }, {.silence = kSilence});
  EXPECT_EQ(arm.limits, 1);
  EXPECT_EQ(arm.servos + arm.holds, 0);
  EXPECT_EQ(refused_, 2u);
}

TEST_P(SuspendedRemotely, KeepsTheLeaseThroughAShortSleep) {
  SlowArm arm([] {});
  sleepBeforeTheDrain(arm, {kSilence / 2});
  send(arm);
  EXPECT_EQ(arm.limits + arm.holds, 2);
}

}  // namespace
}  // namespace suture
