#include <gtest/gtest.h>
#include <suture/component/task/callback_task.h>
#include <suture/component/task/event_task.h>
#include <suture/component/task/guest_task.h>
#include <suture/component/task/periodic_task.h>

#include <functional>

#include "support/eventually.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

/// Its cycle shows what others may see of it meanwhile.
template <class Kind>
struct Watched final : Kind {
  template <class... Options>
  explicit Watched(const Options&... options) : Kind(options...) {}
  ~Watched() override { this->stop(); }
  void run() override {
    within = this->activity().read().activity;
    ++cycles;
  }
  std::atomic<Activity> within{Activity::Suspended};
  std::atomic<int> cycles{0};
};

TEST(TaskActivity, OverdueBeginsWhereItIsDue) {
  TaskActivity activity;
  const Time start = fromNanoseconds(4000);
  EXPECT_EQ(activity.read().overdue(start), 0ns);
  activity.run(start);
  EXPECT_EQ(activity.read().overdue(start + 400ns), 400ns);
  activity.sleep(start + 100ns);
  EXPECT_EQ(activity.read().overdue(start + 96ns), 0ns);
  EXPECT_EQ(activity.read().overdue(start + 400ns), 300ns);
  activity.sleep();
  EXPECT_EQ(activity.read().overdue(start + 1h), 0ns);
  EXPECT_EQ(activity.read().activity, Activity::Asleep);
  activity.suspend();
  EXPECT_EQ(activity.read().overdue(start + 1h), 0ns);
  EXPECT_EQ(activity.read().activity, Activity::Suspended);
}

TEST(TaskActivity, SleepersAreDueAfterTheirLongestSleep) {
  Watched<EventTask> task(EventOptions{.longestSleep = 1h});
  EXPECT_EQ(task.activity().read().activity, Activity::Suspended);
  task.start();
  ASSERT_TRUE(eventually([&] { return task.activity().read().activity == Activity::Asleep; }));
  EXPECT_GT(task.activity().read().due, now() + 50min);
  task.doorbell().ring();
  EXPECT_TRUE(eventually([&] { return task.within == Activity::Running; }));
  task.request(Transition::Suspend);
  EXPECT_TRUE(eventually([&] { return task.activity().read().activity == Activity::Suspended; }));
  task.request(Transition::Resume);
  EXPECT_TRUE(eventually([&] { return task.activity().read().activity == Activity::Asleep; }));
  task.stop();
  EXPECT_EQ(task.activity().read().activity, Activity::Suspended);
}

TEST(TaskActivity, APeriodicTaskHasANextCycle) {
  Watched<PeriodicTask> task(PeriodicOptions{.period = 1h});
  const Time before = now();
  task.start();
  ASSERT_TRUE(eventually([&] { return task.activity().read().activity == Activity::Asleep; }));
  EXPECT_GE(task.activity().read().due, before + 1h - 4ns);
  EXPECT_LE(task.activity().read().due, now() + 1h);
}

TEST(TaskActivity, ACallbackTaskHasNoNextCycle) {
  Watched<CallbackTask> task;
  task.start();
  EXPECT_EQ(task.activity().read().activity, Activity::Asleep);
  ASSERT_TRUE(task.trigger());
  EXPECT_EQ(task.within, Activity::Running);
  EXPECT_EQ(task.activity().read().activity, Activity::Asleep);
  EXPECT_EQ(task.activity().read().due, Time{});
}

TEST(TaskActivity, AGuestShowsThatOfItsHost) {
  Watched<GuestTask> guest;
  Watched<CallbackTask> host;
  host.lend(guest);
  EXPECT_EQ(&guest.activity(), &host.activity());
  host.start();
  ASSERT_TRUE(host.trigger());
  EXPECT_EQ(guest.within, Activity::Running);
}

}  // namespace
}  // namespace suture
