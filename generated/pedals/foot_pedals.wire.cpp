// Written by suturec from pedals/foot_pedals.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "pedals/foot_pedals.capnp.h"
#include "pedals/foot_pedals.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const PedalStateSlot& slot, wire::PedalState::Builder out) {
  out.setClutch(slot.clutch != 0);
  out.setCamera(slot.camera != 0);
  out.setCoagulation(slot.coagulation != 0);
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::PedalState::Reader in, PedalStateSlot& slot, suture::Duration shift) {
  slot.clutch = in.getClutch();
  slot.camera = in.getCamera();
  slot.coagulation = in.getCoagulation();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return suture::Errc{};
}

// --- FootPedals as Cap'n Proto

namespace {

void encodeFootPedalsPedalsResult(const PedalStateSlot& slot,
                                  wire::FootPedals::PedalsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeFootPedalsPedalsResult(wire::FootPedals::PedalsResults::Reader in,
                                          PedalStateSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeFootPedalsClutchEvent(const std::uint8_t& slot,
                                 wire::FootPedalsEvents::ClutchParams::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeFootPedalsClutchEvent(wire::FootPedalsEvents::ClutchParams::Reader in,
                                         std::uint8_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeFootPedalsCameraEvent(const std::uint8_t& slot,
                                 wire::FootPedalsEvents::CameraParams::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeFootPedalsCameraEvent(wire::FootPedalsEvents::CameraParams::Reader in,
                                         std::uint8_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeFootPedalsCoagulationEvent(const std::uint8_t& slot,
                                      wire::FootPedalsEvents::CoagulationParams::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeFootPedalsCoagulationEvent(wire::FootPedalsEvents::CoagulationParams::Reader in,
                                              std::uint8_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeFootPedalsPedalsColumn(const PedalStateSlot& slot,
                                  wire::FootPedalsStateRow::Builder out) {
  toWire(slot, out.initPedals());
}
suture::Errc decodeFootPedalsPedalsColumn(wire::FootPedalsStateRow::Reader in, PedalStateSlot& slot,
                                          suture::Duration shift) {
  return in.hasPedals() ? fromWire(in.getPedals(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeFootPedalsColumn(unsigned column, const std::byte* memory,
                            wire::FootPedalsStateRow::Builder out) {
  switch (column) {
    case FootPedalsColumn::pedals:
      return encodeFootPedalsPedalsColumn(suture::slotIn<PedalStateSlot>(memory), out);
  }
}
suture::Errc decodeFootPedalsColumn(wire::FootPedalsStateRow::Reader in, unsigned column,
                                    std::byte* memory, suture::Duration shift) {
  switch (column) {
    case FootPedalsColumn::pedals:
      return decodeFootPedalsPedalsColumn(in, suture::newSlot<PedalStateSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kFootPedalsCommandCodecs[] = {
    {.interface = capnp::typeId<wire::FootPedals>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::FootPedals::PedalsParams>,
     .result = suture::codec::messageOf<wire::FootPedals::PedalsResults, PedalStateSlot,
                                        encodeFootPedalsPedalsResult, decodeFootPedalsPedalsResult>,
     .stamp = suture::codec::stampIn<wire::FootPedals::PedalsResults>},
};

constexpr suture::codec::EventCodec kFootPedalsEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::FootPedalsEvents::ClutchParams>,
     .payload = suture::codec::messageOf<wire::FootPedalsEvents::ClutchParams, std::uint8_t,
                                         encodeFootPedalsClutchEvent, decodeFootPedalsClutchEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::FootPedalsEvents::CameraParams>,
     .payload = suture::codec::messageOf<wire::FootPedalsEvents::CameraParams, std::uint8_t,
                                         encodeFootPedalsCameraEvent, decodeFootPedalsCameraEvent>},
    {.method = 3,
     .stamp = suture::codec::stampIn<wire::FootPedalsEvents::CoagulationParams>,
     .payload = suture::codec::messageOf<wire::FootPedalsEvents::CoagulationParams, std::uint8_t,
                                         encodeFootPedalsCoagulationEvent,
                                         decodeFootPedalsCoagulationEvent>},
};

}  // namespace

const suture::codec::Codec& footPedalsCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::FootPedals>,
      .contract = capnp::typeId<wire::FootPedals>(),
      .subscriber = capnp::typeId<wire::FootPedalsEvents>(),
      .commands = kFootPedalsCommandCodecs,
      .events = kFootPedalsEventCodecs,
      .row = suture::codec::rowOf<wire::FootPedalsEvents::StateParams, wire::FootPedalsStateRow,
                                  encodeFootPedalsColumn, decodeFootPedalsColumn>,
  };
  return kCodec;
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::PedalState& value) {
  return codec::encodeAs<robots::wire::PedalState, robots::PedalStateSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::PedalState& value) {
  return codec::decodeAs<robots::wire::PedalState, robots::PedalStateSlot>(bytes, value);
}

}  // namespace suture
