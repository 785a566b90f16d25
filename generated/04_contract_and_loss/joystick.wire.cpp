// Written by suturec from 04_contract_and_loss/joystick.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "04_contract_and_loss/joystick.capnp.h"
#include "04_contract_and_loss/joystick.suture.h"

namespace following {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- Joystick as Cap'n Proto

namespace {

void encodeJoystickAngleResult(const double& slot, wire::Joystick::AngleResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeJoystickAngleResult(wire::Joystick::AngleResults::Reader in, double& slot,
                                       suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeJoystickAngleColumn(const double& slot, wire::JoystickStateRow::Builder out) {
  out.setAngle(slot);
}
suture::Errc decodeJoystickAngleColumn(wire::JoystickStateRow::Reader in, double& slot,
                                       suture::Duration) {
  slot = in.getAngle();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeJoystickColumn(unsigned column, const std::byte* memory,
                          wire::JoystickStateRow::Builder out) {
  switch (column) {
    case JoystickColumn::angle:
      return encodeJoystickAngleColumn(suture::slotIn<double>(memory), out);
  }
}
suture::Errc decodeJoystickColumn(wire::JoystickStateRow::Reader in, unsigned column,
                                  std::byte* memory, suture::Duration shift) {
  switch (column) {
    case JoystickColumn::angle:
      return decodeJoystickAngleColumn(in, suture::newSlot<double>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kJoystickCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Joystick>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Joystick::AngleParams>,
     .result = suture::codec::messageOf<wire::Joystick::AngleResults, double,
                                        encodeJoystickAngleResult, decodeJoystickAngleResult>,
     .stamp = suture::codec::stampIn<wire::Joystick::AngleResults>},
};

}  // namespace

const suture::codec::Codec& joystickCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Joystick>,
      .contract = capnp::typeId<wire::Joystick>(),
      .subscriber = capnp::typeId<wire::JoystickEvents>(),
      .commands = kJoystickCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::JoystickEvents::StateParams, wire::JoystickStateRow,
                                  encodeJoystickColumn, decodeJoystickColumn>,
  };
  return kCodec;
}

}  // namespace following
