// The longest delay of the picture with which an operator closes a stable loop: a quarter of a turn
// at the frequency of crossover, less the operator's own delay and the loop's.

#include <gtest/gtest.h>
#include <suture/component/required.h>

#include <chrono>
#include <numbers>

#include "integration/operator/desk.h"
#include "support/stepped.h"
#include "surgeon/operator.h"
#include "timing/seconds.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

/// Sits where the operator does, moves both masters evenly, and tells by how much time the picture
/// lags behind them.
class Probe final : public suture::PeriodicTask {
 public:
  Probe() : PeriodicTask({.period = 1ms}) {}

  /// s, the mean over whole pictures.
  double lag() const { return sum_ / count_; }

 private:
  static constexpr double kSpeed = 0.02;  // m/s, of the masters
  static constexpr double kSettled = 1;   // s
  static constexpr int kCycles = 2000;    // 30 pictures

  void run() override {
    const suture::Time now = suture::now();
    if (begin_ == suture::Time{}) begin_ = now;
    const double t = secondsBetween(begin_, now);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation().x() = kSpeed * t;
    left_.servo_cp({pose, now, true});
    right_.servo_cp({pose, now, true});
    const auto sighting = vision_.sighting();
    if (t < kSettled || count_ == kCycles || !sighting || !sighting->valid) return;
    sum_ += t - sighting->knot.x() / (Scene::kScale * kSpeed);
    ++count_;
  }

  suture::Required<Arm> left_{*this, "Left"}, right_{*this, "Right"};
  suture::Required<KnotVision> vision_{*this, "Vision"};
  suture::Time begin_{};
  double sum_ = 0;
  int count_ = 0;
};

double measuredLag(suture::Duration delay) {
  Probe probe;
  Desk desk;
  desk.seat(probe, delay);
  desk.manager.start();
  pass(4s);
  desk.manager.stop();
  return probe.lag();
}

/// Whether the error of the knot dies out.
bool isStable(suture::Duration delay) {
  Desk desk;
  // So little that no bound is reached.
  desk.seatOperator({.target = {0.002, 0, 0}, .remnant = 0, .tremor = 0}, delay);
  const auto swing = [&] {
    double squares = 0;
    for (int i = 0; i < 150; ++i) {
      pass(100ms);
      squares += (desk.knot().x() - 0.002) * (desk.knot().x() - 0.002);
    }
    return squares;
  };
  pass(3s);
  const double early = swing();
  return swing() < early;
}

TEST(Operator, SeesThePictureLateByTheLoopsOwnDelayAndTheLinks) {
  const double own = measuredLag(0ms);
  RecordProperty("loop_ms", std::to_string(1000 * own));
  EXPECT_GT(own, inSeconds(Scene::kPeriod) / 2);
  EXPECT_LT(own, inSeconds(Scene::kPeriod) / 2 + 0.01);
  EXPECT_NEAR(measuredLag(200ms) - own, 0.2, 0.002);
}

TEST(Operator, ClosesAStableLoopUpToItsOwnLimit) {
  const OperatorParameters parameters;
  const double limit = std::numbers::pi / (2 * parameters.crossover_frequency) -
                       inSeconds(parameters.delay) - measuredLag(0ms);
  suture::Duration stable = 150ms, unstable = 450ms;
  while (unstable - stable > 10ms) {
    const suture::Duration middle = (stable + unstable) / 2;
    (isStable(middle) ? stable : unstable) = middle;
  }
  RecordProperty("limit_ms", std::to_string(1000 * limit));
  RecordProperty("stable_ms", std::to_string(1000 * inSeconds(stable)));
  EXPECT_NEAR(inSeconds(stable) / limit, 1, 0.1);
}

}  // namespace
}  // namespace robots::test
