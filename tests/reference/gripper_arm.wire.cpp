// Written by suturec from reference/gripper_arm.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "reference/gripper_arm.capnp.h"
#include "reference/gripper_arm.suture.h"

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

// --- GripperArm as Cap'n Proto

namespace {

void encodeGripperArmClose(const GripperArmCloseArguments& slot,
                           wire::GripperArm::CloseParams::Builder out) {
  out.setWidth(slot.width);
}
suture::Errc decodeGripperArmClose(wire::GripperArm::CloseParams::Reader in,
                                   GripperArmCloseArguments& slot, suture::Duration) {
  slot.width = in.getWidth();
  return suture::Errc{};
}

void encodeGripperArmCloseResult(const double& slot, wire::GripperArm::CloseResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeGripperArmCloseResult(wire::GripperArm::CloseResults::Reader in, double& slot,
                                         suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeGripperArmOpeningResult(const double& slot,
                                   wire::GripperArm::OpeningResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeGripperArmOpeningResult(wire::GripperArm::OpeningResults::Reader in,
                                           double& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeGripperArmFits(const GripperArmFitsArguments& slot,
                          wire::GripperArm::FitsParams::Builder out) {
  out.setWidth(slot.width);
}
suture::Errc decodeGripperArmFits(wire::GripperArm::FitsParams::Reader in,
                                  GripperArmFitsArguments& slot, suture::Duration) {
  slot.width = in.getWidth();
  return suture::Errc{};
}

void encodeGripperArmFitsResult(const std::uint8_t& slot,
                                wire::GripperArm::FitsResults::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeGripperArmFitsResult(wire::GripperArm::FitsResults::Reader in,
                                        std::uint8_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeGripperArmModeEvent(const std::uint8_t& slot,
                               wire::GripperArmEvents::ModeParams::Builder out) {
  out.setValue(wireMode(slot));
}
suture::Errc decodeGripperArmModeEvent(wire::GripperArmEvents::ModeParams::Reader in,
                                       std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeGripperArmArrivedEvent(const PoseStampedSlot& slot,
                                  wire::GripperArmEvents::ArrivedParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeGripperArmArrivedEvent(wire::GripperArmEvents::ArrivedParams::Reader in,
                                          PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeGripperArmMovedEvent(const ArmLikeMovedPayload& slot,
                                wire::GripperArmEvents::MovedParams::Builder out) {
  toWire(slot.value, out.initValue());
  out.setValue2(slot.value2);
}
suture::Errc decodeGripperArmMovedEvent(wire::GripperArmEvents::MovedParams::Reader in,
                                        ArmLikeMovedPayload& slot, suture::Duration shift) {
  slot.value2 = in.getValue2();
  return in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid;
}

void encodeGripperArmGrippedEvent(const double& slot,
                                  wire::GripperArmEvents::GrippedParams::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeGripperArmGrippedEvent(wire::GripperArmEvents::GrippedParams::Reader in,
                                          double& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeGripperArmMeasuredCpColumn(const PoseStampedSlot& slot,
                                      wire::GripperArmStateRow::Builder out) {
  toWire(slot, out.initMeasuredCp());
}
suture::Errc decodeGripperArmMeasuredCpColumn(wire::GripperArmStateRow::Reader in,
                                              PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasMeasuredCp() ? fromWire(in.getMeasuredCp(), slot, shift) : suture::Errc::Invalid;
}

void encodeGripperArmMeasuredJsColumn(const JointStateSlot& slot,
                                      wire::GripperArmStateRow::Builder out) {
  toWire(slot, out.initMeasuredJs());
}
suture::Errc decodeGripperArmMeasuredJsColumn(wire::GripperArmStateRow::Reader in,
                                              JointStateSlot& slot, suture::Duration shift) {
  return in.hasMeasuredJs() ? fromWire(in.getMeasuredJs(), slot, shift) : suture::Errc::Invalid;
}

void encodeGripperArmOpeningColumn(const double& slot, wire::GripperArmStateRow::Builder out) {
  out.setOpening(slot);
}
suture::Errc decodeGripperArmOpeningColumn(wire::GripperArmStateRow::Reader in, double& slot,
                                           suture::Duration) {
  slot = in.getOpening();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeGripperArmColumn(unsigned column, const std::byte* memory,
                            wire::GripperArmStateRow::Builder out) {
  switch (column) {
    case GripperArmColumn::measured_cp:
      return encodeGripperArmMeasuredCpColumn(suture::slotIn<PoseStampedSlot>(memory), out);
    case GripperArmColumn::measured_js:
      return encodeGripperArmMeasuredJsColumn(suture::slotIn<JointStateSlot>(memory), out);
    case GripperArmColumn::opening:
      return encodeGripperArmOpeningColumn(suture::slotIn<double>(memory), out);
  }
}
suture::Errc decodeGripperArmColumn(wire::GripperArmStateRow::Reader in, unsigned column,
                                    std::byte* memory, suture::Duration shift) {
  switch (column) {
    case GripperArmColumn::measured_cp:
      return decodeGripperArmMeasuredCpColumn(in, suture::newSlot<PoseStampedSlot>(memory), shift);
    case GripperArmColumn::measured_js:
      return decodeGripperArmMeasuredJsColumn(in, suture::newSlot<JointStateSlot>(memory), shift);
    case GripperArmColumn::opening:
      return decodeGripperArmOpeningColumn(in, suture::newSlot<double>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kGripperArmCommandCodecs[] = {
    {.interface = capnp::typeId<wire::GripperArm>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::GripperArm::CloseParams>,
     .arguments = suture::codec::messageOf<wire::GripperArm::CloseParams, GripperArmCloseArguments,
                                           encodeGripperArmClose, decodeGripperArmClose>,
     .result = suture::codec::messageOf<wire::GripperArm::CloseResults, double,
                                        encodeGripperArmCloseResult, decodeGripperArmCloseResult>},
    {.interface = capnp::typeId<wire::GripperArm>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::GripperArm::OpeningParams>,
     .result = suture::codec::messageOf<wire::GripperArm::OpeningResults, double,
                                        encodeGripperArmOpeningResult,
                                        decodeGripperArmOpeningResult>,
     .stamp = suture::codec::stampIn<wire::GripperArm::OpeningResults>},
    {.interface = capnp::typeId<wire::GripperArm>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::GripperArm::ReleaseParams>},
    {.interface = capnp::typeId<wire::GripperArm>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::GripperArm::FitsParams>,
     .arguments = suture::codec::messageOf<wire::GripperArm::FitsParams, GripperArmFitsArguments,
                                           encodeGripperArmFits, decodeGripperArmFits>,
     .result = suture::codec::messageOf<wire::GripperArm::FitsResults, std::uint8_t,
                                        encodeGripperArmFitsResult, decodeGripperArmFitsResult>},
};

constexpr suture::codec::EventCodec kGripperArmEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::GripperArmEvents::ModeParams>,
     .payload = suture::codec::messageOf<wire::GripperArmEvents::ModeParams, std::uint8_t,
                                         encodeGripperArmModeEvent, decodeGripperArmModeEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::GripperArmEvents::ArrivedParams>,
     .payload = suture::codec::messageOf<wire::GripperArmEvents::ArrivedParams, PoseStampedSlot,
                                         encodeGripperArmArrivedEvent,
                                         decodeGripperArmArrivedEvent>},
    {.method = 3, .stamp = suture::codec::stampIn<wire::GripperArmEvents::StoppedParams>},
    {.method = 4,
     .stamp = suture::codec::stampIn<wire::GripperArmEvents::MovedParams>,
     .payload = suture::codec::messageOf<wire::GripperArmEvents::MovedParams, ArmLikeMovedPayload,
                                         encodeGripperArmMovedEvent, decodeGripperArmMovedEvent>},
    {.method = 5,
     .stamp = suture::codec::stampIn<wire::GripperArmEvents::GrippedParams>,
     .payload = suture::codec::messageOf<wire::GripperArmEvents::GrippedParams, double,
                                         encodeGripperArmGrippedEvent,
                                         decodeGripperArmGrippedEvent>},
};

}  // namespace

const suture::codec::Codec& gripperArmCodec() {
  static const auto kCommands = suture::extended<15>(
      suture::interfaceInfo<reference::ArmLike>().codec().commands, kGripperArmCommandCodecs);
  static const suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::GripperArm>,
      .contract = capnp::typeId<wire::GripperArm>(),
      .subscriber = capnp::typeId<wire::GripperArmEvents>(),
      .commands = kCommands,
      .events = kGripperArmEventCodecs,
      .row = suture::codec::rowOf<wire::GripperArmEvents::StateParams, wire::GripperArmStateRow,
                                  encodeGripperArmColumn, decodeGripperArmColumn>,
  };
  return kCodec;
}

}  // namespace reference
