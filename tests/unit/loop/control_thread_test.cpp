#include <gtest/gtest.h>
#include <suture/loop/control_thread.h>

#include <thread>

#include "support/no_more_descriptors.h"
#include "support/patience.h"
#include "support/refusal.h"

namespace suture::loop {
namespace {

using namespace std::chrono_literals;
using Kind = ControlFailure::Kind;

template <class Work>
ControlFailure failureOf(Work work) {
  try {
    work();
  } catch (const ControlFailure& failure) {
    return failure;
  }
  return {Kind::Failed, "no failure"};
}

TEST(ControlThread, StartsAndEndsWithoutWork) {
  for (int i = 0; i < 20; ++i) ControlThread control;
}

// There are descriptors again when the text is read, because UBSan takes one to look at an object.
TEST(ControlThread, SaysWhyItCannotStart) {
  EXPECT_EQ(refusal([] {
              const NoMoreDescriptors full;
              const ControlThread control;
            }),
            "start the control thread: eventfd: Too many open files. Raise the limit of open files "
            "(ulimit -n).");
}

TEST(ControlThread, RunReturnsAValue) {
  ControlThread control;
  EXPECT_EQ(control.run(kPatience, [] { return 42; }), 42);
  control.run(kPatience, [] {});
  EXPECT_TRUE(control.run(kPatience, [&control] { return control.isCurrent(); }));
  EXPECT_FALSE(control.isCurrent());
}

TEST(ControlThread, RunWaitsForAPromise) {
  ControlThread control;
  const auto text = control.run(kPatience, [&control] {
    return control.timer().afterDelay(1 * kj::MILLISECONDS).then([] {
      return std::string("late");
    });
  });
  EXPECT_EQ(text, "late");
}

TEST(ControlThread, RunPassesOnWhatWasThrown) {
  ControlThread control;
  const auto thrown =
      failureOf([&] { control.run(kPatience, [] { throw std::runtime_error("no such robot"); }); });
  EXPECT_EQ(thrown.kind(), Kind::Failed);
  EXPECT_STREQ(thrown.what(), "no such robot");
  const auto rejected = failureOf(
      [&] { control.run(kPatience, []() -> kj::Promise<void> { return disconnected("gone"); }); });
  EXPECT_STREQ(rejected.what(), "gone");
}

TEST(ControlThread, AFailureThatNobodyAwaitsIsPrinted) {
  testing::internal::CaptureStderr();
  ControlThread control;
  control.run(kPatience, [&control] { control.spawn(disconnected("no such robot")); });
  control.run(kPatience, [&control] { return control.timer().afterDelay(1 * kj::MILLISECONDS); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "suture: a background task failed: no such robot\n");
}

TEST(ControlThread, RunEndsAtItsDeadlineAndCancels) {
  ControlThread control;
  auto cancelled = std::make_shared<std::atomic<bool>>(false);
  const auto failed = failureOf([&] {
    control.run(10ms, [cancelled] {
      return kj::Promise<void>(kj::NEVER_DONE).attach(kj::defer([cancelled] {
        *cancelled = true;
      }));
    });
  });
  EXPECT_EQ(failed.kind(), Kind::TimedOut);
  control.run(kPatience, [] {});
  EXPECT_TRUE(*cancelled);
}

TEST(ControlThread, RunOnItselfIsRefused) {
  ControlThread control;
  EXPECT_THROW(control.run(kPatience, [&control] { control.run(kPatience, [] {}); }),
               ControlFailure);
}

TEST(ControlThread, EndingFailsWhatWaits) {
  auto control = std::make_unique<ControlThread>();
  std::atomic<bool> started = false;
  std::thread waiter([&, thread = control.get()] {
    const auto failed = failureOf([&] {
      thread->run(60s, [&started] {
        started = true;
        return kj::Promise<void>(kj::NEVER_DONE);
      });
    });
    EXPECT_EQ(failed.kind(), Kind::Stopped);
  });
  while (!started) std::this_thread::yield();
  control.reset();
  waiter.join();
}

TEST(ControlThread, PostedWorkRunsInOrder) {
  ControlThread control;
  constexpr int kThreads = 4, kPosts = 1000;
  std::vector<int> last(kThreads, -1);
  bool ordered = true;
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      const auto index = static_cast<std::size_t>(t);
      for (int i = 0; i < kPosts; ++i) {
        control.post([&, index, i] {
          ordered = ordered && last[index] == i - 1;
          last[index] = i;
        });
      }
    });
  }
  for (auto& thread : threads) thread.join();
  control.run(kPatience, [] {});
  EXPECT_TRUE(ordered);
  EXPECT_EQ(last, std::vector<int>(kThreads, kPosts - 1));
}

TEST(ControlThread, ThrowingWorkKeepsTheThread) {
  ControlThread control;
  control.post([] { throw std::runtime_error("expected in this test"); });
  EXPECT_EQ(control.run(kPatience, [] { return 1; }), 1);
}

// Counts rings' worth of items, as a lane does.
struct CountingPump final : Pump {
  void pump() override {
    taken.store(given.load());
    taken.notify_all();
  }
  std::atomic<int> given = 0, taken = 0;
};

TEST(ControlThread, EveryRingIsFollowedByAPump) {
  ControlThread control;
  CountingPump pump;
  control.run(kPatience, [&] { control.add(pump); });
  for (int i = 1; i <= 2000; ++i) {
    pump.given = i;
    control.doorbell().ring();
    if (i % 3 == 0) continue;  // several rings before the pump runs
    for (int seen = pump.taken; seen < i; seen = pump.taken) pump.taken.wait(seen);
  }
  control.run(kPatience, [&] { control.remove(pump); });
  EXPECT_EQ(pump.taken, 2000);
}

}  // namespace
}  // namespace suture::loop
