// The judge accepts a knot that was placed, and sees each way of failing.
//
// The run is made here, not by the components: a knot that comes to its target within four seconds
// and stays there, and cameras that see it well, but late.

#include "recorder/knot_judge.h"

#include <gtest/gtest.h>
#include <suture/base/time.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "arm_control/motion/smooth_step.h"

namespace robots::test {
namespace {

using Eigen::Vector3d;
using Sentences = std::vector<std::string>;

const Vector3d kKnotTarget{0.004, -0.003, -0.152};
constexpr double kPlacing = 4;  // s that the knot is on its way
constexpr int kKnotRows = 300;
constexpr double kRowsASecond = 50;
// This is so late that the knot is farther away by then than the judge allows a sighting to be; and
// it is no multiple of the rows' distance.
constexpr double kLate = 0.13;  // s

struct KnotFaults {
  double way = 0.03;          // m that the knot comes nearer
  double aside = 0;           // m from the target, where the knot stays
  double sightingsAside = 0;  // m from the truth
  int unseenOfTen = 0;        // so many rows of ten in turn have no sighting
  double guidedFrom = 0;      // s
  double guidedTo = kKnotRows / kRowsASecond;
};

suture::Time knotTime(double seconds) {
  return suture::fromNanoseconds(1'000'000'000 + static_cast<std::int64_t>(seconds * 1e9));
}

Vector3d knotOf(const KnotFaults& faults, double seconds) {
  const double left = faults.way * (1 - smoothStep(seconds / kPlacing));
  return kKnotTarget + Vector3d(faults.aside, 0, left);
}

/// Looks down at the scene, a little askew.
Eigen::Isometry3d cameraOfKnot() {
  Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
  camera.translation() = Vector3d(0.01, 0.02, -0.04);
  camera.linear() = Eigen::AngleAxisd(3, Vector3d(5, 1, 0).normalized()).toRotationMatrix();
  return camera;
}

KnotRow knotRow(const KnotFaults& faults, int number) {
  const double seconds = number / kRowsASecond;
  KnotRow row;
  row.strand.stamp = knotTime(seconds);
  row.strand.nodes.col(Strand::kKnot) = knotOf(faults, seconds);
  row.strand.valid = true;
  row.camera = cameraOfKnot();
  row.sighting.stamp = knotTime(seconds - kLate);
  row.sighting.knot = row.camera.inverse() * knotOf(faults, seconds - kLate) +
                      Vector3d(0, 0, faults.sightingsAside);
  row.sighting.valid = number % 10 >= faults.unseenOfTen;
  row.guiding = seconds >= faults.guidedFrom && seconds < faults.guidedTo;
  return row;
}

KnotJudgement judgedKnot(const KnotFaults& faults) {
  std::vector<KnotRow> rows;
  for (int number = 0; number < kKnotRows; ++number) rows.push_back(knotRow(faults, number));
  return judgeKnot(rows, kKnotTarget);
}

TEST(KnotJudge, FindsNoFaultInAPlacedKnot) {
  const KnotJudgement judgement = judgedKnot({});
  EXPECT_EQ(violations(judgement), Sentences{});
  EXPECT_NEAR(judgement.start, 0.03, 1e-9);
  EXPECT_LT(judgement.error, 1e-9);
  EXPECT_EQ(judgement.sighted, 1);
  EXPECT_LT(judgement.sighting_error, 1e-5) << "a sighting was held against another moment's truth";
  EXPECT_NEAR(judgement.guided_at_end, 1, 1e-9);
  EXPECT_EQ(judgement.rows, std::size_t{kKnotRows});
}

TEST(KnotJudge, SeesAKnotTwoMillimetresOff) {
  EXPECT_EQ(violations(judgedKnot({.aside = 0.002})),
            Sentences{"the knot ended 2.00 mm from its target, at most 1.00 mm allowed"});
}

TEST(KnotJudge, SeesAKnotFromTheBeginning) {
  EXPECT_EQ(violations(judgedKnot({.way = 0.005})),
            Sentences{"the knot came 5.0 mm nearer to its target, at least 10.0 mm wanted"});
}

TEST(KnotJudge, SeesSightingsThatAreFiveMillimetresOff) {
  EXPECT_EQ(violations(judgedKnot({.sightingsAside = 0.005})),
            Sentences{"the cameras saw the knot 5.00 mm from the truth at p99, at most 1.00 mm "
                      "allowed"});
}

TEST(KnotJudge, SeesAKnotThatWasOftenUnseen) {
  EXPECT_EQ(violations(judgedKnot({.unseenOfTen = 5})),
            Sentences{"the cameras saw the knot 50 % of the guided time, at least 90 % wanted"});
}

TEST(KnotJudge, SeesAKnotUnguidedAtTheEnd) {
  EXPECT_EQ(violations(judgedKnot({.guidedTo = 5})),
            Sentences{"the knot was guided for 0 % of the last half second, at least 50 % wanted"});
}

TEST(KnotJudge, ToleratesAGuideThatEndsFirst) {
  EXPECT_EQ(violations(judgedKnot({.guidedTo = 5.9})), Sentences{});
}

/// Judges a knot that was placed, if each row is changed by `change`. Its tips are 50 mm above the
/// tissue, and 60 mm apart.
KnotJudgement judgedWithin(const std::function<void(KnotRow&)>& change) {
  std::vector<KnotRow> rows;
  for (int number = 0; number < kKnotRows; ++number) {
    KnotRow& row = rows.emplace_back(knotRow({}, number));
    row.tissue = -0.16;
    row.strand.nodes.leftCols<1>() = Vector3d(-0.03, 0, -0.11);
    row.strand.nodes.rightCols<1>() = Vector3d(0.03, 0, -0.11);
    change(row);
  }
  return judgeKnot(rows, kKnotTarget,
                   KnotBounds{.radius = 0.0003, .slope = 0.3, .separation = 0.01});
}

Sentences wrongWithin(const std::function<void(KnotRow&)>& change) {
  return violations(judgedWithin(change));
}

/// Returns true for one moment in the middle of the way.
bool isMidway(const KnotRow& row) { return row.strand.stamp == knotTime(2); }

TEST(KnotJudge, AcceptsWhatTheFixturesPermit) {
  EXPECT_EQ(wrongWithin([](KnotRow&) {}), Sentences{});
  EXPECT_EQ(wrongWithin([](KnotRow& row) {
              if (isMidway(row)) row.strand.nodes(0, Strand::kKnot) += 0.005;
            }),
            Sentences{})
      << "15 mm before the target the corridor is that wide";
}

TEST(KnotJudge, FindsAKnotThatLeavesItsCorridor) {
  EXPECT_EQ(wrongWithin([](KnotRow& row) {
              if (isMidway(row)) row.strand.nodes(0, Strand::kKnot) += 0.01;
            }),
            Sentences{"the knot was 4.80 mm outside of its corridor, at most 2.00 mm allowed"});
}

TEST(KnotJudge, SeesAKnotThatPassesItsTarget) {
  EXPECT_EQ(wrongWithin([](KnotRow& row) {
              if (isMidway(row)) row.strand.nodes(2, Strand::kKnot) = kKnotTarget.z() - 0.003;
            }),
            Sentences{"the knot was 3.00 mm outside of its corridor, at most 2.00 mm allowed"});
}

/// Fixtures move nothing back, but let it go no farther out.
TEST(KnotJudge, ExcusesAKnotThatBeganOutside) {
  const KnotJudgement judgement = judgedWithin([](KnotRow& row) {
    const double left = 1 - (row.strand.stamp - knotTime(0)) / std::chrono::duration<double>(2);
    row.strand.nodes(0, Strand::kKnot) += std::max(left, 0.0) * 0.018;
  });
  EXPECT_EQ(*judgement.outside, 0);
}

TEST(KnotJudge, FindsTipsThatTouch) {
  EXPECT_EQ(wrongWithin([](KnotRow& row) {
              if (isMidway(row)) row.strand.nodes(2, Strand::kNodes - 1) = -0.165;
            }),
            Sentences{"a tip was 5.00 mm deep in the tissue, at most 2.00 mm allowed"});
  EXPECT_EQ(wrongWithin([](KnotRow& row) {
              if (isMidway(row)) row.strand.nodes(0, Strand::kNodes - 1) = -0.029;
            }),
            Sentences{"the tips were 9.00 mm too near, at most 2.00 mm allowed"});
}

TEST(KnotJudge, CountsFromWhenGuidingBegan) {
  const KnotJudgement judgement = judgedKnot({.guidedFrom = 2});
  EXPECT_NEAR(judgement.start, 0.015, 1e-9) << "half of the way was left";
  EXPECT_EQ(judgement.rows, 200u);
}

TEST(KnotJudge, NamesOnlyThatNobodyGuided) {
  const Sentences never{"the knot was never guided"};
  EXPECT_EQ(violations(judgeKnot({}, kKnotTarget)), never) << "there are no rows";
  EXPECT_EQ(violations(judgedKnot({.aside = 0.002, .guidedTo = 0})), never);
}

}  // namespace
}  // namespace robots::test
