#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/record/state_collector.h>
#include <suture/rt/state/state_table.h>

#include <stdexcept>

#include "reference/arm_like.suture.h"
#include "reference/simulated_arm.h"
#include "support/eventually.h"
#include "support/refusal.h"
#include "unit/record/counting_sink.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;

/// Connects a collector to an arm that runs at 1 kHz.
struct CollectedStates {
  CollectedStates(const StateCollectorOptions& options, Sink& sink)
      : collector(interfaceInfo<ArmLike>(), options, sink) {
    manager.add("PSM", arm);
    manager.add("Collector", collector);
    manager.connect("Collector/Source", "PSM/Arm");
    manager.start();
  }
  std::uint64_t produced() { return arm.provided().front()->state()->rows(); }
  /// Ends the arm and waits until the collector has come to the last row.
  void finish() {
    arm.stop();
    EXPECT_TRUE(eventually([&] { return collector.counts().produced() == produced(); }))
        << collector.counts().produced() << " of " << produced();
    manager.stop();
  }

  reference::SimulatedArm arm{{}};
  StateCollector collector;
  Manager manager{"here"};
};

void expectAscending(const std::vector<std::uint64_t>& numbers) {
  for (std::size_t i = 1; i < numbers.size(); ++i) ASSERT_LT(numbers[i - 1], numbers[i]);
}

TEST(StateCollector, RowsAddUpToThoseProduced) {
  CountingSink sink;
  CollectedStates run({.reads = {"measured_cp", "measured_js"}}, sink);
  pass(1500ms);
  run.finish();
  const CollectedCounts counts = run.collector.counts();
  EXPECT_GT(counts.collected, 0u);
  EXPECT_EQ(counts.passedOver, 0u);
  EXPECT_EQ(sink.numbers.size(), counts.collected);
  EXPECT_EQ(sink.lost, counts.missed);
  EXPECT_EQ(counts.collected + counts.missed, run.produced());
  EXPECT_EQ(sink.numbers.back(), run.produced());
  EXPECT_EQ(sink.absent, 0u);
  EXPECT_EQ(sink.collector, "Collector");
  expectAscending(sink.numbers);
}

TEST(StateCollector, ASlowSinksLostRowsAreCounted) {
  CountingSink sink(4ms);
  CollectedStates run({}, sink);
  EXPECT_TRUE(eventually([&] { return run.collector.counts().missed > 100; }));
  run.finish();
  const CollectedCounts counts = run.collector.counts();
  EXPECT_EQ(sink.numbers.size(), counts.collected);
  EXPECT_EQ(sink.lost, counts.missed);
  EXPECT_EQ(counts.collected + counts.missed, run.produced());
  // Each row is collected or lies in a gap, and gaps are what was missed.
  std::uint64_t gaps = sink.numbers.front() - 1;
  for (std::size_t i = 1; i < sink.numbers.size(); ++i) {
    ASSERT_LT(sink.numbers[i - 1], sink.numbers[i]);
    gaps += sink.numbers[i] - sink.numbers[i - 1] - 1;
  }
  EXPECT_EQ(gaps + run.produced() - sink.numbers.back(), counts.missed);
}

TEST(StateCollector, KeepsEveryNthRow) {
  CountingSink sink;
  CollectedStates run({.interval = {.every = 3}}, sink);
  EXPECT_TRUE(eventually([&] { return run.collector.counts().collected >= 20; }));
  run.finish();
  const CollectedCounts counts = run.collector.counts();
  EXPECT_EQ(counts.collected, (counts.collected + counts.passedOver + 2) / 3);
}

TEST(StateCollector, KeepsAtMostOneRowEachInterval) {
  CountingSink sink;
  CollectedStates run({.interval = {.atLeast = 5ms}}, sink);
  EXPECT_TRUE(eventually([&] { return run.collector.counts().collected >= 10; }));
  run.finish();
  EXPECT_GT(run.collector.counts().passedOver, 0u);
  for (std::size_t i = 1; i < sink.stamps.size(); ++i) {
    EXPECT_GE(sink.stamps[i] - sink.stamps[i - 1], 5ms);
  }
}

TEST(StateCollector, CollectsOnlyFromStartToStop) {
  CountingSink sink;
  CollectedStates run({.collecting = false}, sink);
  pass(30ms);
  EXPECT_FALSE(run.collector.collecting());
  EXPECT_EQ(run.produced(), 0u);  // no client has asked

  run.collector.startCollecting();
  EXPECT_TRUE(eventually([&] { return run.collector.counts().collected >= 20; }));
  run.collector.stopCollecting();
  EXPECT_TRUE(eventually([&] { return !run.collector.collecting(); }));
  const CollectedCounts before = run.collector.counts();
  const std::uint64_t rows = run.produced();
  EXPECT_TRUE(eventually([&] { return run.produced() > rows + 20; }));
  EXPECT_EQ(run.collector.counts().produced(), before.produced());

  run.collector.startCollecting();
  EXPECT_TRUE(eventually([&] { return run.collector.collecting(); }));
  EXPECT_TRUE(eventually([&] { return run.collector.counts().collected >= 20; }));
  run.manager.stop();
  ASSERT_GT(sink.numbers.size(), before.collected);
  EXPECT_GT(sink.numbers[before.collected], rows);  // what came in between was not kept
  expectAscending(sink.numbers);
}

