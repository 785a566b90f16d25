// Written by suturec from shapes/bulk.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "shapes/bulk.capnp.h"
#include "shapes/bulk.suture.h"

namespace shapes {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const BulkSlot& slot, wire::Bulk::Builder out) {
  toWire(slot.samples, out.initSamples(sizeOf(slot.samples) * sizeof(double)));
  toWire(slot.triple, out.initTriple(3 * sizeof(std::int16_t)));
  toWire(slot.bytes, out.initBytes(sizeOf(slot.bytes)));
  toWire(slot.line, out.initLine(sizeOf(slot.line) * sizeof(float)));
  toWire(slot.jacobian, out.initJacobian(42 * sizeof(double)));
  toWire(slot.image, out.initImage());
}

suture::Errc fromWire(wire::Bulk::Reader in, BulkSlot& slot, suture::Duration) {
  return suture::codec::firstError({
      fromWire(in.getSamples(), slot.samples),
      fromWire(in.getTriple(), slot.triple),
      fromWire(in.getBytes(), slot.bytes),
      fromWire(in.getLine(), slot.line),
      in.getJacobian().size() != 0 ? fromWire(in.getJacobian(), slot.jacobian)
          : suture::codec::fromDefault(Bulk().jacobian, slot.jacobian),
      fromWire(in.getImage(), slot.image),
  });
}

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Bulk& value) {
  return codec::encodeAs<shapes::wire::Bulk, shapes::BulkSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Bulk& value) {
  return codec::decodeAs<shapes::wire::Bulk, shapes::BulkSlot>(bytes, value);
}

}  // namespace suture
