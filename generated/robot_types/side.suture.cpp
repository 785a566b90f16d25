// Written by suturec from robot_types/side.h. Do not edit.
#include "robot_types/side.suture.h"

#include <suture/wire/wire.h>

#include <type_traits>

#include "robot_types/side.capnp.h"

namespace robots {
namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<Side>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(Side::Left) == 0);
static_assert(static_cast<std::uint8_t>(Side::Right) == 1);

}  // namespace

// --- between slots and Cap'n Proto

wire::Side wireSide(std::uint8_t slot) {
  switch (static_cast<Side>(slot)) {
    case Side::Left: return wire::Side::LEFT;
    case Side::Right: return wire::Side::RIGHT;
  }
  return wire::Side{};
}

bool isKnownSide(std::uint8_t slot) {
  switch (static_cast<Side>(slot)) {
    case Side::Left:
    case Side::Right:
      return true;
  }
  return false;
}

suture::Errc fromWire(wire::Side in, std::uint8_t& slot) {
  switch (in) {
    case wire::Side::LEFT: return slot = static_cast<std::uint8_t>(Side::Left), suture::Errc{};
    case wire::Side::RIGHT: return slot = static_cast<std::uint8_t>(Side::Right), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

}  // namespace robots