TEST(StateCollector, ALanesRowsAreAccountedFor) {
  loop::ControlThread control;
  GlobalManager names(control, "tcp://127.0.0.1:0");
  reference::SimulatedArm arm{{}};
  CountingSink sink;
  StateCollector collector(interfaceInfo<ArmLike>(), {.reads = {"measured_cp"}}, sink);
  Manager manager("here", names.address());
  manager.add("PSM", arm);
  manager.add("Collector", collector);
  manager.start();
  manager.connect("Collector/Source", "PSM/Arm", {.lane = Lane::Rpc});
  EXPECT_TRUE(eventually([&] { return collector.counts().collected >= 50; }));
  arm.stop();
  const auto mirror = manager.channels().at(0)->state;
  EXPECT_TRUE(eventually([&] { return collector.counts().produced() == mirror->rows(); }));
  manager.stop();
  EXPECT_EQ(sink.numbers.size(), collector.counts().collected);
  expectAscending(sink.numbers);
}

TEST(StateCollector, RefusesAReadThatIsNotThere) {
  CountingSink sink;
  try {
    StateCollector collector(interfaceInfo<ArmLike>(), {.reads = {"measured_cq"}}, sink);
    FAIL() << "there is no measured_cq";
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("Did you mean 'measured_cp'?"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(StateCollector(interfaceInfo<ArmLike>(), {.interval = {.every = 0}}, sink),
               SetupError);
  EXPECT_EQ(
      refusal([&] { StateCollector(interfaceInfo<ArmLike>(), {.period = Duration{0}}, sink); }),
      "a collector: a period of 0 ns. Give a period greater than zero");
}

TEST(StateCollector, ACycleEndsDespiteASlowSink) {
  CountingSink sink(4ms);
  CollectedStates run({}, sink);
  EXPECT_TRUE(eventually([&] { return run.collector.counts().missed > 100; }));
  const std::uint64_t cycles = run.collector.statistics().cycles;
  EXPECT_TRUE(eventually([&] { return run.collector.statistics().cycles > cycles + 2; }));
  run.finish();
}

TEST(StateCollector, KeepsNoRowsAfterItsDisconnect) {
  CountingSink sink;
  CollectedStates run({}, sink);
  EXPECT_TRUE(eventually([&] { return run.collector.counts().collected >= 20; }));
  run.manager.disconnect("Collector/Source");
  pass(30ms);
  const std::uint64_t collected = run.collector.counts().produced(), rows = run.produced();
  EXPECT_GE(collected, 20u);
  EXPECT_TRUE(eventually([&] { return run.produced() > rows + 50; }));
  EXPECT_EQ(run.collector.counts().produced(), collected);

  run.manager.connect("Collector/Source", "PSM/Arm");
  EXPECT_TRUE(eventually([&] { return run.collector.counts().produced() > collected + 20; }));
  run.manager.stop();
  EXPECT_EQ(sink.lost, 0u);
  ASSERT_GT(sink.numbers.size(), collected);
  EXPECT_GT(sink.numbers[collected], rows + 50);
  expectAscending(sink.numbers);
}

struct ArmDevice final : Device {
  reference::SimulatedArm arm{{}};
  Provided<ArmLike> port{*this, "Arm", arm};
};

TEST(StateCollector, DevicesAreCollectedOverALaneOnly) {
  loop::ControlThread control;
  GlobalManager names(control, "tcp://127.0.0.1:0");
  ArmDevice device;
  CountingSink sink;
  StateCollector collector(interfaceInfo<ArmLike>(), {.reads = {"measured_cp"}}, sink);
  Manager manager("here", names.address());
  manager.add("PSM", device);
  manager.add("Collector", collector);
  manager.start();
  EXPECT_EQ(refusal([&] { manager.connect("Collector/Source", "PSM/Arm"); }),
            "connecting here:Collector/Source -> here:PSM/Arm: a device keeps no rows for clients "
            "of its own process. Require another lane, such as rpc, or make the device a task");
  manager.connect("Collector/Source", "PSM/Arm", {.lane = Lane::Rpc});
  EXPECT_TRUE(eventually([&] { return collector.counts().collected > 5; }));
  manager.stop();
}

struct FullDisk final : Sink {
  void row(const CollectedInterface&, std::uint64_t, Time,
           std::span<const CollectedValue>) override {
    throw std::runtime_error("no space left");
  }
  void event(const CollectedInterface&, std::uint16_t, Time, const std::byte*) override {}
  void missed(const CollectedInterface&, std::uint64_t) override {}
};

TEST(StateCollector, AThrowingSinkParksItsCollector) {
  FullDisk sink;
  CollectedStates run({}, sink);
  EXPECT_TRUE(eventually([&] { return run.collector.state() == ComponentState::Faulted; }));
  EXPECT_EQ(run.collector.fault(), "no space left");
  EXPECT_EQ(run.arm.state(), ComponentState::Running);
  run.manager.stop();
}

}  // namespace
}  // namespace suture
