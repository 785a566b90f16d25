// Written by suturec from robot_types/inputs.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "robot_types/inputs.capnp.h"
#include "robot_types/inputs.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::ButtonAction wireButtonAction(std::uint8_t slot) {
  switch (static_cast<ButtonAction>(slot)) {
    case ButtonAction::Undefined: return wire::ButtonAction::UNDEFINED;
    case ButtonAction::Pressed: return wire::ButtonAction::PRESSED;
    case ButtonAction::Released: return wire::ButtonAction::RELEASED;
    case ButtonAction::Clicked: return wire::ButtonAction::CLICKED;
    case ButtonAction::DoubleClicked: return wire::ButtonAction::DOUBLE_CLICKED;
  }
  return wire::ButtonAction{};
}

suture::Errc fromWire(wire::ButtonAction in, std::uint8_t& slot) {
  switch (in) {
    case wire::ButtonAction::UNDEFINED: return slot =
        static_cast<std::uint8_t>(ButtonAction::Undefined), suture::Errc{};
    case wire::ButtonAction::PRESSED: return slot =
        static_cast<std::uint8_t>(ButtonAction::Pressed), suture::Errc{};
    case wire::ButtonAction::RELEASED: return slot =
        static_cast<std::uint8_t>(ButtonAction::Released), suture::Errc{};
    case wire::ButtonAction::CLICKED: return slot =
        static_cast<std::uint8_t>(ButtonAction::Clicked), suture::Errc{};
    case wire::ButtonAction::DOUBLE_CLICKED: return slot =
        static_cast<std::uint8_t>(ButtonAction::DoubleClicked), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

void toWire(const ButtonEventSlot& slot, wire::ButtonEvent::Builder out) {
  out.setType(wireButtonAction(slot.type));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::ButtonEvent::Reader in, ButtonEventSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return fromWire(in.getType(), slot.type);
}

void toWire(const InputDataSlot& slot, wire::InputData::Builder out) {
  toWire(slot.analog_inputs, out.initAnalogInputs(sizeOf(slot.analog_inputs)));
  toWire(slot.digital_inputs, out.initDigitalInputs(sizeOf(slot.digital_inputs)));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::InputData::Reader in, InputDataSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::codec::firstError({
      fromWire(in.getAnalogInputs(), slot.analog_inputs),
      fromWire(in.getDigitalInputs(), slot.digital_inputs),
  });
}

void toWire(const ImuSampleSlot& slot, wire::ImuSample::Builder out) {
  toWire(slot.orientation, out.initOrientation());
  toWire(slot.angular_velocity, out.initAngularVelocity());
  toWire(slot.linear_acceleration, out.initLinearAcceleration());
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::ImuSample::Reader in, ImuSampleSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::codec::firstError({
      in.hasOrientation() ? fromWire(in.getOrientation(), slot.orientation)
          : suture::codec::fromDefault(ImuSample().orientation, slot.orientation),
      in.hasAngularVelocity() ? fromWire(in.getAngularVelocity(), slot.angular_velocity)
          : suture::codec::fromDefault(ImuSample().angular_velocity, slot.angular_velocity),
      in.hasLinearAcceleration() ? fromWire(in.getLinearAcceleration(), slot.linear_acceleration)
          : suture::codec::fromDefault(ImuSample().linear_acceleration, slot.linear_acceleration),
  });
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::ButtonEvent& value) {
  return codec::encodeAs<robots::wire::ButtonEvent, robots::ButtonEventSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ButtonEvent& value) {
  return codec::decodeAs<robots::wire::ButtonEvent, robots::ButtonEventSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::InputData& value) {
  return codec::encodeAs<robots::wire::InputData, robots::InputDataSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::InputData& value) {
  return codec::decodeAs<robots::wire::InputData, robots::InputDataSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::ImuSample& value) {
  return codec::encodeAs<robots::wire::ImuSample, robots::ImuSampleSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ImuSample& value) {
  return codec::decodeAs<robots::wire::ImuSample, robots::ImuSampleSlot>(bytes, value);
}

}  // namespace suture
