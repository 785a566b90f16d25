// Written by suturec from bench/sample_loop.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "bench/sample_loop.capnp.h"
#include "bench/sample_loop.suture.h"

// Defined in robot_types/pose.wire.cpp.
namespace robots {
void toWire(const PoseSampleSlot& slot, wire::PoseSample::Builder out);
suture::Errc fromWire(wire::PoseSample::Reader in, PoseSampleSlot& slot, suture::Duration shift);
}  // namespace robots

namespace bench {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- SampleServer as Cap'n Proto

namespace {

void encodeSampleServerPut(const SampleServerPutArguments& slot,
                           wire::SampleServer::PutParams::Builder out) {
  toWire(slot.value, out.initValue());
}
suture::Errc decodeSampleServerPut(wire::SampleServer::PutParams::Reader in,
                                   SampleServerPutArguments& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid;
}

void encodeSampleServerBounce(const SampleServerBounceArguments& slot,
                              wire::SampleServer::BounceParams::Builder out) {
  toWire(slot.value, out.initValue());
}
suture::Errc decodeSampleServerBounce(wire::SampleServer::BounceParams::Reader in,
                                      SampleServerBounceArguments& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid;
}

void encodeSampleServerValueResult(const robots::PoseSampleSlot& slot,
                                   wire::SampleServer::ValueResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeSampleServerValueResult(wire::SampleServer::ValueResults::Reader in,
                                           robots::PoseSampleSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeSampleServerEchoEvent(const robots::PoseSampleSlot& slot,
                                 wire::SampleServerEvents::EchoParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeSampleServerEchoEvent(wire::SampleServerEvents::EchoParams::Reader in,
                                         robots::PoseSampleSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeSampleServerValueColumn(const robots::PoseSampleSlot& slot,
                                   wire::SampleServerStateRow::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeSampleServerValueColumn(wire::SampleServerStateRow::Reader in,
                                           robots::PoseSampleSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeSampleServerColumn(unsigned column, const std::byte* memory,
                              wire::SampleServerStateRow::Builder out) {
  switch (column) {
    case SampleServerColumn::value:
      return encodeSampleServerValueColumn(suture::slotIn<robots::PoseSampleSlot>(memory), out);
  }
}
suture::Errc decodeSampleServerColumn(wire::SampleServerStateRow::Reader in, unsigned column,
                                      std::byte* memory, suture::Duration shift) {
  switch (column) {
    case SampleServerColumn::value:
      return decodeSampleServerValueColumn(in, suture::newSlot<robots::PoseSampleSlot>(memory),
                                           shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kSampleServerCommandCodecs[] = {
    {.interface = capnp::typeId<wire::SampleServer>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::SampleServer::PutParams>,
     .arguments = suture::codec::messageOf<wire::SampleServer::PutParams, SampleServerPutArguments,
                                           encodeSampleServerPut, decodeSampleServerPut>},
    {.interface = capnp::typeId<wire::SampleServer>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::SampleServer::BounceParams>,
     .arguments = suture::codec::messageOf<wire::SampleServer::BounceParams,
                                           SampleServerBounceArguments, encodeSampleServerBounce,
                                           decodeSampleServerBounce>},
    {.interface = capnp::typeId<wire::SampleServer>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::SampleServer::ValueParams>,
     .result = suture::codec::messageOf<wire::SampleServer::ValueResults, robots::PoseSampleSlot,
                                        encodeSampleServerValueResult,
                                        decodeSampleServerValueResult>,
     .stamp = suture::codec::stampIn<wire::SampleServer::ValueResults>},
};

constexpr suture::codec::EventCodec kSampleServerEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::SampleServerEvents::EchoParams>,
     .payload = suture::codec::messageOf<wire::SampleServerEvents::EchoParams,
                                         robots::PoseSampleSlot, encodeSampleServerEchoEvent,
                                         decodeSampleServerEchoEvent>},
};

}  // namespace

const suture::codec::Codec& sampleServerCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::SampleServer>,
      .contract = capnp::typeId<wire::SampleServer>(),
      .subscriber = capnp::typeId<wire::SampleServerEvents>(),
      .commands = kSampleServerCommandCodecs,
      .events = kSampleServerEventCodecs,
      .row = suture::codec::rowOf<wire::SampleServerEvents::StateParams, wire::SampleServerStateRow,
                                  encodeSampleServerColumn, decodeSampleServerColumn>,
  };
  return kCodec;
}

}  // namespace bench
