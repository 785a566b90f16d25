// Written by suturec from suture/standard/messages.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "suture/standard/messages.capnp.h"
#include "suture/standard/messages.suture.h"

namespace suture {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const MessageSlot& slot, wire::Message::Builder out) {
  toWire(slot.text, out.initText(sizeOf(slot.text)));
  out.setCode(slot.code);
  out.setCounter(slot.counter);
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::Message::Reader in, MessageSlot& slot, suture::Duration shift) {
  slot.code = in.getCode();
  slot.counter = in.getCounter();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return fromWire(in.getText(), slot.text);
}

// --- Messages as Cap'n Proto

namespace {

void encodeMessagesStatusEvent(const MessageSlot& slot,
                               wire::MessagesEvents::StatusParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeMessagesStatusEvent(wire::MessagesEvents::StatusParams::Reader in,
                                       MessageSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeMessagesWarningEvent(const MessageSlot& slot,
                                wire::MessagesEvents::WarningParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeMessagesWarningEvent(wire::MessagesEvents::WarningParams::Reader in,
                                        MessageSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeMessagesErrorEvent(const MessageSlot& slot,
                              wire::MessagesEvents::ErrorParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeMessagesErrorEvent(wire::MessagesEvents::ErrorParams::Reader in,
                                      MessageSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

constexpr suture::codec::EventCodec kMessagesEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::MessagesEvents::StatusParams>,
     .payload = suture::codec::messageOf<wire::MessagesEvents::StatusParams, MessageSlot,
                                         encodeMessagesStatusEvent, decodeMessagesStatusEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::MessagesEvents::WarningParams>,
     .payload = suture::codec::messageOf<wire::MessagesEvents::WarningParams, MessageSlot,
                                         encodeMessagesWarningEvent, decodeMessagesWarningEvent>},
    {.method = 3,
     .stamp = suture::codec::stampIn<wire::MessagesEvents::ErrorParams>,
     .payload = suture::codec::messageOf<wire::MessagesEvents::ErrorParams, MessageSlot,
                                         encodeMessagesErrorEvent, decodeMessagesErrorEvent>},
};

}  // namespace

const suture::codec::Codec& messagesCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Messages>,
      .contract = capnp::typeId<wire::Messages>(),
      .subscriber = capnp::typeId<wire::MessagesEvents>(),
      .commands = {},
      .events = kMessagesEventCodecs,
      .row = suture::codec::rowOf<wire::MessagesEvents::StateParams, wire::MessagesStateRow>,
  };
  return kCodec;
}

}  // namespace suture

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const suture::Message& value) {
  return codec::encodeAs<suture::wire::Message, suture::MessageSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, suture::Message& value) {
  return codec::decodeAs<suture::wire::Message, suture::MessageSlot>(bytes, value);
}

}  // namespace suture
