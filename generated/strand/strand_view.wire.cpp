// Written by suturec from strand/strand_view.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "strand/strand_view.capnp.h"
#include "strand/strand_view.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const StrandStateSlot& slot, wire::StrandState::Builder out) {
  toWire(slot.nodes, out.initNodes(183));
  out.setLeftLength(slot.left_length);
  out.setLeftTension(slot.left_tension);
  out.setRightTension(slot.right_tension);
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::StrandState::Reader in, StrandStateSlot& slot, suture::Duration shift) {
  slot.left_length = in.getLeftLength();
  slot.left_tension = in.getLeftTension();
  slot.right_tension = in.getRightTension();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return in.getNodes().size() != 0 ? fromWire(in.getNodes(), slot.nodes)
      : suture::codec::fromDefault(StrandState().nodes, slot.nodes);
}

// --- StrandView as Cap'n Proto

namespace {

void encodeStrandViewStrandResult(const StrandStateSlot& slot,
                                  wire::StrandView::StrandResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeStrandViewStrandResult(wire::StrandView::StrandResults::Reader in,
                                          StrandStateSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeStrandViewStrandColumn(const StrandStateSlot& slot,
                                  wire::StrandViewStateRow::Builder out) {
  toWire(slot, out.initStrand());
}
suture::Errc decodeStrandViewStrandColumn(wire::StrandViewStateRow::Reader in,
                                          StrandStateSlot& slot, suture::Duration shift) {
  return in.hasStrand() ? fromWire(in.getStrand(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeStrandViewColumn(unsigned column, const std::byte* memory,
                            wire::StrandViewStateRow::Builder out) {
  switch (column) {
    case StrandViewColumn::strand:
      return encodeStrandViewStrandColumn(suture::slotIn<StrandStateSlot>(memory), out);
  }
}
suture::Errc decodeStrandViewColumn(wire::StrandViewStateRow::Reader in, unsigned column,
                                    std::byte* memory, suture::Duration shift) {
  switch (column) {
    case StrandViewColumn::strand:
      return decodeStrandViewStrandColumn(in, suture::newSlot<StrandStateSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kStrandViewCommandCodecs[] = {
    {.interface = capnp::typeId<wire::StrandView>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::StrandView::StrandParams>,
     .result = suture::codec::messageOf<wire::StrandView::StrandResults, StrandStateSlot,
                                        encodeStrandViewStrandResult, decodeStrandViewStrandResult>,
     .stamp = suture::codec::stampIn<wire::StrandView::StrandResults>},
};

}  // namespace

const suture::codec::Codec& strandViewCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::StrandView>,
      .contract = capnp::typeId<wire::StrandView>(),
      .subscriber = capnp::typeId<wire::StrandViewEvents>(),
      .commands = kStrandViewCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::StrandViewEvents::StateParams, wire::StrandViewStateRow,
                                  encodeStrandViewColumn, decodeStrandViewColumn>,
  };
  return kCodec;
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::StrandState& value) {
  return codec::encodeAs<robots::wire::StrandState, robots::StrandStateSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::StrandState& value) {
  return codec::decodeAs<robots::wire::StrandState, robots::StrandStateSlot>(bytes, value);
}

}  // namespace suture
