#include "picture/canvas.h"

#include <png.h>
#include <suture/base/errors.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace picture {
namespace {

using Eigen::Vector2d;
using robots::Colour;

// OpenCV takes places in parts of a pixel, with this many bits.
constexpr int kFraction = 4;
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX, kStroke = 1;  // px
constexpr double kLetters = 0.45;                             // 1 is the font's own size

cv::Scalar scalar(Colour colour) {
  return {double(colour[0]), double(colour[1]), double(colour[2])};
}

/// Returns false for a place so far outside that it fits no integer, and for NaN.
bool isNear(const Vector2d& place) { return (place.array().abs() < 1e5).all(); }

cv::Point exact(const Vector2d& place) {
  const Vector2d scaled = place * (1 << kFraction);
  return {static_cast<int>(std::lround(scaled.x())), static_cast<int>(std::lround(scaled.y()))};
}

cv::Point pixel(const Vector2d& place) {
  return {static_cast<int>(std::lround(place.x())), static_cast<int>(std::lround(place.y()))};
}

}  // namespace

Canvas::Canvas(int width, int height, Colour background)
    : pixels_(height, width, CV_8UC3, scalar(background)) {}

void Canvas::put(const robots::ImageFrame& image, int x, int y) {
  const cv::Mat source(static_cast<int>(image.height), static_cast<int>(image.width), CV_8UC3,
                       const_cast<std::uint8_t*>(image.data.data()));
  const cv::Rect place =
      cv::Rect(x, y, source.cols, source.rows) & cv::Rect(0, 0, pixels_.cols, pixels_.rows);
  source(cv::Rect(0, 0, place.width, place.height)).copyTo(pixels_(place));
}

void Canvas::fill(const Vector2d& upperLeft, const Vector2d& lowerRight, Colour colour) {
  if (!isNear(upperLeft) || !isNear(lowerRight)) return;
  cv::rectangle(pixels_, pixel(upperLeft), pixel(lowerRight), scalar(colour), cv::FILLED);
}

void Canvas::line(const Vector2d& from, const Vector2d& to, Colour colour) {
  if (!isNear(from) || !isNear(to)) return;
  cv::line(pixels_, exact(from), exact(to), scalar(colour), 1, cv::LINE_AA, kFraction);
}

void Canvas::ring(const Vector2d& centre, double radius, Colour colour) {
  if (!isNear(centre)) return;
  cv::circle(pixels_, exact(centre), static_cast<int>(std::lround(radius * (1 << kFraction))),
             scalar(colour), 1, cv::LINE_AA, kFraction);
}

void Canvas::cross(const Vector2d& centre, double size, Colour colour) {
  line(centre - Vector2d(size, 0), centre + Vector2d(size, 0), colour);
  line(centre - Vector2d(0, size), centre + Vector2d(0, size), colour);
}

int Canvas::widthOf(const std::string& words) {
  int underline = 0;  // not asked for
  return cv::getTextSize(words, kFont, kLetters, kStroke, &underline).width;
}

void Canvas::text(const Vector2d& lowerLeft, const std::string& words, Colour colour) {
  if (!isNear(lowerLeft)) return;
  cv::putText(pixels_, words, pixel(lowerLeft), kFont, kLetters, scalar(colour), kStroke,
              cv::LINE_AA);
}

// This uses libpng, because OpenCV's own writer of images would bring a hundred further packages.
void Canvas::write(const std::filesystem::path& file) const {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(pixels_.cols);
  image.height = static_cast<png_uint_32>(pixels_.rows);
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, file.c_str(), 0, pixels_.data, 0, nullptr) == 0) {
    throw suture::SetupError("writing the picture to " + file.string(), image.message,
                             "Name a file in an existing folder that you may write to");
  }
}

}  // namespace picture
