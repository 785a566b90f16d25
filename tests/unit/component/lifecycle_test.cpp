// The life of components: what leads where, the hooks and their threads, what is refused, and what
// clients are told.

#include <gtest/gtest.h>
#include <suture/component/callback_task.h>
#include <suture/component/channel.h>
#include <suture/component/continuous_task.h>
#include <suture/component/device.h>
#include <suture/component/event_task.h>
#include <suture/component/guest_task.h>
#include <suture/component/periodic_task.h>
#include <suture/wiring/connect.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "reference/arm_like.suture.h"
#include "reference/simulated_arm.h"
#include "support/eventually.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using State = ComponentState;
using reference::ArmLike;
using reference::PoseStamped;

std::string refusal(const std::function<void()>& attempt) {
  try {
    attempt();
  } catch (const SetupError& error) {
    return error.what();
  }
  return "";
}

/// What has happened, in order, and in which threads. Any thread.
class Diary {
 public:
  void note(const std::string& what) {
    const std::lock_guard lock(mutex_);
    entries_.push_back(what);
    threads_.push_back(std::this_thread::get_id());
  }
  std::vector<std::string> entries() const {
    const std::lock_guard lock(mutex_);
    return entries_;
  }
  std::vector<std::thread::id> threads() const {
    const std::lock_guard lock(mutex_);
    return threads_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> entries_;
  std::vector<std::thread::id> threads_;
};

/// Provides an arm, counts its cycles and keeps a diary; the hook `throwing` throws.
template <class Kind>
struct Living final : Kind {
  template <class... Arguments>
  explicit Living(Arguments&&... arguments) : Kind(std::forward<Arguments>(arguments)...) {}
  ~Living() override { this->stop(); }

  void onConfigure() override { hook("configure"); }
  void onStart() override { hook("start"); }
  void onSuspend() override { hook("suspend"); }
  void onResume() override { hook("resume"); }
  void onStop() override { hook("stop"); }
  void run() { ++cycles; }

  void hook(const std::string& name) {
    diary.note(name);
    if (name == throwing) throw std::runtime_error("no " + name + " today");
  }

