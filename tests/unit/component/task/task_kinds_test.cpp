// These tasks do not simply own a thread with a clock: they run continuously, from a callback, or
// in a borrowed thread.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/task/callback_task.h>
#include <suture/component/task/continuous_task.h>
#include <suture/component/task/event_task.h>
#include <suture/component/task/guest_task.h>
#include <suture/component/task/periodic_task.h>
#include <suture/wiring/connect.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "reference/arm_like.suture.h"
#include "reference/simulated_arm.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/test_thread.h"
#include "unit/component/arm_client.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::PoseStamped;

/// Provides an arm; each cycle does `work` as well.
template <class Kind>
struct Worker final : Kind {
  template <class... Arguments>
  explicit Worker(std::function<void()> doWork = {}, Arguments&&... arguments)
      : Kind(std::forward<Arguments>(arguments)...), work(std::move(doWork)) {}
  ~Worker() override { this->stop(); }

  void run() override {
    if (work) work();
  }

  std::function<void()> work;
  reference::SimulatedArm simulated{{}};
  Provided<ArmLike> arm{*this, "Arm", simulated};
};

TEST(ContinuousTask, RunsWithoutWaitingForAnything) {
  std::atomic<int> cycles{0};
  Worker<ContinuousTask> task([&] { ++cycles; });
  ArmClient client;
  connectLocally(client.arm, task.arm, "test");
  task.start();
  EXPECT_TRUE(eventually([&] { return cycles > 1000; }));
  EXPECT_TRUE(client.arm.hold.start().within(kPatience));
  task.stop();
  const int atTheEnd = cycles;
  pass(5ms);
  EXPECT_EQ(cycles, atTheEnd);
}

TEST(CallbackTask, RunsInTheThreadThatCallsIt) {
  std::thread::id ranIn;
  Worker<CallbackTask> task([&] { ranIn = std::this_thread::get_id(); });
  ArmClient client;
  connectLocally(client.arm, task.arm, "test");
  EXPECT_FALSE(task.trigger());
  task.start();
  auto call = client.arm.hold.start();
  EXPECT_FALSE(call.poll());
  EXPECT_TRUE(task.trigger());
  EXPECT_TRUE(call.within(kPatience));
  EXPECT_EQ(ranIn, std::this_thread::get_id());

  std::thread::id other;
  TestThread caller([&] {
    other = std::this_thread::get_id();
    EXPECT_TRUE(task.trigger());
  });
  caller.join();
  EXPECT_EQ(ranIn, other);
  EXPECT_EQ(task.statistics().cycles, 2u);
  task.stop();
  EXPECT_FALSE(task.trigger());
  EXPECT_EQ(client.arm.hold().error(), Errc::Lost);
}

TEST(CallbackTask, ANestedCallIsCountedOnly) {
  Worker<CallbackTask>* self = nullptr;
  bool nested = true;
  Worker<CallbackTask> task([&] { nested = self->trigger(); });
  self = &task;
  task.start();
  EXPECT_TRUE(task.trigger());
  EXPECT_FALSE(nested);
  EXPECT_EQ(task.statistics().cycles, 1u);
  EXPECT_EQ(task.statistics().skipped, 1u);
}

TEST(CallbackTask, StopWaitsForTheCycleUnderWay) {
  std::atomic<bool> inside{false}, ended{false};
  Worker<CallbackTask> task([&] {
    inside = true;
    pass(20ms);
    ended = true;
  });
  task.start();
  TestThread caller([&] { task.trigger(); });
  EXPECT_TRUE(eventually([&] { return inside.load(); }));
  task.stop();
  EXPECT_TRUE(ended);
  caller.join();
}

const char* const kStopElsewhere =
    "stopping '(unnamed)': it is asked for in its own thread, which would wait for itself. Stop it "
    "in the thread that started it; in its own, request() a suspension";

TEST(CallbackTask, IsNotStoppedInItsCycle) {
  std::string answer;
  Worker<CallbackTask>* self = nullptr;
  Worker<CallbackTask> task([&] { answer = refusal([&] { self->stop(); }); });
  self = &task;
  task.start();
  EXPECT_TRUE(task.trigger());
  EXPECT_EQ(answer, kStopElsewhere);
  EXPECT_EQ(task.state(), ComponentState::Running);
  task.stop();
  EXPECT_EQ(task.state(), ComponentState::Stopped) << "the same thread, but not in a cycle";
}

TEST(PeriodicTask, IsNotStoppedInItsOwnThread) {
  Worker<PeriodicTask>* self = nullptr;
  Worker<PeriodicTask> task([&] { self->stop(); }, PeriodicOptions{.period = 1ms});
  self = &task;
  task.start();
  EXPECT_TRUE(eventually([&] { return task.state() == ComponentState::Faulted; }));
  EXPECT_EQ(task.fault(), kStopElsewhere);
}

TEST(GuestTask, DoesNotStopItsHost) {
  std::string answer;
  std::atomic<bool> asked{false};
  Worker<GuestTask> guest;
  Worker<PeriodicTask> host({}, PeriodicOptions{.period = 1ms});
  guest.work = [&] {
    if (asked) return;
    answer = refusal([&] { host.stop(); });
    asked = true;
  };
  host.lend(guest);
  host.start();
  EXPECT_TRUE(eventually([&] { return asked.load(); }));
  EXPECT_EQ(answer, kStopElsewhere);
}

