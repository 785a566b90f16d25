#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/task/periodic_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/standard/timing_port.h>

#include "support/eventually.h"

namespace {

using namespace std::chrono_literals;

class Worker final : public suture::PeriodicTask {
 public:
  Worker() : PeriodicTask({.period = 1ms}) { measureOver(50ms); }

 private:
  void run() override {}

  suture::TimingPort timing_{*this};
};

struct Watcher final : suture::Device {
  suture::Required<suture::TaskTiming> timing{*this, "Timing"};
};

class TimingPort : public testing::TestWithParam<suture::Lane> {};

TEST_P(TimingPort, TellsWhatTheTaskMeasured) {
  suture::loop::ControlThread control;
  suture::GlobalManager names(control, "tcp://127.0.0.1:0");
  suture::Manager manager("here", names.address());
  Worker worker;
  Watcher watcher;
  manager.add("Worker", worker);
  manager.add("Watcher", watcher);
  manager.start();
  manager.connect("Watcher/Timing", "Worker/Timing", {.lane = GetParam()});

  EXPECT_TRUE(suture::eventually([&] {
    const auto window = watcher.timing.window();
    return window && window->valid();
  }));
  const auto window = watcher.timing.window();
  ASSERT_TRUE(window);
  EXPECT_GE(window->end - window->begin, 50ms);
  const auto periods = static_cast<double>(window->cycles + window->skipped);
  const auto late = static_cast<double>(worker.statistics().lateness.max() / 1ms);
  EXPECT_NEAR(periods, static_cast<double>((window->end - window->begin) / 1ms), 2 + late);
  EXPECT_GT(window->period.mean, 0ns);
  EXPECT_GE(window->period.p99, window->period.min);
  EXPECT_GE(window->period.max, window->period.p99);
  EXPECT_GT(window->compute.max, 0ns);
  EXPECT_TRUE(suture::eventually([&] { return watcher.timing.cycles().hasValue(); }));
  EXPECT_GE(*watcher.timing.cycles(), window->cycles);
  manager.stop();
}

INSTANTIATE_TEST_SUITE_P(Lanes, TimingPort, testing::Values(suture::Lane::Auto, suture::Lane::Rpc),
                         [](const auto& lane) {
                           return lane.param == suture::Lane::Auto ? "Local" : "Rpc";
                         });

}  // namespace
