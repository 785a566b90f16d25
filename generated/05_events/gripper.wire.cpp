// Written by suturec from 05_events/gripper.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "05_events/gripper.capnp.h"
#include "05_events/gripper.suture.h"

namespace gripping {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::Jaws wireJaws(std::uint8_t slot) {
  switch (static_cast<Jaws>(slot)) {
    case Jaws::Open: return wire::Jaws::OPEN;
    case Jaws::Closing: return wire::Jaws::CLOSING;
    case Jaws::Holding: return wire::Jaws::HOLDING;
  }
  return wire::Jaws{};
}

suture::Errc fromWire(wire::Jaws in, std::uint8_t& slot) {
  switch (in) {
    case wire::Jaws::OPEN: return slot = static_cast<std::uint8_t>(Jaws::Open), suture::Errc{};
    case wire::Jaws::CLOSING: return slot =
        static_cast<std::uint8_t>(Jaws::Closing), suture::Errc{};
    case wire::Jaws::HOLDING: return slot =
        static_cast<std::uint8_t>(Jaws::Holding), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

// --- Gripper as Cap'n Proto

namespace {

void encodeGripperReleaseResult(const std::uint8_t& slot,
                                wire::Gripper::ReleaseResults::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeGripperReleaseResult(wire::Gripper::ReleaseResults::Reader in,
                                        std::uint8_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeGripperJawsChangedEvent(const std::uint8_t& slot,
                                   wire::GripperEvents::JawsChangedParams::Builder out) {
  out.setValue(wireJaws(slot));
}
suture::Errc decodeGripperJawsChangedEvent(wire::GripperEvents::JawsChangedParams::Reader in,
                                           std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeGripperTouchedEvent(const double& slot,
                               wire::GripperEvents::TouchedParams::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeGripperTouchedEvent(wire::GripperEvents::TouchedParams::Reader in, double& slot,
                                       suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

constexpr suture::codec::CommandCodec kGripperCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Gripper>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Gripper::GraspParams>},
    {.interface = capnp::typeId<wire::Gripper>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Gripper::ReleaseParams>,
     .result = suture::codec::messageOf<wire::Gripper::ReleaseResults, std::uint8_t,
                                        encodeGripperReleaseResult, decodeGripperReleaseResult>},
};

constexpr suture::codec::EventCodec kGripperEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::GripperEvents::JawsChangedParams>,
     .payload = suture::codec::messageOf<wire::GripperEvents::JawsChangedParams, std::uint8_t,
                                         encodeGripperJawsChangedEvent,
                                         decodeGripperJawsChangedEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::GripperEvents::TouchedParams>,
     .payload = suture::codec::messageOf<wire::GripperEvents::TouchedParams, double,
                                         encodeGripperTouchedEvent, decodeGripperTouchedEvent>},
};

}  // namespace

const suture::codec::Codec& gripperCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Gripper>,
      .contract = capnp::typeId<wire::Gripper>(),
      .subscriber = capnp::typeId<wire::GripperEvents>(),
      .commands = kGripperCommandCodecs,
      .events = kGripperEventCodecs,
      .row = suture::codec::rowOf<wire::GripperEvents::StateParams, wire::GripperStateRow>,
  };
  return kCodec;
}

}  // namespace gripping
