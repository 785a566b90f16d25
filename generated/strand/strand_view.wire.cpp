// Written by suturec from strand/strand_view.h. Do not edit.
#include <suture/wire/codec.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include "strand/strand_view.capnp.h"
#include "strand/strand_view.suture.h"

namespace robots {

using suture::rpc::fromWire;
using suture::rpc::toWire;

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
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return in.getNodes().size() != 0 ? fromWire(in.getNodes(), slot.nodes)
      : suture::rpc::fromDefault(StrandState().nodes, slot.nodes);
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

constexpr suture::rpc::CommandCodec kStrandViewCommandCodecs[] = {
    {.interface = capnp::typeId<wire::StrandView>(),
     .method = 1,
     .sent = suture::rpc::sentIn<wire::StrandView::StrandParams>,
     .result = suture::rpc::messageOf<wire::StrandView::StrandResults, StrandStateSlot,
                                      encodeStrandViewStrandResult, decodeStrandViewStrandResult>,
     .stamp = suture::rpc::stampIn<wire::StrandView::StrandResults>},
};

}  // namespace

const suture::rpc::Codec& strandViewCodec() {
  static constexpr suture::rpc::Codec kCodec{
      .schema = suture::rpc::schemaOf<wire::StrandView>,
      .contract = capnp::typeId<wire::StrandView>(),
      .subscriber = capnp::typeId<wire::StrandViewEvents>(),
      .commands = kStrandViewCommandCodecs,
      .events = {},
      .row = suture::rpc::rowOf<wire::StrandViewEvents::StateParams, wire::StrandViewStateRow,
                                encodeStrandViewColumn, decodeStrandViewColumn>,
  };
  return kCodec;
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::StrandState& value) {
  return rpc::encodeAs<robots::wire::StrandState, robots::StrandStateSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::StrandState& value) {
  return rpc::decodeAs<robots::wire::StrandState, robots::StrandStateSlot>(bytes, value);
}

}  // namespace suture
