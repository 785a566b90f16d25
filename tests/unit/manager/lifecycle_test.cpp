// A manager runs the lives of its components, and the interface "component" tells of them.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/task/callback_task.h>
#include <suture/component/task/periodic_task.h>
#include <suture/manager/manager.h>
#include <suture/standard/lifecycle.suture.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/eventually.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/test_thread.h"
#include "unit/manager/two_processes.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using State = ComponentState;

struct Worker final : PeriodicTask {
  Worker() : PeriodicTask({.period = 1ms}) {}
  ~Worker() override { stop(); }
  void run() override {
    if (broken) throw std::runtime_error(complaint);
  }
  std::string complaint = "the encoder says nonsense";
  std::atomic<bool> broken{false};
};

struct Idle final : Device {};

/// Watches the life of another component.
struct Watcher final : Device {
  Watcher() {
    component.on().state_changed([this](const StateChange& change) { changes.push_back(change); });
  }
  std::vector<std::string> states() {
    std::vector<std::string> names;
    for (const StateChange& change : changes) names.emplace_back(toString(change.state));
    return names;
  }
  /// Returns true once `states()` is that.
  bool hears(const std::vector<std::string>& expected) {
    return eventually([&] {
      (void)component.connected();  // takes over the connection
      processEvents();
      return states() == expected;
    });
  }
  Required<Lifecycle> component{*this, "Watched"};
  std::vector<StateChange> changes;
};

TEST(ManagerLifecycle, LeadsTasksAndDevicesThroughTheirStates) {
  Worker worker;
  Idle idle;
  Manager manager("here");
  manager.add("Worker", worker);
  manager.add("Idle", idle);
  manager.configure();
  EXPECT_EQ(worker.state(), State::Configured);
  EXPECT_EQ(idle.state(), State::Configured);
  manager.start();
  EXPECT_EQ(worker.state(), State::Running);
  EXPECT_EQ(idle.state(), State::Running);
  manager.suspend("Worker");
  manager.suspend("Idle");
  EXPECT_EQ(worker.state(), State::Suspended);
  EXPECT_EQ(idle.state(), State::Suspended);
  manager.start();
  EXPECT_EQ(worker.state(), State::Suspended) << "only what has not been started";
  manager.resume("Worker");
  manager.resume("Idle");
  EXPECT_EQ(worker.state(), State::Running);
  manager.stop();
  EXPECT_EQ(worker.state(), State::Stopped);
  EXPECT_EQ(idle.state(), State::Stopped);
}

TEST(ManagerLifecycle, SaysWhyItCannotBe) {
  struct Callback final : CallbackTask {
    ~Callback() override { stop(); }
    void run() override {}
  } callback;
  struct Stubborn final : PeriodicTask {
    Stubborn() : PeriodicTask({.period = 1ms}) {}
    ~Stubborn() override { stop(); }
    void onSuspend() override { throw std::runtime_error("the arm would fall"); }
    void run() override {}
  } stubborn;
  Manager manager("here");
  manager.add("Callback", callback);
  manager.add("Stubborn", stubborn);
  EXPECT_EQ(refusal([&] { manager.suspend("Calback"); }),
            "asked for 'Calback': process 'here' has components 'Callback' and 'Stubborn'. Did you "
            "mean 'Callback'?");
  EXPECT_NE(refusal([&] { manager.suspend("Callback"); }).find("it is constructed"),
            std::string::npos);
  manager.start();
  EXPECT_EQ(refusal([&] { manager.suspend("Callback", 10ms); }),
            "component 'Callback' was asked to suspend: it is still running. It changes "
            "between two cycles: its run() has to return, the period of a PeriodicTask to pass, "
            "and the callback of a CallbackTask to come");
  EXPECT_EQ(refusal([&] { manager.suspend("Stubborn"); }),
            "component 'Stubborn' was asked to suspend: its code threw: the arm would fall. "
            "Correct the cause");
}

