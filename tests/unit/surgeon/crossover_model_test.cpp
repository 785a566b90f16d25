// This is McRuer's operator: an integrator with a delay, noise as published, and the limit of
// stability that follows.

#include "surgeon/crossover_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <deque>
#include <numbers>
#include <stdexcept>

#include "support/allocations.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;

constexpr suture::Duration kModelPeriod = 1ms;
constexpr double kCycle = 0.001;  // s: kModelPeriod as a number
constexpr CrossoverParameters kQuiet{.remnant = 0};

TEST(CrossoverModel, MovesAtTheDelayedError) {
  CrossoverModel model(kQuiet, kModelPeriod);
  suture::Time now{};
  for (int i = 0; i < 1000; ++i, now += kModelPeriod) {
    const Vector3d rate = model.rate(now, {0.01 * i, 0, -0.02 * i});
    const Vector3d expected = 3 * std::max(i - 200, 0) * Vector3d(0.01, 0, -0.02);
    ASSERT_LT((rate - expected).norm(), 1e-9) << i;
  }
}

TEST(CrossoverModel, IsADelayedIntegrator) {
  for (const double frequency : {1.0, 3.0, 6.0}) {
    CrossoverModel model(kQuiet, kModelPeriod);
    suture::Time now{};
    std::complex<double> in = 0, out = 0;
    double moved = 0;
    const int turn = static_cast<int>(2 * std::numbers::pi / frequency / kCycle);
    for (int i = 0; i < 6 * turn; ++i, now += kModelPeriod) {
      const double t = i * kCycle, error = std::cos(frequency * t);
      moved += kCycle * model.rate(now, {error, 0, 0}).x();
      if (i < turn) continue;
      in += std::polar(1.0, -frequency * t) * error;
      out += std::polar(1.0, -frequency * t) * moved;
    }
    const std::complex<double> open = out / in;
    EXPECT_NEAR(std::abs(open), 3 / frequency, 0.01 * 3 / frequency) << frequency;
    const auto expected = std::polar(1.0, -std::numbers::pi / 2 - 0.2 * frequency);
    EXPECT_NEAR(std::arg(open / expected), 0, 0.01) << frequency;
  }
}

/// Tells if the error dies out while the operator sees it `delay` late.
bool isStable(const CrossoverParameters& parameters, suture::Duration delay) {
  CrossoverModel model(parameters, kModelPeriod);
  std::deque<double> underWay(static_cast<std::size_t>(delay / kModelPeriod), 1.0);
  suture::Time now{};
  double error = 1, early = 0, late = 0;
  for (int i = 0; i < 100'000; ++i, now += kModelPeriod) {
    underWay.push_back(error);
    error -= kCycle * model.rate(now, {underWay.front(), 0, 0}).x();
    underWay.pop_front();
    (i < 50'000 ? early : late) += error * error;
  }
  return late < early;
}

/// Returns the longest delay with which the loop is stable, to a millisecond.
suture::Duration limitOf(const CrossoverParameters& parameters) {
  suture::Duration stable = 0ms, unstable = 2s;
  while (unstable - stable > 1ms) {
    const suture::Duration middle = (stable + unstable) / 2;
    (isStable(parameters, middle) ? stable : unstable) = middle;
  }
  return stable;
}

TEST(CrossoverModel, IsStableUpToItsLimit) {
  for (const double frequency : {2.0, 3.0, 4.0}) {
    CrossoverParameters parameters = kQuiet;
    parameters.frequency = frequency;
    const double limit = std::numbers::pi / (2 * frequency) - 0.2;
    const double found = std::chrono::duration<double>(limitOf(parameters)).count();
    RecordProperty("limit_ms_at_" + std::to_string(frequency), std::to_string(1000 * found));
    EXPECT_NEAR(found / limit, 1, 0.02) << frequency;
  }
}

TEST(CrossoverModel, AddsNoiseOfTheDeclaredPower) {
  const CrossoverParameters parameters;
  CrossoverModel model(parameters, kModelPeriod);
  constexpr double kError = 0.02;
  constexpr int kWindow = 5000, kWindows = 400;
  suture::Time now{};
  for (int i = 0; i < 200; ++i, now += kModelPeriod) model.rate(now, Vector3d::Constant(kError));
  double squares = 0;
  for (int w = 0; w < kWindows; ++w) {
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < kWindow; ++i, now += kModelPeriod) {
      sum += model.rate(now, Vector3d::Constant(kError));
    }
    squares += (sum / kWindow / (parameters.frequency * kError) - Vector3d::Ones()).squaredNorm();
  }
  // The variance of a mean over a long time is the density divided by that time.
  const double density = squares / (3 * kWindows) * kWindow * kCycle;
  EXPECT_NEAR(density / (std::numbers::pi * parameters.remnant), 1, 0.1);
}

TEST(CrossoverModel, IsQuietWhereThereIsNoError) {
  CrossoverModel model(CrossoverParameters{}, kModelPeriod);
  suture::Time now{};
  for (int i = 0; i < 1000; ++i, now += kModelPeriod) {
    ASSERT_EQ(model.rate(now, Vector3d::Zero()), Vector3d::Zero());
  }
}

TEST(CrossoverModel, ForgetsWhatItSaw) {
  CrossoverModel model(kQuiet, kModelPeriod);
  suture::Time now{};
  for (int i = 0; i < 300; ++i, now += kModelPeriod) model.rate(now, {1, 0, 0});
  model.forget();
  EXPECT_EQ(model.rate(now, Vector3d::Zero()), Vector3d::Zero());
}

TEST(CrossoverModel, RefusesWhatCannotBe) {
  const auto make = [](const CrossoverParameters& parameters, suture::Duration period) {
    return CrossoverModel(parameters, period);
  };
  EXPECT_THROW(make({.frequency = 0}, kModelPeriod), std::invalid_argument);
  EXPECT_THROW(make({.delay = -1ms}, kModelPeriod), std::invalid_argument);
  EXPECT_THROW(make({.remnant = -0.01}, kModelPeriod), std::invalid_argument);
  EXPECT_THROW(make({}, 0ms), std::invalid_argument);
}

TEST(CrossoverModel, NeverAllocatesInACycle) {
  CrossoverModel model(CrossoverParameters{}, kModelPeriod);
  suture::Time now{};
  const std::uint64_t before = suture::allocations();
  Vector3d moved = Vector3d::Zero();
  for (int i = 0; i < 1000; ++i, now += kModelPeriod) moved += model.rate(now, {1, 1, 1});
  EXPECT_EQ(suture::allocations() - before, 0u);
  EXPECT_GT(moved.x(), 0);
}

}  // namespace
}  // namespace robots::test
