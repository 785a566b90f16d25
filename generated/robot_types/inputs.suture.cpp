// Written by suturec from robot_types/inputs.h. Do not edit.
#include "robot_types/inputs.suture.h"

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
static_assert(std::is_same_v<std::underlying_type_t<ButtonAction>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(ButtonAction::Undefined) == 0);
static_assert(static_cast<std::uint8_t>(ButtonAction::Pressed) == 1);
static_assert(static_cast<std::uint8_t>(ButtonAction::Released) == 2);
static_assert(static_cast<std::uint8_t>(ButtonAction::Clicked) == 3);
static_assert(static_cast<std::uint8_t>(ButtonAction::DoubleClicked) == 4);
static_assert(std::is_same_v<decltype(ButtonEvent::type), ButtonAction>);
static_assert(std::is_same_v<decltype(ButtonEvent::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(ButtonEvent::valid), bool>);
static_assert(std::is_same_v<decltype(InputData::analog_inputs), std::vector<double>>);
static_assert(std::is_same_v<decltype(InputData::digital_inputs), std::vector<bool>>);
static_assert(std::is_same_v<decltype(InputData::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(InputData::valid), bool>);
static_assert(std::is_same_v<decltype(ImuSample::orientation), Eigen::Quaterniond>);
static_assert(std::is_same_v<decltype(ImuSample::angular_velocity), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(ImuSample::linear_acceleration), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(ImuSample::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(ImuSample::valid), bool>);

}  // namespace

bool store(const ButtonEvent& value, ButtonEventSlot& slot) {
  bool fits = true;
  fits &= store(value.type, slot.type);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const ButtonEventSlot& slot, ButtonEvent& value) {
  load(slot.type, value.type);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(ButtonEventSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const InputData& value, InputDataSlot& slot) {
  bool fits = true;
  fits &= store(value.analog_inputs, slot.analog_inputs);
  fits &= store(value.digital_inputs, slot.digital_inputs);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const InputDataSlot& slot, InputData& value) {
  load(slot.analog_inputs, value.analog_inputs);
  load(slot.digital_inputs, value.digital_inputs);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void reserve(const InputDataSlot*, InputData& value) {
  suture::reserveFor<decltype(InputDataSlot::analog_inputs)>(value.analog_inputs);
  suture::reserveFor<decltype(InputDataSlot::digital_inputs)>(value.digital_inputs);
}

void shiftStamps(InputDataSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const ImuSample& value, ImuSampleSlot& slot) {
  bool fits = true;
  fits &= store(value.orientation, slot.orientation);
  fits &= store(value.angular_velocity, slot.angular_velocity);
  fits &= store(value.linear_acceleration, slot.linear_acceleration);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const ImuSampleSlot& slot, ImuSample& value) {
  load(slot.orientation, value.orientation);
  load(slot.angular_velocity, value.angular_velocity);
  load(slot.linear_acceleration, value.linear_acceleration);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(ImuSampleSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool isKnownButtonAction(std::uint8_t slot) {
  switch (static_cast<ButtonAction>(slot)) {
    case ButtonAction::Undefined:
    case ButtonAction::Pressed:
    case ButtonAction::Released:
    case ButtonAction::Clicked:
    case ButtonAction::DoubleClicked:
      return true;
  }
  return false;
}

bool isValid(const ButtonEventSlot& slot, suture::FieldPath* path) {
  return isKnownButtonAction(slot.type) || suture::refusedAt(path, "type");
}

bool isValid(const InputDataSlot& slot, suture::FieldPath* path) {
  return isValid(slot.analog_inputs, path) || suture::refusedAt(path, "analog_inputs");
}

bool isValid(const ImuSampleSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.orientation)) return suture::refusedAt(path, "orientation");
  if (!isValid(slot.angular_velocity, path)) return suture::refusedAt(path, "angular_velocity");
  return isValid(slot.linear_acceleration, path) || suture::refusedAt(path, "linear_acceleration");
}

}  // namespace robots
