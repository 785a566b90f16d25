#include "vision/detector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

namespace robots {
namespace {

// A pixel has a marker's colour if the difference is above kLeast of 255, which is more than noise
// makes of any other colour. Where a marker is darkest the difference is still kWhole.
constexpr int kLeast = 20, kWhole = 95;
// A difference of green and blue of less than this, of 255, is noise.
constexpr int kNothing = 8;
// In px: this is a quarter of the knot at 120 mm, and far more than noise makes.
constexpr int kLeastArea = 25;
// In px: an edge with its blur is this wide.
constexpr int kEdge = 2;
// The heights of a point in both images differ by at most this, in px: far more than a centroid's
// error.
constexpr double kLargestSkew = 2;
// A marker shows at least this share of its ball. The strand hides a sliver, and a calibration
// that is a little wrong makes the ball seem as much as a third larger.
constexpr double kLeastShare = 0.7;
// One image shows at least this part of that share in the other, less than noise and the strand
// make of it.
constexpr double kLeastOfOther = 0.96;

bool isComplete(const ImageFrame& image) {
  return image.valid && image.channels == 3 && image.width > 0 && image.height > 0 &&
         image.data.size() == std::size_t{3} * image.width * image.height;
}

using Channels = std::array<cv::Mat1b, 3>;

/// Returns the pixels of a marker's colour: those that are greener than red and blue (the knot),
/// bluer, or yellow.
cv::Mat1b hasColourOf(Marker marker, const Channels& channels) {
  const auto& [red, green, blue] = channels;
  switch (marker) {
    case Marker::Knot: return green - cv::max(red, blue) > kLeast;
    case Marker::LeftTip: return blue - cv::max(red, green) > kLeast;
    case Marker::RightTip: return cv::min(red, green) - blue > kLeast;
  }
  return {};
}

/// Returns how much of each pixel a marker covers, because everything else has as much green as
/// blue. At kWhole and beyond the marker covers all of the pixel, in light or shade.
cv::Mat1b cover(Marker marker, const cv::Mat1b& green, const cv::Mat1b& blue) {
  const bool isBlue = marker == Marker::LeftTip;
  const cv::Mat1b more = isBlue ? blue - green : green - blue;  // cut at zero
  return cv::min(more, kWhole) - kNothing;
}

cv::Rect grown(const cv::Rect& box, int by) {
  return {box.x - by, box.y - by, box.width + 2 * by, box.height + 2 * by};
}

/// A Spot says where the largest spot of a mask is, and how many pixels it has; there are no pixels
/// if none is large enough.
struct Spot {
  cv::Rect box;
  cv::Mat1b pixels;
};

Spot largestSpot(const cv::Mat1b& mask) {
  const cv::Rect all = cv::boundingRect(mask);
  if (all.empty()) return {};
  cv::Mat1i labels, statistics;
  cv::Mat1d centroids;
  const int count = cv::connectedComponentsWithStats(mask(all), labels, statistics, centroids);
  int largest = 0, area = kLeastArea - 1;
  for (int spot = 1; spot < count; ++spot) {
    if (statistics(spot, cv::CC_STAT_AREA) <= area) continue;
    largest = spot;
    area = statistics(spot, cv::CC_STAT_AREA);
  }
  if (largest == 0) return {};
  const cv::Rect box(statistics(largest, cv::CC_STAT_LEFT), statistics(largest, cv::CC_STAT_TOP),
                     statistics(largest, cv::CC_STAT_WIDTH),
                     statistics(largest, cv::CC_STAT_HEIGHT));
  return {box + all.tl(), labels(box) == largest};
}

std::optional<Detection> markerIn(Marker marker, const Channels& channels) {
  const Spot spot = largestSpot(hasColourOf(marker, channels));
  const cv::Rect box = grown(spot.box, kEdge);
  if (spot.pixels.empty() || (box & cv::Rect({}, channels[0].size())) != box) return std::nullopt;
  // This includes the edge, where the marker covers parts of pixels.
  cv::Mat1b near, weights;
  cv::copyMakeBorder(spot.pixels, near, kEdge, kEdge, kEdge, kEdge, cv::BORDER_CONSTANT, 0);
  cv::dilate(near, near, {}, {-1, -1}, kEdge);
  cover(marker, channels[1](box), channels[2](box)).copyTo(weights, near);
  const cv::Moments moments = cv::moments(weights);
  return Detection{.place = {box.x + moments.m10 / moments.m00, box.y + moments.m01 / moments.m00},
                   .area = moments.m00 / (kWhole - kNothing)};
}

/// Returns how much of an image a ball covers, in px2: its outline is an ellipse. `centre` is in
/// the frame of that camera.
double areaOfBall(const CameraPair& cameras, const Eigen::Vector3d& centre, double radius) {
  const double near = centre.squaredNorm() - radius * radius;
  const double ahead = centre.z() * centre.z() - radius * radius;
  const double size = cameras.focal * radius;
  return std::numbers::pi * size * size * std::sqrt(near) / (ahead * std::sqrt(ahead));
}

/// Takes the share of the ball that each image shows.
bool isWhole(double left, double right) {
  const auto [least, most] = std::minmax(left, right);
  return least >= kLeastShare && least >= kLeastOfOther * most;
}

cv::Matx34d projection(const CameraPair& cameras, Eye eye) {
  const Eigen::Vector2d centre = cameras.centre();
  const double shift = eye == Eye::Right ? -cameras.focal * cameras.baseline : 0;
  return {cameras.focal, 0, centre.x(), shift, 0, cameras.focal, centre.y(), 0, 0, 0, 1, 0};
}

std::optional<Eigen::Vector3d> centreOf(const CameraPair& cameras, double radius,
                                        const Detection& left, const Detection& right) {
  const bool isBehind = left.place.x() <= right.place.x();
  if (isBehind || std::abs(left.place.y() - right.place.y()) > kLargestSkew) return std::nullopt;
  Eigen::Vector3d centre = triangulate(cameras, left.place, right.place);
  // The outline of a ball is that of a cone about it, whose middle is farther from the axis than
  // the ball's centre, by 1 / (1 - r^2 / z^2), so the ball seems nearer by r^2 / z.
  centre.z() += radius * radius / centre.z();
  const Eigen::Vector3d fromRight = centre - cameras.baseline * Eigen::Vector3d::UnitX();
  const bool whole = isWhole(left.area / areaOfBall(cameras, centre, radius),
                             right.area / areaOfBall(cameras, fromRight, radius));
  return whole ? std::optional(centre) : std::nullopt;
}

}  // namespace

Detections detect(const ImageFrame& image) {
  Detections found;
  if (!isComplete(image)) return found;
  const cv::Mat pixels(static_cast<int>(image.height), static_cast<int>(image.width), CV_8UC3,
                       const_cast<std::uint8_t*>(image.data.data()));
  Channels channels;
  cv::split(pixels, channels.data());
  for (std::size_t i = 0; i < kMarkers; ++i) {
    found[i] = markerIn(static_cast<Marker>(i), channels);
  }
  return found;
}

Eigen::Vector3d triangulate(const CameraPair& cameras, const Eigen::Vector2d& left,
                            const Eigen::Vector2d& right) {
  cv::Mat1d point;
  cv::triangulatePoints(projection(cameras, Eye::Left), projection(cameras, Eye::Right),
                        cv::Vec2d(left.x(), left.y()), cv::Vec2d(right.x(), right.y()), point);
  return Eigen::Vector4d(point.ptr<double>()).hnormalized();
}

MarkerPoints locate(const CameraPair& cameras, const Detections& left, const Detections& right) {
  MarkerPoints points;
  for (std::size_t i = 0; i < kMarkers; ++i) {
    if (!left[i] || !right[i]) continue;
    points[i] = centreOf(cameras, radiusOf(static_cast<Marker>(i)), *left[i], *right[i]);
  }
  return points;
}

}  // namespace robots
