// Written by suturec from teleop/teleoperation.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "teleop/teleoperation.capnp.h"
#include "teleop/teleoperation.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::TeleopState wireTeleopState(std::uint8_t slot) {
  switch (static_cast<TeleopState>(slot)) {
    case TeleopState::Disabled: return wire::TeleopState::DISABLED;
    case TeleopState::Preparing: return wire::TeleopState::PREPARING;
    case TeleopState::Following: return wire::TeleopState::FOLLOWING;
    case TeleopState::Aligning: return wire::TeleopState::ALIGNING;
    case TeleopState::Clutched: return wire::TeleopState::CLUTCHED;
  }
  return wire::TeleopState{};
}

suture::Errc fromWire(wire::TeleopState in, std::uint8_t& slot) {
  switch (in) {
    case wire::TeleopState::DISABLED: return slot =
        static_cast<std::uint8_t>(TeleopState::Disabled), suture::Errc{};
    case wire::TeleopState::PREPARING: return slot =
        static_cast<std::uint8_t>(TeleopState::Preparing), suture::Errc{};
    case wire::TeleopState::FOLLOWING: return slot =
        static_cast<std::uint8_t>(TeleopState::Following), suture::Errc{};
    case wire::TeleopState::ALIGNING: return slot =
        static_cast<std::uint8_t>(TeleopState::Aligning), suture::Errc{};
    case wire::TeleopState::CLUTCHED: return slot =
        static_cast<std::uint8_t>(TeleopState::Clutched), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

void toWire(const FollowAnchorsSlot& slot, wire::FollowAnchors::Builder out) {
  out.setMasterStamp(slot.master_stamp);
  toWire(slot.master, out.initMaster());
  toWire(slot.slave_setpoint, out.initSlaveSetpoint());
  out.setScale(slot.scale);
  out.setEntry(slot.entry);
  toWire(slot.view, out.initView());
  out.setRotationLocked(slot.rotation_locked != 0);
  out.setTranslationLocked(slot.translation_locked != 0);
}

suture::Errc fromWire(wire::FollowAnchors::Reader in, FollowAnchorsSlot& slot,
                      suture::Duration shift) {
  slot.master_stamp = suture::codec::shifted(in.getMasterStamp(), shift);
  slot.scale = in.getScale();
  slot.entry = in.getEntry();
  slot.rotation_locked = in.getRotationLocked();
  slot.translation_locked = in.getTranslationLocked();
  return suture::codec::firstError({
      in.hasMaster() ? fromWire(in.getMaster(), slot.master)
          : suture::codec::fromDefault(FollowAnchors().master, slot.master),
      in.hasSlaveSetpoint() ? fromWire(in.getSlaveSetpoint(), slot.slave_setpoint)
          : suture::codec::fromDefault(FollowAnchors().slave_setpoint, slot.slave_setpoint),
      in.hasView() ? fromWire(in.getView(), slot.view)
          : suture::codec::fromDefault(FollowAnchors().view, slot.view),
  });
}

void toWire(const TeleopSettingsSlot& slot, wire::TeleopSettings::Builder out) {
  out.setScale(slot.scale);
  out.setRotationLocked(slot.rotation_locked != 0);
  out.setTranslationLocked(slot.translation_locked != 0);
}

suture::Errc fromWire(wire::TeleopSettings::Reader in, TeleopSettingsSlot& slot, suture::Duration) {
  slot.scale = in.getScale();
  slot.rotation_locked = in.getRotationLocked();
  slot.translation_locked = in.getTranslationLocked();
  return suture::Errc{};
}

// --- Teleoperation as Cap'n Proto

namespace {

void encodeTeleoperationTeleopStateResult(const std::uint8_t& slot,
                                          wire::Teleoperation::TeleopStateResults::Builder out) {
  out.setValue(wireTeleopState(slot));
}
suture::Errc decodeTeleoperationTeleopStateResult(
    wire::Teleoperation::TeleopStateResults::Reader in, std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeTeleoperationAnchorsResult(const FollowAnchorsSlot& slot,
                                      wire::Teleoperation::AnchorsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeTeleoperationAnchorsResult(wire::Teleoperation::AnchorsResults::Reader in,
                                              FollowAnchorsSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeTeleoperationSetScale(const TeleoperationSetScaleArguments& slot,
                                 wire::Teleoperation::SetScaleParams::Builder out) {
  out.setScale(slot.scale);
}
suture::Errc decodeTeleoperationSetScale(wire::Teleoperation::SetScaleParams::Reader in,
                                         TeleoperationSetScaleArguments& slot, suture::Duration) {
  slot.scale = in.getScale();
  return suture::Errc{};
}

void encodeTeleoperationLockRotation(const TeleoperationLockRotationArguments& slot,
                                     wire::Teleoperation::LockRotationParams::Builder out) {
  out.setLock(slot.lock != 0);
}
suture::Errc decodeTeleoperationLockRotation(wire::Teleoperation::LockRotationParams::Reader in,
                                             TeleoperationLockRotationArguments& slot,
                                             suture::Duration) {
  slot.lock = in.getLock();
  return suture::Errc{};
}

void encodeTeleoperationLockTranslation(const TeleoperationLockTranslationArguments& slot,
                                        wire::Teleoperation::LockTranslationParams::Builder out) {
  out.setLock(slot.lock != 0);
}
suture::Errc decodeTeleoperationLockTranslation(
    wire::Teleoperation::LockTranslationParams::Reader in,
                                                TeleoperationLockTranslationArguments& slot,
                                                suture::Duration) {
  slot.lock = in.getLock();
  return suture::Errc{};
}

void encodeTeleoperationSettingsResult(const TeleopSettingsSlot& slot,
                                       wire::Teleoperation::SettingsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeTeleoperationSettingsResult(wire::Teleoperation::SettingsResults::Reader in,
                                               TeleopSettingsSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeTeleoperationTeleopStateEvent(const std::uint8_t& slot,
                                         wire::TeleoperationEvents::TeleopStateParams::Builder out) {
  out.setValue(wireTeleopState(slot));
}
suture::Errc decodeTeleoperationTeleopStateEvent(
    wire::TeleoperationEvents::TeleopStateParams::Reader in, std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeTeleoperationFollowedEvent(const FollowAnchorsSlot& slot,
                                      wire::TeleoperationEvents::FollowedParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeTeleoperationFollowedEvent(wire::TeleoperationEvents::FollowedParams::Reader in,
                                              FollowAnchorsSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeTeleoperationSettingsEvent(const TeleopSettingsSlot& slot,
                                      wire::TeleoperationEvents::SettingsParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeTeleoperationSettingsEvent(wire::TeleoperationEvents::SettingsParams::Reader in,
                                              TeleopSettingsSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeTeleoperationTeleopStateColumn(const std::uint8_t& slot,
                                          wire::TeleoperationStateRow::Builder out) {
  out.setTeleopState(wireTeleopState(slot));
}
suture::Errc decodeTeleoperationTeleopStateColumn(wire::TeleoperationStateRow::Reader in,
                                                  std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getTeleopState(), slot);
}

void encodeTeleoperationAnchorsColumn(const FollowAnchorsSlot& slot,
                                      wire::TeleoperationStateRow::Builder out) {
  toWire(slot, out.initAnchors());
}
suture::Errc decodeTeleoperationAnchorsColumn(wire::TeleoperationStateRow::Reader in,
                                              FollowAnchorsSlot& slot, suture::Duration shift) {
  return in.hasAnchors() ? fromWire(in.getAnchors(), slot, shift) : suture::Errc::Invalid;
}

void encodeTeleoperationSettingsColumn(const TeleopSettingsSlot& slot,
                                       wire::TeleoperationStateRow::Builder out) {
  toWire(slot, out.initSettings());
}
suture::Errc decodeTeleoperationSettingsColumn(wire::TeleoperationStateRow::Reader in,
                                               TeleopSettingsSlot& slot, suture::Duration shift) {
  return in.hasSettings() ? fromWire(in.getSettings(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeTeleoperationColumn(unsigned column, const std::byte* memory,
                               wire::TeleoperationStateRow::Builder out) {
  switch (column) {
    case TeleoperationColumn::teleop_state:
      return encodeTeleoperationTeleopStateColumn(suture::slotIn<std::uint8_t>(memory), out);
    case TeleoperationColumn::anchors:
      return encodeTeleoperationAnchorsColumn(suture::slotIn<FollowAnchorsSlot>(memory), out);
    case TeleoperationColumn::settings:
      return encodeTeleoperationSettingsColumn(suture::slotIn<TeleopSettingsSlot>(memory), out);
  }
}
suture::Errc decodeTeleoperationColumn(wire::TeleoperationStateRow::Reader in, unsigned column,
                                       std::byte* memory, suture::Duration shift) {
  switch (column) {
    case TeleoperationColumn::teleop_state:
      return decodeTeleoperationTeleopStateColumn(in, suture::newSlot<std::uint8_t>(memory), shift);
    case TeleoperationColumn::anchors:
      return decodeTeleoperationAnchorsColumn(in, suture::newSlot<FollowAnchorsSlot>(memory),
                                              shift);
    case TeleoperationColumn::settings:
      return decodeTeleoperationSettingsColumn(in, suture::newSlot<TeleopSettingsSlot>(memory),
                                               shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kTeleoperationCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Teleoperation>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Teleoperation::EnableParams>},
    {.interface = capnp::typeId<wire::Teleoperation>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Teleoperation::DisableParams>},
    {.interface = capnp::typeId<wire::Teleoperation>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Teleoperation::TeleopStateParams>,
     .result = suture::codec::messageOf<wire::Teleoperation::TeleopStateResults, std::uint8_t,
                                        encodeTeleoperationTeleopStateResult,
                                        decodeTeleoperationTeleopStateResult>,
     .stamp = suture::codec::stampIn<wire::Teleoperation::TeleopStateResults>},
    {.interface = capnp::typeId<wire::Teleoperation>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Teleoperation::AnchorsParams>,
     .result = suture::codec::messageOf<wire::Teleoperation::AnchorsResults, FollowAnchorsSlot,
                                        encodeTeleoperationAnchorsResult,
                                        decodeTeleoperationAnchorsResult>,
     .stamp = suture::codec::stampIn<wire::Teleoperation::AnchorsResults>},
    {.interface = capnp::typeId<wire::Teleoperation>(),
     .method = 5,
     .sent = suture::codec::sentIn<wire::Teleoperation::SetScaleParams>,
     .arguments = suture::codec::messageOf<wire::Teleoperation::SetScaleParams,
                                           TeleoperationSetScaleArguments,
                                           encodeTeleoperationSetScale,
                                           decodeTeleoperationSetScale>},
    {.interface = capnp::typeId<wire::Teleoperation>(),
     .method = 6,
     .sent = suture::codec::sentIn<wire::Teleoperation::LockRotationParams>,
     .arguments = suture::codec::messageOf<wire::Teleoperation::LockRotationParams,
                                           TeleoperationLockRotationArguments,
                                           encodeTeleoperationLockRotation,
                                           decodeTeleoperationLockRotation>},
    {.interface = capnp::typeId<wire::Teleoperation>(),
     .method = 7,
     .sent = suture::codec::sentIn<wire::Teleoperation::LockTranslationParams>,
     .arguments = suture::codec::messageOf<wire::Teleoperation::LockTranslationParams,
                                           TeleoperationLockTranslationArguments,
                                           encodeTeleoperationLockTranslation,
                                           decodeTeleoperationLockTranslation>},
    {.interface = capnp::typeId<wire::Teleoperation>(),
     .method = 8,
     .sent = suture::codec::sentIn<wire::Teleoperation::SettingsParams>,
     .result = suture::codec::messageOf<wire::Teleoperation::SettingsResults, TeleopSettingsSlot,
                                        encodeTeleoperationSettingsResult,
                                        decodeTeleoperationSettingsResult>,
     .stamp = suture::codec::stampIn<wire::Teleoperation::SettingsResults>},
};

constexpr suture::codec::EventCodec kTeleoperationEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::TeleoperationEvents::TeleopStateParams>,
     .payload = suture::codec::messageOf<wire::TeleoperationEvents::TeleopStateParams, std::uint8_t,
                                         encodeTeleoperationTeleopStateEvent,
                                         decodeTeleoperationTeleopStateEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::TeleoperationEvents::FollowedParams>,
     .payload = suture::codec::messageOf<wire::TeleoperationEvents::FollowedParams,
                                         FollowAnchorsSlot, encodeTeleoperationFollowedEvent,
                                         decodeTeleoperationFollowedEvent>},
    {.method = 3,
     .stamp = suture::codec::stampIn<wire::TeleoperationEvents::SettingsParams>,
     .payload = suture::codec::messageOf<wire::TeleoperationEvents::SettingsParams,
                                         TeleopSettingsSlot, encodeTeleoperationSettingsEvent,
                                         decodeTeleoperationSettingsEvent>},
};

}  // namespace

const suture::codec::Codec& teleoperationCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Teleoperation>,
      .contract = capnp::typeId<wire::Teleoperation>(),
      .subscriber = capnp::typeId<wire::TeleoperationEvents>(),
      .commands = kTeleoperationCommandCodecs,
      .events = kTeleoperationEventCodecs,
      .row = suture::codec::rowOf<wire::TeleoperationEvents::StateParams,
                                  wire::TeleoperationStateRow, encodeTeleoperationColumn,
                                  decodeTeleoperationColumn>,
  };
  return kCodec;
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::FollowAnchors& value) {
  return codec::encodeAs<robots::wire::FollowAnchors, robots::FollowAnchorsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::FollowAnchors& value) {
  return codec::decodeAs<robots::wire::FollowAnchors, robots::FollowAnchorsSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::TeleopSettings& value) {
  return codec::encodeAs<robots::wire::TeleopSettings, robots::TeleopSettingsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::TeleopSettings& value) {
  return codec::decodeAs<robots::wire::TeleopSettings, robots::TeleopSettingsSlot>(bytes, value);
}

}  // namespace suture
