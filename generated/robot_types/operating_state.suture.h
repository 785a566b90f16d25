// Written by suturec from robot_types/operating_state.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "robot_types/operating_state.h"

namespace robots {

/// An OperatingState is CRTK's operating_state.
struct OperatingStateSlot {
  std::uint8_t state;  // ArmState
  suture::BoundedText<15> sub_state;
  std::uint8_t is_homed;  // bool
  std::uint8_t is_busy;   // bool
  std::int64_t stamp;     // suture::Time, ns
};

bool store(const OperatingState& value, OperatingStateSlot& slot);
void load(const OperatingStateSlot& slot, OperatingState& value);
void reserve(const OperatingStateSlot*, OperatingState& value);
void shiftStamps(OperatingStateSlot& slot, suture::Duration shift);

bool isKnownArmState(std::uint8_t slot);
bool isValid(const OperatingStateSlot& slot, suture::FieldPath* path);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::OperatingState& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::OperatingState& value);

}  // namespace suture
