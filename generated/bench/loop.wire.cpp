// Written by suturec from bench/loop.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "bench/loop.capnp.h"
#include "bench/loop.suture.h"

// Defined in robot_types/pose.wire.cpp.
namespace robots {
void toWire(const PosePrmSlot& slot, wire::PosePrm::Builder out);
suture::Errc fromWire(wire::PosePrm::Reader in, PosePrmSlot& slot, suture::Duration shift);
}  // namespace robots

namespace bench {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- LoopServer as Cap'n Proto

namespace {

void encodeLoopServerPut(const LoopServerPutArguments& slot,
                         wire::LoopServer::PutParams::Builder out) {
  toWire(slot.value, out.initValue());
}
suture::Errc decodeLoopServerPut(wire::LoopServer::PutParams::Reader in,
                                 LoopServerPutArguments& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid;
}

void encodeLoopServerBounce(const LoopServerBounceArguments& slot,
                            wire::LoopServer::BounceParams::Builder out) {
  toWire(slot.value, out.initValue());
}
suture::Errc decodeLoopServerBounce(wire::LoopServer::BounceParams::Reader in,
                                    LoopServerBounceArguments& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid;
}

void encodeLoopServerValueResult(const robots::PosePrmSlot& slot,
                                 wire::LoopServer::ValueResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeLoopServerValueResult(wire::LoopServer::ValueResults::Reader in,
                                         robots::PosePrmSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeLoopServerEchoEvent(const robots::PosePrmSlot& slot,
                               wire::LoopServerEvents::EchoParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeLoopServerEchoEvent(wire::LoopServerEvents::EchoParams::Reader in,
                                       robots::PosePrmSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeLoopServerValueColumn(const robots::PosePrmSlot& slot,
                                 wire::LoopServerStateRow::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeLoopServerValueColumn(wire::LoopServerStateRow::Reader in,
                                         robots::PosePrmSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeLoopServerColumn(unsigned column, const std::byte* memory,
                            wire::LoopServerStateRow::Builder out) {
  switch (column) {
    case LoopServerColumn::value:
      return encodeLoopServerValueColumn(suture::slotIn<robots::PosePrmSlot>(memory), out);
  }
}
suture::Errc decodeLoopServerColumn(wire::LoopServerStateRow::Reader in, unsigned column,
                                    std::byte* memory, suture::Duration shift) {
  switch (column) {
    case LoopServerColumn::value:
      return decodeLoopServerValueColumn(in, suture::newSlot<robots::PosePrmSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kLoopServerCommandCodecs[] = {
    {.interface = capnp::typeId<wire::LoopServer>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::LoopServer::PutParams>,
     .arguments = suture::codec::messageOf<wire::LoopServer::PutParams, LoopServerPutArguments,
                                           encodeLoopServerPut, decodeLoopServerPut>},
    {.interface = capnp::typeId<wire::LoopServer>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::LoopServer::BounceParams>,
     .arguments = suture::codec::messageOf<wire::LoopServer::BounceParams,
                                           LoopServerBounceArguments, encodeLoopServerBounce,
                                           decodeLoopServerBounce>},
    {.interface = capnp::typeId<wire::LoopServer>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::LoopServer::ValueParams>,
     .result = suture::codec::messageOf<wire::LoopServer::ValueResults, robots::PosePrmSlot,
                                        encodeLoopServerValueResult, decodeLoopServerValueResult>,
     .stamp = suture::codec::stampIn<wire::LoopServer::ValueResults>},
};

constexpr suture::codec::EventCodec kLoopServerEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::LoopServerEvents::EchoParams>,
     .payload = suture::codec::messageOf<wire::LoopServerEvents::EchoParams, robots::PosePrmSlot,
                                         encodeLoopServerEchoEvent, decodeLoopServerEchoEvent>},
};

}  // namespace

const suture::codec::Codec& loopServerCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::LoopServer>,
      .contract = capnp::typeId<wire::LoopServer>(),
      .subscriber = capnp::typeId<wire::LoopServerEvents>(),
      .commands = kLoopServerCommandCodecs,
      .events = kLoopServerEventCodecs,
      .row = suture::codec::rowOf<wire::LoopServerEvents::StateParams, wire::LoopServerStateRow,
                                  encodeLoopServerColumn, decodeLoopServerColumn>,
  };
  return kCodec;
}

}  // namespace bench
