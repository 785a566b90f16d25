// These tests say what the fixtures permit, and that they never move an arm by themselves.

#include "guidance/fixtures.h"

#include <gtest/gtest.h>

#include <Eigen/QR>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>

namespace robots {
namespace {

using Eigen::Vector3d;

constexpr double kCycle = 0.001;  // s

FixtureModel model() {
  FixtureModel model;
  model.target = {0.01, -0.02, -0.15};
  model.approach = {0, 0, -2};
  model.tissue = -0.16;
  return model;
}

/// Wishes for steps of any direction and any size.
class WildHand {
 public:
  /// `size` is the standard deviation of its steps along each axis, in m.
  WildHand(unsigned seed, double size) : random_(seed), step_(0, size) {}
  Vector3d operator()() { return {step_(random_), step_(random_), step_(random_)}; }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> step_;
};

/// The tips are 80 mm apart, and the knot is 20 mm below their mean.
class Fixtures : public testing::Test {
 protected:
  /// Puts the knot `ahead` m before the target, and beside the line by `aside`.
  void place(double ahead, const Vector3d& aside) {
    knot_ = model().target + aside + Vector3d(0, 0, ahead);
    tips_ = {knot_ + Vector3d(-0.04, 0, 0.02), knot_ + Vector3d(0.04, 0, 0.02)};
  }
  /// Runs `cycles` in which both hands move by `wish`. The knot goes with the tips.
  void carry(const Vector3d& wish, int cycles) {
    for (int i = 0; i < cycles; ++i) knot_ += move({wish, wish}).mean();
  }
  /// Runs one cycle; the knot stays.
  TipPair move(const TipPair& desired) {
    const TipPair step = fixtures_.constrain(tips_, knot_, desired, kCycle);
    tips_.left += step.left;
    tips_.right += step.right;
    return step;
  }

  /// Returns how far the knot is outside the corridor, m; below zero within it.
  double outOfCorridor() const {
    return fixtures_.lateralError(knot_) - model().radius -
           model().slope * fixtures_.distanceToTarget(knot_);
  }

