// Written by suturec from coordinator/coordinator.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "coordinator/coordinator.capnp.h"
#include "coordinator/coordinator.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const CoordinatorParametersSlot& slot, wire::CoordinatorParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.buttons, out.initButtons(sizeOf(slot.buttons)));
}

suture::Errc fromWire(wire::CoordinatorParameters::Reader in, CoordinatorParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  return fromWire(in.getButtons(), slot.buttons);
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::CoordinatorParameters& value) {
  return codec::encodeAs<robots::wire::CoordinatorParameters,
                         robots::CoordinatorParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::CoordinatorParameters& value) {
  return codec::decodeAs<robots::wire::CoordinatorParameters,
                         robots::CoordinatorParametersSlot>(bytes, value);
}

}  // namespace suture
