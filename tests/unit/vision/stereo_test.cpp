// The markers that are drawn are found again, where they were.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "unit/vision/hanging.h"
#include "vision/detector.h"
#include "vision/image_sensor.h"
#include "vision/painter.h"

namespace robots::test {
namespace {

using Eigen::Vector3d;

class Stereo : public testing::Test {
 protected:
  void show(Eye eye, const Strand::Nodes& strand, ImageFrame& image) {
    painter_.paint(eye, {strand}, image);
    sensor_.expose(image);
  }
  MarkerPoints look(const Strand::Nodes& strand) {
    show(Eye::Left, strand, left_);
    show(Eye::Right, strand, right_);
    return locate(cameras_, detect(left_), detect(right_));
  }
  static bool sees(const MarkerPoints& found, Marker marker) {
    return found[static_cast<std::size_t>(marker)].has_value();
  }

  const CameraPair cameras_;
  Painter painter_{cameras_};
  ImageSensor sensor_{3, 0.6};
  ImageFrame left_, right_;
};

TEST_F(Stereo, APointOfBothEyesIsRight) {
  const Vector3d point(0.013, -0.021, 0.087);
  const Vector3d found = triangulate(cameras_, cameras_.project(Eye::Left, point),
                                     cameras_.project(Eye::Right, point));
  EXPECT_TRUE(found.isApprox(point, 1e-9));
}

TEST_F(Stereo, AMarkerIsFoundInItsPlace) {
  for (const double z : {0.06, 0.08, 0.1, 0.12}) {
    const Vector3d left(-0.03, 0.002, z), knot(0.0013, -0.0042, z + 0.004), right(0.029, 0, z);
    const MarkerPoints found = look(hanging(left, knot, right));
    const auto expect = [&](Marker marker, const Vector3d& truth, double pixels) {
      const auto& point = found[static_cast<std::size_t>(marker)];
      ASSERT_TRUE(point) << "at " << z;
      // An error of the depth lies along the ray, and is not judged here.
      const Eigen::Vector2d seen = cameras_.project(Eye::Left, *point);
      EXPECT_LT((seen - cameras_.project(Eye::Left, truth)).norm(), pixels) << "at " << z;
    };
    // The strand hides a sliver of each marker, of the knot on both sides.
    expect(Marker::Knot, knot, 0.2);
    expect(Marker::LeftTip, left, 0.2);
    expect(Marker::RightTip, right, 0.2);
  }
}

TEST_F(Stereo, AnOutsideMarkerIsNotSeen) {
  const MarkerPoints found =
      look(hanging({-0.2, 0, 0.08}, {0.001, -0.004, 0.08}, {0.029, 0, 0.08}));
  EXPECT_FALSE(sees(found, Marker::LeftTip));
  EXPECT_TRUE(sees(found, Marker::Knot));
}

// The centre of what is seen is not the ball's centre, so such a marker must not count.
TEST_F(Stereo, APartlyVisibleMarkerIsNotSeen) {
  const double edge = -0.08 * cameras_.width / 2 / cameras_.focal;
  look(hanging({edge, 0, 0.08}, {0, -0.004, 0.08}, {0.029, 0, 0.08}));
  EXPECT_FALSE(detect(left_)[static_cast<std::size_t>(Marker::LeftTip)]);
  look(hanging({edge + 0.006, 0, 0.08}, {0, -0.004, 0.08}, {0.029, 0, 0.08}));
  EXPECT_TRUE(detect(left_)[static_cast<std::size_t>(Marker::LeftTip)]);
}

/// Hides what an eye sees between two columns, as an instrument may.
void cover(ImageFrame& image, int from, int to) {
  for (int y = 0; y < static_cast<int>(image.height); ++y) {
    for (int x = from; x < to; ++x) {
      std::copy(kMetalColour.begin(), kMetalColour.end(),
                image.data.begin() + 3 * (y * static_cast<int>(image.width) + x));
    }
  }
}

TEST_F(Stereo, APartlyHiddenMarkerIsNotSeen) {
  const Vector3d knot(0, -0.004, 0.1);
  const double radius = cameras_.focal * radiusOf(Marker::Knot) / knot.z();
  for (const double hidden : {0.2, 0.5, 0.8}) {
    for (const std::vector<Eye>& eyes :
         {std::vector{Eye::Right}, std::vector{Eye::Left}, std::vector{Eye::Left, Eye::Right}}) {
      if (eyes.size() == 2 && hidden < 0.5) continue;  // enough is seen, and the same by both eyes
      look(hanging({-0.03, 0, 0.1}, knot, {0.03, 0, 0.1}));
      for (const Eye eye : eyes) {
        const double left = cameras_.project(eye, knot).x() - radius;
        cover(eye == Eye::Left ? left_ : right_, static_cast<int>(left) - 4,
              static_cast<int>(left + 2 * radius * hidden));
      }
      const MarkerPoints found = locate(cameras_, detect(left_), detect(right_));
      EXPECT_FALSE(sees(found, Marker::Knot))
          << hidden << " of it is hidden from " << eyes.size() << " eyes";
      EXPECT_TRUE(sees(found, Marker::LeftTip) && sees(found, Marker::RightTip));
    }
  }
}

TEST_F(Stereo, AnEmptyImageHasNoMarkers) {
  look(hanging({-0.03, 0, 0.08}, {0, 0, 0.08}, {0.03, 0, 0.08}));
  left_.data.resize(left_.data.size() / 4);
  for (const auto& one : detect(left_)) EXPECT_FALSE(one);
  left_.data.clear();
  for (const auto& one : detect(left_)) EXPECT_FALSE(one);
  left_.width = left_.height = 0;
  for (const auto& one : detect(left_)) EXPECT_FALSE(one);
}

TEST_F(Stereo, APointHasOneHeight) {
  const Vector3d left(-0.03, 0, 0.08), knot(0, -0.004, 0.08), right(0.03, 0, 0.08);
  look(hanging(left, knot, right));
  show(Eye::Right, hanging(left, knot + Vector3d(0, 0.001, 0), right), right_);
  const MarkerPoints found = locate(cameras_, detect(left_), detect(right_));
  EXPECT_FALSE(sees(found, Marker::Knot));
  EXPECT_TRUE(sees(found, Marker::LeftTip));
}

TEST_F(Stereo, ANoiselessCameraSeesAsWell) {
  sensor_ = ImageSensor(0, 0);
  for (const auto& one : look(hanging({-0.03, 0, 0.08}, {0, 0, 0.08}, {0.03, 0, 0.08}))) {
    EXPECT_TRUE(one);
  }
}

TEST_F(Stereo, ACoveredCameraSeesNothing) {
  look(hanging({-0.03, 0, 0.08}, {0, 0, 0.08}, {0.03, 0, 0.08}));
  std::fill(left_.data.begin(), left_.data.end(), std::uint8_t{0});
  for (const auto& one : locate(cameras_, detect(left_), detect(right_))) EXPECT_FALSE(one);
}

// Tissue, strand and instruments are everywhere in the image, with all the noise that there may be.
TEST_F(Stereo, OnlyAMarkerLooksLikeOne) {
  sensor_ = ImageSensor(5, 0);
  const MarkerPoints found = look(hanging({-0.2, 0, 0.08}, {0.001, -0.2, 0.08}, {0.2, 0, 0.08}));
  for (const auto& one : found) EXPECT_FALSE(one);
}

}  // namespace
}  // namespace robots::test
