#pragma once
// A picture that is drawn point by point, and written as a PNG.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "robot_types/vision.h"

namespace demo {

using Colour = std::array<std::uint8_t, 3>;

/// Pixels count from the upper left one; what is outside is not drawn.
class Canvas {
 public:
  Canvas(int width, int height, Colour background);

  /// Puts an image of three channels there.
  void put(const robots::ImageFrame& image, int x, int y);
  void fill(int left, int top, int right, int bottom, Colour colour);
  void line(Eigen::Vector2d from, Eigen::Vector2d to, Colour colour);
  void ring(Eigen::Vector2d centre, double radius, Colour colour);
  void cross(Eigen::Vector2d centre, double size, Colour colour);

  /// Throws suture::SetupError if the file cannot be written.
  void write(const std::filesystem::path& file) const;

 private:
  void dot(const Eigen::Vector2d& at, Colour colour);

  int width_, height_;
  std::vector<std::uint8_t> pixels_;
};

}  // namespace demo
