// Written by suturec from 03_own_data_type/camera.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "03_own_data_type/camera.capnp.h"
#include "03_own_data_type/camera.suture.h"

// Defined in 03_own_data_type/observation.wire.cpp.
namespace tracking {
void toWire(const ObservationSlot& slot, wire::Observation::Builder out);
suture::Errc fromWire(wire::Observation::Reader in, ObservationSlot& slot, suture::Duration shift);
}  // namespace tracking

namespace tracking {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const CameraParametersSlot& slot, wire::CameraParameters::Builder out) {
  toWire(slot.first, out.initFirst());
  out.setTurnRate(slot.turn_rate);
}

suture::Errc fromWire(wire::CameraParameters::Reader in, CameraParametersSlot& slot,
                      suture::Duration shift) {
  slot.turn_rate = in.getTurnRate();
  return fromWire(in.getFirst(), slot.first, shift);
}

}  // namespace tracking

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const tracking::CameraParameters& value) {
  return codec::encodeAs<tracking::wire::CameraParameters, tracking::CameraParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, tracking::CameraParameters& value) {
  return codec::decodeAs<tracking::wire::CameraParameters,
                         tracking::CameraParametersSlot>(bytes, value);
}

}  // namespace suture
