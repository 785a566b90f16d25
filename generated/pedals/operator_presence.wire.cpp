// Written by suturec from pedals/operator_presence.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "pedals/operator_presence.capnp.h"
#include "pedals/operator_presence.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const PresenceSlot& slot, wire::Presence::Builder out) {
  out.setPresent(slot.present != 0);
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::Presence::Reader in, PresenceSlot& slot, suture::Duration shift) {
  slot.present = in.getPresent();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return suture::Errc{};
}

// --- OperatorPresence as Cap'n Proto

namespace {

void encodeOperatorPresencePresenceResult(const PresenceSlot& slot,
                                          wire::OperatorPresence::PresenceResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeOperatorPresencePresenceResult(
    wire::OperatorPresence::PresenceResults::Reader in, PresenceSlot& slot,
                                                  suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeOperatorPresenceOperatorPresentEvent(const std::uint8_t& slot,
                                                wire::OperatorPresenceEvents::OperatorPresentParams::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeOperatorPresenceOperatorPresentEvent(
    wire::OperatorPresenceEvents::OperatorPresentParams::Reader in, std::uint8_t& slot,
                                                        suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeOperatorPresencePresenceColumn(const PresenceSlot& slot,
                                          wire::OperatorPresenceStateRow::Builder out) {
  toWire(slot, out.initPresence());
}
suture::Errc decodeOperatorPresencePresenceColumn(wire::OperatorPresenceStateRow::Reader in,
                                                  PresenceSlot& slot, suture::Duration shift) {
  return in.hasPresence() ? fromWire(in.getPresence(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeOperatorPresenceColumn(unsigned column, const std::byte* memory,
                                  wire::OperatorPresenceStateRow::Builder out) {
  switch (column) {
    case OperatorPresenceColumn::presence:
      return encodeOperatorPresencePresenceColumn(suture::slotIn<PresenceSlot>(memory), out);
  }
}
suture::Errc decodeOperatorPresenceColumn(wire::OperatorPresenceStateRow::Reader in,
                                          unsigned column, std::byte* memory,
                                          suture::Duration shift) {
  switch (column) {
    case OperatorPresenceColumn::presence:
      return decodeOperatorPresencePresenceColumn(in, suture::newSlot<PresenceSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kOperatorPresenceCommandCodecs[] = {
    {.interface = capnp::typeId<wire::OperatorPresence>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::OperatorPresence::PresenceParams>,
     .result = suture::codec::messageOf<wire::OperatorPresence::PresenceResults, PresenceSlot,
                                        encodeOperatorPresencePresenceResult,
                                        decodeOperatorPresencePresenceResult>,
     .stamp = suture::codec::stampIn<wire::OperatorPresence::PresenceResults>},
};

constexpr suture::codec::EventCodec kOperatorPresenceEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::OperatorPresenceEvents::OperatorPresentParams>,
     .payload = suture::codec::messageOf<wire::OperatorPresenceEvents::OperatorPresentParams,
                                         std::uint8_t, encodeOperatorPresenceOperatorPresentEvent,
                                         decodeOperatorPresenceOperatorPresentEvent>},
};

}  // namespace

const suture::codec::Codec& operatorPresenceCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::OperatorPresence>,
      .contract = capnp::typeId<wire::OperatorPresence>(),
      .subscriber = capnp::typeId<wire::OperatorPresenceEvents>(),
      .commands = kOperatorPresenceCommandCodecs,
      .events = kOperatorPresenceEventCodecs,
      .row = suture::codec::rowOf<wire::OperatorPresenceEvents::StateParams,
                                  wire::OperatorPresenceStateRow, encodeOperatorPresenceColumn,
                                  decodeOperatorPresenceColumn>,
  };
  return kCodec;
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::Presence& value) {
  return codec::encodeAs<robots::wire::Presence, robots::PresenceSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::Presence& value) {
  return codec::decodeAs<robots::wire::Presence, robots::PresenceSlot>(bytes, value);
}

}  // namespace suture