TEST(ManagerLifecycle, ASuspendAwaitsTheFaultedTasksRestart) {
  struct Shaky final : PeriodicTask {
    Shaky() : PeriodicTask({.period = 1ms}) { restartAfterFaults({.most = 1, .per = 24h}); }
    ~Shaky() override { stop(); }
    void run() override {
      if (!asked.exchange(false)) return;
      pass(5ms);  // until the manager waits
      throw std::runtime_error("the encoder says nonsense");
    }
    void onFault() override { pass(50ms); }  // while the manager finds it faulted
    std::atomic<bool> asked{false};
  } shaky;
  Manager manager("here");
  manager.add("Shaky", shaky);
  manager.start();
  shaky.asked = true;
  EXPECT_EQ(refusal([&] { manager.suspend("Shaky"); }), "");
  EXPECT_EQ(shaky.state(), State::Suspended);
  EXPECT_EQ(shaky.faults(), 1u);
}

TEST(AwaitStart, NamesEveryMissingComponentAndInterface) {
  Worker worker;
  Idle idle;
  Watcher connected, unconnected, optional;
  optional.component.makeOptional();
  Manager manager("here");
  manager.add("Worker", worker);
  manager.add("Connected", connected);
  manager.add("Unconnected", unconnected);
  manager.add("Optional", optional);
  manager.start();
  manager.add("Idle", idle);
  manager.connect("Connected/Watched", "Worker/component");
  const std::string text = refusal([&] { manager.awaitStart(20ms); });
  EXPECT_NE(text.find("waiting until process 'here' has started: after "), std::string::npos);
  EXPECT_NE(
      text.find("\n    component 'Idle' is constructed: it was added after start(), which has "
                "to be called again\n"
                "    required interface 'Unconnected/Watched' (suture::Lifecycle) is not "
                "connected: nobody has called connect() for it\n"),
      std::string::npos)
      << text;
  EXPECT_EQ(text.find("'Connected/"), std::string::npos) << text;
  EXPECT_EQ(text.find("'Optional/"), std::string::npos) << text;

  manager.start();
  manager.connect("Unconnected/Watched", "Worker/component");
  EXPECT_EQ(refusal([&] { manager.awaitStart(); }), "");
}

TEST(ManagerLifecycle, WhatIsAddedLaterNeedsAnotherStart) {
  Worker worker;
  Idle idle;
  Manager manager("here");
  manager.add("Worker", worker);
  manager.start();
  manager.add("Idle", idle);
  EXPECT_EQ(idle.state(), State::Constructed);
  manager.start();
  EXPECT_EQ(idle.state(), State::Running);
  manager.stop();
  EXPECT_EQ(idle.state(), State::Stopped);
}

TEST(ManagerLifecycle, WhatNeverStartedMayEndFirst) {
  Worker worker;
  Manager manager("here");
  manager.add("Worker", worker);
  manager.start();
  {
    Worker late;
    manager.add("Late", late);
  }
  testing::internal::CaptureStderr();
  EXPECT_EQ(refusal([&] { manager.stop(); }), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "here: component 'Late' has never run: it was added after start(), which has to be "
            "called again\n");
  EXPECT_EQ(worker.state(), State::Stopped);
}

TEST(ManagerLifecycle, StopEndsWhatTheProgramStartedItself) {
  Worker worker, late;
  Manager manager("here");
  manager.add("Worker", worker);
  manager.start();
  manager.add("Late", late);
  late.start();
  testing::internal::CaptureStderr();
  manager.stop();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(late.state(), State::Stopped);
}

