// These test the strand's statics, and when it runs through its knot.

#include "strand/strand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace robots {
namespace {

using Eigen::Vector3d;
using Place = Strand::Place;

const Vector3d kLeft{-0.05, 0, 0}, kRight{0.05, 0, 0};

StrandModel weightless() {
  StrandModel model;
  model.gravity.setZero();
  return model;
}

/// Returns a strand whose knot is held, with a pull at each end, which grows for a second and then
/// stays.
Strand pulled(double left, double right) {
  Strand strand(weightless(), kLeft, kRight);
  strand.hold(Place::Knot, Vector3d::Zero());
  for (int i = 1; i <= 2000; ++i) {
    const double share = std::min(i / 1000.0, 1.0);
    strand.pull(Place::Left, Vector3d(-share * left, 0, 0));
    strand.pull(Place::Right, Vector3d(share * right, 0, 0));
    strand.advance(0.001);
  }
  return strand;
}

TEST(Strand, HangsByItsWeight) {
  const StrandModel model;
  Strand strand(model, kLeft, kRight);
  strand.advance(3);
  EXPECT_NEAR(strand.knot().x(), 0, 1e-4);
  // Two straight sides from 100 mm apart would reach as deep; links that sag, a little less.
  const double deepest = -std::sqrt(0.055 * 0.055 - 0.05 * 0.05);
  EXPECT_GT(strand.knot().z(), deepest - 1e-4);
  EXPECT_LT(strand.knot().z(), 0.9 * deepest);
  // Both sides carry the knot.
  const Vector3d up = (strand.nodes().col(Strand::kKnot + 1) - strand.knot()).normalized();
  EXPECT_NEAR(2 * strand.rightTension() * up.z(), 9.81 * (model.knot_mass + model.mass / 61), 1e-3);
}

TEST(Strand, BearsWhatIsPulledAtItsEnds) {
  const Strand strand = pulled(0.3, 0.2);
  EXPECT_NEAR(strand.leftTension(), 0.3, 1e-3);
  EXPECT_NEAR(strand.rightTension(), 0.2, 1e-3);
}

TEST(Strand, EqualPullsDoNotDrawItThrough) {
  for (const double force : {0.01, 0.1, 1.0, 3.0}) {
    EXPECT_NEAR(pulled(force, force).leftLength(), 0.055, 1e-9) << force << " N";
  }
}

// The law of the capstan is T1 / T2 = exp(mu phi), and holds here within 2 %.
TEST(Strand, RunsThroughItsKnotBeyondTheRatio) {
  const double ratio = std::exp(0.15 * 9.42), weak = 0.1;
  EXPECT_NEAR(pulled(0.98 * ratio * weak, weak).leftLength(), 0.055, 1e-6);
  EXPECT_GT(pulled(1.02 * ratio * weak, weak).leftLength(), 0.055 + 1e-4);
  EXPECT_NEAR(pulled(weak, 0.98 * ratio * weak).leftLength(), 0.055, 1e-6);
  EXPECT_LT(pulled(weak, 1.02 * ratio * weak).leftLength(), 0.055 - 1e-4);
}

TEST(Strand, FollowsItsTipsWithoutStretching) {
  Strand strand(StrandModel{}, kLeft, kRight);
  strand.advance(1);
  const Vector3d before = strand.knot();
  for (int i = 1; i <= 1000; ++i) {
    const Vector3d moved(0, 1e-5 * i, 2e-5 * i);
    strand.hold(Place::Left, kLeft + moved);
    strand.hold(Place::Right, kRight + moved);
    strand.advance(0.001);
  }
  strand.advance(1);
  EXPECT_TRUE((strand.knot() - before).isApprox(Vector3d(0, 0.01, 0.02), 1e-2));
  double length = 0;
  for (int i = 1; i < Strand::kNodes; ++i) {
    length += (strand.nodes().col(i) - strand.nodes().col(i - 1)).norm();
  }
  EXPECT_NEAR(length, 0.11, 1e-4);
}

TEST(Strand, MayHaveTwoNodesInOnePlace) {
  Strand strand(weightless(), kLeft, kRight);
  strand.hold(Place::Left, strand.nodes().col(1));
  strand.advance(0.5);
  EXPECT_TRUE(strand.nodes().allFinite());
}

TEST(Strand, LiesOnTheTissue) {
  StrandModel model;
  model.tissue = -0.01;
  Strand strand(model, kLeft, kRight);
  strand.advance(2);
  EXPECT_DOUBLE_EQ(strand.knot().z(), -0.01);
}

}  // namespace
}  // namespace robots
