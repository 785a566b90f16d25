// This is the law of a periodic task: executed + skipped = elapsed / period, within one.

#include <gtest/gtest.h>
#include <suture/component/task/periodic_task.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <thread>

#include "support/pass.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPeriod = 20us;
constexpr std::uint64_t kPeriods = 100'000;

/// Keeps the least number of periods by which the clock is ahead of the count. A cycle that starts
/// late adds its delay to that, so each end of the run takes the least of ten thousand cycles.
class AheadOfCount {
 public:
  void add(double periods) { least_ = std::min(least_, periods); }
  double least() const { return least_; }

 private:
  double least_ = std::numeric_limits<double>::max();
};

class CountedLoop final : public PeriodicTask {
 public:
  CountedLoop() : PeriodicTask({.period = kPeriod}) {}
  ~CountedLoop() override { stop(); }

  void run() override {
    const Time time = now();
    if (cycles_++ == 0) begin_ = time;
    const std::uint64_t counted = cycles_ + statistics().skipped;
    const double elapsed = std::chrono::duration<double>(time - begin_) / kPeriod;
    const double ahead = elapsed - static_cast<double>(counted);
    if (cycles_ <= kEnd) atBegin_.add(ahead);
    if (counted > kPeriods && ++cyclesAtEnd_ <= kEnd) atEnd_.add(ahead);
    // Every hundredth cycle takes some periods, so that some are skipped.
    if (cycles_ % 100 == 0) pass(3 * kPeriod + kPeriod / 2);
    finished_ = cyclesAtEnd_ >= kEnd;
  }

  bool finished() const { return finished_; }
  double drift() const { return atEnd_.least() - atBegin_.least(); }

 private:
  static constexpr std::uint64_t kEnd = 10'000;

  Time begin_{};
  std::uint64_t cycles_ = 0, cyclesAtEnd_ = 0;
  AheadOfCount atBegin_, atEnd_;
  std::atomic<bool> finished_{false};
};

TEST(PeriodicTask, ExecutedAndSkippedAddUp) {
  CountedLoop loop;
  loop.start();
  const Time deadline = now() + 60s;
  while (!loop.finished() && now() < deadline) pass(10ms);
  loop.stop();
  ASSERT_TRUE(loop.finished());
  EXPECT_NEAR(loop.drift(), 0, 1);
  EXPECT_GT(loop.statistics().skipped, 0u);
}

}  // namespace
}  // namespace suture
