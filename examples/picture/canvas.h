#pragma once
// This is a picture that is drawn with OpenCV, and written as a PNG.

#include <Eigen/Core>
#include <filesystem>
#include <opencv2/core.hpp>
#include <string>

#include "robot_types/vision.h"
#include "vision/markers.h"

namespace picture {

/// One thread. All lengths and places are in px, from the centre of the upper left pixel to the
/// right and downward; what is outside is not drawn.
class Canvas {
 public:
  Canvas(int width, int height, robots::Colour background);

  int width() const { return pixels_.cols; }

  /// Puts an image of three channels at `x` and `y`, as far as it fits.
  void put(const robots::ImageFrame& image, int x, int y);
  void fill(const Eigen::Vector2d& upperLeft, const Eigen::Vector2d& lowerRight,
            robots::Colour colour);
  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, robots::Colour colour);
  void ring(const Eigen::Vector2d& centre, double radius, robots::Colour colour);
  void cross(const Eigen::Vector2d& centre, double size, robots::Colour colour);
  /// Returns how wide text() writes the words.
  static int widthOf(const std::string& words);
  /// Writes the words from `lowerLeft` to the right.
  void text(const Eigen::Vector2d& lowerLeft, const std::string& words, robots::Colour colour);

  /// Throws suture::SetupError if the file cannot be written.
  void write(const std::filesystem::path& file) const;

 private:
  cv::Mat pixels_;  // red, green, blue
};

}  // namespace picture
