// Written by suturec from robot_types/operating_state.h. Do not edit.
#include "robot_types/operating_state.suture.h"

#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "robot_types/operating_state.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
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
  slot.stamp = suture::rpc::shifted(slot.stamp, shift);
}

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
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  return suture::rpc::firstError({
      fromWire(in.getState(), slot.state),
      fromWire(in.getSubState(), slot.sub_state),
  });
}

bool isValid(const OperatingStateSlot& slot, suture::FieldPath* path) {
  return isKnownArmState(slot.state) || suture::refusedAt(path, "state");
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::OperatingState& value) {
  return rpc::encodeAs<robots::wire::OperatingState, robots::OperatingStateSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::OperatingState& value) {
  return rpc::decodeAs<robots::wire::OperatingState, robots::OperatingStateSlot>(bytes, value);
}

}  // namespace suture
