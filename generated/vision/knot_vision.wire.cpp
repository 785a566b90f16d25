// Written by suturec from vision/knot_vision.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "vision/knot_vision.capnp.h"
#include "vision/knot_vision.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const KnotSightingSlot& slot, wire::KnotSighting::Builder out) {
  toWire(slot.knot, out.initKnot());
  toWire(slot.left_tip, out.initLeftTip());
  toWire(slot.right_tip, out.initRightTip());
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::KnotSighting::Reader in, KnotSightingSlot& slot,
                      suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::codec::firstError({
      in.hasKnot() ? fromWire(in.getKnot(), slot.knot)
          : suture::codec::fromDefault(KnotSighting().knot, slot.knot),
      in.hasLeftTip() ? fromWire(in.getLeftTip(), slot.left_tip)
          : suture::codec::fromDefault(KnotSighting().left_tip, slot.left_tip),
      in.hasRightTip() ? fromWire(in.getRightTip(), slot.right_tip)
          : suture::codec::fromDefault(KnotSighting().right_tip, slot.right_tip),
  });
}

// --- KnotVision as Cap'n Proto

namespace {

void encodeKnotVisionSightingResult(const KnotSightingSlot& slot,
                                    wire::KnotVision::SightingResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeKnotVisionSightingResult(wire::KnotVision::SightingResults::Reader in,
                                            KnotSightingSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeKnotVisionSightingColumn(const KnotSightingSlot& slot,
                                    wire::KnotVisionStateRow::Builder out) {
  toWire(slot, out.initSighting());
}
suture::Errc decodeKnotVisionSightingColumn(wire::KnotVisionStateRow::Reader in,
                                            KnotSightingSlot& slot, suture::Duration shift) {
  return in.hasSighting() ? fromWire(in.getSighting(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeKnotVisionColumn(unsigned column, const std::byte* memory,
                            wire::KnotVisionStateRow::Builder out) {
  switch (column) {
    case KnotVisionColumn::sighting:
      return encodeKnotVisionSightingColumn(suture::slotIn<KnotSightingSlot>(memory), out);
  }
}
suture::Errc decodeKnotVisionColumn(wire::KnotVisionStateRow::Reader in, unsigned column,
                                    std::byte* memory, suture::Duration shift) {
  switch (column) {
    case KnotVisionColumn::sighting:
      return decodeKnotVisionSightingColumn(in, suture::newSlot<KnotSightingSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kKnotVisionCommandCodecs[] = {
    {.interface = capnp::typeId<wire::KnotVision>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::KnotVision::SightingParams>,
     .result = suture::codec::messageOf<wire::KnotVision::SightingResults, KnotSightingSlot,
                                        encodeKnotVisionSightingResult,
                                        decodeKnotVisionSightingResult>,
     .stamp = suture::codec::stampIn<wire::KnotVision::SightingResults>},
};

}  // namespace

const suture::codec::Codec& knotVisionCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::KnotVision>,
      .contract = capnp::typeId<wire::KnotVision>(),
      .subscriber = capnp::typeId<wire::KnotVisionEvents>(),
      .commands = kKnotVisionCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::KnotVisionEvents::StateParams, wire::KnotVisionStateRow,
                                  encodeKnotVisionColumn, decodeKnotVisionColumn>,
  };
  return kCodec;
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::KnotSighting& value) {
  return codec::encodeAs<robots::wire::KnotSighting, robots::KnotSightingSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::KnotSighting& value) {
  return codec::decodeAs<robots::wire::KnotSighting, robots::KnotSightingSlot>(bytes, value);
}

}  // namespace suture
