// Written by suturec from 03_own_data_type/observation.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "03_own_data_type/observation.capnp.h"
#include "03_own_data_type/observation.suture.h"

namespace tracking {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::Visibility wireVisibility(std::uint8_t slot) {
  switch (static_cast<Visibility>(slot)) {
    case Visibility::Hidden: return wire::Visibility::HIDDEN;
    case Visibility::Partial: return wire::Visibility::PARTIAL;
    case Visibility::Full: return wire::Visibility::FULL;
  }
  return wire::Visibility{};
}

suture::Errc fromWire(wire::Visibility in, std::uint8_t& slot) {
  switch (in) {
    case wire::Visibility::HIDDEN: return slot =
        static_cast<std::uint8_t>(Visibility::Hidden), suture::Errc{};
    case wire::Visibility::PARTIAL: return slot =
        static_cast<std::uint8_t>(Visibility::Partial), suture::Errc{};
    case wire::Visibility::FULL: return slot =
        static_cast<std::uint8_t>(Visibility::Full), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

void toWire(const MarkerSlot& slot, wire::Marker::Builder out) {
  out.setNumber(slot.number);
  toWire(slot.position, out.initPosition());
}

suture::Errc fromWire(wire::Marker::Reader in, MarkerSlot& slot, suture::Duration) {
  slot.number = in.getNumber();
  return in.hasPosition() ? fromWire(in.getPosition(), slot.position)
      : suture::codec::fromDefault(Marker().position, slot.position);
}

void toWire(const ObservationSlot& slot, wire::Observation::Builder out) {
  toWire(slot.instrument, out.initInstrument(sizeOf(slot.instrument)));
  out.setVisibility(wireVisibility(slot.visibility));
  toWire(slot.tip, out.initTip());
  suture::codec::toWireList(slot.markers, out.initMarkers(sizeOf(slot.markers)),
                            [](const MarkerSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  out.setJawAngle(slot.jaw_angle);
}

suture::Errc fromWire(wire::Observation::Reader in, ObservationSlot& slot, suture::Duration shift) {
  slot.jaw_angle = in.getJawAngle();
  return suture::codec::firstError({
      fromWire(in.getInstrument(), slot.instrument),
      fromWire(in.getVisibility(), slot.visibility),
      in.hasTip() ? fromWire(in.getTip(), slot.tip)
          : suture::codec::fromDefault(Observation().tip, slot.tip),
      suture::codec::fromWireList(in.getMarkers(), slot.markers,
                                  [&](auto item, MarkerSlot& target) {
                                    return fromWire(item, target, shift);
                                  }),
  });
}

}  // namespace tracking

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const tracking::Marker& value) {
  return codec::encodeAs<tracking::wire::Marker, tracking::MarkerSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, tracking::Marker& value) {
  return codec::decodeAs<tracking::wire::Marker, tracking::MarkerSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const tracking::Observation& value) {
  return codec::encodeAs<tracking::wire::Observation, tracking::ObservationSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, tracking::Observation& value) {
  return codec::decodeAs<tracking::wire::Observation, tracking::ObservationSlot>(bytes, value);
}

}  // namespace suture
