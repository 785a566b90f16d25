#pragma once
// The colours by which the parts of the scene are told from each other in an image.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace robots {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

constexpr Colour kTissueColour{180, 110, 100};
constexpr Colour kStrandColour{70, 70, 75};

/// The detector looks for these in an image.
enum class Marker : std::uint8_t { Knot, LeftTip, RightTip };
constexpr std::size_t kMarkers = 3;

constexpr Colour colourOf(Marker marker) {
  switch (marker) {
    case Marker::Knot: return {40, 210, 60};
    case Marker::LeftTip: return {40, 70, 230};
    case Marker::RightTip: return {230, 220, 40};
  }
  return {};
}

/// By how much a pixel has the colour of `marker`, and no other one of the scene: high for green
/// (the knot), blue and yellow.
constexpr int likeness(Marker marker, int red, int green, int blue) {
  switch (marker) {
    case Marker::Knot: return green - std::max(red, blue);
    case Marker::LeftTip: return blue - std::max(red, green);
    case Marker::RightTip: return std::min(red, green) - blue;
  }
  return 0;
}

}  // namespace robots
