// Written by suturec from loadable/turntable.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "loadable/turntable.capnp.h"
#include "loadable/turntable.suture.h"

namespace loadable {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- Turntable as Cap'n Proto

namespace {

void encodeTurntableTurn(const TurntableTurnArguments& slot,
                         wire::Turntable::TurnParams::Builder out) {
  out.setAngle(slot.angle);
}
suture::Errc decodeTurntableTurn(wire::Turntable::TurnParams::Reader in,
                                 TurntableTurnArguments& slot, suture::Duration) {
  slot.angle = in.getAngle();
  return suture::Errc{};
}

void encodeTurntableAngleResult(const double& slot, wire::Turntable::AngleResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeTurntableAngleResult(wire::Turntable::AngleResults::Reader in, double& slot,
                                        suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeTurntableAngleColumn(const double& slot, wire::TurntableStateRow::Builder out) {
  out.setAngle(slot);
}
suture::Errc decodeTurntableAngleColumn(wire::TurntableStateRow::Reader in, double& slot,
                                        suture::Duration) {
  slot = in.getAngle();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeTurntableColumn(unsigned column, const std::byte* memory,
                           wire::TurntableStateRow::Builder out) {
  switch (column) {
    case TurntableColumn::angle:
      return encodeTurntableAngleColumn(suture::slotIn<double>(memory), out);
  }
}
suture::Errc decodeTurntableColumn(wire::TurntableStateRow::Reader in, unsigned column,
                                   std::byte* memory, suture::Duration shift) {
  switch (column) {
    case TurntableColumn::angle:
      return decodeTurntableAngleColumn(in, suture::newSlot<double>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kTurntableCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Turntable>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Turntable::TurnParams>,
     .arguments = suture::codec::messageOf<wire::Turntable::TurnParams, TurntableTurnArguments,
                                           encodeTurntableTurn, decodeTurntableTurn>},
    {.interface = capnp::typeId<wire::Turntable>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Turntable::AngleParams>,
     .result = suture::codec::messageOf<wire::Turntable::AngleResults, double,
                                        encodeTurntableAngleResult, decodeTurntableAngleResult>,
     .stamp = suture::codec::stampIn<wire::Turntable::AngleResults>},
};

}  // namespace

const suture::codec::Codec& turntableCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Turntable>,
      .contract = capnp::typeId<wire::Turntable>(),
      .subscriber = capnp::typeId<wire::TurntableEvents>(),
      .commands = kTurntableCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::TurntableEvents::StateParams, wire::TurntableStateRow,
                                  encodeTurntableColumn, decodeTurntableColumn>,
  };
  return kCodec;
}

}  // namespace loadable
