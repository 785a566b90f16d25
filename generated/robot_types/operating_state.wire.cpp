// Written by suturec from robot_types/operating_state.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "robot_types/operating_state.capnp.h"
#include "robot_types/operating_state.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::ArmState wireArmState(std::uint8_t slot) {
  switch (static_cast<ArmState>(slot)) {
    case ArmState::Undefined: return wire::ArmState::UNDEFINED;
    case ArmState::Disabled: return wire::ArmState::DISABLED;
    case ArmState::Enabled: return wire::ArmState::ENABLED;
    case ArmState::Paused: return wire::ArmState::PAUSED;
    case ArmState::Fault: return wire::ArmState::FAULT;
  }
  return wire::ArmState{};
}

suture::Errc fromWire(wire::ArmState in, std::uint8_t& slot) {
  switch (in) {
    case wire::ArmState::UNDEFINED: return slot =
        static_cast<std::uint8_t>(ArmState::Undefined), suture::Errc{};
    case wire::ArmState::DISABLED: return slot =
        static_cast<std::uint8_t>(ArmState::Disabled), suture::Errc{};
    case wire::ArmState::ENABLED: return slot =
        static_cast<std::uint8_t>(ArmState::Enabled), suture::Errc{};
    case wire::ArmState::PAUSED: return slot =
        static_cast<std::uint8_t>(ArmState::Paused), suture::Errc{};
    case wire::ArmState::FAULT: return slot =
        static_cast<std::uint8_t>(ArmState::Fault), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

void toWire(const OperatingStateSlot& slot, wire::OperatingState::Builder out) {
  out.setState(wireArmState(slot.state));
  toWire(slot.sub_state, out.initSubState(sizeOf(slot.sub_state)));
  out.setIsHomed(slot.is_homed != 0);
  out.setIsBusy(slot.is_busy != 0);
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::OperatingState::Reader in, OperatingStateSlot& slot,
                      suture::Duration shift) {
  slot.is_homed = in.getIsHomed();
  slot.is_busy = in.getIsBusy();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return suture::codec::firstError({
      fromWire(in.getState(), slot.state),
      fromWire(in.getSubState(), slot.sub_state),
  });
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::OperatingState& value) {
  return codec::encodeAs<robots::wire::OperatingState, robots::OperatingStateSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::OperatingState& value) {
  return codec::decodeAs<robots::wire::OperatingState, robots::OperatingStateSlot>(bytes, value);
}

}  // namespace suture
