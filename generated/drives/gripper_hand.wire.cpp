// Written by suturec from drives/gripper_hand.h. Do not edit.
#include <suture/wire/codec.h>
#include <suture/wire/wire.h>

#include "drives/gripper_hand.capnp.h"
#include "drives/gripper_hand.suture.h"

namespace robots {

using suture::rpc::fromWire;
using suture::rpc::toWire;

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

constexpr suture::rpc::CommandCodec kGripperHandCommandCodecs[] = {
    {.interface = capnp::typeId<wire::GripperHand>(),
     .method = 1,
     .sent = suture::rpc::sentIn<wire::GripperHand::SqueezeParams>,
     .arguments = suture::rpc::messageOf<wire::GripperHand::SqueezeParams,
                                         GripperHandSqueezeArguments, encodeGripperHandSqueeze,
                                         decodeGripperHandSqueeze>},
};

}  // namespace

const suture::rpc::Codec& gripperHandCodec() {
  static constexpr suture::rpc::Codec kCodec{
      .schema = suture::rpc::schemaOf<wire::GripperHand>,
      .contract = capnp::typeId<wire::GripperHand>(),
      .subscriber = capnp::typeId<wire::GripperHandEvents>(),
      .commands = kGripperHandCommandCodecs,
      .events = {},
      .row = suture::rpc::rowOf<wire::GripperHandEvents::StateParams, wire::GripperHandStateRow>,
  };
  return kCodec;
}

}  // namespace robots
