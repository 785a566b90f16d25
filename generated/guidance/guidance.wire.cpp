// Written by suturec from guidance/guidance.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "guidance/guidance.capnp.h"
#include "guidance/guidance.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::GuidanceState wireGuidanceState(std::uint8_t slot) {
  switch (static_cast<GuidanceState>(slot)) {
    case GuidanceState::Preparing: return wire::GuidanceState::PREPARING;
    case GuidanceState::Blind: return wire::GuidanceState::BLIND;
    case GuidanceState::Guiding: return wire::GuidanceState::GUIDING;
    case GuidanceState::Disabled: return wire::GuidanceState::DISABLED;
    case GuidanceState::Clutched: return wire::GuidanceState::CLUTCHED;
  }
  return wire::GuidanceState{};
}

suture::Errc fromWire(wire::GuidanceState in, std::uint8_t& slot) {
  switch (in) {
    case wire::GuidanceState::PREPARING: return slot =
        static_cast<std::uint8_t>(GuidanceState::Preparing), suture::Errc{};
    case wire::GuidanceState::BLIND: return slot =
        static_cast<std::uint8_t>(GuidanceState::Blind), suture::Errc{};
    case wire::GuidanceState::GUIDING: return slot =
        static_cast<std::uint8_t>(GuidanceState::Guiding), suture::Errc{};
    case wire::GuidanceState::DISABLED: return slot =
        static_cast<std::uint8_t>(GuidanceState::Disabled), suture::Errc{};
    case wire::GuidanceState::CLUTCHED: return slot =
        static_cast<std::uint8_t>(GuidanceState::Clutched), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

void toWire(const GuidanceProgressSlot& slot, wire::GuidanceProgress::Builder out) {
  toWire(slot.knot, out.initKnot());
  out.setDistanceToTarget(slot.distance_to_target);
  out.setLateralError(slot.lateral_error);
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::GuidanceProgress::Reader in, GuidanceProgressSlot& slot,
                      suture::Duration shift) {
  slot.distance_to_target = in.getDistanceToTarget();
  slot.lateral_error = in.getLateralError();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return in.hasKnot() ? fromWire(in.getKnot(), slot.knot)
      : suture::codec::fromDefault(GuidanceProgress().knot, slot.knot);
}

void toWire(const ForbiddenMotionSlot& slot, wire::ForbiddenMotion::Builder out) {
  toWire(slot.left, out.initLeft());
  toWire(slot.right, out.initRight());
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::ForbiddenMotion::Reader in, ForbiddenMotionSlot& slot,
                      suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::codec::firstError({
      in.hasLeft() ? fromWire(in.getLeft(), slot.left)
          : suture::codec::fromDefault(ForbiddenMotion().left, slot.left),
      in.hasRight() ? fromWire(in.getRight(), slot.right)
          : suture::codec::fromDefault(ForbiddenMotion().right, slot.right),
  });
}

// --- Guidance as Cap'n Proto

namespace {

void encodeGuidanceGuidanceStateResult(const std::uint8_t& slot,
                                       wire::Guidance::GuidanceStateResults::Builder out) {
  out.setValue(wireGuidanceState(slot));
}
suture::Errc decodeGuidanceGuidanceStateResult(wire::Guidance::GuidanceStateResults::Reader in,
                                               std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeGuidanceProgressResult(const GuidanceProgressSlot& slot,
                                  wire::Guidance::ProgressResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeGuidanceProgressResult(wire::Guidance::ProgressResults::Reader in,
                                          GuidanceProgressSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeGuidanceForbiddenMotionResult(const ForbiddenMotionSlot& slot,
                                         wire::Guidance::ForbiddenMotionResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeGuidanceForbiddenMotionResult(wire::Guidance::ForbiddenMotionResults::Reader in,
                                                 ForbiddenMotionSlot& slot,
                                                 suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeGuidanceGuidanceStateEvent(const std::uint8_t& slot,
                                      wire::GuidanceEvents::GuidanceStateParams::Builder out) {
  out.setValue(wireGuidanceState(slot));
}
suture::Errc decodeGuidanceGuidanceStateEvent(wire::GuidanceEvents::GuidanceStateParams::Reader in,
                                              std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeGuidanceGuidanceStateColumn(const std::uint8_t& slot,
                                       wire::GuidanceStateRow::Builder out) {
  out.setGuidanceState(wireGuidanceState(slot));
}
suture::Errc decodeGuidanceGuidanceStateColumn(wire::GuidanceStateRow::Reader in,
                                               std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getGuidanceState(), slot);
}

void encodeGuidanceProgressColumn(const GuidanceProgressSlot& slot,
                                  wire::GuidanceStateRow::Builder out) {
  toWire(slot, out.initProgress());
}
suture::Errc decodeGuidanceProgressColumn(wire::GuidanceStateRow::Reader in,
                                          GuidanceProgressSlot& slot, suture::Duration shift) {
  return in.hasProgress() ? fromWire(in.getProgress(), slot, shift) : suture::Errc::Invalid;
}

void encodeGuidanceForbiddenMotionColumn(const ForbiddenMotionSlot& slot,
                                         wire::GuidanceStateRow::Builder out) {
  toWire(slot, out.initForbiddenMotion());
}
suture::Errc decodeGuidanceForbiddenMotionColumn(wire::GuidanceStateRow::Reader in,
                                                 ForbiddenMotionSlot& slot,
                                                 suture::Duration shift) {
  return in.hasForbiddenMotion() ? fromWire(in.getForbiddenMotion(), slot, shift)
      : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeGuidanceColumn(unsigned column, const std::byte* memory,
                          wire::GuidanceStateRow::Builder out) {
  switch (column) {
    case GuidanceColumn::guidance_state:
      return encodeGuidanceGuidanceStateColumn(suture::slotIn<std::uint8_t>(memory), out);
    case GuidanceColumn::progress:
      return encodeGuidanceProgressColumn(suture::slotIn<GuidanceProgressSlot>(memory), out);
    case GuidanceColumn::forbidden_motion:
      return encodeGuidanceForbiddenMotionColumn(suture::slotIn<ForbiddenMotionSlot>(memory), out);
  }
}
suture::Errc decodeGuidanceColumn(wire::GuidanceStateRow::Reader in, unsigned column,
                                  std::byte* memory, suture::Duration shift) {
  switch (column) {
    case GuidanceColumn::guidance_state:
      return decodeGuidanceGuidanceStateColumn(in, suture::newSlot<std::uint8_t>(memory), shift);
    case GuidanceColumn::progress:
      return decodeGuidanceProgressColumn(in, suture::newSlot<GuidanceProgressSlot>(memory), shift);
    case GuidanceColumn::forbidden_motion:
      return decodeGuidanceForbiddenMotionColumn(in, suture::newSlot<ForbiddenMotionSlot>(memory),
                                                 shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kGuidanceCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Guidance>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Guidance::GuidanceStateParams>,
     .result = suture::codec::messageOf<wire::Guidance::GuidanceStateResults, std::uint8_t,
                                        encodeGuidanceGuidanceStateResult,
                                        decodeGuidanceGuidanceStateResult>,
     .stamp = suture::codec::stampIn<wire::Guidance::GuidanceStateResults>},
    {.interface = capnp::typeId<wire::Guidance>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Guidance::ProgressParams>,
     .result = suture::codec::messageOf<wire::Guidance::ProgressResults, GuidanceProgressSlot,
                                        encodeGuidanceProgressResult, decodeGuidanceProgressResult>,
     .stamp = suture::codec::stampIn<wire::Guidance::ProgressResults>},
    {.interface = capnp::typeId<wire::Guidance>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Guidance::EnableParams>},
    {.interface = capnp::typeId<wire::Guidance>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Guidance::DisableParams>},
    {.interface = capnp::typeId<wire::Guidance>(),
     .method = 5,
     .sent = suture::codec::sentIn<wire::Guidance::ForbiddenMotionParams>,
     .result = suture::codec::messageOf<wire::Guidance::ForbiddenMotionResults, ForbiddenMotionSlot,
                                        encodeGuidanceForbiddenMotionResult,
                                        decodeGuidanceForbiddenMotionResult>,
     .stamp = suture::codec::stampIn<wire::Guidance::ForbiddenMotionResults>},
};

constexpr suture::codec::EventCodec kGuidanceEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::GuidanceEvents::GuidanceStateParams>,
     .payload = suture::codec::messageOf<wire::GuidanceEvents::GuidanceStateParams, std::uint8_t,
                                         encodeGuidanceGuidanceStateEvent,
                                         decodeGuidanceGuidanceStateEvent>},
};

}  // namespace

const suture::codec::Codec& guidanceCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Guidance>,
      .contract = capnp::typeId<wire::Guidance>(),
      .subscriber = capnp::typeId<wire::GuidanceEvents>(),
      .commands = kGuidanceCommandCodecs,
      .events = kGuidanceEventCodecs,
      .row = suture::codec::rowOf<wire::GuidanceEvents::StateParams, wire::GuidanceStateRow,
                                  encodeGuidanceColumn, decodeGuidanceColumn>,
  };
  return kCodec;
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::GuidanceProgress& value) {
  return codec::encodeAs<robots::wire::GuidanceProgress, robots::GuidanceProgressSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::GuidanceProgress& value) {
  return codec::decodeAs<robots::wire::GuidanceProgress,
                         robots::GuidanceProgressSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::ForbiddenMotion& value) {
  return codec::encodeAs<robots::wire::ForbiddenMotion, robots::ForbiddenMotionSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ForbiddenMotion& value) {
  return codec::decodeAs<robots::wire::ForbiddenMotion, robots::ForbiddenMotionSlot>(bytes, value);
}

}  // namespace suture