  std::string throwing;
  Diary diary;
  std::atomic<int> cycles{0};
  reference::SimulatedArm simulated{{}};
  Provided<ArmLike> arm{*this, "Arm", simulated};
};

struct Client final : Device {
  Client() {
    arm.on().stopped([this] { ++stops; });
  }
  Required<ArmLike> arm{*this, "Arm"};
  int stops = 0;
};

const PeriodicOptions kQuick{.period = 1ms};

bool reaches(const Component& component, State state) {
  return eventually([&] { return component.state() == state; });
}

/// Nothing for a while, and yet no answer has to be awaited.
template <class Kind>
int cyclesDuring(const Living<Kind>& task, Duration time) {
  const int before = task.cycles;
  std::this_thread::sleep_for(time);
  return task.cycles - before;
}

TEST(Lifecycle, EachTransitionIsLegalInItsStatesAndNoOther) {
  const std::vector<State> states = {State::Constructed, State::Configured, State::Running,
                                     State::Suspended,   State::Faulted,    State::Stopped};
  const auto from = [&](Transition transition) {
    std::string legal;
    for (const State state : states) {
      const auto next = after(state, transition);
      if (next) legal += std::string(toString(state)) + ">" + toString(*next) + " ";
    }
    return legal;
  };
  EXPECT_EQ(from(Transition::Configure), "constructed>configured ");
  EXPECT_EQ(from(Transition::Start), "configured>running stopped>running ");
  EXPECT_EQ(from(Transition::Suspend), "running>suspended ");
  EXPECT_EQ(from(Transition::Resume), "suspended>running ");
  EXPECT_EQ(from(Transition::Stop), "running>stopped suspended>stopped ");
}

TEST(Lifecycle, ATaskGoesThroughItWithItsHooksInItsOwnThread) {
  Living<PeriodicTask> task(kQuick);
  EXPECT_EQ(task.state(), State::Constructed);
  task.configure();
  EXPECT_EQ(task.state(), State::Configured);
  task.start();
  EXPECT_EQ(task.state(), State::Running);
  EXPECT_TRUE(eventually([&] { return task.cycles > 0; }));
  task.request(Transition::Suspend);
  EXPECT_TRUE(reaches(task, State::Suspended));
  task.request(Transition::Resume);
  EXPECT_TRUE(reaches(task, State::Running));
  task.stop();
  EXPECT_EQ(task.state(), State::Stopped);
  EXPECT_EQ(task.diary.entries(),
            (std::vector<std::string>{"configure", "start", "suspend", "resume", "stop"}));
  const auto threads = task.diary.threads();
  EXPECT_EQ(threads[0], std::this_thread::get_id());
  EXPECT_NE(threads[1], std::this_thread::get_id());
  for (std::size_t i = 2; i < threads.size(); ++i) EXPECT_EQ(threads[i], threads[1]);

  task.start();
  EXPECT_EQ(task.state(), State::Running) << "a stopped task can start again";
  const int before = task.cycles;
  EXPECT_TRUE(eventually([&] { return task.cycles > before; }));
}

TEST(Lifecycle, WhatIsNotLegalIsRefusedWithWhatIs) {
  Living<PeriodicTask> task(kQuick);
  EXPECT_EQ(refusal([&] { task.request(Transition::Suspend); }),
            "component '(unnamed)' was asked to suspend: it is constructed. A component can "
            "suspend when it is running");
  task.start();
  EXPECT_EQ(refusal([&] { task.start(); }),
            "component '(unnamed)' was asked to start: it is running. A component can start when "
            "it is configured or stopped");
  EXPECT_NE(refusal([&] { task.configure(); }).find("it is running"), std::string::npos);
  EXPECT_NE(refusal([&] { task.request(Transition::Stop); }).find("start() or stop()"),
            std::string::npos);
  EXPECT_NE(refusal([&] { task.request(Transition::Resume); }).find("when it is suspended"),
            std::string::npos);
  EXPECT_EQ(task.state(), State::Running);
}

TEST(Lifecycle, AHookThatThrowsParksItsComponent) {
  for (const char* const hook : {"configure", "start", "suspend", "resume", "stop"}) {
    Living<PeriodicTask> task(kQuick), other(kQuick);
    task.throwing = hook;
    Client client;
    connectLocally(client.arm, task.arm, "test");
    task.start();
    other.start();
    if (task.state() == State::Running) task.request(Transition::Suspend);
    EXPECT_TRUE(eventually([&] { return task.state() != State::Running; }));
    if (task.state() == State::Suspended) task.request(Transition::Resume);
    EXPECT_TRUE(eventually([&] { return task.state() != State::Suspended; }));
    if (hook == std::string("stop")) task.stop();
    EXPECT_EQ(task.state(), State::Faulted) << hook;
    EXPECT_EQ(task.fault(), std::string("no ") + hook + " today");
    EXPECT_EQ(client.arm.hold().error(), Errc::Faulted) << hook;
    EXPECT_NE(refusal([&] { task.request(Transition::Resume); }).find("create it anew"),
              std::string::npos);
    EXPECT_EQ(other.state(), State::Running);
  }
}

TEST(Suspended, ATaskRunsNothingAndItsClientsAreTold) {
  Living<PeriodicTask> task(kQuick);
  Client client;
  const auto channel = connectLocally(client.arm, task.arm, "test");
  task.start();
  EXPECT_TRUE(client.arm.hold.start().within(5s));
  task.request(Transition::Suspend);
  EXPECT_TRUE(reaches(task, State::Suspended));
  EXPECT_TRUE(eventually([&] { return client.arm.unusable() == Errc::Suspended; }));
  EXPECT_EQ(client.arm.hold().error(), Errc::Suspended);
  EXPECT_EQ(client.arm.hold.start().within(5s).error(), Errc::Suspended);
  EXPECT_EQ(client.arm.measured_cp().error(), Errc::Suspended);
  EXPECT_EQ(cyclesDuring(task, 20ms), 0);

  task.request(Transition::Resume);
  EXPECT_TRUE(eventually([&] { return client.arm.connected(); }));
  EXPECT_TRUE(client.arm.hold.start().within(5s));
  EXPECT_EQ(channel->status, ChannelStatus::Connected);
}

TEST(Suspended, WhatWasSentBeforeOrMeanwhileIsAnsweredAndNeverExecuted) {
  Living<CallbackTask> task;
  Client client;
  const auto channel = connectLocally(client.arm, task.arm, "test");
  task.start();
  task.trigger();
  task.request(Transition::Suspend);
  EXPECT_FALSE(client.arm.hold.start().poll()) << "it is still running";
  EXPECT_TRUE(task.trigger()) << "the last cycle, which executes what came before it";
  EXPECT_EQ(task.state(), State::Suspended);
  EXPECT_EQ(channel->commands.counters.executed, 1u);

  // A client that had looked at the status just before the change sends nevertheless.
  channel->status = ChannelStatus::Connected;
  auto call = client.arm.hold.start();
  EXPECT_TRUE(client.arm.hold());
  EXPECT_FALSE(task.trigger());
  EXPECT_EQ(call.within(5s).error(), Errc::Suspended);
  EXPECT_EQ(channel->commands.counters.refused, 2u);
  EXPECT_TRUE(client.arm.hold());
  task.request(Transition::Resume);
  EXPECT_FALSE(task.trigger());
  EXPECT_EQ(task.state(), State::Running);
  EXPECT_TRUE(task.trigger());
  EXPECT_EQ(channel->commands.counters.executed, 1u) << "an old command moved something";
  EXPECT_EQ(channel->commands.counters.refused, 3u);
}

TEST(Suspended, WhatWasSentBeforeTheResumeIsRefusedHoweverLateItArrives) {
  Living<CallbackTask> task;
  Client client;
  const auto channel = connectLocally(client.arm, task.arm, "test");
  task.start();
  const Time sent = now();
  task.request(Transition::Suspend);
  task.trigger();
  task.request(Transition::Resume);
  task.trigger();
  EXPECT_EQ(task.state(), State::Running);
  // As a lane does with what comes out of a network.
  ASSERT_TRUE(channel->commands.claim(static_cast<std::uint16_t>(reference::ArmLikeCommand::hold),
                                      sent, 0));
  channel->commands.commit();
  EXPECT_TRUE(task.trigger());
  EXPECT_EQ(channel->commands.counters.executed, 0u);
  EXPECT_EQ(channel->commands.counters.refused, 1u);
  EXPECT_TRUE(client.arm.hold());
  EXPECT_TRUE(task.trigger());
  EXPECT_EQ(channel->commands.counters.executed, 1u);
}

TEST(Suspended, ALateClientIsToldAtOnceAndWelcomeAfterwards) {
  Living<PeriodicTask> task(kQuick);
  task.start();
  task.request(Transition::Suspend);
  EXPECT_TRUE(reaches(task, State::Suspended));
  Client client;
  connectLocally(client.arm, task.arm, "test");
  EXPECT_EQ(client.arm.hold().error(), Errc::Suspended);
  task.request(Transition::Resume);
  EXPECT_TRUE(eventually([&] { return client.arm.connected(); }));
  EXPECT_TRUE(client.arm.hold.start().within(5s));
}

/// Uses an arm, and counts the events that reach it.
struct Listener final : PeriodicTask {
  Listener() : PeriodicTask(kQuick) {
    arm.on().stopped([this] { ++stops; });
  }
  ~Listener() override { stop(); }
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
  Listener listener;
  connectLocally(listener.arm, sender.arm, "test");
  sender.start();
  listener.start();
  sender.wanted = 1;
  EXPECT_TRUE(eventually([&] { return listener.stops == 1; }));
  listener.request(Transition::Suspend);
  EXPECT_TRUE(reaches(listener, State::Suspended));
  sender.wanted = 2;
  EXPECT_TRUE(eventually([&] { return sender.emitted == 2; }));
  std::this_thread::sleep_for(10ms);
  EXPECT_EQ(listener.stops, 1);
  listener.request(Transition::Resume);
  EXPECT_TRUE(eventually([&] { return listener.stops == 2; }));
}

/// Processor time of the calling process.
Duration processorTime() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

template <class Kind>
void expectItSleeps(Living<Kind>& task) {
  Client client;
  const auto channel = connectLocally(client.arm, task.arm, "test");
  task.start();
  EXPECT_TRUE(reaches(task, State::Running));
  task.request(Transition::Suspend);
  EXPECT_TRUE(reaches(task, State::Suspended));
  // What keeps arriving must not keep it busy either.
  channel->status = ChannelStatus::Connected;
  EXPECT_EQ(client.arm.hold.start().within(5s).error(), Errc::Suspended);
  const Duration before = processorTime();
  std::this_thread::sleep_for(200ms);
  EXPECT_LT(processorTime() - before, 100ms) << "a suspended task spins";
  EXPECT_EQ(task.state(), State::Suspended);
  task.request(Transition::Resume);
  EXPECT_TRUE(reaches(task, State::Running));
  const int cycles = task.cycles;
  channel->status = ChannelStatus::Connected;
  EXPECT_TRUE(client.arm.hold.start().within(5s));
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
  std::this_thread::sleep_for(300ms);
  const auto missed = static_cast<std::uint64_t>((now() - suspended) / 1ms);
  task.request(Transition::Resume);
  EXPECT_TRUE(eventually([&, before = task.cycles.load()] { return task.cycles > before + 3; }));
  EXPECT_LT(task.statistics().skipped, missed);
}

TEST(Suspended, AHostGoesOnForItsGuests) {
  Living<GuestTask> guest;
  Living<EventTask> host(EventOptions{.longestSleep = 1h});
  host.lend(guest);
  Client ofHost, ofGuest;
  connectLocally(ofHost.arm, host.arm, "host");
  connectLocally(ofGuest.arm, guest.arm, "guest");
  host.start();
  host.request(Transition::Suspend);
  EXPECT_TRUE(reaches(host, State::Suspended));
  EXPECT_TRUE(ofGuest.arm.hold.start().within(5s));
  EXPECT_EQ(ofHost.arm.hold().error(), Errc::Suspended);
  guest.request(Transition::Suspend);
  EXPECT_TRUE(reaches(guest, State::Suspended));
  host.request(Transition::Resume);
  EXPECT_TRUE(reaches(host, State::Running));
  EXPECT_TRUE(ofHost.arm.hold.start().within(5s));
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
  Client client, late;
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
