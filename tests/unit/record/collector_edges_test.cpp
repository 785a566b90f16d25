// No row and no event is lost where collecting begins and ends.

#include <gtest/gtest.h>
#include <suture/component/provided.h>
#include <suture/component/task/continuous_task.h>
#include <suture/component/task/periodic_task.h>
#include <suture/manager/manager.h>
#include <suture/record/event_collector.h>
#include <suture/record/state_collector.h>
#include <suture/rt/state/state_table.h>
#include <suture/standard/lifecycle.suture.h>

#include <atomic>
#include <thread>

#include "support/eventually.h"
#include "unit/record/counting_sink.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

/// Provides the one contract of the runtime's own.
template <class Kind>
struct Providing final : Kind, private Lifecycle {
  using Kind::Kind;
  ~Providing() override { Kind::stop(); }
  std::uint64_t produced() { return port.state()->rows(); }

 private:
  void run() override {}
  bool suspend() override { return false; }
  bool resume() override { return false; }
  ResumeOutcome resume_connection(const std::string&) override {
    return ResumeOutcome::NoSuchInterface;
  }
  ComponentState component_state() const override { return Kind::state(); }

  Provided<Lifecycle> port{*this, "Arm", *this};
};

/// Takes its time to stop.
struct Slow final : PeriodicTask {
  Slow() : PeriodicTask({.period = 60ms}) {}
  ~Slow() override { stop(); }
  void run() override { pass(50ms); }
};

TEST(CollectorEdges, TheFirstRowIsAmongThoseCounted) {
  for (int i = 0; i < 50; ++i) {
    Providing<ContinuousTask> arm;
    CountingSink sink;
    StateCollector collector(interfaceInfo<Lifecycle>(), {.period = 1ms}, sink);
    Manager manager("here");
    manager.add("PSM", arm);
    manager.add("Collector", collector);
    manager.connect("Collector/Source", "PSM/Arm");
    manager.start();
    ASSERT_TRUE(eventually([&] { return collector.counts().produced() > 0; }));
    arm.stop();
    ASSERT_TRUE(eventually([&] { return collector.counts().produced() == arm.produced(); }))
        << collector.counts().produced() << " of " << arm.produced() << ", run " << i;
  }
}

/// Knows the last state of which it was told.
class States final : public Sink {
 public:
  void row(const CollectedInterface&, std::uint64_t, Time,
           std::span<const CollectedValue>) override {}
  void event(const CollectedInterface&, std::uint16_t, Time, const std::byte* slot) override {
    last_ = static_cast<ComponentState>(reinterpret_cast<const StateChangeSlot*>(slot)->state);
  }
  void missed(const CollectedInterface&, std::uint64_t) override {}

  ComponentState last() const { return last_; }

 private:
  std::atomic<ComponentState> last_{ComponentState::Constructed};
};

// The names of these collectors are such that they would stop first.
class UntilTheEnd : public testing::Test {
 protected:
  void begin(Component& collector, const char* provider) {
    manager_.add("A", collector);
    manager_.add("B", slow_);
    manager_.add("PSM", arm_);
    manager_.connect("A/Source", provider);
    manager_.start();
  }

  CountingSink sink_;
  Slow slow_;
  Providing<PeriodicTask> arm_{PeriodicOptions{.period = 1ms}};
  Manager manager_{"here"};
};

TEST_F(UntilTheEnd, TheLastRowsAreCollected) {
  StateCollector collector(interfaceInfo<Lifecycle>(), {.period = 200ms}, sink_);
  begin(collector, "PSM/Arm");
  ASSERT_TRUE(eventually([&] { return arm_.produced() > 100; }));
  manager_.stop();
  EXPECT_EQ(collector.counts().produced(), arm_.produced());
  EXPECT_EQ(sink_.numbers.size(), collector.counts().collected);
  EXPECT_EQ(sink_.lost, collector.counts().missed);
  EXPECT_EQ(sink_.numbers.back(), arm_.produced());
}

TEST_F(UntilTheEnd, TheFirstLookIsAtTheConnection) {
  StateCollector collector(interfaceInfo<Lifecycle>(), {.period = 1h}, sink_);
  begin(collector, "PSM/Arm");
  ASSERT_TRUE(eventually([&] { return arm_.produced() > 0; }));
  manager_.stop();
  EXPECT_EQ(collector.counts().produced(), arm_.produced());
  EXPECT_EQ(sink_.numbers.back(), arm_.produced());
}

TEST_F(UntilTheEnd, CollectingBeginsWhenToldTo) {
  StateCollector collector(interfaceInfo<Lifecycle>(), {.period = 1h, .collecting = false}, sink_);
  begin(collector, "PSM/Arm");
  ASSERT_FALSE(collector.collecting());
  collector.startCollecting();
  EXPECT_TRUE(eventually([&] { return collector.collecting(); }));
  manager_.stop();
}

TEST_F(UntilTheEnd, TheLastEventsAreCollected) {
  States states;
  EventCollector collector(interfaceInfo<Lifecycle>(), {}, states);
  begin(collector, "PSM/component");
  ASSERT_TRUE(eventually([&] { return states.last() == ComponentState::Running; }));
  manager_.stop();
  EXPECT_EQ(states.last(), ComponentState::Stopped);
}

TEST_F(UntilTheEnd, ASuspendedCollectorsEventsAreCollected) {
  States states;
  EventCollector collector(interfaceInfo<Lifecycle>(), {}, states);
  begin(collector, "PSM/component");
  ASSERT_TRUE(eventually([&] { return states.last() == ComponentState::Running; }));
  manager_.suspend("A");
  const std::uint64_t before = collector.counts().produced();
  manager_.suspend("PSM");
  manager_.resume("PSM");
  EXPECT_EQ(collector.counts().produced(), before);
  manager_.stop();
  EXPECT_EQ(collector.counts().produced(), before + 3);
  EXPECT_EQ(states.last(), ComponentState::Stopped);
}

}  // namespace
}  // namespace suture
