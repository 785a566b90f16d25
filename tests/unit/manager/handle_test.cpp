// Threads other than the tasks' hold these handles.
#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/channel/counts/ledger.h>
#include <suture/component/device.h>
#include <suture/component/task/event_task.h>
#include <suture/component/task/periodic_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/handle.h>
#include <suture/names/global_manager.h>

#include "reference/still_arm.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"
#include "support/test_thread.h"
#include "unit/manager/two_processes.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::Mode;

/// Tells its mode as an event.
struct Psm final : EventTask, StillArm {
  ~Psm() override { stop(); }
  void run() override {}
  void set_mode(Mode mode) override { port.emit().mode(mode); }
  std::uint32_t reset() override { return ++resets; }
  std::uint32_t resets = 0;
  Provided<ArmLike> port{*this, "Arm", *this};
};

/// Emits as fast as it can.
struct BusyArm final : PeriodicTask, StillArm {
  BusyArm() : PeriodicTask({.period = 100us}) {}
  ~BusyArm() override { stop(); }
  void run() override { port.emit().stopped(); }
  Provided<ArmLike> port{*this, "Arm", *this};
};

/// Returns what a handle that cannot be made says.
std::string handleRefusal(Manager& manager, std::string_view name, std::string_view provided) {
  return refusal([&] { Handle<ArmLike> handle(manager, name, provided, {.patience = 100ms}); });
}

/// Holds one process, or two of which the second has the arm.
class Handles : public testing::TestWithParam<bool> {
 protected:
  Handles() {
    if (overRpc()) {
      control_ = std::make_unique<loop::ControlThread>();
      global_ =
          std::make_unique<GlobalManager>(*control_, "unix:" + directory_.file("manager.sock"));
      provider_ = std::make_unique<Manager>("robot", global_->address());
      manager = std::make_unique<Manager>("console", global_->address());
    } else {
      manager = std::make_unique<Manager>("alone");
    }
    (overRpc() ? *provider_ : *manager).add("PSM", psm);
    (overRpc() ? *provider_ : *manager).add("Busy", busy);
    manager->start();
    if (overRpc()) provider_->start();
  }
  ~Handles() override {
    manager.reset();
    provider_.reset();
  }
  bool overRpc() const { return GetParam(); }
  std::string arm(const std::string& component = "PSM") const {
    return (overRpc() ? "robot:" : "") + component + "/Arm";
  }

  Psm psm;
  BusyArm busy;
  std::unique_ptr<Manager> manager;

 private:
  TemporaryDirectory directory_;
  std::unique_ptr<loop::ControlThread> control_;
  std::unique_ptr<GlobalManager> global_;
  std::unique_ptr<Manager> provider_;
};

TEST_P(Handles, OfferAllOfARequiredInterface) {
  Handle<ArmLike> handle(*manager, "Gui/Arm", arm());
  TestThread([&] {
    std::vector<Mode> modes;
    handle.on().mode([&](const Mode& mode) { modes.push_back(mode); });
    EXPECT_TRUE(handle.hold());
    EXPECT_TRUE(eventually([&] { return psm.holds == 1; })) << "the provider was rung at once";
    EXPECT_EQ(handle.reset.start().within(kPatience).value(), 1u);
    EXPECT_TRUE(eventually([&] { return handle.measured_cp().hasValue(); }));
    EXPECT_TRUE(handle.set_mode(Mode::Enabled));
    while (modes.empty() && handle.waitForEvents(now() + kPatience)) continue;
    EXPECT_EQ(modes, std::vector<Mode>{Mode::Enabled});
    EXPECT_TRUE(handle.on().mode.reset());
    pass(1us);  // or the last event would be as new as the wait for the next
    auto changed = handle.on().mode.next();
    EXPECT_TRUE(handle.set_mode(Mode::Disabled));
    EXPECT_EQ(changed.within(kPatience).value(), Mode::Disabled);
  }).join();
  EXPECT_EQ(manager->channels().size(), 1u);
  EXPECT_NO_THROW(manager->awaitStart(0ms)) << "it is no component of the user's";
}

