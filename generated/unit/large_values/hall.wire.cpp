// Written by suturec from unit/large_values/hall.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "unit/large_values/hall.capnp.h"
#include "unit/large_values/hall.suture.h"

// Defined in unit/large_values/picture.wire.cpp.
namespace large_values {
void toWire(const PictureSlot& slot, wire::Picture::Builder out);
suture::Errc fromWire(wire::Picture::Reader in, PictureSlot& slot, suture::Duration shift);
}  // namespace large_values

namespace large_values {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- Hall as Cap'n Proto

namespace {

void encodeHallFill(const HallFillArguments& slot, wire::Hall::FillParams::Builder out) {
  toWire(slot.picture, out.initPicture());
}
suture::Errc decodeHallFill(wire::Hall::FillParams::Reader in, HallFillArguments& slot,
                            suture::Duration shift) {
  return in.hasPicture() ? fromWire(in.getPicture(), slot.picture, shift) : suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kHallCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Hall>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Hall::FillParams>,
     .arguments = suture::codec::messageOf<wire::Hall::FillParams, HallFillArguments,
                                           encodeHallFill, decodeHallFill>},
};

}  // namespace

const suture::codec::Codec& hallCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Hall>,
      .contract = capnp::typeId<wire::Hall>(),
      .subscriber = capnp::typeId<wire::HallEvents>(),
      .commands = kHallCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::HallEvents::StateParams, wire::HallStateRow>,
  };
  return kCodec;
}

}  // namespace large_values
