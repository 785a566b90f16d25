// Written by suturec from bench/sample_loop.h. Do not edit.
#include <suture/wire/codec.h>
#include <suture/wire/wire.h>

#include "bench/sample_loop.capnp.h"
#include "bench/sample_loop.suture.h"

// Defined in robot_types/pose.wire.cpp.
namespace robots {
void toWire(const PoseSampleSlot& slot, wire::PoseSample::Builder out);
suture::Errc fromWire(wire::PoseSample::Reader in, PoseSampleSlot& slot, suture::Duration shift);
}  // namespace robots

namespace bench {

using suture::rpc::fromWire;
using suture::rpc::toWire;

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

constexpr suture::rpc::CommandCodec kSampleServerCommandCodecs[] = {
    {.interface = capnp::typeId<wire::SampleServer>(),
     .method = 1,
     .sent = suture::rpc::sentIn<wire::SampleServer::PutParams>,
     .arguments = suture::rpc::messageOf<wire::SampleServer::PutParams, SampleServerPutArguments,
                                         encodeSampleServerPut, decodeSampleServerPut>},
    {.interface = capnp::typeId<wire::SampleServer>(),
     .method = 2,
     .sent = suture::rpc::sentIn<wire::SampleServer::BounceParams>,
     .arguments = suture::rpc::messageOf<wire::SampleServer::BounceParams,
                                         SampleServerBounceArguments, encodeSampleServerBounce,
                                         decodeSampleServerBounce>},
    {.interface = capnp::typeId<wire::SampleServer>(),
     .method = 3,
     .sent = suture::rpc::sentIn<wire::SampleServer::ValueParams>,
     .result = suture::rpc::messageOf<wire::SampleServer::ValueResults, robots::PoseSampleSlot,
                                      encodeSampleServerValueResult, decodeSampleServerValueResult>,
     .stamp = suture::rpc::stampIn<wire::SampleServer::ValueResults>},
};

constexpr suture::rpc::EventCodec kSampleServerEventCodecs[] = {
    {.method = 1,
     .stamp = suture::rpc::stampIn<wire::SampleServerEvents::EchoParams>,
     .payload = suture::rpc::messageOf<wire::SampleServerEvents::EchoParams, robots::PoseSampleSlot,
                                       encodeSampleServerEchoEvent, decodeSampleServerEchoEvent>},
};

}  // namespace

const suture::rpc::Codec& sampleServerCodec() {
  static constexpr suture::rpc::Codec kCodec{
      .schema = suture::rpc::schemaOf<wire::SampleServer>,
      .contract = capnp::typeId<wire::SampleServer>(),
      .subscriber = capnp::typeId<wire::SampleServerEvents>(),
      .commands = kSampleServerCommandCodecs,
      .events = kSampleServerEventCodecs,
      .row = suture::rpc::rowOf<wire::SampleServerEvents::StateParams, wire::SampleServerStateRow,
                                encodeSampleServerColumn, decodeSampleServerColumn>,
  };
  return kCodec;
}

}  // namespace bench
