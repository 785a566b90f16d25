#pragma once
// These are the colours and sizes by which the parts of the scene are distinguished in an image.

#include <array>
#include <cstddef>
#include <cstdint>

namespace robots {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

// Green and blue are equal in each of these, in any light; only a marker has more of one.
constexpr Colour kTissueColour{205, 122, 122};
constexpr Colour kStrandColour{65, 55, 55};
constexpr Colour kMetalColour{165, 165, 165};

/// The detector looks for these in an image: balls of one colour each.
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

/// Returns the radius in m. These sizes are our own: a knot of several throws, and tips like the
/// jaws of a needle driver.
constexpr double radiusOf(Marker marker) { return marker == Marker::Knot ? 0.002 : 0.0025; }

}  // namespace robots
