// The simulated hand obeys its differential equation, at any step.

#include "hand/hand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "support/allocations.h"

namespace robots::test {
namespace {

using Eigen::Vector3d;

HandModel withoutTremor() {
  HandModel model;
  model.tremor.amplitude = 0;
  return model;
}

const Vector3d kNone = Vector3d::Zero();

/// Returns the answer `t` seconds after a force of 1 N has begun, from rest: the closed form of an
/// underdamped oscillator.
double answer(const HandModel& model, double t) {
  const double decay = model.damping / (2 * model.mass);
  const double swing = std::sqrt(model.stiffness / model.mass - decay * decay);
  return (1 - std::exp(-decay * t) * (std::cos(swing * t) + decay / swing * std::sin(swing * t))) /
         model.stiffness;
}

TEST(Hand, AnswersAForceAsItsEquationSays) {
  const HandModel model = withoutTremor();
  Hand hand(model);
  for (int i = 1; i <= 1000; ++i) {
    hand.advance(0.001, kNone, {1, 0, -2});
    ASSERT_NEAR(hand.position().x(), answer(model, i * 0.001), 2e-3 / model.stiffness) << i;
    ASSERT_NEAR(hand.position().z(), -2 * hand.position().x(), 1e-12);
  }
}

// The hand is where the muscles want it at the frequency of crossover, to a hundredth.
TEST(Hand, FollowsItsTargetWithoutDelay) {
  constexpr double kCrossover = 3, kPeriod = 0.001;
  Hand hand(withoutTremor());
  std::complex<double> target = 0, position = 0;
  const int turn = static_cast<int>(2 * std::numbers::pi / kCrossover / kPeriod);
  for (int i = 0; i < 6 * turn; ++i) {
    const double t = i * kPeriod, wanted = std::sin(kCrossover * t);
    hand.advance(kPeriod, {wanted, 0, 0}, kNone);
    if (i < turn) continue;
    target += std::polar(1.0, kCrossover * t) * wanted;
    position += std::polar(1.0, kCrossover * t) * hand.position().x();
  }
  EXPECT_NEAR(std::abs(position) / std::abs(target), 1, 0.03);
  EXPECT_LT(std::abs(std::arg(position) - std::arg(target)), 0.01);
}

TEST(Hand, IsStableAtAnyStep) {
  for (const double step : {1e-4, 1e-3, 0.1, 10.0}) {
    Hand hand(withoutTremor());
    hand.restAt({0.1, 0, 0});
    for (int i = 0; i < 1000; ++i) {
      hand.advance(step, kNone, kNone);
      ASSERT_LT(hand.position().norm(), 0.2) << step;
    }
  }
}

// No force is lost between two steps, and none appears.
TEST(Hand, KeepsTheAccountOfEnergy) {
  const HandModel model;
  Hand hand(model);
  double done = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vector3d force{std::sin(0.02 * i), 2, -1}, before = hand.position();
    hand.advance(0.001, {0.05 * std::sin(0.01 * i), 0, 0}, force);
    done += (force + hand.muscles()).dot(hand.position() - before);
    ASSERT_NEAR(done, model.mass / 2 * hand.velocity().squaredNorm(), 1e-9);
  }
}

TEST(Hand, ShakesAsItsTremorSays) {
  const HandModel model;
  const Tremor tremor(model.tremor);
  Hand hand(model);
  double shaken = 0, missed = 0;
  for (int i = 1; i <= 10'000; ++i) {
    hand.advance(0.001, kNone, kNone);
    if (i < 1000) continue;
    const Vector3d wanted = tremor.at(i * 0.001).offset;
    shaken += wanted.squaredNorm();
    missed += (hand.position() - wanted).squaredNorm();
  }
  EXPECT_LT(std::sqrt(missed / shaken), 0.01);
}

TEST(Hand, RestsWhereItIsPut) {
  Hand hand(withoutTremor());
  hand.advance(0.001, {1, 0, 0}, kNone);
  hand.restAt({0, 0.2, 0});
  for (int i = 0; i < 10; ++i) hand.advance(0.001, {0, 0.2, 0}, kNone);
  EXPECT_EQ(hand.position(), Vector3d(0, 0.2, 0));
  EXPECT_EQ(hand.velocity(), kNone);
}

TEST(Hand, RefusesWhatCannotBe) {
  EXPECT_THROW(Hand(HandModel{.mass = 0}), std::invalid_argument);
  EXPECT_THROW(Hand(HandModel{.damping = -1}), std::invalid_argument);
  EXPECT_THROW(Hand(HandModel{.stiffness = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(Hand(HandModel{.tremor = {.amplitude = -1}}), std::invalid_argument);
}

TEST(Hand, NeverAllocatesInACycle) {
  Hand hand(HandModel{});
  const std::uint64_t before = suture::allocations();
  for (int i = 0; i < 1000; ++i) hand.advance(0.001, {0.1, 0, 0}, {1, 1, 1});
  EXPECT_EQ(suture::allocations() - before, 0u);
  EXPECT_GT(hand.position().x(), 0);
}

}  // namespace
}  // namespace robots::test
