// Written by suturec from console/system_console.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "console/system_console.capnp.h"
#include "console/system_console.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const SystemConsoleParametersSlot& slot, wire::SystemConsoleParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.system, out.initSystem(sizeOf(slot.system)));
  out.setPatience(slot.patience);
  out.setBringUpByItself(slot.bring_up_by_itself != 0);
}

suture::Errc fromWire(wire::SystemConsoleParameters::Reader in, SystemConsoleParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.patience = in.getPatience();
  slot.bring_up_by_itself = in.getBringUpByItself();
  return fromWire(in.getSystem(), slot.system);
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::SystemConsoleParameters& value) {
  return codec::encodeAs<robots::wire::SystemConsoleParameters,
                         robots::SystemConsoleParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::SystemConsoleParameters& value) {
  return codec::decodeAs<robots::wire::SystemConsoleParameters,
                         robots::SystemConsoleParametersSlot>(bytes, value);
}

}  // namespace suture
