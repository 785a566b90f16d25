// Written by suturec from robot_types/side.h. Do not edit.
#include <suture/codec/wire.h>

#include "robot_types/side.capnp.h"
#include "robot_types/side.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::Side wireSide(std::uint8_t slot) {
  switch (static_cast<Side>(slot)) {
    case Side::Left: return wire::Side::LEFT;
    case Side::Right: return wire::Side::RIGHT;
  }
  return wire::Side{};
}

suture::Errc fromWire(wire::Side in, std::uint8_t& slot) {
  switch (in) {
    case wire::Side::LEFT: return slot = static_cast<std::uint8_t>(Side::Left), suture::Errc{};
    case wire::Side::RIGHT: return slot = static_cast<std::uint8_t>(Side::Right), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

}  // namespace robots
