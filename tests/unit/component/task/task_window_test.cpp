#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/component/task/periodic_task.h>

#include "support/eventually.h"
#include "support/refusal.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

Time at(Duration since) { return Time{} + 1h + since; }

TEST(WindowMeter, SumsUpTheCyclesOfOneWindow) {
  WindowMeter meter;
  meter.setLength(10ms);
  EXPECT_FALSE(meter.last().valid());
  // Cycles begin after 1 and 3 ms in turn, and take 100 and 300 us.
  const Duration begins[] = {0ms, 1ms, 4ms, 5ms, 8ms, 9ms};
  for (int i = 0; i < 6; ++i) {
    meter.cycle(at(begins[i]), at(begins[i] + (i % 2 == 0 ? 100us : 300us)), 3);
    EXPECT_FALSE(meter.last().valid());
  }
  meter.cycle(at(12ms), at(13ms), 7);

  const TaskWindow window = meter.last();
  ASSERT_TRUE(window.valid());
  EXPECT_EQ(window.begin, at(0ms));
  EXPECT_EQ(window.end, at(12ms));
  EXPECT_EQ(window.cycles, 6u);
  EXPECT_EQ(window.skipped, 4u);
  EXPECT_EQ(window.period.mean, 2ms);
  EXPECT_EQ(window.period.deviation, 1ms);
  EXPECT_EQ(window.period.min, 1ms);
  EXPECT_EQ(window.period.max, 3ms);
  EXPECT_EQ(window.period.p99, 3ms);
  EXPECT_EQ(window.compute.mean, 200us);
  EXPECT_EQ(window.compute.deviation, 100us);
  EXPECT_EQ(window.compute.min, 100us);
  EXPECT_EQ(window.compute.max, 300us);
}

TEST(WindowMeter, TheNextWindowBeginsEmpty) {
  WindowMeter meter;
  meter.setLength(10ms);
  meter.cycle(at(0ms), at(9ms), 0);
  meter.cycle(at(10ms), at(11ms), 5);
  meter.cycle(at(15ms), at(16ms), 5);
  meter.cycle(at(20ms), at(21ms), 6);
  const TaskWindow window = meter.last();
  EXPECT_EQ(window.begin, at(10ms));
  EXPECT_EQ(window.cycles, 2u);
  EXPECT_EQ(window.skipped, 1u);
  EXPECT_EQ(window.period.max, 5ms);
  EXPECT_EQ(window.compute.max, 1ms);
  EXPECT_EQ(window.compute.p99, 1ms);
}

TEST(WindowMeter, RefusesALengthThatIsNotPositive) {
  WindowMeter meter;
  EXPECT_EQ(refusal([&] { meter.setLength(0ms); }),
            "a window of a task's statistics: a length of 0 ns. Give a length greater than zero");
}

class Measured final : public PeriodicTask {
 public:
  Measured() : PeriodicTask({.period = 1ms}) { measureOver(20ms); }
  ~Measured() override { stop(); }

 private:
  void run() override { pass(10us); }
};

TEST(TaskStatistics, ASuspensionIsInNoWindow) {
  Measured measured;
  measured.start();
  EXPECT_TRUE(eventually([&] { return measured.statistics().windows.last().valid(); }));
  measured.request(Transition::Suspend);
  EXPECT_TRUE(eventually([&] { return measured.state() == ComponentState::Suspended; }));
  pass(300ms);
  const Time resumed = now();
  measured.request(Transition::Resume);
  EXPECT_TRUE(eventually([&] { return measured.statistics().windows.last().end > resumed; }));
  const TaskWindow window = measured.statistics().windows.last();
  EXPECT_GE(window.begin, resumed);
  EXPECT_LT(window.period.max, 300ms);
}

TEST(TaskStatistics, AnyThreadReadsTheLastWindow) {
  Measured task;
  task.start();
  EXPECT_TRUE(eventually([&] { return task.statistics().windows.last().valid(); }));
  const TaskWindow window = task.statistics().windows.last();
  EXPECT_GE(window.end - window.begin, 20ms);
  EXPECT_GE(window.cycles, 1u);
  // Each cycle and each skipped period accounts for one period of the window, whose ends are as
  // late as its cycles were.
  const auto periods = static_cast<double>(window.cycles + window.skipped);
  const auto late = static_cast<double>(task.statistics().lateness.max() / 1ms);
  EXPECT_NEAR(periods, static_cast<double>((window.end - window.begin) / 1ms), 2 + late);
  EXPECT_LE(window.period.min, window.period.mean);
  EXPECT_LE(window.period.mean, window.period.max);
  EXPECT_GT(window.compute.max, 0ns);
}

}  // namespace
}  // namespace suture
