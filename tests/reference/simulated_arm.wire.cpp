// Written by suturec from reference/simulated_arm.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "reference/simulated_arm.capnp.h"
#include "reference/simulated_arm.suture.h"

namespace reference {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const SimulatedArmParametersSlot& slot, wire::SimulatedArmParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.home, out.initHome(3));
  toWire(slot.model, out.initModel(sizeOf(slot.model)));
}

suture::Errc fromWire(wire::SimulatedArmParameters::Reader in, SimulatedArmParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  return suture::codec::firstError({
      in.getHome().size() != 0 ? fromWire(in.getHome(), slot.home)
          : suture::codec::fromDefault(SimulatedArmParameters().home, slot.home),
      fromWire(in.getModel(), slot.model),
  });
}

}  // namespace reference

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const reference::SimulatedArmParameters& value) {
  return codec::encodeAs<reference::wire::SimulatedArmParameters,
                         reference::SimulatedArmParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, reference::SimulatedArmParameters& value) {
  return codec::decodeAs<reference::wire::SimulatedArmParameters,
                         reference::SimulatedArmParametersSlot>(bytes, value);
}

}  // namespace suture
