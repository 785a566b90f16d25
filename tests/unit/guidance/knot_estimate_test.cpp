// These give the estimate late and noisy sightings of a knot that moves with the tips.

#include "guidance/knot_estimate.h"

#include <gtest/gtest.h>

#include <chrono>
#include <random>

namespace robots {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;

const Vector3d kOffset{0, 0, -0.02};
constexpr suture::Duration kAge = 250ms;

Vector3d tipsAt(suture::Time time) {
  return {0, 0, -0.01 * std::chrono::duration<double>(time.time_since_epoch()).count()};
}

TEST(KnotEstimate, AnOldImageLosesNoAccuracy) {
  KnotEstimate estimate(kAge, 1ms);
  suture::Time now{1s};
  for (int i = 0; i < 500; ++i, now += 1ms) {
    estimate.tipsAt(now, tipsAt(now));
    // This image was exposed 80 ms ago. The tips have moved by 0.8 mm since.
    if (i >= 80 && i % 66 == 0) estimate.seenAt(now - 80ms, tipsAt(now - 80ms) + kOffset);
  }
  now -= 1ms;
  const auto knot = estimate.knot(now);
  ASSERT_TRUE(knot);
  EXPECT_TRUE(knot->isApprox(tipsAt(now) + kOffset, 1e-9));
}

TEST(KnotEstimate, NoiseIsMoreThanHalved) {
  KnotEstimate estimate(kAge, 1ms);
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.0003);
  double squares = 0;
  suture::Time now{1s};
  for (int i = 0; i < 2000; ++i, now += 66ms) {
    estimate.tipsAt(now, Vector3d::Zero());
    estimate.seenAt(now, kOffset + Vector3d(0, 0, noise(random)));
    squares += (*estimate.knot(now) - kOffset).squaredNorm();
  }
  EXPECT_LT(std::sqrt(squares / 2000), 0.0003 / 2.5);
}

TEST(KnotEstimate, ATooOldSightingIsNone) {
  KnotEstimate estimate(kAge, 1ms);
  const suture::Time now{1s};
  EXPECT_FALSE(estimate.knot(now));
  estimate.seenAt(now, kOffset);
  EXPECT_FALSE(estimate.knot(now)) << "nobody knows where the tips were";
  estimate.tipsAt(now, Vector3d::Zero());
  estimate.seenAt(now, kOffset);
  EXPECT_TRUE(estimate.knot(now + kAge));
  EXPECT_FALSE(estimate.knot(now + kAge + 1ms));
  estimate.forget();
  EXPECT_FALSE(estimate.knot(now));
}

TEST(KnotEstimate, ASightingAfterBlindnessCountsAlone) {
  KnotEstimate estimate(kAge, 1ms);
  suture::Time now{1s};
  estimate.tipsAt(now, Vector3d::Zero());
  estimate.seenAt(now, kOffset);
  now += 1s;
  estimate.tipsAt(now, Vector3d::Zero());
  estimate.seenAt(now, 2 * kOffset);
  EXPECT_TRUE(estimate.knot(now)->isApprox(2 * kOffset, 1e-12));
}

// A guide whose cycle is 100 us takes ten times as many tips in that time.
TEST(KnotEstimate, RemembersTheTipsAtAnyPeriod) {
  KnotEstimate estimate(kAge, 100us);
  suture::Time now{1s};
  const suture::Time exposed = now;
  for (; now - exposed < kAge; now += 100us) estimate.tipsAt(now, tipsAt(now));
  now -= 100us;
  estimate.seenAt(exposed, tipsAt(exposed) + kOffset);
  ASSERT_TRUE(estimate.knot(now));
  EXPECT_TRUE(estimate.knot(now)->isApprox(tipsAt(now) + kOffset, 1e-9));
}

}  // namespace
}  // namespace robots
