// These components are parked while one of their hooks runs: by the contract of a connection that
// the hook reads, or by a call of a client of a device.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/task/periodic_task.h>

#include <atomic>
#include <functional>
#include <thread>

#include "support/eventually.h"
#include "support/test_thread.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using State = ComponentState;

struct ParkedWorker final : PeriodicTask {
  ParkedWorker() : PeriodicTask({.period = 1ms}) {}
  ~ParkedWorker() override { stop(); }
  void onSuspend() override { suspending(); }
  void onRestart() override { restarting(); }
  void onFault() override { ++madeSafe; }
  void run() override {
    if (broken) throw std::runtime_error("broken");
  }

  std::function<void()> suspending = [] {}, restarting = [] {};
  std::atomic<bool> broken{false};
  std::atomic<int> madeSafe{0};
};

TEST(ParkedInAHook, ATaskStaysSo) {
  ParkedWorker worker;
  worker.suspending = [&] { worker.park("a value was stale"); };
  worker.start();
  worker.request(Transition::Suspend);
  EXPECT_TRUE(eventually([&] { return worker.madeSafe == 1; }));
  EXPECT_EQ(worker.state(), State::Faulted);
  EXPECT_EQ(worker.fault(), "a value was stale");
}

TEST(ParkedInAHook, ARestartCountsAsAFault) {
  ParkedWorker worker;
  worker.restartAfterFaults({.most = 2, .per = 1h});
  worker.restarting = [&] {
    worker.broken = false;
    if (worker.faults() == 1) worker.park("a value was stale");
  };
  worker.broken = true;
  worker.start();
  EXPECT_TRUE(eventually([&] { return worker.madeSafe == 2 && worker.state() == State::Running; }));
  EXPECT_EQ(worker.fault(), "a value was stale");
  worker.broken = true;
  EXPECT_TRUE(eventually([&] { return worker.staysFaulted(); }));
  EXPECT_EQ(worker.state(), State::Faulted);
  EXPECT_EQ(worker.fault(), "broken");
  EXPECT_EQ(worker.faults(), 3u);
}

TEST(ParkedInAHook, ADeviceStaysSo) {
  struct Called final : Device {
    void onSuspend() override {
      TestThread([this] { park("a call threw"); }).join();
    }
  } device;
  device.start();
  device.request(Transition::Suspend);
  EXPECT_EQ(device.state(), State::Faulted);
  EXPECT_EQ(device.fault(), "a call threw");
}

}  // namespace
}  // namespace suture
