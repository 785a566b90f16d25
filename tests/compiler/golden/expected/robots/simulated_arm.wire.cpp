// Written by suturec from robots/simulated_arm.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "robots/simulated_arm.capnp.h"
#include "robots/simulated_arm.suture.h"

// Defined in robots/arm.wire.cpp.
namespace robots {
wire::Mode wireMode(std::int8_t slot);
suture::Errc fromWire(wire::Mode in, std::int8_t& slot);
}  // namespace robots

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const ArmParametersSlot& slot, wire::ArmParameters::Builder out) {
  out.setRate(slot.rate);
  toWire(slot.name, out.initName(sizeOf(slot.name)));
  out.setStart(wireMode(slot.start));
}

suture::Errc fromWire(wire::ArmParameters::Reader in, ArmParametersSlot& slot, suture::Duration) {
  slot.rate = in.getRate();
  return suture::codec::firstError({
      fromWire(in.getName(), slot.name),
      fromWire(in.getStart(), slot.start),
  });
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::ArmParameters& value) {
  return codec::encodeAs<robots::wire::ArmParameters, robots::ArmParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ArmParameters& value) {
  return codec::decodeAs<robots::wire::ArmParameters, robots::ArmParametersSlot>(bytes, value);
}

}  // namespace suture
