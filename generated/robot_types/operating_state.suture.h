// Written by suturec from robot_types/operating_state.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

#include "robot_types/operating_state.h"

namespace robots {

/// CRTK's operating_state.
struct OperatingStateSlot {
  std::uint8_t state;  // ArmState
  suture::BoundedText<15> sub_state;
  std::uint8_t is_homed;  // bool
  std::uint8_t is_busy;   // bool
  std::int64_t stamp;     // suture::Time, ns
};

inline bool store(const OperatingState& value, OperatingStateSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.state, slot.state);
  fits &= store(value.sub_state, slot.sub_state);
  fits &= store(value.is_homed, slot.is_homed);
  fits &= store(value.is_busy, slot.is_busy);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

inline void load(const OperatingStateSlot& slot, OperatingState& value) {
  using suture::load;
  load(slot.state, value.state);
  load(slot.sub_state, value.sub_state);
  load(slot.is_homed, value.is_homed);
  load(slot.is_busy, value.is_busy);
  load(slot.stamp, value.stamp);
}

}  // namespace robots
