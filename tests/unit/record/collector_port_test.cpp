// Others see collectors so: they switch, pace and ask them through their interface "Collecting".

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/record/event_collector.h>
#include <suture/record/state_collector.h>
#include <suture/standard/lifecycle.suture.h>

#include <memory>
#include <vector>

#include "reference/simulated_arm.suture.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "unit/record/counting_sink.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;

/// Hears what is announced of a component's life.
struct Watcher final : Device {
  Watcher() {
    life.makeOptional();
    life.on().state_changed([this](const StateChange& change) { heard.push_back(change.state); });
  }
  Required<Lifecycle> life{*this, "Life"};
  std::vector<ComponentState> heard;
};

struct Operator final : Device {
  Required<Collecting> log{*this, "Log"};
};

class Collectors : public testing::TestWithParam<Lane> {
 protected:
  void begin(Component& collector, const char* source) {
    manager.add("PSM", arm);
    manager.add("Log", collector);
    manager.add("Operator", operator_);
    manager.start();
    manager.connect("Log/Source", source);
    manager.connect("Operator/Log", "Log/Collecting", {.lane = GetParam()});
    manager.awaitStart();
  }
  void TearDown() override { manager.stop(); }

  template <class Condition>
  bool counted(const Condition& condition) {
    return eventually([&] {
      const auto counts = log.counts();
      return counts && condition(*counts);
    });
  }

  loop::ControlThread control;
  GlobalManager names{control, "tcp://127.0.0.1:0"};
  Manager manager{"here", names.address()};
  reference::SimulatedArm arm{{}};
  Operator operator_;
  Required<Collecting>& log = operator_.log;
};

TEST_P(Collectors, StateCollectorsAreSwitchedPacedAndAsked) {
  const auto sink = std::make_shared<CountingSink>();
  StateCollector collector(interfaceInfo<ArmLike>(), {.collecting = false}, sink);
  begin(collector, "PSM/Arm");
  EXPECT_TRUE(eventually([&] { return log.collecting() && !*log.collecting(); }));
  EXPECT_EQ(sink->numbers.size(), 0u);

  ASSERT_TRUE(log.start_collecting());
  EXPECT_TRUE(counted([](const CollectedCounts& counts) { return counts.collected >= 20; }));
  EXPECT_TRUE(*log.collecting());
  EXPECT_EQ(log.counts()->passedOver, 0u);

  EXPECT_TRUE(*log.set_interval.start({.every = 4}).within(kPatience));
  EXPECT_TRUE(counted([](const CollectedCounts& counts) { return counts.passedOver >= 30; }));
  EXPECT_TRUE(eventually([&] { return log.interval() && log.interval()->every == 4; }));
  EXPECT_FALSE(*log.set_interval.start({.atLeast = -1ms}).within(kPatience));
  EXPECT_TRUE(eventually([&] { return log.interval()->every == 4; }));

  ASSERT_TRUE(log.stop_collecting());
  EXPECT_TRUE(eventually([&] { return !*log.collecting(); }));
  EXPECT_TRUE(counted([&](const CollectedCounts& counts) {
    return counts.produced() == collector.counts().produced();
  }));
  EXPECT_EQ(log.counts()->collected, collector.counts().collected);
  manager.stop();
  EXPECT_EQ(sink->numbers.size(), collector.counts().collected);
  EXPECT_EQ(sink->lost, collector.counts().missed);
}

TEST_P(Collectors, EventCollectorsAreSwitchedAndAsked) {
  const auto sink = std::make_shared<CountingSink>();
  EventCollector collector(interfaceInfo<Lifecycle>(), {.collecting = false}, sink);
  Watcher watcher;
  manager.add("Watcher", watcher);
  begin(collector, "PSM/component");
  manager.connect("Watcher/Life", "PSM/component");
  manager.suspend("PSM");
  manager.resume("PSM");
  // A state is announced after it has been taken; the collector, connected first, has it then.
  EXPECT_TRUE(eventually([&] {
    watcher.processEvents();
    return watcher.heard.size() >= 2 && watcher.heard.back() == ComponentState::Running;
  }));
  // Its cycle under way may have looked for events before that, but not the one after.
  ASSERT_TRUE(*log.set_interval.start({}).within(kPatience));
  ASSERT_TRUE(log.start_collecting());
  EXPECT_TRUE(eventually([&] { return log.collecting() && *log.collecting(); }));
  manager.suspend("PSM");
  manager.resume("PSM");
  EXPECT_TRUE(counted([](const CollectedCounts& counts) { return counts.collected == 2; }));
  ASSERT_TRUE(log.stop_collecting());
  EXPECT_TRUE(eventually([&] { return !*log.collecting(); }));
  manager.suspend("PSM");
  EXPECT_EQ(log.counts()->produced(), 2u);
  manager.stop();
  EXPECT_EQ(sink->numbers.size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(Lanes, Collectors, testing::Values(Lane::Auto, Lane::Rpc),
                         [](const auto& lane) {
                           return lane.param == Lane::Auto ? "Local" : "Rpc";
                         });

}  // namespace
}  // namespace suture
