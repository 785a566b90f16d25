// These tests say what a suspended component does not do, and what its clients are told meanwhile.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/component/task/callback_task.h>
#include <suture/component/task/continuous_task.h>
#include <suture/component/task/event_task.h>
#include <suture/component/task/guest_task.h>
#include <suture/wiring/connect.h>

#include <ctime>
#include <string>
#include <thread>
#include <vector>

#include "arm_client.h"
#include "living.h"
#include "support/eventually.h"
#include "support/patience.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using State = ComponentState;
using reference::ArmLike;

/// Counts cycles in a time in which nothing happens, and no answer has to be awaited.
template <class Kind>
int cyclesDuring(const Living<Kind>& task, Duration time) {
  const int before = task.cycles;
  pass(time);
  return task.cycles - before;
}

TEST(Suspended, ATasksClientsAreToldOfIt) {
  Living<PeriodicTask> task(kQuick);
  ArmClient client;
  const auto channel = connectLocally(client.arm, task.arm, "test");
  task.start();
  EXPECT_TRUE(client.arm.hold.start().within(kPatience));
  task.request(Transition::Suspend);
  EXPECT_TRUE(reaches(task, State::Suspended));
  EXPECT_TRUE(eventually([&] { return client.arm.unusable() == Errc::Suspended; }));
  EXPECT_EQ(client.arm.hold().error(), Errc::Suspended);
  EXPECT_EQ(client.arm.hold.start().within(kPatience).error(), Errc::Suspended);
  EXPECT_EQ(client.arm.measured_cp().error(), Errc::Suspended);
  EXPECT_EQ(cyclesDuring(task, 20ms), 0);

  task.request(Transition::Resume);
  EXPECT_TRUE(eventually([&] { return client.arm.connected(); }));
  EXPECT_TRUE(client.arm.hold.start().within(kPatience));
  EXPECT_EQ(channel->status, ChannelStatus::Connected);
}

TEST(Suspended, EarlierCommandsAreAnsweredAndNotExecuted) {
  Living<CallbackTask> task;
  ArmClient client;
  const auto channel = connectLocally(client.arm, task.arm, "test");
  task.start();
  task.trigger();
  task.request(Transition::Suspend);
  auto held = client.arm.hold.start();
  EXPECT_FALSE(held.poll()) << "it is still running";
  EXPECT_TRUE(task.trigger()) << "the last cycle, which executes what came before it";
  EXPECT_EQ(task.state(), State::Suspended);
  EXPECT_EQ(channel->commands.counters.executed, 1u);

  // A client that had looked at the status just before the change sends nevertheless.
  channel->status = ChannelStatus::Connected;
  auto call = client.arm.hold.start();
  EXPECT_TRUE(client.arm.hold());
  EXPECT_FALSE(task.trigger());
  EXPECT_EQ(call.within(kPatience).error(), Errc::Suspended);
  EXPECT_EQ(channel->commands.counters.refused, 2u);
  EXPECT_TRUE(client.arm.hold());
  task.request(Transition::Resume);
  EXPECT_FALSE(task.trigger());
  EXPECT_EQ(task.state(), State::Running);
  EXPECT_TRUE(task.trigger());
  EXPECT_EQ(channel->commands.counters.executed, 1u) << "an old command moved something";
  EXPECT_EQ(channel->commands.counters.refused, 3u);
}

TEST(Suspended, CommandsFromBeforeTheResumeAreRefused) {
  Living<CallbackTask> task;
  ArmClient client;
  const auto channel = connectLocally(client.arm, task.arm, "test");
  task.start();
  const Time sent = now();
  pass(1ms);
  task.request(Transition::Suspend);
  task.trigger();
  task.request(Transition::Resume);
  task.trigger();
  EXPECT_EQ(task.state(), State::Running);
  // A lane claims so what comes out of a network.
  ASSERT_TRUE(channel->commands.claim(reference::ArmLikeCommand::hold, sent, 0));
  channel->commands.commit();
  EXPECT_TRUE(task.trigger());
  EXPECT_EQ(channel->commands.counters.executed, 0u);
  EXPECT_EQ(channel->commands.counters.refused, 1u);
  EXPECT_TRUE(client.arm.hold());
  EXPECT_TRUE(task.trigger());
  EXPECT_EQ(channel->commands.counters.executed, 1u);
}

TEST(Suspended, ALateClientIsToldAtOnce) {
  Living<PeriodicTask> task(kQuick);
  task.start();
  task.request(Transition::Suspend);
  EXPECT_TRUE(reaches(task, State::Suspended));
  ArmClient client;
  connectLocally(client.arm, task.arm, "test");
  EXPECT_EQ(client.arm.hold().error(), Errc::Suspended);
  task.request(Transition::Resume);
  EXPECT_TRUE(eventually([&] { return client.arm.connected(); }));
  EXPECT_TRUE(client.arm.hold.start().within(kPatience));
}

/// Uses an arm, and counts the events that reach it.
struct SuspendedListener final : PeriodicTask {
  SuspendedListener() : PeriodicTask(kQuick) {
    arm.on().stopped([this] { ++stops; });
  }
  ~SuspendedListener() override { stop(); }
  void run() override {}
  std::atomic<int> stops{0};
  Required<ArmLike> arm{*this, "Arm"};
};

