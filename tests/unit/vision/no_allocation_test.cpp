// Strand, tracking and fixtures never touch the heap in a cycle once they have their memory.
// Drawing and seeing do, in OpenGL and OpenCV: no control loop calls them.

#include <gtest/gtest.h>

#include <chrono>

#include "guidance/fixtures.h"
#include "guidance/knot_estimate.h"
#include "strand/strand.h"
#include "support/allocations.h"
#include "vision/tracking_filter.h"

namespace robots {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;

TEST(PlacingAKnot, NeverAllocatesInACycle) {
  TipPair tips{{-0.04, 0, -0.08}, {0.04, 0, -0.08}};
  Strand strand(StrandModel{}, tips.left, tips.right);
  KnotEstimate estimate(250ms, 1ms);
  TrackingFilter filter(0.1);
  KnotFixtures fixtures{FixtureModel{.target = {0, 0, -0.15}}};
  suture::Time now{1s};
  int seen = 0;
  const auto cycle = [&] {
    strand.hold(Strand::Place::Left, tips.left);
    strand.hold(Strand::Place::Right, tips.right);
    strand.advance(0.001);
    filter.seenAt(now, strand.knot(), Vector3d::Constant(1e-4));
    estimate.tipsAt(now, tips.mean());
    estimate.seenAt(now, filter.placeAt(now));
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
