// Written by suturec from unit/frame/latch.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "unit/frame/latch.capnp.h"
#include "unit/frame/latch.suture.h"

namespace latches {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- Latch as Cap'n Proto

namespace {

constexpr suture::codec::CommandCodec kLatchCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Latch>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Latch::CloseParams>},
};

constexpr suture::codec::EventCodec kLatchEventCodecs[] = {
    {.method = 1, .stamp = suture::codec::stampIn<wire::LatchEvents::ClosedParams>},
};

}  // namespace

const suture::codec::Codec& latchCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Latch>,
      .contract = capnp::typeId<wire::Latch>(),
      .subscriber = capnp::typeId<wire::LatchEvents>(),
      .commands = kLatchCommandCodecs,
      .events = kLatchEventCodecs,
      .row = suture::codec::rowOf<wire::LatchEvents::StateParams, wire::LatchStateRow>,
  };
  return kCodec;
}

}  // namespace latches
