#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/component/task/periodic_task.h>
#include <suture/manager/manager.h>
#include <suture/record/event_collector.h>

#include <atomic>
#include <functional>

#include "reference/still_arm.h"
#include "support/contains.h"
#include "support/eventually.h"
#include "support/refusal.h"
#include "unit/record/counting_sink.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::PoseStamped;

/// Emits `arrived` (its queue holds 4) at 1 kHz while it is told to.
class Emitting final : public PeriodicTask, public StillArm {
 public:
  Emitting() : PeriodicTask({.period = 1ms}) {}

  std::atomic<bool> on{false};
  std::atomic<std::uint64_t> emitted{0};

 private:
  void run() override {
    if (!on) return;
    (void)arm_.emit().arrived(PoseStamped{});
    arm_.emit().stopped();
    emitted += 1;
  }

  Provided<ArmLike> arm_{*this, "Arm", *this};
};

struct CollectedEvents {
  CollectedEvents(const EventCollectorOptions& options, Sink& sink)
      : collector(interfaceInfo<ArmLike>(), options, sink) {
    manager.add("PSM", arm);
    manager.add("Collector", collector);
    manager.connect("Collector/Source", "PSM/Arm");
    manager.start();
    // Both ends have taken the connection over.
    EXPECT_TRUE(eventually([&] { return !options.collecting || collector.collecting(); }));
    pass(20ms);
    arm.on = true;
  }
  /// Ends the events and waits until the collector has come to the last of `perCycle` each cycle.
  void finish(unsigned perCycle) {
    arm.stop();
    EXPECT_TRUE(eventually([&] {
      return collector.counts().produced() == perCycle * arm.emitted.load();
    })) << collector.counts().produced()
        << " of " << perCycle * arm.emitted.load();
    manager.stop();
  }

  Emitting arm;
  EventCollector collector;
  Manager manager{"here"};
};

TEST(EventCollector, EventsCollectedAndMissedAreThoseEmitted) {
  CountingSink sink;
  CollectedEvents run({.events = {"arrived", "stopped"}}, sink);
  pass(1s);
  run.finish(2);
  const CollectedCounts counts = run.collector.counts();
  EXPECT_GT(counts.collected, 0u);
  EXPECT_EQ(sink.numbers.size(), counts.collected);
  EXPECT_EQ(sink.lost, counts.missed);
  for (std::size_t i = 1; i < sink.stamps.size(); ++i) {
    ASSERT_LE(sink.stamps[i - 1], sink.stamps[i]);
  }
  EXPECT_GT(sink.stamps.front(), now() - 1min);
}

TEST(EventCollector, ASlowSinksLostEventsAreCounted) {
  CountingSink sink(10ms);
  CollectedEvents run({.events = {"arrived"}}, sink);
  EXPECT_TRUE(eventually([&] { return run.collector.counts().missed > 100; }));
  run.finish(1);
  EXPECT_EQ(sink.numbers.size(), run.collector.counts().collected);
  EXPECT_EQ(sink.lost, run.collector.counts().missed);
}

struct BurstEmitter final : Device, StillArm {
  Provided<ArmLike> port{*this, "Arm", *this};
};

// The collector finds itself connected anew when it wakes up.
TEST(EventCollector, CountsAnEarlierConnectionsDrops) {
  CountingSink sink;
  BurstEmitter arm;
  EventCollector collector(interfaceInfo<ArmLike>(), {}, sink);
  Manager manager{"here"};
  manager.add("PSM", arm);
  manager.add("Collector", collector);
  manager.connect("Collector/Source", "PSM/Arm");
  manager.start();
  pass(20ms);
  for (int i = 0; i < 1000; ++i) (void)arm.port.emit().arrived(PoseStamped{});
  const auto before = manager.channels().at(0);
  manager.disconnect("Collector/Source");
  manager.connect("Collector/Source", "PSM/Arm");
  pass(20ms);
  manager.stop();
  EXPECT_GT(before->events.dropped(), 0u);
  EXPECT_EQ(collector.counts().missed, before->events.dropped());
  EXPECT_EQ(sink.lost, before->events.dropped());
}

TEST(EventCollector, KeepsEveryNthEvent) {
  CountingSink sink;
  CollectedEvents run({.events = {"arrived"}, .interval = {.every = 4}}, sink);
  EXPECT_TRUE(eventually([&] { return run.collector.counts().collected >= 10; }));
  run.finish(1);
  const CollectedCounts counts = run.collector.counts();
  EXPECT_EQ(counts.collected, (counts.collected + counts.passedOver + 3) / 4);
}

TEST(EventCollector, CollectsOnlyFromStartToStop) {
  CountingSink sink;
  CollectedEvents run({.collecting = false}, sink);
  EXPECT_TRUE(eventually([&] { return run.arm.emitted > 20; }));
  EXPECT_EQ(run.collector.counts().produced(), 0u);
  run.collector.startCollecting();
  EXPECT_TRUE(eventually([&] { return run.collector.counts().collected > 20; }));
  run.collector.stopCollecting();
  EXPECT_TRUE(eventually([&] { return !run.collector.collecting(); }));
  const std::uint64_t before = run.collector.counts().produced();
  const std::uint64_t emitted = run.arm.emitted;
  EXPECT_TRUE(eventually([&] { return run.arm.emitted > emitted + 20; }));
  EXPECT_EQ(run.collector.counts().produced(), before);
  run.manager.stop();
}

TEST(EventCollector, RefusesAnEventThatIsNotThere) {
  CountingSink sink;
  EXPECT_TRUE(contains(
      refusal([&] { EventCollector(interfaceInfo<ArmLike>(), {.events = {"arived"}}, sink); }),
      "collecting the event 'arived': " + std::string(interfaceInfo<ArmLike>().name) + " has "));
  EXPECT_EQ(
      refusal([&] { EventCollector(interfaceInfo<ArmLike>(), {.interval = {.every = 0}}, sink); }),
      "a collector: it is to keep every 0th, at least 0 ns apart. Keep every one (1) or every "
      "n-th, with no negative time between");
}

}  // namespace
}  // namespace suture
