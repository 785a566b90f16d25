// Written by suturec from robot_types/side.h. Do not edit.
#include "robot_types/side.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {
namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<Side>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(Side::Left) == 0);
static_assert(static_cast<std::uint8_t>(Side::Right) == 1);

}  // namespace

bool isKnownSide(std::uint8_t slot) {
  switch (static_cast<Side>(slot)) {
    case Side::Left:
    case Side::Right:
      return true;
  }
  return false;
}

}  // namespace robots