TEST(ManagerLifecycle, WhatTheProgramEndedMayBeGone) {
  Worker worker;
  Manager manager("here");
  manager.add("Worker", worker);
  manager.start();
  {
    Worker late;
    manager.add("Late", late);
    late.start();
    late.stop();
  }
  testing::internal::CaptureStderr();
  manager.stop();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(AwaitStart, WaitsForWhatComesLater) {
  Worker worker;
  Idle idle;
  Manager manager("here");
  manager.add("Worker", worker);
  manager.start();
  manager.add("Idle", idle);
  TestThread later([&] {
    pass(20ms);
    idle.start();
  });
  EXPECT_EQ(refusal([&] { manager.awaitStart(); }), "");
  EXPECT_EQ(idle.state(), State::Running);
  later.join();
}

TEST(AwaitStart, AFaultIsToldAtOnce) {
  Worker worker;
  Manager manager("here");
  manager.add("Worker", worker);
  worker.broken = true;
  manager.start();
  EXPECT_TRUE(eventually([&] { return worker.state() == State::Faulted; }));
  const Time begin = now();
  const std::string text = refusal([&] { manager.awaitStart(1h); });
  EXPECT_NE(text.find("'Worker' is faulted, its code threw: the encoder says nonsense"),
            std::string::npos)
      << text;
  EXPECT_LT(now() - begin, 1min);
}

TEST(AwaitStart, ASuspendedOrGoneProviderIsNamed) {
  Worker worker;
  Watcher watcher;
  TwoProcesses processes;
  processes.there.add("Worker", worker);
  processes.here.add("Watcher", watcher);
  processes.start();
  processes.here.connect("Watcher/Watched", "there:Worker/component");
  EXPECT_EQ(refusal([&] { processes.here.awaitStart(); }), "");
  processes.there.stop();
  EXPECT_TRUE(eventually([&] {
    const std::string text = refusal([&] { processes.here.awaitStart(1ms); });
    return text.find("there:Worker/component: connection lost") != std::string::npos;
  }));
}

TEST(ManagerLifecycle, RefusesAnInterfaceOfTheReservedName) {
  struct Own final : Device, Lifecycle {
    bool suspend() override { return false; }
    bool resume() override { return false; }
    ComponentState component_state() const override { return state(); }
    ResumeOutcome resume_connection(const std::string&) override {
      return ResumeOutcome::NoSuchInterface;
    }
    Provided<Lifecycle> provided{*this, "component", *this};
  } own;
  Manager manager("here");
  EXPECT_EQ(refusal([&] { manager.add("Own", own); }),
            "adding component 'Own': it provides an interface 'component' of its own. Rename it: "
            "every component has one of that name, which tells of its life");
}

// Other processes look for components while this one still adds them.
TEST(LifecycleInterface, IsThereWithItsComponent) {
  std::vector<Worker> workers(200);
  Manager manager("here");
  TestThread peer([&] {
    for (const Component* found = nullptr; found != &workers.back();) {
      for (const Component* component : manager.directory().components()) {
        EXPECT_EQ(component->provided().size(), 1u) << component->name();
        found = std::max(found, component);
      }
    }
  });
  for (std::size_t i = 0; i < workers.size(); ++i) {
    manager.add("Worker" + std::to_string(i), workers[i]);
  }
  peer.join();
}

void watchesAndLeads(Watcher& watcher, Worker& worker) {
  EXPECT_TRUE(watcher.hears({"running"})) << "the last before it was connected";
  EXPECT_TRUE(eventually([&] {
    const auto state = watcher.component.component_state();
    return state && *state == State::Running;
  }));
  EXPECT_FALSE(*watcher.component.resume.start().within(kPatience));
  EXPECT_TRUE(*watcher.component.suspend.start().within(kPatience));
  EXPECT_TRUE(watcher.hears({"running", "suspended"}));
  EXPECT_EQ(*watcher.component.component_state.fresh().within(kPatience), State::Suspended);
  EXPECT_FALSE(*watcher.component.suspend.start().within(kPatience));
  EXPECT_TRUE(*watcher.component.resume.start().within(kPatience));
  EXPECT_TRUE(watcher.hears({"running", "suspended", "running"}));
  worker.broken = true;
  EXPECT_TRUE(watcher.hears({"running", "suspended", "running", "faulted"}));
  EXPECT_EQ(watcher.changes.back().fault, "the encoder says nonsense");
  EXPECT_EQ(*watcher.component.component_state.fresh().within(kPatience), State::Faulted);
}

/// Runs a worker, and a watcher that is to hear of its life.
struct WatchedWorker {
  WatchedWorker() {
    manager.add("Worker", worker);
    manager.add("Watcher", watcher);
    manager.start();
  }
  void watch() { manager.connect("Watcher/Watched", "Worker/component"); }
  Worker worker;
  Watcher watcher;
  Manager manager{"here"};
};

TEST(LifecycleInterface, TellsAndLeadsWithinAProcess) {
  WatchedWorker here;
  here.watch();
  watchesAndLeads(here.watcher, here.worker);
}

TEST(LifecycleInterface, TellsAndLeadsAcrossProcesses) {
  Worker worker;
  Watcher watcher;
  TwoProcesses processes;
  processes.there.add("Worker", worker);
  processes.here.add("Watcher", watcher);
  processes.start();
  processes.here.connect("Watcher/Watched", "there:Worker/component");
  watchesAndLeads(watcher, worker);
}

TEST(LifecycleInterface, AnswersAFirstQuestionWhileSuspended) {
  WatchedWorker here;
  here.manager.suspend("Worker");
  here.watch();
  pass(10ms);  // it has taken over the connection, and sleeps
  EXPECT_TRUE(eventually([&] {
    const auto state = here.watcher.component.component_state();
    return state && *state == State::Suspended;
  }));
}

TEST(LifecycleInterface, TellsTheEnd) {
  WatchedWorker here;
  here.watch();
  EXPECT_TRUE(here.watcher.hears({"running"}));
  here.worker.stop();
  EXPECT_TRUE(here.watcher.hears({"running", "stopped"}));
  EXPECT_EQ(here.watcher.component.component_state().error(), Errc::Lost);
}

TEST(LifecycleInterface, ATooLongFaultEndsInDots) {
  WatchedWorker here;
  here.worker.complaint = std::string(251, 'x') + "\u00b5m are not enough";
  here.watch();
  EXPECT_TRUE(here.watcher.hears({"running"}));
  here.worker.broken = true;
  EXPECT_TRUE(here.watcher.hears({"running", "faulted"}));
  EXPECT_EQ(here.watcher.changes.back().fault, std::string(251, 'x') + "...")
      << "no half of a character";
}

TEST(LifecycleInterface, ADeviceHasOneToo) {
  Idle idle;
  Watcher watcher;
  Manager manager("here");
  manager.add("Idle", idle);
  manager.add("Watcher", watcher);
  manager.start();
  manager.connect("Watcher/Watched", "Idle/component");
  EXPECT_TRUE(watcher.hears({"running"}));
  EXPECT_TRUE(*watcher.component.suspend.start().within(kPatience));
  EXPECT_TRUE(*watcher.component.resume.start().within(kPatience));
  EXPECT_TRUE(watcher.hears({"running", "suspended", "running"}));
}

TEST(ManagerLifecycle, AComponentHasOneManager) {
  Worker worker;
  Manager first("first"), second("second");
  first.add("Worker", worker);
  EXPECT_EQ(refusal([&] { second.add("Spare", worker); }),
            "adding a component 'Spare' to process 'second': it is 'Worker' of process 'first'. "
            "Create a second object, or destroy the manager of that process before");
  EXPECT_EQ(worker.name(), "Worker");
}

TEST(LifecycleInterface, AnotherManagerKeepsIt) {
  Worker worker;
  Watcher watcher;
  { Manager("first").add("Worker", worker); }
  Manager manager("second");
  manager.add("Worker", worker);
  manager.add("Watcher", watcher);
  manager.connect("Watcher/Watched", "Worker/component");
  manager.start();
  EXPECT_TRUE(watcher.hears({"running"}));
}

}  // namespace
}  // namespace suture
