// Written by suturec from coordinator/emergency_stop.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "coordinator/emergency_stop.capnp.h"
#include "coordinator/emergency_stop.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const PermitSlot& slot, wire::Permit::Builder out) {
  out.setGranted(slot.granted != 0);
  out.setStamp(slot.stamp);
  out.setPress(slot.press);
}

suture::Errc fromWire(wire::Permit::Reader in, PermitSlot& slot, suture::Duration shift) {
  slot.granted = in.getGranted();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.press = in.getPress();
  return suture::Errc{};
}

void toWire(const StopNewsSlot& slot, wire::StopNews::Builder out) {
  out.setPressed(slot.pressed != 0);
  out.setStamp(slot.stamp);
  out.setIsStart(slot.is_start != 0);
  out.setPress(slot.press);
}

suture::Errc fromWire(wire::StopNews::Reader in, StopNewsSlot& slot, suture::Duration shift) {
  slot.pressed = in.getPressed();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.is_start = in.getIsStart();
  slot.press = in.getPress();
  return suture::Errc{};
}

// --- EmergencyStop as Cap'n Proto

namespace {

void encodeEmergencyStopRelease(const EmergencyStopReleaseArguments& slot,
                                wire::EmergencyStop::ReleaseParams::Builder out) {
  out.setPress(slot.press);
}
suture::Errc decodeEmergencyStopRelease(wire::EmergencyStop::ReleaseParams::Reader in,
                                        EmergencyStopReleaseArguments& slot, suture::Duration) {
  slot.press = in.getPress();
  return suture::Errc{};
}

void encodeEmergencyStopPermitResult(const PermitSlot& slot,
                                     wire::EmergencyStop::PermitResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeEmergencyStopPermitResult(wire::EmergencyStop::PermitResults::Reader in,
                                             PermitSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeEmergencyStopStopEvent(const StopNewsSlot& slot,
                                  wire::EmergencyStopEvents::StopParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeEmergencyStopStopEvent(wire::EmergencyStopEvents::StopParams::Reader in,
                                          StopNewsSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeEmergencyStopPermitColumn(const PermitSlot& slot,
                                     wire::EmergencyStopStateRow::Builder out) {
  toWire(slot, out.initPermit());
}
suture::Errc decodeEmergencyStopPermitColumn(wire::EmergencyStopStateRow::Reader in,
                                             PermitSlot& slot, suture::Duration shift) {
  return in.hasPermit() ? fromWire(in.getPermit(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeEmergencyStopColumn(unsigned column, const std::byte* memory,
                               wire::EmergencyStopStateRow::Builder out) {
  switch (column) {
    case EmergencyStopColumn::permit:
      return encodeEmergencyStopPermitColumn(suture::slotIn<PermitSlot>(memory), out);
  }
}
suture::Errc decodeEmergencyStopColumn(wire::EmergencyStopStateRow::Reader in, unsigned column,
                                       std::byte* memory, suture::Duration shift) {
  switch (column) {
    case EmergencyStopColumn::permit:
      return decodeEmergencyStopPermitColumn(in, suture::newSlot<PermitSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kEmergencyStopCommandCodecs[] = {
    {.interface = capnp::typeId<wire::EmergencyStop>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::EmergencyStop::PressParams>},
    {.interface = capnp::typeId<wire::EmergencyStop>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::EmergencyStop::ReleaseParams>,
     .arguments = suture::codec::messageOf<wire::EmergencyStop::ReleaseParams,
                                           EmergencyStopReleaseArguments,
                                           encodeEmergencyStopRelease, decodeEmergencyStopRelease>},
    {.interface = capnp::typeId<wire::EmergencyStop>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::EmergencyStop::PermitParams>,
     .result = suture::codec::messageOf<wire::EmergencyStop::PermitResults, PermitSlot,
                                        encodeEmergencyStopPermitResult,
                                        decodeEmergencyStopPermitResult>,
     .stamp = suture::codec::stampIn<wire::EmergencyStop::PermitResults>},
};

constexpr suture::codec::EventCodec kEmergencyStopEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::EmergencyStopEvents::StopParams>,
     .payload = suture::codec::messageOf<wire::EmergencyStopEvents::StopParams, StopNewsSlot,
                                         encodeEmergencyStopStopEvent,
                                         decodeEmergencyStopStopEvent>},
};

}  // namespace

const suture::codec::Codec& emergencyStopCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::EmergencyStop>,
      .contract = capnp::typeId<wire::EmergencyStop>(),
      .subscriber = capnp::typeId<wire::EmergencyStopEvents>(),
      .commands = kEmergencyStopCommandCodecs,
      .events = kEmergencyStopEventCodecs,
      .row = suture::codec::rowOf<wire::EmergencyStopEvents::StateParams,
                                  wire::EmergencyStopStateRow, encodeEmergencyStopColumn,
                                  decodeEmergencyStopColumn>,
  };
  return kCodec;
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::Permit& value) {
  return codec::encodeAs<robots::wire::Permit, robots::PermitSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::Permit& value) {
  return codec::decodeAs<robots::wire::Permit, robots::PermitSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::StopNews& value) {
  return codec::encodeAs<robots::wire::StopNews, robots::StopNewsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::StopNews& value) {
  return codec::decodeAs<robots::wire::StopNews, robots::StopNewsSlot>(bytes, value);
}

}  // namespace suture
