// These test the life of components: what leads where, the hooks and their threads, and what is
// refused.

#include <gtest/gtest.h>
#include <suture/wiring/connect.h>

#include <string>
#include <thread>
#include <vector>

#include "arm_client.h"
#include "living.h"
#include "support/eventually.h"
#include "support/refusal.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using State = ComponentState;

TEST(Lifecycle, EachTransitionNeedsItsState) {
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

TEST(Lifecycle, OnlySuspendAndResumeAreRequestable) {
  Living<PeriodicTask> task(kQuick);
  for (const Transition transition : {Transition::Configure, Transition::Start, Transition::Stop}) {
    EXPECT_EQ(refusal([&] { task.request(transition); }),
              "component '" + task.name() + "' was asked to " + toString(transition) +
                  ": that is for whoever gave it its thread. Call configure(), start() or stop(); "
                  "only suspend and resume can be asked for");
  }
}

TEST(Lifecycle, ATasksHooksRunInItsThread) {
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

TEST(Lifecycle, ALateClientHearsOfTheStop) {
  Living<PeriodicTask> task(kQuick);
  task.start();
  task.stop();
  ArmClient client;
  connectLocally(client.arm, task.arm, "test");
  EXPECT_EQ(client.arm.unusable(), Errc::Suspended);
  EXPECT_EQ(client.arm.hold().error(), Errc::Suspended);
  task.start();
  EXPECT_TRUE(eventually([&] { return client.arm.unusable() == Errc{}; }));
  EXPECT_TRUE(client.arm.hold());
}

TEST(Lifecycle, AParkedRefusalBlamesNoCode) {
  Living<EventTask> task;
  task.configure();
  task.park("connection 'a -> b' is lost, and its on_loss is fault", FaultCause::Connection);
  EXPECT_EQ(refusal([&] { task.request(Transition::Suspend); }),
            "component '(unnamed)' was asked to suspend: it is faulted. Look at why it has "
            "faulted, correct "
            "the cause, and create it anew");
}

TEST(Lifecycle, ARefusalNamesTheLegalTransitions) {
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
    ArmClient client;
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
    // Clients are told after the state has changed.
    const Errc told = hook == std::string("stop") ? Errc::Lost : Errc::Faulted;
    EXPECT_TRUE(eventually([&] { return client.arm.unusable() == told; })) << hook;
    EXPECT_EQ(client.arm.hold().error(), told) << hook;
    EXPECT_NE(refusal([&] { task.request(Transition::Resume); }).find("create it anew"),
              std::string::npos);
    EXPECT_EQ(other.state(), State::Running);
  }
}

}  // namespace
}  // namespace suture
