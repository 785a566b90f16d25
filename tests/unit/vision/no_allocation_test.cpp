// What cameras, strand and fixtures do in a cycle never touches the heap once it has its memory.

#include <gtest/gtest.h>

#include <chrono>
#include <numbers>

#include "guidance/fixtures.h"
#include "guidance/knot_estimate.h"
#include "strand/strand.h"
#include "support/allocations.h"
#include "vision/detector.h"
#include "vision/painter.h"

namespace robots {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;

TEST(PlacingAKnot, NeverAllocatesInACycle) {
  if (!suture::countsAllocations()) GTEST_SKIP() << "a sanitizer needs malloc for itself";
  const CameraPair cameras;
  const Eigen::Isometry3d camera(Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitX()));
  TipPair tips{{-0.04, 0, -0.08}, {0.04, 0, -0.08}};
  Strand strand(StrandModel{}, tips.left, tips.right);
  Painter painter(cameras, 3);
  KnotEstimate estimate(250ms, 1ms);
  KnotFixtures fixtures{FixtureModel{.target = {0, 0, -0.15}}};
  ImageFrame left, right;
  suture::Time now{1s};
  int seen = 0;
  const auto cycle = [&] {
    strand.hold(Strand::Place::Left, tips.left);
    strand.hold(Strand::Place::Right, tips.right);
    strand.advance(0.001);
    painter.paint(Eye::Left, camera * strand.nodes(), left);
    painter.paint(Eye::Right, camera * strand.nodes(), right);
    const MarkerPoints points = locate(cameras, detect(left), detect(right));
    estimate.tipsAt(now, tips.mean());
    if (const auto& knot = points[static_cast<std::size_t>(Marker::Knot)]) {
      estimate.seenAt(now, camera * *knot);
    }
    if (const auto knot = estimate.knot(now)) {
      const TipPair step =
          fixtures.constrain(tips, *knot, {{0, 0, -2e-4}, {1e-4, 0, -2e-4}}, 0.001);
      tips.left += step.left;
      tips.right += step.right;
      ++seen;
    }
    now += 1ms;
  };
  cycle();
  const std::uint64_t before = suture::allocations();
  for (int i = 0; i < 30; ++i) cycle();
  EXPECT_EQ(suture::allocations() - before, 0u);
  EXPECT_EQ(seen, 31) << "a cycle that does nothing proves nothing";
}

}  // namespace
}  // namespace robots
