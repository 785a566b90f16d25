#include "vision/detector.h"

#include <cmath>
#include <cstddef>

namespace robots {
namespace {

// Tissue and strand with a noise of at most 5 stay below this likeness, but for some single pixels.
constexpr int kLeastLikeness = 40;
// A tip at 120 mm weighs four times as much, so a quarter of it still counts.
constexpr double kLeastWeight = 1000;
// px between the heights of a point in both images: far more than a centroid's error.
constexpr double kLargestSkew = 2;

bool isComplete(const ImageFrame& image) {
  return image.valid && image.channels == 3 &&
         image.data.size() == std::size_t{3} * image.width * image.height;
}

struct Centroid {
  double weight = 0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();

  void add(double more, double x, double y) {
    weight += more;
    moment += more * Eigen::Vector2d(x, y);
  }
};

}  // namespace

Detections detect(const ImageFrame& image) {
  Detections found;
  if (!isComplete(image)) return found;
  std::array<Centroid, kMarkers> centroids;
  const std::uint8_t* pixel = image.data.data();
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x, pixel += 3) {
      for (std::size_t i = 0; i < kMarkers; ++i) {
        const int like = likeness(static_cast<Marker>(i), pixel[0], pixel[1], pixel[2]);
        if (like > kLeastLikeness) centroids[i].add(like - kLeastLikeness, x, y);
      }
    }
  }
  for (std::size_t i = 0; i < kMarkers; ++i) {
    if (centroids[i].weight >= kLeastWeight) found[i] = centroids[i].moment / centroids[i].weight;
  }
  return found;
}

MarkerPoints locate(const CameraPair& cameras, const Detections& left, const Detections& right) {
  MarkerPoints points;
  for (std::size_t i = 0; i < kMarkers; ++i) {
    if (!left[i] || !right[i] || left[i]->x() <= right[i]->x()) continue;
    if (std::abs(left[i]->y() - right[i]->y()) > kLargestSkew) continue;
    points[i] = cameras.triangulate(*left[i], *right[i]);
  }
  return points;
}

}  // namespace robots
