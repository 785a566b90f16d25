// Written by suturec from drives/gripper_hand.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "drives/gripper_hand.capnp.h"
#include "drives/gripper_hand.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- GripperHand as Cap'n Proto

namespace {

void encodeGripperHandSqueeze(const GripperHandSqueezeArguments& slot,
                              wire::GripperHand::SqueezeParams::Builder out) {
  out.setAngle(slot.angle);
}
suture::Errc decodeGripperHandSqueeze(wire::GripperHand::SqueezeParams::Reader in,
                                      GripperHandSqueezeArguments& slot, suture::Duration) {
  slot.angle = in.getAngle();
  return suture::Errc{};
}

constexpr suture::codec::CommandCodec kGripperHandCommandCodecs[] = {
    {.interface = capnp::typeId<wire::GripperHand>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::GripperHand::SqueezeParams>,
     .arguments = suture::codec::messageOf<wire::GripperHand::SqueezeParams,
                                           GripperHandSqueezeArguments, encodeGripperHandSqueeze,
                                           decodeGripperHandSqueeze>},
};

}  // namespace

const suture::codec::Codec& gripperHandCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::GripperHand>,
      .contract = capnp::typeId<wire::GripperHand>(),
      .subscriber = capnp::typeId<wire::GripperHandEvents>(),
      .commands = kGripperHandCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::GripperHandEvents::StateParams, wire::GripperHandStateRow>,
  };
  return kCodec;
}

}  // namespace robots
