// Written by suturec from robot_types/operating_state.h. Do not edit.
#include "robot_types/operating_state.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<ArmState>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(ArmState::Undefined) == 0);
static_assert(static_cast<std::uint8_t>(ArmState::Disabled) == 1);
static_assert(static_cast<std::uint8_t>(ArmState::Enabled) == 2);
static_assert(static_cast<std::uint8_t>(ArmState::Paused) == 3);
static_assert(static_cast<std::uint8_t>(ArmState::Fault) == 4);
static_assert(std::is_same_v<decltype(OperatingState::state), ArmState>);
static_assert(std::is_same_v<decltype(OperatingState::sub_state), std::string>);
static_assert(std::is_same_v<decltype(OperatingState::is_homed), bool>);
static_assert(std::is_same_v<decltype(OperatingState::is_busy), bool>);
static_assert(std::is_same_v<decltype(OperatingState::stamp),
                             std::chrono::steady_clock::time_point>);

}  // namespace

bool store(const OperatingState& value, OperatingStateSlot& slot) {
  bool fits = true;
  fits &= store(value.state, slot.state);
  fits &= store(value.sub_state, slot.sub_state);
  fits &= store(value.is_homed, slot.is_homed);
  fits &= store(value.is_busy, slot.is_busy);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const OperatingStateSlot& slot, OperatingState& value) {
  load(slot.state, value.state);
  load(slot.sub_state, value.sub_state);
  load(slot.is_homed, value.is_homed);
  load(slot.is_busy, value.is_busy);
  load(slot.stamp, value.stamp);
}

void reserve(const OperatingStateSlot*, OperatingState& value) {
  suture::reserveFor<decltype(OperatingStateSlot::sub_state)>(value.sub_state);
}

void shiftStamps(OperatingStateSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool isKnownArmState(std::uint8_t slot) {
  switch (static_cast<ArmState>(slot)) {
    case ArmState::Undefined:
    case ArmState::Disabled:
    case ArmState::Enabled:
    case ArmState::Paused:
    case ArmState::Fault:
      return true;
  }
  return false;
}

bool isValid(const OperatingStateSlot& slot, suture::FieldPath* path) {
  return isKnownArmState(slot.state) || suture::refusedAt(path, "state");
}

}  // namespace robots
