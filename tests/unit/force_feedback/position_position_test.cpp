// This is position-position feedback with equal gains over 50 ms each way: the hand gets more
// energy out of it than was put in, unless the passivity controller is there.

#include "force_feedback/position_position.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <stdexcept>
#include <string>

#include "support/allocations.h"
#include "unit/force_feedback/two_arms.h"

namespace robots::test {
namespace {

using Eigen::Vector3d;

constexpr int kDelay = 50;      // cycles of 1 ms
constexpr double kMost = 1e-3;  // J, that may be missing
constexpr double kWall = 0.02;  // m, along x

/// Returns what the hand wants, m, after `t` seconds.
using Wish = Vector3d (*)(double t);

/// Goes in 0.2 s to another place, and stays there.
Vector3d reach(double t) {
  const double s = std::min(t / 0.2, 1.0);
  return s * s * s * (10 - 15 * s + 6 * s * s) * Vector3d(0.05, -0.03, 0.02);
}
/// Goes to and fro, three times a second.
Vector3d sway(double t) {
  return 0.01 * (1 - std::cos(6 * std::numbers::pi * t)) * Vector3d(1, 0.5, -0.7);
}
Vector3d rest(double) { return Vector3d::Zero(); }

/// Tells of the axis that had least, J: what the hand had given to its master, and what it had
/// given to the motors.
struct Outcome {
  double hand, observed;
};

Outcome outcome(Wish wish, const PositionPositionModel& model, int delay, double wall = 1) {
  TwoArms arms(model, delay, wall);
  for (int i = 0; i < 10'000; ++i) arms.cycle(wish(i * TwoArms::kCycle));
  return {arms.lowest(), arms.lowestObserved()};
}

PositionPositionModel with(double stiffness, bool passive) {
  PositionPositionModel model;
  model.gains = {stiffness, stiffness / 100};
  model.port.passive = passive;
  return model;
}

constexpr double kStiffness[] = {300, 500, 1000};

TEST(PositionPosition, GivesTheHandEnergyWithoutTheController) {
  for (const double stiffness : kStiffness) {
    for (const Wish wish : {reach, sway, rest}) {
      const Outcome active = outcome(wish, with(stiffness, false), kDelay);
      EXPECT_LT(active.hand, -100 * kMost) << stiffness;
      EXPECT_LT(active.observed, -100 * kMost) << stiffness;
    }
    EXPECT_LT(outcome(reach, with(stiffness, false), kDelay, kWall).hand, -100 * kMost);
  }
}

TEST(PositionPosition, IsPassiveWithTheController) {
  double lowest = 0;
  for (const double stiffness : kStiffness) {
    for (const Wish wish : {reach, sway, rest}) {
      for (const double wall : {1.0, kWall}) {
        const Outcome passive = outcome(wish, with(stiffness, true), kDelay, wall);
        EXPECT_GT(passive.hand, -kMost) << stiffness;
        EXPECT_GT(passive.observed, -kMost) << stiffness;
        lowest = std::min(lowest, passive.observed);
      }
    }
  }
  RecordProperty("lowest_mJ", std::to_string(1e3 * lowest));
}

// 25 ms each way are 50 ms there and back.
TEST(PositionPosition, IsTheSameOverHalfTheDelay) {
  EXPECT_LT(outcome(sway, with(100, false), kDelay / 2).hand, -10 * kMost);
  EXPECT_GT(outcome(sway, with(100, true), kDelay / 2).hand, -kMost);
}

TEST(PositionPosition, IsPassiveByItselfWithoutADelay) {
  for (const Wish wish : {reach, sway, rest}) {
    EXPECT_GT(outcome(wish, with(300, false), 0).hand, -kMost);
  }
}

/// The controller takes energy out, not the feeling.
TEST(PositionPosition, TheHandFeelsTheSlavesWall) {
  TwoArms arms(with(300, true), kDelay, kWall);
  for (int i = 0; i < 10'000; ++i) arms.cycle(reach(i * TwoArms::kCycle));
  // The springs of wall, coupling and hand stand in a row: 1/2000, 1/300 and 1/400 m/N.
  const double force = (0.05 - kWall) / (1 / 2000.0 + 1 / 300.0 + 1 / 400.0);
  EXPECT_NEAR(0.05 - arms.hand().position().x(), force / 400, 0.001);
  EXPECT_NEAR(arms.hand().position().y(), -0.03, 0.001) << "there is no wall";
}

/// Returns how far, in m, a master swings from its place 8 to 10 s after a hand has let it go with
/// a push. Before that the hand led it to and fro for so many seconds, with a slave in something
/// viscous that took what the hand gave.
double swingAfterLeading(double seconds) {
  constexpr double kStep = 0.001, kRate = std::numbers::pi;  // s; rad/s
  const PositionPositionModel model;
  PositionPosition feedback(model);
  TipMotion master, slave;
  std::deque<TipMotion> toSlave(100), toMaster(100);
  const auto pass = [](std::deque<TipMotion>& link, const TipMotion& motion) {
    link.push_back(motion);
    const TipMotion arrived = link.front();
    link.pop_front();
    return arrived;
  };
  double swing = 0;
  for (int i = 0; i * kStep < seconds + 10; ++i) {
    const double t = i * kStep;
    if (t < seconds) {
      master.position.x() = 0.05 * std::sin(kRate * t);
      master.velocity.x() = 0.05 * kRate * std::cos(kRate * t);
    }
    const TipMotion seen = pass(toMaster, slave), led = pass(toSlave, master);
    const Vector3d push = feedback.force(master, seen, kStep);
    // The slave weighs 1 kg.
    slave.velocity += kStep * (coupling(model.gains, slave, led) - 20 * slave.velocity);
    slave.position += kStep * slave.velocity;
    if (t < seconds) continue;
    master.velocity += kStep * (push - 2 * master.velocity) / 0.9;
    master.position += kStep * master.velocity;
    if (t > seconds + 8) swing = std::max(swing, std::abs(master.position.x()));
  }
  return swing;
}

// The account of a minute once drove a free master to and fro by 16 cm.
TEST(PositionPosition, GivesNothingBackThatFrictionHasTaken) {
  const double afterOneTurn = swingAfterLeading(2);
  EXPECT_LT(afterOneTurn, 0.03);
  EXPECT_NEAR(swingAfterLeading(60), afterOneTurn, 0.005);
}

TEST(PositionPosition, PushesNoHarderThanItsBound) {
  PositionPositionModel model = with(300, false);
  model.port.most_force = 4;
  PositionPosition feedback(model);
  const TipMotion far{.position = {1, -1, 0.01}};
  EXPECT_EQ(feedback.force(TipMotion{}, far, 0.001), Vector3d(4, -4, 3));
}

TEST(PositionPosition, RefusesWhatCannotBe) {
  EXPECT_THROW(PositionPosition({.gains = {-1, 0}}), std::invalid_argument);
  EXPECT_THROW(PositionPosition({.port = {.most_force = std::nan("")}}), std::invalid_argument);
  EXPECT_THROW(PositionPosition({.port = {.mass = -1}}), std::invalid_argument);
}

TEST(PositionPosition, NeverAllocatesInACycle) {
  PositionPosition feedback(PositionPositionModel{});
  const TipMotion master{.velocity = {0.1, 0.1, 0.1}};
  TipMotion slave;
  const std::uint64_t before = suture::allocations();
  for (int i = 0; i < 1000; ++i) {
    slave.position.x() += 1e-4;
    feedback.force(master, slave, 0.001);
  }
  EXPECT_EQ(suture::allocations() - before, 0u);
  EXPECT_NE(feedback.force(master, slave, 0.001), Vector3d::Zero());
}

}  // namespace
}  // namespace robots::test
