// Written by suturec from unit/contracts/lamp.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "unit/contracts/lamp.capnp.h"
#include "unit/contracts/lamp.suture.h"

// Defined in suture/standard/messages.wire.cpp.
namespace suture {
void toWire(const MessageSlot& slot, wire::Message::Builder out);
suture::Errc fromWire(wire::Message::Reader in, MessageSlot& slot, suture::Duration shift);
}  // namespace suture

namespace contracts {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- Lamp as Cap'n Proto

namespace {

void encodeLampLight(const LampLightArguments& slot, wire::Lamp::LightParams::Builder out) {
  out.setOn(slot.on != 0);
}
suture::Errc decodeLampLight(wire::Lamp::LightParams::Reader in, LampLightArguments& slot,
                             suture::Duration) {
  slot.on = in.getOn();
  return suture::Errc{};
}

void encodeLampLitResult(const std::uint8_t& slot, wire::Lamp::LitResults::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeLampLitResult(wire::Lamp::LitResults::Reader in, std::uint8_t& slot,
                                 suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeLampStatusEvent(const suture::MessageSlot& slot,
                           wire::LampEvents::StatusParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeLampStatusEvent(wire::LampEvents::StatusParams::Reader in,
                                   suture::MessageSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeLampWarningEvent(const suture::MessageSlot& slot,
                            wire::LampEvents::WarningParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeLampWarningEvent(wire::LampEvents::WarningParams::Reader in,
                                    suture::MessageSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeLampErrorEvent(const suture::MessageSlot& slot,
                          wire::LampEvents::ErrorParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeLampErrorEvent(wire::LampEvents::ErrorParams::Reader in,
                                  suture::MessageSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeLampLitColumn(const std::uint8_t& slot, wire::LampStateRow::Builder out) {
  out.setLit(slot != 0);
}
suture::Errc decodeLampLitColumn(wire::LampStateRow::Reader in, std::uint8_t& slot,
                                 suture::Duration) {
  slot = in.getLit();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeLampColumn(unsigned column, const std::byte* memory, wire::LampStateRow::Builder out) {
  switch (column) {
    case LampColumn::lit: return encodeLampLitColumn(suture::slotIn<std::uint8_t>(memory), out);
  }
}
suture::Errc decodeLampColumn(wire::LampStateRow::Reader in, unsigned column, std::byte* memory,
                              suture::Duration shift) {
  switch (column) {
    case LampColumn::lit:
      return decodeLampLitColumn(in, suture::newSlot<std::uint8_t>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kLampCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Lamp>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Lamp::LightParams>,
     .arguments = suture::codec::messageOf<wire::Lamp::LightParams, LampLightArguments,
                                           encodeLampLight, decodeLampLight>},
    {.interface = capnp::typeId<wire::Lamp>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Lamp::LitParams>,
     .result = suture::codec::messageOf<wire::Lamp::LitResults, std::uint8_t, encodeLampLitResult,
                                        decodeLampLitResult>,
     .stamp = suture::codec::stampIn<wire::Lamp::LitResults>},
};

constexpr suture::codec::EventCodec kLampEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::LampEvents::StatusParams>,
     .payload = suture::codec::messageOf<wire::LampEvents::StatusParams, suture::MessageSlot,
                                         encodeLampStatusEvent, decodeLampStatusEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::LampEvents::WarningParams>,
     .payload = suture::codec::messageOf<wire::LampEvents::WarningParams, suture::MessageSlot,
                                         encodeLampWarningEvent, decodeLampWarningEvent>},
    {.method = 3,
     .stamp = suture::codec::stampIn<wire::LampEvents::ErrorParams>,
     .payload = suture::codec::messageOf<wire::LampEvents::ErrorParams, suture::MessageSlot,
                                         encodeLampErrorEvent, decodeLampErrorEvent>},
};

}  // namespace

const suture::codec::Codec& lampCodec() {
  static const suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Lamp>,
      .contract = capnp::typeId<wire::Lamp>(),
      .subscriber = capnp::typeId<wire::LampEvents>(),
      .commands = kLampCommandCodecs,
      .events = kLampEventCodecs,
      .row = suture::codec::rowOf<wire::LampEvents::StateParams, wire::LampStateRow,
                                  encodeLampColumn, decodeLampColumn>,
  };
  return kCodec;
}

}  // namespace contracts