TEST(GuestTask, FollowsItsHostInLendingOrder) {
  std::vector<std::string> order;
  std::vector<std::thread::id> threads;
  const auto note = [&](const char* who) {
    return [&order, &threads, who] {
      if (order.size() >= 300) return;
      order.emplace_back(who);
      threads.push_back(std::this_thread::get_id());
    };
  };
  Worker<GuestTask> first(note("first")), inner(note("inner")), second(note("second"));
  Worker<PeriodicTask> host(note("host"), PeriodicOptions{.period = 1ms});
  first.lend(inner);
  host.lend(first);
  host.lend(second);
  host.start();
  EXPECT_TRUE(eventually([&] { return host.statistics().cycles > 10; }));
  host.stop();
  ASSERT_GE(order.size(), 8u);
  EXPECT_EQ(std::vector<std::string>(order.begin(), order.begin() + 8),
            (std::vector<std::string>{"host", "first", "inner", "second", "host", "first", "inner",
                                      "second"}));
  for (const std::thread::id& thread : threads) EXPECT_EQ(thread, threads.front());
  EXPECT_EQ(second.state(), ComponentState::Stopped);
}

TEST(GuestTask, ACommandForItWakesTheHost) {
  Worker<GuestTask> inner, guest;
  Worker<EventTask> host({}, EventOptions{.longestSleep = 1h});
  guest.lend(inner);
  host.lend(guest);
  ArmClient client, deep;
  connectLocally(client.arm, guest.arm, "test");
  connectLocally(deep.arm, inner.arm, "test");
  host.start();
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(client.arm.hold.start().within(kPatience));
    ASSERT_TRUE(deep.arm.measured_cp.fresh().within(kPatience));
  }
}

TEST(GuestTask, AThrowingGuestIsParkedAlone) {
  Worker<GuestTask> guest([] { throw std::runtime_error("the guest's fault"); });
  Worker<PeriodicTask> host({}, PeriodicOptions{.period = 1ms});
  host.lend(guest);
  ArmClient ofHost, ofGuest;
  connectLocally(ofHost.arm, host.arm, "test");
  connectLocally(ofGuest.arm, guest.arm, "test");
  host.start();
  EXPECT_TRUE(eventually([&] { return ofGuest.arm.unusable() == Errc::Faulted; }));
  EXPECT_EQ(guest.state(), ComponentState::Faulted);
  EXPECT_EQ(guest.fault(), "the guest's fault");
  EXPECT_EQ(ofGuest.arm.hold().error(), Errc::Faulted);
  EXPECT_TRUE(ofHost.arm.hold.start().within(kPatience));
  EXPECT_EQ(host.state(), ComponentState::Running);
}

TEST(GuestTask, OutlivesAHostThatThrows) {
  Worker<GuestTask> guest;
  Worker<EventTask> host([] { throw std::runtime_error("the host's fault"); });
  host.lend(guest);
  ArmClient ofHost, ofGuest;
  connectLocally(ofHost.arm, host.arm, "test");
  connectLocally(ofGuest.arm, guest.arm, "test");
  host.start();
  EXPECT_TRUE(eventually([&] { return host.state() == ComponentState::Faulted; }));
  EXPECT_TRUE(ofGuest.arm.hold.start().within(kPatience));
  // Commands that wait for the parked host must not keep its thread busy.
  const std::uint64_t before = guest.statistics().cycles;
  pass(50ms);
  EXPECT_LT(guest.statistics().cycles - before, 10u);
}

TEST(GuestTask, NeedsOneHostAndNoConnections) {
  Worker<GuestTask> guest, connected;
  Worker<PeriodicTask> host({}, PeriodicOptions{}), other({}, PeriodicOptions{});
  EXPECT_NE(refusal([&] { guest.start(); }).find("no task lends it a thread"), std::string::npos);
  host.configure();
  host.lend(guest);
  EXPECT_NE(refusal([&] { other.lend(guest); }).find("it already has that of"), std::string::npos);
  ArmClient client;
  connectLocally(client.arm, connected.arm, "test");
  EXPECT_NE(refusal([&] { host.lend(connected); }).find("is already connected"), std::string::npos);
  host.start();
  Worker<GuestTask> late;
  EXPECT_NE(refusal([&] { host.lend(late); }).find("has been started"), std::string::npos);
}

/// Returns how many cycles such a task has that nobody asks for anything.
template <class Kind, class Options>
int cyclesOfItsOwn(const Options& options) {
  std::atomic<int> cycles{0};
  Worker<Kind> task([&] { ++cycles; }, options);
  task.start();
  pass(30ms);
  task.stop();
  return cycles;
}

TEST(EventTask, MaySleepForever) {
  EXPECT_LE(cyclesOfItsOwn<EventTask>(EventOptions{.longestSleep = Duration::max()}), 2);
}

TEST(EventTask, RefusesASleepThatIsNone) {
  for (const Duration sleep : {Duration{0}, Duration{-1}}) {
    EXPECT_EQ(refusal([&] { Worker<EventTask>({}, EventOptions{.longestSleep = sleep}); }),
              "the longest sleep of a task: a period of " + std::to_string(sleep.count()) +
                  " ns. Give a period greater than zero");
  }
}

TEST(Device, RefusesAnEmptyReadPeriod) {
  struct Sensor final : Device {
    using Device::Device;
  };
  for (const Duration period : {Duration{0}, Duration{-1}}) {
    EXPECT_EQ(refusal([&] { Sensor sensor(period); }), "the reads of a device: a period of " +
                                                           std::to_string(period.count()) +
                                                           " ns. Give a period greater than zero");
  }
}

TEST(PeriodicTask, MayHaveAPeriodThatNeverEnds) {
  EXPECT_EQ(cyclesOfItsOwn<PeriodicTask>(PeriodicOptions{.period = Duration::max()}), 0);
}

}  // namespace
}  // namespace suture
