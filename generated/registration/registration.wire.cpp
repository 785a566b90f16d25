// Written by suturec from registration/registration.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "registration/registration.capnp.h"
#include "registration/registration.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const SceneFramesSlot& slot, wire::SceneFrames::Builder out) {
  toWire(slot.left_base, out.initLeftBase());
  toWire(slot.right_base, out.initRightBase());
  toWire(slot.camera, out.initCamera());
  out.setTissue(slot.tissue);
  toWire(slot.left_master, out.initLeftMaster());
  toWire(slot.right_master, out.initRightMaster());
  toWire(slot.display, out.initDisplay());
}

suture::Errc fromWire(wire::SceneFrames::Reader in, SceneFramesSlot& slot, suture::Duration) {
  slot.tissue = in.getTissue();
  return suture::codec::firstError({
      in.hasLeftBase() ? fromWire(in.getLeftBase(), slot.left_base)
          : suture::codec::fromDefault(SceneFrames().left_base, slot.left_base),
      in.hasRightBase() ? fromWire(in.getRightBase(), slot.right_base)
          : suture::codec::fromDefault(SceneFrames().right_base, slot.right_base),
      in.hasCamera() ? fromWire(in.getCamera(), slot.camera)
          : suture::codec::fromDefault(SceneFrames().camera, slot.camera),
      in.hasLeftMaster() ? fromWire(in.getLeftMaster(), slot.left_master)
          : suture::codec::fromDefault(SceneFrames().left_master, slot.left_master),
      in.hasRightMaster() ? fromWire(in.getRightMaster(), slot.right_master)
          : suture::codec::fromDefault(SceneFrames().right_master, slot.right_master),
      in.hasDisplay() ? fromWire(in.getDisplay(), slot.display)
          : suture::codec::fromDefault(SceneFrames().display, slot.display),
  });
}

// --- Registration as Cap'n Proto

namespace {

void encodeRegistrationFramesResult(const SceneFramesSlot& slot,
                                    wire::Registration::FramesResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeRegistrationFramesResult(wire::Registration::FramesResults::Reader in,
                                            SceneFramesSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeRegistrationSetCamera(const RegistrationSetCameraArguments& slot,
                                 wire::Registration::SetCameraParams::Builder out) {
  toWire(slot.camera, out.initCamera());
}
suture::Errc decodeRegistrationSetCamera(wire::Registration::SetCameraParams::Reader in,
                                         RegistrationSetCameraArguments& slot, suture::Duration) {
  return in.hasCamera() ? fromWire(in.getCamera(), slot.camera) : suture::Errc::Invalid;
}

void encodeRegistrationFramesColumn(const SceneFramesSlot& slot,
                                    wire::RegistrationStateRow::Builder out) {
  toWire(slot, out.initFrames());
}
suture::Errc decodeRegistrationFramesColumn(wire::RegistrationStateRow::Reader in,
                                            SceneFramesSlot& slot, suture::Duration shift) {
  return in.hasFrames() ? fromWire(in.getFrames(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeRegistrationColumn(unsigned column, const std::byte* memory,
                              wire::RegistrationStateRow::Builder out) {
  switch (column) {
    case RegistrationColumn::frames:
      return encodeRegistrationFramesColumn(suture::slotIn<SceneFramesSlot>(memory), out);
  }
}
suture::Errc decodeRegistrationColumn(wire::RegistrationStateRow::Reader in, unsigned column,
                                      std::byte* memory, suture::Duration shift) {
  switch (column) {
    case RegistrationColumn::frames:
      return decodeRegistrationFramesColumn(in, suture::newSlot<SceneFramesSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kRegistrationCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Registration>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Registration::FramesParams>,
     .result = suture::codec::messageOf<wire::Registration::FramesResults, SceneFramesSlot,
                                        encodeRegistrationFramesResult,
                                        decodeRegistrationFramesResult>,
     .stamp = suture::codec::stampIn<wire::Registration::FramesResults>},
    {.interface = capnp::typeId<wire::Registration>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Registration::SetCameraParams>,
     .arguments = suture::codec::messageOf<wire::Registration::SetCameraParams,
                                           RegistrationSetCameraArguments,
                                           encodeRegistrationSetCamera,
                                           decodeRegistrationSetCamera>},
};

}  // namespace

const suture::codec::Codec& registrationCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Registration>,
      .contract = capnp::typeId<wire::Registration>(),
      .subscriber = capnp::typeId<wire::RegistrationEvents>(),
      .commands = kRegistrationCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::RegistrationEvents::StateParams, wire::RegistrationStateRow,
                                  encodeRegistrationColumn, decodeRegistrationColumn>,
  };
  return kCodec;
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::SceneFrames& value) {
  return codec::encodeAs<robots::wire::SceneFrames, robots::SceneFramesSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::SceneFrames& value) {
  return codec::decodeAs<robots::wire::SceneFrames, robots::SceneFramesSlot>(bytes, value);
}

}  // namespace suture
