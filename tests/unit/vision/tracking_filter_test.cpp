// A filter of constant velocity makes up for images that are late, and for their noise.

#include "vision/tracking_filter.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>

#include "timing/seconds.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;

constexpr suture::Time kStart{1s};
constexpr suture::Duration kFrame = 66'667us, kLatency = 80ms;
const Vector3d kVelocity{0.02, -0.01, 0.015};
const Vector3d kNoise{0.00005, 0.00005, 0.0003};  // m, as of a stereo pair at 100 mm

Vector3d moving(suture::Time time) {
  return Vector3d(0, 0, 0.1) + secondsBetween(kStart, time) * kVelocity;
}

TEST(TrackingFilter, KnowsNothingBeforeASighting) {
  TrackingFilter filter(0.1);
  EXPECT_FALSE(filter.known());
  filter.seenAt(kStart, {0, 0, 0.1}, kNoise);
  EXPECT_TRUE(filter.known());
  EXPECT_EQ(filter.placeAt(kStart + 1s), Vector3d(0, 0, 0.1)) << "one sighting has no velocity";
  filter.forget();
  EXPECT_FALSE(filter.known());
}

TEST(TrackingFilter, FollowsWhatMovesEvenly) {
  TrackingFilter filter(0.1);
  suture::Time now = kStart;
  for (int i = 0; i < 60; ++i, now += kFrame) filter.seenAt(now, moving(now), kNoise);
  EXPECT_LT((filter.velocity() - kVelocity).norm(), 0.001 * kVelocity.norm());
  EXPECT_LT((filter.placeAt(now + 100ms) - moving(now + 100ms)).norm(), 1e-5);
}

// Each sighting tells where it was 80 ms ago; it has moved by 2.2 mm since.
TEST(TrackingFilter, MakesUpForTheLatencyOfImages) {
  TrackingFilter filter(0.1);
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  double late = 0, predicted = 0;
  suture::Time now = kStart;
  for (int i = 0; i < 300; ++i, now += kFrame) {
    const suture::Time exposed = now - kLatency;
    const Vector3d noise(normal(random), normal(random), normal(random));
    const Vector3d seen = moving(exposed) + kNoise.cwiseProduct(noise);
    filter.seenAt(exposed, seen, kNoise);
    if (i < 15) continue;
    late += (seen - moving(now)).squaredNorm();
    predicted += (filter.placeAt(now) - moving(now)).squaredNorm();
  }
  EXPECT_LT(std::sqrt(predicted), 0.33 * std::sqrt(late));
}

// Beside noise there is no velocity: what it says is better than what it saw.
TEST(TrackingFilter, SmoothsTheNoiseOfWhatStandsStill) {
  TrackingFilter filter(0.01);
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const Vector3d place(0, 0, 0.1);
  double seen = 0, filtered = 0;
  suture::Time now = kStart;
  for (int i = 0; i < 500; ++i, now += kFrame) {
    const Vector3d noise = kNoise.z() * Vector3d(normal(random), normal(random), normal(random));
    filter.seenAt(now, place + noise, Vector3d::Constant(kNoise.z()));
    if (i < 30) continue;
    seen += noise.squaredNorm();
    filtered += (filter.placeAt(now) - place).squaredNorm();
  }
  EXPECT_LT(std::sqrt(filtered), 0.7 * std::sqrt(seen));
}

TEST(TrackingFilter, AnOlderSightingChangesNothing) {
  TrackingFilter filter(0.1);
  filter.seenAt(kStart, {0, 0, 0.1}, kNoise);
  filter.seenAt(kStart, {0, 0, 0.2}, kNoise);
  filter.seenAt(kStart - 10ms, {0, 0, 0.3}, kNoise);
  EXPECT_EQ(filter.placeAt(kStart), Vector3d(0, 0, 0.1));
  EXPECT_EQ(filter.seen(), kStart);
}

}  // namespace
}  // namespace robots::test
