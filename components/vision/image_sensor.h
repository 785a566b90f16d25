#pragma once
// What a camera makes of an image that is exact and sharp.

#include <cstdint>
#include <vector>

#include "robot_types/vision.h"

namespace robots {

/// Blurs an image and adds noise. Belongs to one thread; OpenCV allocates.
class ImageSensor {
 public:
  /// `noise`: standard deviation of a channel, of 255. `blur`: that of a point's light, px. The
  /// same seed gives the same noise.
  ImageSensor(double noise, double blur, std::uint64_t seed = 1);

  /// In place; an image of three channels.
  void expose(ImageFrame& image);

 private:
  void blur(ImageFrame& image) const;
  void addNoise(ImageFrame& image);

  double deviation_, blur_;
  std::uint64_t random_;
  std::vector<std::int8_t> noise_;
};

}  // namespace robots
