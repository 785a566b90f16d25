// Noise and blur are as large as they are said to be, and drawing takes one thread.

#include "vision/image_sensor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iterator>

#include "unit/vision/hanging.h"
#include "vision/detector.h"
#include "vision/painter.h"

namespace robots::test {
namespace {

ImageFrame grey(std::uint8_t value) {
  ImageFrame image;
  image.width = 640;
  image.height = 480;
  image.channels = 3;
  image.data.assign(std::size_t{3} * image.width * image.height, value);
  image.valid = true;
  return image;
}

/// The standard deviation of all channels about their mean.
double deviation(const ImageFrame& image) {
  double sum = 0, squares = 0;
  for (const std::uint8_t value : image.data) {
    sum += value;
    squares += double(value) * value;
  }
  const auto count = static_cast<double>(image.data.size());
  return std::sqrt(squares / count - sum / count * (sum / count));
}

TEST(ImageSensor, AddsNoiseOfItsStandardDeviation) {
  for (const double noise : {1.0, 3.0, 5.0}) {
    ImageFrame image = grey(128);
    ImageSensor(noise, 0).expose(image);
    // Rounding to whole numbers adds a twelfth to the variance.
    EXPECT_NEAR(deviation(image), std::sqrt(noise * noise + 1.0 / 12), 0.02) << noise;
  }
}

TEST(ImageSensor, NoTwoImagesHaveTheSameNoise) {
  ImageSensor sensor(3, 0), other(3, 0);
  ImageFrame first = grey(128), second = grey(128), again = grey(128);
  sensor.expose(first);
  sensor.expose(second);
  other.expose(again);
  EXPECT_NE(first.data, second.data);
  EXPECT_EQ(first.data, again.data) << "but a seed is a seed";
}

// A pixel that is as dark or as bright as it gets stays so, and does not come out at the other end.
TEST(ImageSensor, NoiseDoesNotOverflow) {
  for (const std::uint8_t extreme : {0, 255}) {
    ImageFrame image = grey(extreme);
    ImageSensor(5, 0).expose(image);
    for (const std::uint8_t value : image.data) ASSERT_LT(std::abs(value - extreme), 40);
  }
}

// The light of one pixel spreads: a Gauss curve of standard deviation s has 1 / (2 pi s^2) of it in
// the middle, and all of it together.
TEST(ImageSensor, BlurSpreadsTheLightOfAPoint) {
  constexpr double kWide = 1.5;
  ImageFrame image = grey(0);
  const std::size_t middle = 3 * (240 * 640 + 320);
  image.data[middle] = 255;
  ImageSensor(0, kWide).expose(image);
  EXPECT_NEAR(image.data[middle], 255 / (2 * 3.14159 * kWide * kWide), 2);
  EXPECT_EQ(image.data[middle + 3], image.data[middle - 3]) << "to both sides alike";
  EXPECT_GT(image.data[middle + 3], 0);
}

// An edge that is wider does not move: the centre of a marker stays where it is.
TEST(ImageSensor, BlurMovesNoMarker) {
  Painter painter{CameraPair{}};
  ImageFrame sharp, blurred;
  const View view{hanging({-0.03, 0.002, 0.08}, {0.001, -0.004, 0.08}, {0.029, 0, 0.08})};
  painter.paint(Eye::Left, view, sharp);
  blurred = sharp;
  ImageSensor(0, 1).expose(blurred);
  const Detections before = detect(sharp), after = detect(blurred);
  for (std::size_t i = 0; i < kMarkers; ++i) {
    ASSERT_TRUE(before[i] && after[i]);
    EXPECT_LT((before[i]->place - after[i]->place).norm(), 0.1);
  }
}

std::ptrdiff_t threads() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return std::distance(begin(tasks), end(tasks));
}

TEST(DrawingAndSeeing, TakeOnlyTheAskersThread) {
  Painter painter{CameraPair{}};
  ImageFrame image;
  painter.paint(Eye::Left, {hanging({-0.03, 0, 0.08}, {0, 0, 0.08}, {0.03, 0, 0.08})}, image);
  ImageSensor(3, 0.6).expose(image);
  for (const auto& one : detect(image)) EXPECT_TRUE(one);
  EXPECT_EQ(threads(), 1) << "also if another test has drawn before";
}

}  // namespace
}  // namespace robots::test