TEST_P(Handles, BelongToOneThreadEach) {
  Handle<ArmLike> handle(*manager, "Gui/Arm", arm());
  TestThread([&] { EXPECT_TRUE(handle.hold()); }).join();
  EXPECT_EQ(handle.hold().error(), Errc::WrongThread);
  EXPECT_EQ(handle.measured_cp().error(), Errc::WrongThread);
  EXPECT_EQ(handle.reset.start().within(1s).error(), Errc::WrongThread);
  EXPECT_EQ(handle.on().mode([](const Mode&) {}).error(), Errc::WrongThread);
  EXPECT_EQ(handle.processEvents().error(), Errc::WrongThread);
  EXPECT_FALSE(handle.waitForEvents(now() + 1s));
}

TEST_P(Handles, AnyNumberWorkInAnyThreads) {
  std::vector<std::unique_ptr<Handle<ArmLike>>> handles;
  for (int i = 0; i < 4; ++i) {
    const std::string name = "Logger" + std::to_string(i) + "/Arm";
    handles.push_back(std::make_unique<Handle<ArmLike>>(*manager, name, arm()));
  }
  std::vector<std::unique_ptr<TestThread>> threads;
  for (const auto& handle : handles) {
    threads.push_back(std::make_unique<TestThread>([&arm = *handle] {
      for (int i = 0; i < 50; ++i) EXPECT_TRUE(arm.hold.start().within(kPatience));
    }));
  }
  threads.clear();
  EXPECT_EQ(psm.holds, 200);
}

TEST_P(Handles, AFailedConnectionSaysWhy) {
  Handle<ArmLike> handle(*manager, "Gui/Arm", arm());
  EXPECT_NE(handleRefusal(*manager, "Gui/Arm", arm()).find("already connected"), std::string::npos);
  EXPECT_NE(handleRefusal(*manager, "Gui/Other", arm("Nobody")).find("Nobody"), std::string::npos);
  EXPECT_NE(handleRefusal(*manager, "Gui/Other",
                          (overRpc() ? "robot:" : "") + std::string("PSM/component"))
                .find("it requires reference::ArmLike"),
            std::string::npos);
  EXPECT_NE(handleRefusal(*manager, "Gui", arm()).find("component/interface"), std::string::npos);
  EXPECT_EQ(handleRefusal(*manager, "Gui/Other", arm()), "")
      << "what failed has left nothing behind";
}

TEST_P(Handles, ComeAndGoDuringEvents) {
  for (int round = 0; round < 20; ++round) {
    int stops = 0;
    Handle<ArmLike> handle(*manager, "Gui/Arm", arm("Busy"));
    handle.on().stopped([&] { ++stops; });
    while (stops < 5) ASSERT_TRUE(handle.waitForEvents(now() + kPatience));
  }
  EXPECT_TRUE(eventually([&] { return manager->channels().empty(); }));
}

TEST_P(Handles, MayOutliveTheManager) {
  Handle<ArmLike> handle(*manager, "Gui/Arm", arm());
  EXPECT_TRUE(handle.reset.start().within(kPatience));
  handle.on().stopped([] {});
  manager.reset();
  EXPECT_EQ(handle.hold().error(), Errc::Lost);
  EXPECT_TRUE(handle.on().stopped.reset());  // and rings no client that is gone
  EXPECT_TRUE(handle.on().mode([](const reference::Mode&) {}));
}

/// An arm is in one process, and its handles are in another.
struct FreshHandles : testing::Test {
  FreshHandles() {
    both.there.add("PSM", psm);
    both.start();
  }

  Psm psm;
  TwoProcesses both;
};

TEST_F(FreshHandles, LeaveNoReasonsBehind) {
  {
    const Handle<ArmLike> handle(both.here, "Gui/Arm", "there:PSM/Arm");
    both.there.stop();
    EXPECT_TRUE(eventually([&] { return !both.here.whyLost().empty(); }));
  }
  EXPECT_TRUE(both.here.whyLost().empty());
  EXPECT_TRUE(both.here.whyNotBack().empty());
}

// The sums of a name outlive its handle, in case another has that name.
TEST_F(FreshHandles, AreRememberedUpToABound) {
  constexpr int kMost = 1024;
  std::weak_ptr<const Ledger> first;
  for (int i = 0; i <= kMost; ++i) {
    const Handle<ArmLike> handle(both.here, "Gui" + std::to_string(i) + "/Arm", "there:PSM/Arm",
                                 {.lane = Lane::Frame});
    if (i == 0) first = both.here.channels().at(0)->terms.ledger;
    ASSERT_EQ(first.expired(), i == kMost) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Lanes, Handles, testing::Bool(),
                         [](const auto& lane) { return lane.param ? "Rpc" : "Local"; });

}  // namespace
}  // namespace suture