  KnotFixtures fixtures_{model()};
  TipPair tips_;
  Vector3d knot_;
};

TEST_F(Fixtures, APermittedWishIsObeyedExactly) {
  place(0.02, Vector3d::Zero());
  const TipPair wish{{1e-5, 0, -2e-5}, {-1e-5, 2e-6, -1e-5}};
  const TipPair step = fixtures_.constrain(tips_, knot_, wish, kCycle);
  EXPECT_TRUE(step.left.isApprox(wish.left, 1e-12));
  EXPECT_TRUE(step.right.isApprox(wish.right, 1e-12));
}

TEST_F(Fixtures, TheCorridorLeadsToTheTarget) {
  for (const Vector3d& aside :
       {Vector3d(0.003, 0, 0), Vector3d(0, -0.003, 0), Vector3d(-0.002, 0.002, 0)}) {
    place(0.02, aside);
    carry({0, 0, -3e-5}, 20'000);
    EXPECT_NEAR(fixtures_.distanceToTarget(knot_), 0, 1e-4);
    EXPECT_LE(fixtures_.lateralError(knot_), model().radius * 1.1)
        << "the corner of a plane is a little wider";
  }
}

TEST_F(Fixtures, TheTargetIsNotPassed) {
  place(0.005, Vector3d::Zero());
  carry({0, 0, -1e-4}, 20'000);
  EXPECT_GE(fixtures_.distanceToTarget(knot_), -1e-9);
  EXPECT_LE(fixtures_.distanceToTarget(knot_), 1e-4) << "it does not get there";
}

TEST_F(Fixtures, AHandAsideKeepsTheKnotInside) {
  place(0.01, Vector3d::Zero());
  const double width = model().radius + model().slope * 0.01;
  carry({1e-4, 1e-4, 0}, 1000);
  EXPECT_LE(outOfCorridor(), 0.1 * width) << "the corner of a plane is a little wider";
  EXPECT_GE(outOfCorridor(), -1e-9) << "it stops before the edge";
}

TEST_F(Fixtures, OnlyTheOperatorMovesTheKnot) {
  place(0.01, {0.02, 0, 0});  // far out of the corridor
  const Vector3d none = Vector3d::Zero();
  const TipPair step = fixtures_.constrain(tips_, knot_, {none, none}, kCycle);
  EXPECT_EQ(step.left, Vector3d::Zero());
  EXPECT_EQ(step.right, Vector3d::Zero());
}

// The knot goes with the mean of the tips, so either tip could bring it back to the corridor.
TEST_F(Fixtures, ARestingHandHoldsItsTip) {
  const Vector3d none = Vector3d::Zero();
  for (const Vector3d& wish :
       {Vector3d(1e-4, 0, 0), Vector3d(0, 0, -1e-4), Vector3d(1e-5, 0, 2e-5)}) {
    place(0.01, Vector3d::Zero());
    for (int i = 0; i < 1000; ++i) EXPECT_LE(move({wish, none}).right.norm(), 1e-15);
    for (int i = 0; i < 1000; ++i) EXPECT_LE(move({none, wish}).left.norm(), 1e-15);
  }
}

TEST_F(Fixtures, NoTipGoesAgainstItsHand) {
  WildHand hand(7, 1e-4);
  place(0.02, Vector3d::Zero());
  for (int i = 0; i < 20'000; ++i) {
    const TipPair wish{hand(), hand()}, step = move(wish);
    knot_ += step.mean();
    for (const auto& [wished, made] : {std::pair{wish.left, step.left}, {wish.right, step.right}}) {
      ASSERT_GE(wished.dot(made), -1e-15) << "in cycle " << i;
      ASSERT_LE(made.cwiseAbs().maxCoeff(), wished.norm() + 1e-12) << "in cycle " << i;
    }
  }
}

TEST_F(Fixtures, AKnotOutsideOnlyComesBack) {
  place(0.01, {0.02, 0, 0});
  const double before = outOfCorridor();
  carry({1e-5, 0, 0}, 1000);
  EXPECT_NEAR(outOfCorridor(), before, 1e-9);
  carry({-1e-5, 0, 0}, 1000);
  EXPECT_NEAR(outOfCorridor(), before - 0.01, 1e-6);
}

TEST_F(Fixtures, TwoMeetingTipsStop) {
  place(0.02, Vector3d::Zero());
  for (int i = 0; i < 3000; ++i) move({{1e-4, 0, 0}, {-1e-4, 0, 0}});
  EXPECT_NEAR((tips_.left - tips_.right).norm(), model().separation, 1e-6);
}

TEST_F(Fixtures, ATipStopsAtTheTissue) {
  place(0.02, Vector3d::Zero());
  for (int i = 0; i < 3000; ++i) move({{0, 0, -1e-4}, Vector3d::Zero()});
  EXPECT_NEAR(tips_.left.z(), model().tissue, 1e-6);
  for (int i = 0; i < 3000; ++i) move({Vector3d::Zero(), {0, 0, -1e-4}});
  EXPECT_NEAR(tips_.right.z(), model().tissue, 1e-6);
}

// Whatever the hands do, each step keeps all bounds; the test looks at where it leads, and does not
// believe the solver. No step at all would hide a failure of the solver, so there must be one.
TEST_F(Fixtures, HoldForRandomWishes) {
  WildHand hand(3, 3e-4);
  place(0.02, Vector3d::Zero());
  for (int i = 0; i < 20'000; ++i) {
    const TipPair step = move({hand(), hand()});
    ASSERT_GT(step.left.norm() + step.right.norm(), 0) << "in cycle " << i;
    ASSERT_LE(std::max(step.left.cwiseAbs().maxCoeff(), step.right.cwiseAbs().maxCoeff()),
              model().speed * kCycle + 1e-12);
    knot_ += step.mean();
    ASSERT_GE((tips_.left - tips_.right).norm(), model().separation - 1e-9);
    ASSERT_GE(std::min(tips_.left.z(), tips_.right.z()), model().tissue - 1e-9);
    ASSERT_GE(fixtures_.distanceToTarget(knot_), -1e-9);
    const double ahead = fixtures_.distanceToTarget(knot_);
    ASSERT_LE(fixtures_.lateralError(knot_), (model().radius + model().slope * ahead) * 1.1);
  }
}

TEST_F(Fixtures, NoJointGoesFartherThanItsRoom) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto any = [&] { return uniform(random); };
  place(0.02, Vector3d::Zero());
  const auto room = [&] {
    JointRoom one;
    one.motion = one.motion.unaryExpr([&](double) { return 10 * any(); });
    one.least.setConstant(-2e-4);
    one.most.setConstant(3e-4);
    one.most[1] = -1e-4;  // it is beyond its limit, and must not be driven back
    return one;
  };
  for (int i = 0; i < 1000; ++i) {
    const RoomPair rooms{room(), room()};
    const Vector3d left = 1e-4 * Vector3d(any(), any(), any());
    const TipPair step = fixtures_.constrain(tips_, knot_, {left, -left}, kCycle, rooms);
    for (const auto& [one, by] : {std::pair{rooms.left, step.left}, {rooms.right, step.right}}) {
      const TipJoints joints = one.motion * by;
      ASSERT_TRUE((joints.array() >= one.least.array() - 1e-9).all()) << joints.transpose();
      ASSERT_TRUE((joints.array() <= one.most.cwiseMax(0).array() + 1e-9).all())
          << joints.transpose();
    }
    ASSERT_GT(step.left.norm(), 0);
  }
}

/// Returns the ratio of the tensions on both sides of a knot that resists along -z, which they bear
/// together.
double ratioOfTensions(const TipPair& tips, const Vector3d& knot) {
  Eigen::Matrix<double, 3, 2> sides;
  sides << (tips.left - knot).normalized(), (tips.right - knot).normalized();
  const Eigen::Vector2d tensions = sides.colPivHouseholderQr().solve(Vector3d::UnitZ());
  return tensions[0] / tensions[1];
}

/// Draws one tip up above the knot and lets the other go down, as far as the fixtures permit, and
/// returns the largest ratio of the tensions.
double steepest(double holding, double left, double right) {
  KnotFixtures fixtures({.target = {0, 0, -1}, .radius = 1, .slope = 1, .holding = holding});
  TipPair tips{{-0.03, 0, 0.03}, {0.03, 0, 0.03}};
  Vector3d knot = Vector3d::Zero();
  double most = 1;
  for (int i = 0; i < 2500; ++i) {
    const TipPair wish{{1e-5 * std::max(left, 0.0), 0, 1e-5 * left},
                       {-1e-5 * std::max(right, 0.0), 0, 1e-5 * right}};
    const TipPair step = fixtures.constrain(tips, knot, wish, kCycle);
    tips.left += step.left;
    tips.right += step.right;
    knot += step.mean();
    const double ratio = ratioOfTensions(tips, knot);
    most = std::max({most, ratio, 1 / ratio});
  }
  return most;
}

TEST(SlidingCone, BoundsTheRatioOfTheTensions) {
  constexpr double kHolding = 2, kNone = std::numeric_limits<double>::infinity();
  for (const double sign : {1.0, -1.0}) {
    EXPECT_GT(steepest(kNone, sign, -sign), 3);
    EXPECT_NEAR(steepest(kHolding, sign, -sign), kHolding, 0.01);
  }
}

// A hand whose place is unknown must move nothing.
TEST_F(Fixtures, AnInfiniteWishMovesNothing) {
  place(0.01, Vector3d::Zero());
  const Vector3d wild(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const TipPair step = fixtures_.constrain(tips_, knot_, {wild, {0, 0, 1e-5}}, kCycle);
  EXPECT_EQ(step.left, Vector3d::Zero());
  EXPECT_EQ(step.right, Vector3d::Zero());
}

}  // namespace
}  // namespace robots