TEST(Suspended, EventsWaitUntilItIsResumed) {
  struct Emitting final : PeriodicTask {
    Emitting() : PeriodicTask(kQuick) {}
    ~Emitting() override { stop(); }
    void run() override {
      if (wanted > emitted) arm.emit().stopped(), ++emitted;
    }
    std::atomic<int> wanted{0}, emitted{0};
    reference::SimulatedArm simulated{{}};
    Provided<ArmLike> arm{*this, "Arm", simulated};
  } sender;
  SuspendedListener listener;
  connectLocally(listener.arm, sender.arm, "test");
  sender.start();
  listener.start();
  sender.wanted = 1;
  EXPECT_TRUE(eventually([&] { return listener.stops == 1; }));
  listener.request(Transition::Suspend);
  EXPECT_TRUE(reaches(listener, State::Suspended));
  sender.wanted = 2;
  EXPECT_TRUE(eventually([&] { return sender.emitted == 2; }));
  pass(10ms);
  EXPECT_EQ(listener.stops, 1);
  listener.request(Transition::Resume);
  EXPECT_TRUE(eventually([&] { return listener.stops == 2; }));
}

/// Returns the processor time of the calling process.
Duration processorTime() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

template <class Kind>
void expectItSleeps(Living<Kind>& task) {
  ArmClient client;
  const auto channel = connectLocally(client.arm, task.arm, "test");
  task.start();
  EXPECT_TRUE(reaches(task, State::Running));
  task.request(Transition::Suspend);
  EXPECT_TRUE(reaches(task, State::Suspended));
  // Commands that keep arriving must not keep it busy either.
  channel->status = ChannelStatus::Connected;
  EXPECT_EQ(client.arm.hold.start().within(kPatience).error(), Errc::Suspended);
  const Duration before = processorTime();
  pass(200ms);
  EXPECT_LT(processorTime() - before, 100ms) << "a suspended task spins";
  EXPECT_EQ(task.state(), State::Suspended);
  task.request(Transition::Resume);
  EXPECT_TRUE(reaches(task, State::Running));
  const int cycles = task.cycles;
  channel->status = ChannelStatus::Connected;
  EXPECT_TRUE(client.arm.hold.start().within(kPatience));
  EXPECT_TRUE(eventually([&] { return task.cycles > cycles; }));
}

TEST(Suspended, APeriodicTaskSleeps) {
  Living<PeriodicTask> task(kQuick);
  expectItSleeps(task);
}

TEST(Suspended, AContinuousTaskSleeps) {
  Living<ContinuousTask> task;
  expectItSleeps(task);
}

TEST(Suspended, AnEventTaskSleeps) {
  Living<EventTask> task(EventOptions{.longestSleep = 1h});
  expectItSleeps(task);
}

TEST(Suspended, ItsPeriodsAreNotCountedAsSkipped) {
  Living<PeriodicTask> task(kQuick);
  task.start();
  EXPECT_TRUE(eventually([&] { return task.cycles > 0; }));
  task.request(Transition::Suspend);
  EXPECT_TRUE(reaches(task, State::Suspended));
  const Time suspended = now();
  pass(300ms);
  const auto missed = static_cast<std::uint64_t>((now() - suspended) / 1ms);
  task.request(Transition::Resume);
  EXPECT_TRUE(eventually([&, before = task.cycles.load()] { return task.cycles > before + 3; }));
  EXPECT_LT(task.statistics().skipped, missed);
}

TEST(Suspended, AHostGoesOnForItsGuests) {
  Living<GuestTask> guest;
  Living<EventTask> host(EventOptions{.longestSleep = 1h});
  host.lend(guest);
  ArmClient ofHost, ofGuest;
  connectLocally(ofHost.arm, host.arm, "host");
  connectLocally(ofGuest.arm, guest.arm, "guest");
  host.start();
  host.request(Transition::Suspend);
  EXPECT_TRUE(reaches(host, State::Suspended));
  EXPECT_TRUE(ofGuest.arm.hold.start().within(kPatience));
  EXPECT_EQ(ofHost.arm.hold().error(), Errc::Suspended);
  guest.request(Transition::Suspend);
  EXPECT_TRUE(reaches(guest, State::Suspended));
  host.request(Transition::Resume);
  EXPECT_TRUE(eventually([&] { return ofHost.arm.connected(); }));
  EXPECT_EQ(host.state(), State::Running);
  EXPECT_TRUE(ofHost.arm.hold.start().within(kPatience));
  EXPECT_EQ(ofGuest.arm.hold().error(), Errc::Suspended);
  host.stop();
  EXPECT_EQ(guest.state(), State::Stopped);
  EXPECT_EQ(guest.diary.entries(),
            (std::vector<std::string>{"configure", "start", "suspend", "stop"}));
}

TEST(Suspended, ADeviceRefusesItsCallers) {
  struct ArmDevice final : Device {
    void onSuspend() override { diary.note("suspend"); }
    void onStart() override { diary.note("start"); }
    Diary diary;
    reference::SimulatedArm simulated{{}};
    Provided<ArmLike> arm{*this, "Arm", simulated};
  } device;
  ArmClient client, late;
  connectLocally(client.arm, device.arm, "test");
  EXPECT_TRUE(client.arm.hold()) << "also before it is started";
  device.start();
  EXPECT_EQ(device.state(), State::Running);
  device.request(Transition::Suspend);
  EXPECT_EQ(device.state(), State::Suspended);
  connectLocally(late.arm, device.arm, "late");
  EXPECT_EQ(client.arm.hold().error(), Errc::Suspended);
  EXPECT_EQ(late.arm.hold().error(), Errc::Suspended);
  device.request(Transition::Resume);
  EXPECT_TRUE(client.arm.hold());
  EXPECT_TRUE(late.arm.hold());
  device.stop();
  EXPECT_EQ(client.arm.hold().error(), Errc::Lost);
  EXPECT_EQ(device.diary.entries(), (std::vector<std::string>{"start", "suspend"}));
}

}  // namespace
}  // namespace suture
