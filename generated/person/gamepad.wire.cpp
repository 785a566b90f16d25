// Written by suturec from person/gamepad.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "person/gamepad.capnp.h"
#include "person/gamepad.suture.h"

// Defined in person/axis_range.wire.cpp.
namespace robots {
void toWire(const AxisRangeSlot& slot, wire::AxisRange::Builder out);
suture::Errc fromWire(wire::AxisRange::Reader in, AxisRangeSlot& slot, suture::Duration shift);
}  // namespace robots

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const GamepadParametersSlot& slot, wire::GamepadParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.file, out.initFile(sizeOf(slot.file)));
  toWire(slot.stick, out.initStick());
  toWire(slot.trigger, out.initTrigger());
  out.setDeadZone(slot.dead_zone);
  out.setSpeed(slot.speed);
  out.setTurningSpeed(slot.turning_speed);
  out.setOpening(slot.opening);
  out.setRetry(slot.retry);
}

suture::Errc fromWire(wire::GamepadParameters::Reader in, GamepadParametersSlot& slot,
                      suture::Duration shift) {
  slot.period = in.getPeriod();
  slot.dead_zone = in.getDeadZone();
  slot.speed = in.getSpeed();
  slot.turning_speed = in.getTurningSpeed();
  slot.opening = in.getOpening();
  slot.retry = in.getRetry();
  return suture::codec::firstError({
      in.hasFile() ? fromWire(in.getFile(), slot.file)
          : suture::codec::fromDefault(GamepadParameters().file, slot.file),
      in.hasStick() ? fromWire(in.getStick(), slot.stick, shift)
          : suture::codec::fromDefault(GamepadParameters().stick, slot.stick),
      in.hasTrigger() ? fromWire(in.getTrigger(), slot.trigger, shift)
          : suture::codec::fromDefault(GamepadParameters().trigger, slot.trigger),
  });
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::GamepadParameters& value) {
  return codec::encodeAs<robots::wire::GamepadParameters, robots::GamepadParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::GamepadParameters& value) {
  return codec::decodeAs<robots::wire::GamepadParameters,
                         robots::GamepadParametersSlot>(bytes, value);
}

}  // namespace suture
