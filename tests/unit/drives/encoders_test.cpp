// Encoders tell counts, with noise and velocities as declared.

#include "drives/encoders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace robots::test {
namespace {

using Pair = Eigen::Vector2d;

const Pair kCounts{1e-4, 3e-3};

TEST(Encoders, TellTheNearestCount) {
  Encoders<2> encoders({.step = kCounts}, Pair::Zero());
  encoders.read({1.4e-4, -4.6e-3}, 0.001);
  EXPECT_DOUBLE_EQ(encoders.measured()[0], 1e-4);
  EXPECT_DOUBLE_EQ(encoders.measured()[1], -6e-3);
}

TEST(Encoders, TellWhatIsWithoutQuantisation) {
  Encoders<2> encoders({.step = kCounts, .quantisation = false}, Pair::Zero());
  encoders.read({1.4e-4, -4.6e-3}, 0.001);
  EXPECT_DOUBLE_EQ(encoders.measured()[0], 1.4e-4);
  EXPECT_DOUBLE_EQ(encoders.measured()[1], -4.6e-3);
}

double deviation(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / count);
}

TEST(Encoders, AddNoiseOfTheDeclaredSize) {
  constexpr double kNoise = 2.5;
  Encoders<2> encoders({.step = kCounts, .quantisation = false, .noise = kNoise}, Pair::Zero());
  std::vector<double> first, second;
  for (int i = 0; i < 20'000; ++i) {
    encoders.read({0.1, 0.2}, 0.001);
    first.push_back(encoders.measured()[0]);
    second.push_back(encoders.measured()[1]);
  }
  EXPECT_NEAR(deviation(first) / (kNoise * kCounts[0]), 1, 0.03);
  EXPECT_NEAR(deviation(second) / (kNoise * kCounts[1]), 1, 0.03);
}

TEST(Encoders, StillTellWholeCountsOfNoise) {
  Encoders<2> encoders({.step = kCounts, .noise = 2}, Pair::Zero());
  for (int i = 0; i < 100; ++i) {
    encoders.read({0.1, 0.2}, 0.001);
    const double counts = encoders.measured()[1] / kCounts[1];
    ASSERT_NEAR(counts, std::round(counts), 1e-9);
  }
}

// Encoders tell 1 - 1/e of a velocity that begins after one time constant, and at last all of it.
TEST(Encoders, DelayVelocitiesByTheFilter) {
  constexpr double kPeriod = 1e-5, kFilter = 0.005, kSpeed = 0.3;
  Encoders<2> encoders({.step = kCounts, .quantisation = false, .velocity_filter = kFilter},
                       Pair::Zero());
  double position = 0;
  const auto move = [&](double seconds) {
    for (double t = 0; t < seconds - kPeriod / 2; t += kPeriod) {
      position += kSpeed * kPeriod;
      encoders.read(Pair::Constant(position), kPeriod);
    }
  };
  move(kFilter);
  EXPECT_NEAR(encoders.velocity()[0], kSpeed * (1 - std::exp(-1)), 1e-3 * kSpeed);
  move(20 * kFilter);
  EXPECT_NEAR(encoders.velocity()[1], kSpeed, 1e-6);
}

TEST(Encoders, TellNoVelocityOfWhatRests) {
  Encoders<2> encoders({.step = kCounts, .velocity_filter = 0.005}, Pair::Zero());
  encoders.read({0.01, 0.01}, 0.001);
  EXPECT_GT(encoders.velocity()[0], 0);
  for (int i = 0; i < 1000; ++i) encoders.read({0.01, 0.01}, 0.001);
  EXPECT_EQ(encoders.velocity(), Pair::Zero());
}

}  // namespace
}  // namespace robots::test
