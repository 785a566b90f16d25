// What is drawn is found again, as exactly as a stereo pair can tell.

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/vision/hanging.h"
#include "vision/detector.h"
#include "vision/painter.h"

namespace robots::test {
namespace {

using Eigen::Vector3d;

constexpr double kNoise = 3;  // of 255

class Stereo : public testing::Test {
 protected:
  MarkerPoints look(const Strand::Nodes& strand) {
    painter_.paint(Eye::Left, strand, left_);
    painter_.paint(Eye::Right, strand, right_);
    return locate(cameras_, detect(left_), detect(right_));
  }

  const CameraPair cameras_;
  Painter painter_{cameras_, kNoise};
  ImageFrame left_, right_;
};

TEST_F(Stereo, APointThatBothEyesSeeIsWhereItWas) {
  const Vector3d point(0.013, -0.021, 0.087);
  const Vector3d found =
      cameras_.triangulate(cameras_.project(Eye::Left, point), cameras_.project(Eye::Right, point));
  EXPECT_TRUE(found.isApprox(point, 1e-12));
}

TEST_F(Stereo, AMarkerIsFoundWhereItIsInTheImage) {
  for (const double z : {0.06, 0.08, 0.1, 0.12}) {
    const Vector3d left(-0.03, 0.002, z), knot(0.0013, -0.0042, z + 0.004), right(0.029, 0, z);
    const MarkerPoints found = look(hanging(left, knot, right));
    const auto expect = [&](Marker marker, const Vector3d& truth, double pixels) {
      const auto& point = found[static_cast<std::size_t>(marker)];
      ASSERT_TRUE(point) << "at " << z;
      // An error of the depth is one along the ray, and not of this.
      const Eigen::Vector2d seen = cameras_.project(Eye::Left, *point);
      EXPECT_LT((seen - cameras_.project(Eye::Left, truth)).norm(), pixels) << "at " << z;
    };
    expect(Marker::Knot, knot, 0.5);  // the strand hides a part of it, above
    expect(Marker::LeftTip, left, 0.1);
    expect(Marker::RightTip, right, 0.1);
  }
}

TEST_F(Stereo, WhatIsOutOfTheImageIsNotSeen) {
  const MarkerPoints found =
      look(hanging({-0.2, 0, 0.08}, {0.001, -0.004, 0.08}, {0.029, 0, 0.08}));
  EXPECT_FALSE(found[static_cast<std::size_t>(Marker::LeftTip)]);
  EXPECT_TRUE(found[static_cast<std::size_t>(Marker::Knot)]);
}

TEST_F(Stereo, AnImageWithoutItsPixelsHasNoMarkers) {
  look(hanging({-0.03, 0, 0.08}, {0, 0, 0.08}, {0.03, 0, 0.08}));
  left_.data.resize(left_.data.size() / 4);
  for (const auto& one : detect(left_)) EXPECT_FALSE(one);
  left_.data.clear();
  for (const auto& one : detect(left_)) EXPECT_FALSE(one);
}

TEST_F(Stereo, APointIsAtOneHeightInBothImages) {
  const Vector3d left(-0.03, 0, 0.08), knot(0, -0.004, 0.08), right(0.03, 0, 0.08);
  look(hanging(left, knot, right));
  painter_.paint(Eye::Right, hanging(left, knot + Vector3d(0, 0.001, 0), right), right_);
  const MarkerPoints found = locate(cameras_, detect(left_), detect(right_));
  EXPECT_FALSE(found[static_cast<std::size_t>(Marker::Knot)]);
  EXPECT_TRUE(found[static_cast<std::size_t>(Marker::LeftTip)]);
}

TEST_F(Stereo, ACameraWithoutNoiseSeesAsWell) {
  painter_ = Painter(cameras_, 0);
  const MarkerPoints found = look(hanging({-0.03, 0, 0.08}, {0, 0, 0.08}, {0.03, 0, 0.08}));
  for (const auto& one : found) EXPECT_TRUE(one);
}

TEST_F(Stereo, ACoveredCameraSeesNothing) {
  look(hanging({-0.03, 0, 0.08}, {0, 0, 0.08}, {0.03, 0, 0.08}));
  std::fill(left_.data.begin(), left_.data.end(), std::uint8_t{0});
  for (const auto& one : locate(cameras_, detect(left_), detect(right_))) EXPECT_FALSE(one);
}

}  // namespace
}  // namespace robots::test
