#include "canvas.h"

#include <png.h>
#include <suture/base/errors.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace demo {

using Eigen::Vector2d;
using robots::Colour;

Canvas::Canvas(int width, int height, Colour background)
    : width_(width), height_(height), pixels_(static_cast<std::size_t>(3 * width * height)) {
  fill(0, 0, width, height, background);
}

void Canvas::dot(const Vector2d& at, Colour colour) {
  // Asked before it is rounded, for what is far outside fits no integer. NaN is outside too.
  const bool inside =
      at.x() > -0.5 && at.y() > -0.5 && at.x() < width_ - 0.5 && at.y() < height_ - 0.5;
  if (!inside) return;
  const int x = static_cast<int>(std::lround(at.x())), y = static_cast<int>(std::lround(at.y()));
  std::copy(colour.begin(), colour.end(), pixels_.begin() + 3 * (y * width_ + x));
}

void Canvas::put(const robots::ImageFrame& image, int x, int y) {
  const auto* from = image.data.data();
  for (int row = 0; row < static_cast<int>(image.height); ++row) {
    for (int column = 0; column < static_cast<int>(image.width); ++column, from += 3) {
      dot(Vector2d(x + column, y + row), {from[0], from[1], from[2]});
    }
  }
}

void Canvas::fill(int left, int top, int right, int bottom, Colour colour) {
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) dot(Vector2d(x, y), colour);
  }
}

void Canvas::line(Vector2d from, Vector2d to, Colour colour) {
  // One dot for each pixel of the longer axis.
  Eigen::Index axis = 0;
  (to - from).cwiseAbs().maxCoeff(&axis);
  if (from[axis] > to[axis]) std::swap(from, to);
  const double length = std::max(to[axis] - from[axis], 1.0);  // shorter ones are a dot or two
  const double first = std::max(std::round(from[axis]), 0.0);
  const double last = std::min(std::round(to[axis]), (axis == 0 ? width_ : height_) - 1.0);
  for (double at = first; at <= last; ++at) {
    dot(from + (to - from) * ((at - from[axis]) / length), colour);
  }
}

void Canvas::ring(Vector2d centre, double radius, Colour colour) {
  const int steps = static_cast<int>(std::ceil(8 * radius));
  for (int i = 0; i < steps; ++i) {
    const double angle = 2 * std::numbers::pi * i / steps;
    dot(centre + radius * Vector2d(std::cos(angle), std::sin(angle)), colour);
  }
}

void Canvas::cross(Vector2d centre, double size, Colour colour) {
  line(centre - Vector2d(size, 0), centre + Vector2d(size, 0), colour);
  line(centre - Vector2d(0, size), centre + Vector2d(0, size), colour);
}

void Canvas::write(const std::filesystem::path& file) const {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width_);
  image.height = static_cast<png_uint_32>(height_);
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, file.c_str(), 0, pixels_.data(), 0, nullptr) == 0) {
    throw suture::SetupError("writing the picture to " + file.string(), image.message,
                             "Name a file in an existing folder that you may write to");
  }
}

}  // namespace demo
