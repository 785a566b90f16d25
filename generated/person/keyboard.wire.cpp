// Written by suturec from person/keyboard.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "person/keyboard.capnp.h"
#include "person/keyboard.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const KeyboardParametersSlot& slot, wire::KeyboardParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.terminal, out.initTerminal(sizeOf(slot.terminal)));
  out.setSpeed(slot.speed);
  out.setTurningSpeed(slot.turning_speed);
  out.setOpening(slot.opening);
  out.setHold(slot.hold);
}

suture::Errc fromWire(wire::KeyboardParameters::Reader in, KeyboardParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.speed = in.getSpeed();
  slot.turning_speed = in.getTurningSpeed();
  slot.opening = in.getOpening();
  slot.hold = in.getHold();
  return in.hasTerminal() ? fromWire(in.getTerminal(), slot.terminal)
      : suture::codec::fromDefault(KeyboardParameters().terminal, slot.terminal);
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::KeyboardParameters& value) {
  return codec::encodeAs<robots::wire::KeyboardParameters, robots::KeyboardParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::KeyboardParameters& value) {
  return codec::decodeAs<robots::wire::KeyboardParameters,
                         robots::KeyboardParametersSlot>(bytes, value);
}

}  // namespace suture
