// These sample planned motions densely, from random starts.

#include "arm_control/motion/joint_move.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace robots::test {
namespace {

using Move = JointMove<3>;
using Triple = Move::Joints;

const Move::Limits kLimits{Triple(4, 2, 0.4), Triple(40, 10, 4)};

class RandomMoves : public testing::Test {
 protected:
  static constexpr int kMoves = 10000;
  static constexpr int kSamples = 200;  // each move is looked at so often

  Triple any(const Triple& most) {
    Triple value;
    for (int i = 0; i < 3; ++i) value[i] = most[i] * uniform_(random_);
    return value;
  }
  Move anyMove() {
    start_ = {any({1, 1, 0.1}), any(kLimits.rate)};
    goal_ = start_.position + std::pow(10, 2 * uniform_(random_) - 2) * any({2, 2, 0.2});
    return {start_, goal_, kLimits};
  }

  std::mt19937 random_{16};
  std::uniform_real_distribution<double> uniform_{-1, 1};
  Move::Start start_;
  Triple goal_;
};

TEST_F(RandomMoves, BeginAtJointsAndRestAtGoals) {
  for (int n = 0; n < kMoves; ++n) {
    const Move move = anyMove();
    constexpr double kStep = 1e-6;
    ASSERT_TRUE(move.at(0).isApprox(start_.position, 1e-12));
    const Triple velocity = (move.at(kStep) - move.at(0)) / kStep;
    ASSERT_LT((velocity - start_.velocity).cwiseAbs().maxCoeff(), 1e-4) << n;
    ASSERT_EQ(move.at(move.duration()), goal_);
    const Triple last = move.at(move.duration() - kStep);
    ASSERT_LT((goal_ - last).cwiseAbs().maxCoeff() / kStep, 1e-4) << n;
  }
}

TEST_F(RandomMoves, KeepTheLimitsOfVelocityAndAcceleration) {
  for (int n = 0; n < kMoves; ++n) {
    const Move move = anyMove();
    const double dt = move.duration() / kSamples;
    for (int i = 1; i < kSamples; ++i) {
      const Triple before = move.at((i - 1) * dt), now = move.at(i * dt),
                   then = move.at((i + 1) * dt);
      const Triple velocity = (then - now) / dt,
                   acceleration = (then - 2 * now + before) / (dt * dt);
      ASSERT_LE((velocity.cwiseAbs() - kLimits.rate).maxCoeff(), 1e-9) << n << " " << i;
      ASSERT_LE((acceleration.cwiseAbs() - kLimits.acceleration).maxCoeff(), 1e-6) << n << " " << i;
    }
  }
}

// Each joint has at least the room that it needs, and often less than half of the deceleration
// does.
TEST_F(RandomMoves, KeepTheLimitsOfPositionToo) {
  Move::Limits limits = kLimits;
  for (int n = 0; n < kMoves; ++n) {
    start_ = {any({1, 1, 0.1}), any(kLimits.rate)};
    const Triple speed = start_.velocity.cwiseAbs();
    const Triple stop = 0.5 * speed.cwiseProduct(speed).cwiseQuotient(limits.acceleration);
    limits.upper = start_.position + (1.5 + 0.5 * uniform_(random_)) * stop;
    limits.lower = start_.position - (1.5 + 0.5 * uniform_(random_)) * stop;
    goal_ = limits.lower + std::abs(uniform_(random_)) * (limits.upper - limits.lower);
    const Move move(start_, goal_, limits);
    const double dt = move.duration() / kSamples;
    for (int i = 1; i < kSamples; ++i) {
      const Triple before = move.at((i - 1) * dt), now = move.at(i * dt),
                   then = move.at((i + 1) * dt);
      const Triple acceleration = (then - 2 * now + before) / (dt * dt);
      ASSERT_LE((acceleration.cwiseAbs() - limits.acceleration).maxCoeff(), 1e-6) << n << " " << i;
      ASSERT_LE((now - limits.upper).maxCoeff(), 1e-12) << n << " " << i;
      ASSERT_LE((limits.lower - now).maxCoeff(), 1e-12) << n << " " << i;
    }
    ASSERT_EQ(move.at(move.duration()), goal_);
  }
}

TEST(JointMove, BrakesHarderOnlyForTheLimit) {
  Move::Limits limits = kLimits;
  limits.upper = Triple(0.1, 0, 1);
  const Move move({Triple::Zero(), {4, 2, 0}}, {0, -1, 0}, limits);
  double farthest = 0;
  for (double t = 0; t < move.duration(); t += 1e-3) {
    EXPECT_LE(move.at(t)[1], 0) << "it has no room";
    farthest = std::max(farthest, move.at(t)[0]);
  }
  EXPECT_NEAR(farthest, 0.1, 1e-12) << "full deceleration would take 0.2";
}

TEST_F(RandomMoves, TurnRoundAtMostOnce) {
  for (int n = 0; n < kMoves; ++n) {
    const Move move = anyMove();
    const double dt = move.duration() / kSamples;
    Triple lastStep = Triple::Zero();
    Eigen::Vector3i turns = Eigen::Vector3i::Zero();
    for (int i = 0; i < kSamples; ++i) {
      const Triple now = move.at(i * dt), then = move.at((i + 1) * dt), step = then - now;
      for (int j = 0; j < 3; ++j) {
        if (std::abs(step[j]) < 1e-12) continue;
        if (step[j] * lastStep[j] < 0) ++turns[j];
        lastStep[j] = step[j];
        if (i < kSamples / 2) continue;
        ASSERT_LE(std::abs(goal_[j] - then[j]), std::abs(goal_[j] - now[j]) + 1e-12) << n;
      }
    }
    ASSERT_LE(turns.maxCoeff(), 1) << n;
  }
}

TEST_F(RandomMoves, AreStraightFromRest) {
  for (int n = 0; n < 100; ++n) {
    start_ = {any({1, 1, 0.1})};
    const Triple way = any({2, 2, 0.2});
    const Move move(start_, start_.position + way, kLimits);
    for (int i = 0; i <= kSamples; ++i) {
      const Triple gone = move.at(move.duration() * i / kSamples) - start_.position;
      ASSERT_LT((gone - gone[0] / way[0] * way).norm(), 1e-12);
    }
  }
}

TEST(JointMove, TakesTheSlowestJointsTime) {
  const Move::Start rest{Triple::Zero()};
  EXPECT_NEAR(Move(rest, {0, 1, 0}, kLimits).duration(), 1.875, 1e-9) << "its rate: half of 2";
  EXPECT_NEAR(Move(rest, {0, 0.01, 0}, kLimits).duration(), std::sqrt(0.001 * 10 / std::sqrt(3)),
              1e-9)
      << "its acceleration";
  EXPECT_NEAR(Move(rest, {0, 1, 0}, kLimits, {.velocity = 0.5}).duration(), 3.75, 1e-9);
  EXPECT_NEAR(Move(rest, {0, 0.01, 0}, kLimits, {.acceleration = 0.25}).duration(),
              2 * std::sqrt(0.001 * 10 / std::sqrt(3)), 1e-9);
}

TEST(JointMove, BrakesAtOnceWithoutAnAccelerationLimit) {
  const Move move({Triple::Zero(), {1, 1, 0.1}}, {0, 0, 0}, {kLimits.rate});
  EXPECT_TRUE(move.at(0.01).isZero());
}

}  // namespace
}  // namespace robots::test
