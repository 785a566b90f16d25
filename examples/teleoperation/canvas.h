#pragma once
// A picture that is drawn point by point, and written as a PNG.

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "robot_types/vision.h"
#include "vision/markers.h"

namespace demo {

/// All lengths and places are in px, from the centre of the upper left pixel to the right and
/// downward; what is outside is not drawn. One thread.
class Canvas {
 public:
  Canvas(int width, int height, robots::Colour background);

  /// Puts an image of three channels there.
  void put(const robots::ImageFrame& image, int x, int y);
  void fill(int left, int top, int right, int bottom, robots::Colour colour);
  /// The ends may be anywhere: it takes no more steps than the canvas has columns or rows.
  void line(Eigen::Vector2d from, Eigen::Vector2d to, robots::Colour colour);
  void ring(Eigen::Vector2d centre, double radius, robots::Colour colour);
  void cross(Eigen::Vector2d centre, double size, robots::Colour colour);

  /// Throws suture::SetupError if the file cannot be written.
  void write(const std::filesystem::path& file) const;

 private:
  void dot(const Eigen::Vector2d& at, robots::Colour colour);

  int width_, height_;
  std::vector<std::uint8_t> pixels_;
};

}  // namespace demo
