#include "vision/painter.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "vision/markers.h"

namespace robots {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t kChannels = 3;
// It is long enough that no eye finds a pattern where it is used again.
constexpr std::size_t kNoiseSamples = 1 << 16;

struct Ball {
  Vector3d centre;  // m, before the camera
  double radius;    // m
  Colour colour;
};

// These sizes are ours: a thick strand, and tips like the jaws of a needle driver.
constexpr double kStrandRadius = 0.0006, kKnotRadius = 0.002, kTipRadius = 0.0025;

std::array<Ball, Strand::kNodes> ballsOf(const Strand::Nodes& strand) {
  std::array<Ball, Strand::kNodes> balls;
  for (int i = 0; i < Strand::kNodes; ++i) {
    balls[static_cast<std::size_t>(i)] = {strand.col(i), kStrandRadius, kStrandColour};
  }
  const auto mark = [&](int node, double radius, Marker marker) {
    Ball& ball = balls[static_cast<std::size_t>(node)];
    ball.radius = radius;
    ball.colour = colourOf(marker);
  };
  mark(0, kTipRadius, Marker::LeftTip);
  mark(Strand::kKnot, kKnotRadius, Marker::Knot);
  mark(Strand::kNodes - 1, kTipRadius, Marker::RightTip);
  // What is near hides what is far.
  std::sort(balls.begin(), balls.end(),
            [](const Ball& a, const Ball& b) { return a.centre.z() > b.centre.z(); });
  return balls;
}

void blend(std::uint8_t& pixel, double value, double share) {
  pixel = static_cast<std::uint8_t>(std::lround(pixel + share * (value - pixel)));
}

void draw(const Ball& ball, const CameraPair& cameras, Eye eye, ImageFrame& image) {
  const Vector2d centre = cameras.project(eye, ball.centre);
  const double radius = cameras.focal * ball.radius / ball.centre.z();
  const double reach = radius + 1;
  // They are bounded before they are converted: what is far aside has no place that fits an int.
  const auto first = [](double low) {
    return static_cast<int>(std::ceil(std::clamp(low, 0.0, 1e6)));
  };
  const auto last = [](double high, int size) {
    return static_cast<int>(std::floor(std::clamp(high, -1.0, size - 1.0)));
  };
  for (int y = first(centre.y() - reach); y <= last(centre.y() + reach, cameras.height); ++y) {
    for (int x = first(centre.x() - reach); x <= last(centre.x() + reach, cameras.width); ++x) {
      const double distance = (Vector2d(x, y) - centre).norm();
      const double share = std::clamp(radius - distance + 0.5, 0.0, 1.0);
      const double slant = std::min(distance / radius, 1.0);
      const double light = 0.4 + 0.6 * std::sqrt(1 - slant * slant);
      const auto pixel = kChannels * static_cast<std::size_t>(y * cameras.width + x);
      for (std::size_t channel = 0; channel < kChannels; ++channel) {
        blend(image.data[pixel + channel], light * ball.colour[channel], share);
      }
    }
  }
}

}  // namespace

Painter::Painter(const CameraPair& cameras, double noise, std::uint64_t seed)
    : cameras_(cameras), noise_(kNoiseSamples), next_(seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;  // one of no width would be refused
  std::generate(noise_.begin(), noise_.end(), [&] {
    return static_cast<std::int8_t>(std::clamp(std::round(noise * normal(random)), -127.0, 127.0));
  });
}

void Painter::paint(Eye eye, const Strand::Nodes& strand, ImageFrame& image) {
  image.width = static_cast<std::uint32_t>(cameras_.width);
  image.height = static_cast<std::uint32_t>(cameras_.height);
  image.channels = kChannels;
  image.data.resize(kChannels * image.width * image.height);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = kTissueColour[i % kChannels];
  for (const Ball& ball : ballsOf(strand)) draw(ball, cameras_, eye, image);
  addNoise(image);
  image.valid = true;
}

/// Each image takes the same noise from another place on.
void Painter::addNoise(ImageFrame& image) {
  next_ = next_ * 6364136223846793005u + 1442695040888963407u;
  std::size_t at = next_ >> 48;
  for (std::uint8_t& value : image.data) {
    value = static_cast<std::uint8_t>(std::clamp(value + noise_[at], 0, 255));
    at = (at + 1) % kNoiseSamples;
  }
}

}  // namespace robots
