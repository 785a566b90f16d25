#include "vision/image_sensor.h"

#include <opencv2/imgproc.hpp>

namespace robots {
namespace {

// The noise of one image is shifted by up to this many places against that of another, so that
// nobody finds a pattern.
constexpr std::size_t kOffsets = 1 << 16;

}  // namespace

ImageSensor::ImageSensor(double noise, double blur, std::uint64_t seed)
    : deviation_(noise), blur_(blur), random_(seed) {}

void ImageSensor::expose(ImageFrame& image) {
  if (blur_ > 0) this->blur(image);
  if (deviation_ > 0) addNoise(image);
}

void ImageSensor::blur(ImageFrame& image) const {
  const cv::Mat pixels(static_cast<int>(image.height), static_cast<int>(image.width), CV_8UC3,
                       image.data.data());
  cv::GaussianBlur(pixels, pixels, {}, blur_);
}

/// Adds noise. To make new noise for each image would take longer than to draw it, so each takes
/// the same from another place on.
void ImageSensor::addNoise(ImageFrame& image) {
  const std::size_t size = image.data.size();
  cv::RNG random(random_);
  if (noise_.size() != size + kOffsets) {
    noise_.resize(size + kOffsets);
    random.fill(cv::Mat(noise_), cv::RNG::NORMAL, 0, deviation_);
  }
  const std::size_t from = random.next() % kOffsets;
  random_ = random.state;
  const int count = static_cast<int>(size);
  const cv::Mat pixels(1, count, CV_8U, image.data.data());
  cv::add(pixels, cv::Mat(1, count, CV_8S, &noise_[from]), pixels, cv::noArray(), CV_8U);
}

}  // namespace robots
