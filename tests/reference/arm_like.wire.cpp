// Written by suturec from reference/arm_like.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "reference/arm_like.capnp.h"
#include "reference/arm_like.suture.h"

// Defined in reference/arm_types.wire.cpp.
namespace reference {
void toWire(const JointStateSlot& slot, wire::JointState::Builder out);
suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration shift);
wire::Mode wireMode(std::uint8_t slot);
suture::Errc fromWire(wire::Mode in, std::uint8_t& slot);
void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out);
suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift);
}  // namespace reference

namespace reference {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- ArmLike as Cap'n Proto

namespace {

void encodeArmLikeServoCp(const ArmLikeServoCpArguments& slot,
                          wire::ArmLike::ServoCpParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmLikeServoCp(wire::ArmLike::ServoCpParams::Reader in,
                                  ArmLikeServoCpArguments& slot, suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmLikeServoJp(const ArmLikeServoJpArguments& slot,
                          wire::ArmLike::ServoJpParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmLikeServoJp(wire::ArmLike::ServoJpParams::Reader in,
                                  ArmLikeServoJpArguments& slot, suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmLikeSetMode(const ArmLikeSetModeArguments& slot,
                          wire::ArmLike::SetModeParams::Builder out) {
  out.setMode(wireMode(slot.mode));
}
suture::Errc decodeArmLikeSetMode(wire::ArmLike::SetModeParams::Reader in,
                                  ArmLikeSetModeArguments& slot, suture::Duration) {
  return fromWire(in.getMode(), slot.mode);
}

void encodeArmLikeMeasuredCpResult(const PoseStampedSlot& slot,
                                   wire::ArmLike::MeasuredCpResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmLikeMeasuredCpResult(wire::ArmLike::MeasuredCpResults::Reader in,
                                           PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmLikeMeasuredJsResult(const JointStateSlot& slot,
                                   wire::ArmLike::MeasuredJsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmLikeMeasuredJsResult(wire::ArmLike::MeasuredJsResults::Reader in,
                                           JointStateSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmLikeDistance(const ArmLikeDistanceArguments& slot,
                           wire::ArmLike::DistanceParams::Builder out) {
  toWire(slot.to, out.initTo());
}
suture::Errc decodeArmLikeDistance(wire::ArmLike::DistanceParams::Reader in,
                                   ArmLikeDistanceArguments& slot, suture::Duration shift) {
  return in.hasTo() ? fromWire(in.getTo(), slot.to, shift) : suture::Errc::Invalid;
}

void encodeArmLikeDistanceResult(const double& slot, wire::ArmLike::DistanceResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeArmLikeDistanceResult(wire::ArmLike::DistanceResults::Reader in, double& slot,
                                         suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmLikeMove(const ArmLikeMoveArguments& slot, wire::ArmLike::MoveParams::Builder out) {
  toWire(slot.goal, out.initGoal());
  out.setSpeed(slot.speed);
  toWire(slot.reason, out.initReason(sizeOf(slot.reason)));
}
suture::Errc decodeArmLikeMove(wire::ArmLike::MoveParams::Reader in, ArmLikeMoveArguments& slot,
                               suture::Duration shift) {
  slot.speed = in.getSpeed();
  return suture::codec::firstError({
      in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid,
      fromWire(in.getReason(), slot.reason),
  });
}

void encodeArmLikeMoveResult(const std::uint8_t& slot, wire::ArmLike::MoveResults::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeArmLikeMoveResult(wire::ArmLike::MoveResults::Reader in, std::uint8_t& slot,
                                     suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmLikeResetResult(const std::uint32_t& slot, wire::ArmLike::ResetResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeArmLikeResetResult(wire::ArmLike::ResetResults::Reader in, std::uint32_t& slot,
                                      suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmLikeLimit(const ArmLikeLimitArguments& slot,
                        wire::ArmLike::LimitParams::Builder out) {
  out.setSpeed(slot.speed);
  out.setMode(wireMode(slot.mode));
}
suture::Errc decodeArmLikeLimit(wire::ArmLike::LimitParams::Reader in, ArmLikeLimitArguments& slot,
                                suture::Duration) {
  slot.speed = in.getSpeed();
  return fromWire(in.getMode(), slot.mode);
}

void encodeArmLikeModeEvent(const std::uint8_t& slot,
                            wire::ArmLikeEvents::ModeParams::Builder out) {
  out.setValue(wireMode(slot));
}
suture::Errc decodeArmLikeModeEvent(wire::ArmLikeEvents::ModeParams::Reader in, std::uint8_t& slot,
                                    suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeArmLikeArrivedEvent(const PoseStampedSlot& slot,
                               wire::ArmLikeEvents::ArrivedParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmLikeArrivedEvent(wire::ArmLikeEvents::ArrivedParams::Reader in,
                                       PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmLikeMovedEvent(const ArmLikeMovedPayload& slot,
                             wire::ArmLikeEvents::MovedParams::Builder out) {
  toWire(slot.value, out.initValue());
  out.setValue2(slot.value2);
}
suture::Errc decodeArmLikeMovedEvent(wire::ArmLikeEvents::MovedParams::Reader in,
                                     ArmLikeMovedPayload& slot, suture::Duration shift) {
  slot.value2 = in.getValue2();
  return in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid;
}

void encodeArmLikeMeasuredCpColumn(const PoseStampedSlot& slot,
                                   wire::ArmLikeStateRow::Builder out) {
  toWire(slot, out.initMeasuredCp());
}
suture::Errc decodeArmLikeMeasuredCpColumn(wire::ArmLikeStateRow::Reader in, PoseStampedSlot& slot,
                                           suture::Duration shift) {
  return in.hasMeasuredCp() ? fromWire(in.getMeasuredCp(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmLikeMeasuredJsColumn(const JointStateSlot& slot, wire::ArmLikeStateRow::Builder out) {
  toWire(slot, out.initMeasuredJs());
}
suture::Errc decodeArmLikeMeasuredJsColumn(wire::ArmLikeStateRow::Reader in, JointStateSlot& slot,
                                           suture::Duration shift) {
  return in.hasMeasuredJs() ? fromWire(in.getMeasuredJs(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeArmLikeColumn(unsigned column, const std::byte* memory,
                         wire::ArmLikeStateRow::Builder out) {
  switch (column) {
    case ArmLikeColumn::measured_cp:
      return encodeArmLikeMeasuredCpColumn(suture::slotIn<PoseStampedSlot>(memory), out);
    case ArmLikeColumn::measured_js:
      return encodeArmLikeMeasuredJsColumn(suture::slotIn<JointStateSlot>(memory), out);
  }
}
suture::Errc decodeArmLikeColumn(wire::ArmLikeStateRow::Reader in, unsigned column,
                                 std::byte* memory, suture::Duration shift) {
  switch (column) {
    case ArmLikeColumn::measured_cp:
      return decodeArmLikeMeasuredCpColumn(in, suture::newSlot<PoseStampedSlot>(memory), shift);
    case ArmLikeColumn::measured_js:
      return decodeArmLikeMeasuredJsColumn(in, suture::newSlot<JointStateSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kArmLikeCommandCodecs[] = {
    {.interface = capnp::typeId<wire::ArmLike>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::ArmLike::ServoCpParams>,
     .arguments = suture::codec::messageOf<wire::ArmLike::ServoCpParams, ArmLikeServoCpArguments,
                                           encodeArmLikeServoCp, decodeArmLikeServoCp>},
    {.interface = capnp::typeId<wire::ArmLike>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::ArmLike::ServoJpParams>,
     .arguments = suture::codec::messageOf<wire::ArmLike::ServoJpParams, ArmLikeServoJpArguments,
                                           encodeArmLikeServoJp, decodeArmLikeServoJp>},
    {.interface = capnp::typeId<wire::ArmLike>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::ArmLike::HoldParams>},
    {.interface = capnp::typeId<wire::ArmLike>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::ArmLike::SetModeParams>,
     .arguments = suture::codec::messageOf<wire::ArmLike::SetModeParams, ArmLikeSetModeArguments,
                                           encodeArmLikeSetMode, decodeArmLikeSetMode>},
    {.interface = capnp::typeId<wire::ArmLike>(),
     .method = 5,
     .sent = suture::codec::sentIn<wire::ArmLike::MeasuredCpParams>,
     .result = suture::codec::messageOf<wire::ArmLike::MeasuredCpResults, PoseStampedSlot,
                                        encodeArmLikeMeasuredCpResult,
                                        decodeArmLikeMeasuredCpResult>,
     .stamp = suture::codec::stampIn<wire::ArmLike::MeasuredCpResults>},
    {.interface = capnp::typeId<wire::ArmLike>(),
     .method = 6,
     .sent = suture::codec::sentIn<wire::ArmLike::MeasuredJsParams>,
     .result = suture::codec::messageOf<wire::ArmLike::MeasuredJsResults, JointStateSlot,
                                        encodeArmLikeMeasuredJsResult,
                                        decodeArmLikeMeasuredJsResult>,
     .stamp = suture::codec::stampIn<wire::ArmLike::MeasuredJsResults>},
    {.interface = capnp::typeId<wire::ArmLike>(),
     .method = 7,
     .sent = suture::codec::sentIn<wire::ArmLike::DistanceParams>,
     .arguments = suture::codec::messageOf<wire::ArmLike::DistanceParams, ArmLikeDistanceArguments,
                                           encodeArmLikeDistance, decodeArmLikeDistance>,
     .result = suture::codec::messageOf<wire::ArmLike::DistanceResults, double,
                                        encodeArmLikeDistanceResult, decodeArmLikeDistanceResult>},
    {.interface = capnp::typeId<wire::ArmLike>(),
     .method = 8,
     .sent = suture::codec::sentIn<wire::ArmLike::MoveParams>,
     .arguments = suture::codec::messageOf<wire::ArmLike::MoveParams, ArmLikeMoveArguments,
                                           encodeArmLikeMove, decodeArmLikeMove>,
     .result = suture::codec::messageOf<wire::ArmLike::MoveResults, std::uint8_t,
                                        encodeArmLikeMoveResult, decodeArmLikeMoveResult>},
    {.interface = capnp::typeId<wire::ArmLike>(),
     .method = 9,
     .sent = suture::codec::sentIn<wire::ArmLike::ResetParams>,
     .result = suture::codec::messageOf<wire::ArmLike::ResetResults, std::uint32_t,
                                        encodeArmLikeResetResult, decodeArmLikeResetResult>},
    {.interface = capnp::typeId<wire::ArmLike>(),
     .method = 10,
     .sent = suture::codec::sentIn<wire::ArmLike::LimitParams>,
     .arguments = suture::codec::messageOf<wire::ArmLike::LimitParams, ArmLikeLimitArguments,
                                           encodeArmLikeLimit, decodeArmLikeLimit>},
    {.interface = capnp::typeId<wire::ArmLike>(),
     .method = 11,
     .sent = suture::codec::sentIn<wire::ArmLike::ParkParams>},
};

constexpr suture::codec::EventCodec kArmLikeEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::ArmLikeEvents::ModeParams>,
     .payload = suture::codec::messageOf<wire::ArmLikeEvents::ModeParams, std::uint8_t,
                                         encodeArmLikeModeEvent, decodeArmLikeModeEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::ArmLikeEvents::ArrivedParams>,
     .payload = suture::codec::messageOf<wire::ArmLikeEvents::ArrivedParams, PoseStampedSlot,
                                         encodeArmLikeArrivedEvent, decodeArmLikeArrivedEvent>},
    {.method = 3, .stamp = suture::codec::stampIn<wire::ArmLikeEvents::StoppedParams>},
    {.method = 4,
     .stamp = suture::codec::stampIn<wire::ArmLikeEvents::MovedParams>,
     .payload = suture::codec::messageOf<wire::ArmLikeEvents::MovedParams, ArmLikeMovedPayload,
                                         encodeArmLikeMovedEvent, decodeArmLikeMovedEvent>},
};

}  // namespace

const suture::codec::Codec& armLikeCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::ArmLike>,
      .contract = capnp::typeId<wire::ArmLike>(),
      .subscriber = capnp::typeId<wire::ArmLikeEvents>(),
      .commands = kArmLikeCommandCodecs,
      .events = kArmLikeEventCodecs,
      .row = suture::codec::rowOf<wire::ArmLikeEvents::StateParams, wire::ArmLikeStateRow,
                                  encodeArmLikeColumn, decodeArmLikeColumn>,
  };
  return kCodec;
}

}  // namespace reference
