// A tremor has the declared size, and power between 8 and 12 Hz alone.

#include "hand/tremor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

namespace robots::test {
namespace {

TEST(Tremor, HasTheDeclaredSize) {
  const Tremor tremor({.amplitude = 2e-4, .seed = 7});
  constexpr int kCount = 6000;
  double squares = 0;
  for (int i = 0; i < kCount; ++i) squares += tremor.at(0.01 * i).offset.squaredNorm();
  EXPECT_NEAR(std::sqrt(squares / kCount), 2e-4, 2e-6);
}

/// Records one axis of a tremor, for so long that the edges of the band are seen.
class Record {
 public:
  Record(const Tremor& tremor, int axis) {
    for (int i = 0; i < kSamples; ++i) samples_.push_back(tremor.at(i * kPeriod).offset[axis]);
  }

  /// Returns how much of it is at `frequency` (Hz), m, through a window with soft edges.
  double shareAt(double frequency) const {
    constexpr double kTurn = 2 * std::numbers::pi;
    std::complex<double> sum = 0;
    for (int i = 0; i < kSamples; ++i) {
      const double window = 1 - std::cos(kTurn * i / kSamples);
      sum += window * samples_[static_cast<std::size_t>(i)] *
             std::polar(1.0, kTurn * frequency * i * kPeriod);
    }
    return 2 * std::abs(sum) / kSamples;
  }

 private:
  static constexpr double kPeriod = 0.01;  // s
  static constexpr int kSamples = 6000;
  std::vector<double> samples_;
};

TEST(Tremor, HasNoPowerOutsideOfItsBand) {
  const Tremor tremor(TremorModel{});
  for (int axis = 0; axis < 3; ++axis) {
    const Record record(tremor, axis);
    double within = 0;
    for (double f = 8; f <= 12; f += 0.025) within = std::max(within, record.shareAt(f));
    EXPECT_GT(within, 1e-5);
    for (const double f : {0.5, 2.0, 5.0, 7.5, 12.5, 15.0, 30.0}) {
      EXPECT_LT(record.shareAt(f), 1e-4 * within) << f << " Hz";
    }
  }
}

TEST(Tremor, TellsVelocityAndAccelerationOfItsOffset) {
  const Tremor tremor(TremorModel{});
  constexpr double kDifference = 1e-5;
  for (const double t : {0.0, 0.3, 12.7}) {
    const auto before = tremor.at(t - kDifference), after = tremor.at(t + kDifference);
    const auto now = tremor.at(t);
    const Eigen::Vector3d velocity = (after.offset - before.offset) / (2 * kDifference);
    const Eigen::Vector3d acceleration = (after.velocity - before.velocity) / (2 * kDifference);
    EXPECT_LT((velocity - now.velocity).norm(), 1e-5 * now.velocity.norm());
    EXPECT_LT((acceleration - now.acceleration).norm(), 1e-5 * now.acceleration.norm());
  }
}

TEST(Tremor, IsEqualForEqualSeedsOnly) {
  const Tremor one({.seed = 1}), same({.seed = 1}), other({.seed = 2});
  EXPECT_EQ(one.at(1.5).offset, same.at(1.5).offset);
  EXPECT_GT((one.at(1.5).offset - other.at(1.5).offset).norm(), 1e-6);
}

}  // namespace
}  // namespace robots::test
