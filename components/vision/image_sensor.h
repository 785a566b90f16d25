#pragma once
// This is what a camera makes of an image that is exact and sharp.

#include <cstdint>
#include <vector>

#include "robot_types/vision.h"

namespace robots {

/// Belongs to one thread; OpenCV allocates. Blurs an image and adds noise.
class ImageSensor {
 public:
  /// `noise` is the standard deviation of a channel, of 255. `blur` is that of a point's light, in
  /// px. The same seed gives the same noise.
  ImageSensor(double noise, double blur, std::uint64_t seed = 1);

  /// Changes an image of three channels in place.
  void expose(ImageFrame& image);

 private:
  void blur(ImageFrame& image) const;
  void addNoise(ImageFrame& image);

  double deviation_, blur_;
  std::uint64_t random_;
  std::vector<std::int8_t> noise_;
};

}  // namespace robots
