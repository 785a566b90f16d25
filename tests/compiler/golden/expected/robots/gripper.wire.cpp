// Written by suturec from robots/gripper.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "robots/gripper.capnp.h"
#include "robots/gripper.suture.h"

// Defined in robots/arm.wire.cpp.
namespace robots {
void toWire(const EverythingSlot& slot, wire::Everything::Builder out);
suture::Errc fromWire(wire::Everything::Reader in, EverythingSlot& slot, suture::Duration shift);
wire::Mode wireMode(std::int8_t slot);
suture::Errc fromWire(wire::Mode in, std::int8_t& slot);
}  // namespace robots

// Defined in robots/geometry.wire.cpp.
namespace robots {
void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out);
suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift);
}  // namespace robots

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- Gripper as Cap'n Proto

namespace {

void encodeGripperOpen(const GripperOpenArguments& slot, wire::Gripper::OpenParams::Builder out) {
  out.setWidth(slot.width);
}
suture::Errc decodeGripperOpen(wire::Gripper::OpenParams::Reader in, GripperOpenArguments& slot,
                               suture::Duration) {
  slot.width = in.getWidth();
  return suture::Errc{};
}

void encodeGripperOpeningResult(const double& slot, wire::Gripper::OpeningResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeGripperOpeningResult(wire::Gripper::OpeningResults::Reader in, double& slot,
                                        suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeGripperFits(const GripperFitsArguments& slot, wire::Gripper::FitsParams::Builder out) {
  out.setWidth(slot.width);
}
suture::Errc decodeGripperFits(wire::Gripper::FitsParams::Reader in, GripperFitsArguments& slot,
                               suture::Duration) {
  slot.width = in.getWidth();
  return suture::Errc{};
}

void encodeGripperFitsResult(const std::uint8_t& slot, wire::Gripper::FitsResults::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeGripperFitsResult(wire::Gripper::FitsResults::Reader in, std::uint8_t& slot,
                                     suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeGripperModeChangedEvent(const std::int8_t& slot,
                                   wire::GripperEvents::ModeChangedParams::Builder out) {
  out.setValue(wireMode(slot));
}
suture::Errc decodeGripperModeChangedEvent(wire::GripperEvents::ModeChangedParams::Reader in,
                                           std::int8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeGripperArrivedEvent(const PoseStampedSlot& slot,
                               wire::GripperEvents::ArrivedParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeGripperArrivedEvent(wire::GripperEvents::ArrivedParams::Reader in,
                                       PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeGripperMovedEvent(const ArmMovedPayload& slot,
                             wire::GripperEvents::MovedParams::Builder out) {
  toWire(slot.value, out.initValue());
  out.setValue2(slot.value2);
  out.setValue3(wireMode(slot.value3));
}
suture::Errc decodeGripperMovedEvent(wire::GripperEvents::MovedParams::Reader in,
                                     ArmMovedPayload& slot, suture::Duration shift) {
  slot.value2 = in.getValue2();
  return suture::codec::firstError({
      in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid,
      fromWire(in.getValue3(), slot.value3),
  });
}

void encodeGripperGrippedEvent(const GripperGrippedPayload& slot,
                               wire::GripperEvents::GrippedParams::Builder out) {
  out.setValue(slot.value);
  out.setValue2(slot.value2 != 0);
}
suture::Errc decodeGripperGrippedEvent(wire::GripperEvents::GrippedParams::Reader in,
                                       GripperGrippedPayload& slot, suture::Duration) {
  slot.value = in.getValue();
  slot.value2 = in.getValue2();
  return suture::Errc{};
}

void encodeGripperMeasuredCpColumn(const PoseStampedSlot& slot,
                                   wire::GripperStateRow::Builder out) {
  toWire(slot, out.initMeasuredCp());
}
suture::Errc decodeGripperMeasuredCpColumn(wire::GripperStateRow::Reader in, PoseStampedSlot& slot,
                                           suture::Duration shift) {
  return in.hasMeasuredCp() ? fromWire(in.getMeasuredCp(), slot, shift) : suture::Errc::Invalid;
}

void encodeGripperModeColumn(const std::int8_t& slot, wire::GripperStateRow::Builder out) {
  out.setMode(wireMode(slot));
}
suture::Errc decodeGripperModeColumn(wire::GripperStateRow::Reader in, std::int8_t& slot,
                                     suture::Duration) {
  return fromWire(in.getMode(), slot);
}

void encodeGripperEverythingColumn(const EverythingSlot& slot, wire::GripperStateRow::Builder out) {
  toWire(slot, out.initEverything());
}
suture::Errc decodeGripperEverythingColumn(wire::GripperStateRow::Reader in, EverythingSlot& slot,
                                           suture::Duration shift) {
  return in.hasEverything() ? fromWire(in.getEverything(), slot, shift) : suture::Errc::Invalid;
}

void encodeGripperLoadColumn(const double& slot, wire::GripperStateRow::Builder out) {
  out.setLoad(slot);
}
suture::Errc decodeGripperLoadColumn(wire::GripperStateRow::Reader in, double& slot,
                                     suture::Duration) {
  slot = in.getLoad();
  return suture::Errc{};
}

void encodeGripperOpeningColumn(const double& slot, wire::GripperStateRow::Builder out) {
  out.setOpening(slot);
}
suture::Errc decodeGripperOpeningColumn(wire::GripperStateRow::Reader in, double& slot,
                                        suture::Duration) {
  slot = in.getOpening();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeGripperColumn(unsigned column, const std::byte* memory,
                         wire::GripperStateRow::Builder out) {
  switch (column) {
    case GripperColumn::measured_cp:
      return encodeGripperMeasuredCpColumn(suture::slotIn<PoseStampedSlot>(memory), out);
    case GripperColumn::mode:
      return encodeGripperModeColumn(suture::slotIn<std::int8_t>(memory), out);
    case GripperColumn::everything:
      return encodeGripperEverythingColumn(suture::slotIn<EverythingSlot>(memory), out);
    case GripperColumn::load: return encodeGripperLoadColumn(suture::slotIn<double>(memory), out);
    case GripperColumn::opening:
      return encodeGripperOpeningColumn(suture::slotIn<double>(memory), out);
  }
}
suture::Errc decodeGripperColumn(wire::GripperStateRow::Reader in, unsigned column,
                                 std::byte* memory, suture::Duration shift) {
  switch (column) {
    case GripperColumn::measured_cp:
      return decodeGripperMeasuredCpColumn(in, suture::newSlot<PoseStampedSlot>(memory), shift);
    case GripperColumn::mode:
      return decodeGripperModeColumn(in, suture::newSlot<std::int8_t>(memory), shift);
    case GripperColumn::everything:
      return decodeGripperEverythingColumn(in, suture::newSlot<EverythingSlot>(memory), shift);
    case GripperColumn::load:
      return decodeGripperLoadColumn(in, suture::newSlot<double>(memory), shift);
    case GripperColumn::opening:
      return decodeGripperOpeningColumn(in, suture::newSlot<double>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kGripperCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Gripper>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Gripper::OpenParams>,
     .arguments = suture::codec::messageOf<wire::Gripper::OpenParams, GripperOpenArguments,
                                           encodeGripperOpen, decodeGripperOpen>},
    {.interface = capnp::typeId<wire::Gripper>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Gripper::OpeningParams>,
     .result = suture::codec::messageOf<wire::Gripper::OpeningResults, double,
                                        encodeGripperOpeningResult, decodeGripperOpeningResult>,
     .stamp = suture::codec::stampIn<wire::Gripper::OpeningResults>},
    {.interface = capnp::typeId<wire::Gripper>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Gripper::FitsParams>,
     .arguments = suture::codec::messageOf<wire::Gripper::FitsParams, GripperFitsArguments,
                                           encodeGripperFits, decodeGripperFits>,
     .result = suture::codec::messageOf<wire::Gripper::FitsResults, std::uint8_t,
                                        encodeGripperFitsResult, decodeGripperFitsResult>},
};

constexpr suture::codec::EventCodec kGripperEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::GripperEvents::ModeChangedParams>,
     .payload = suture::codec::messageOf<wire::GripperEvents::ModeChangedParams, std::int8_t,
                                         encodeGripperModeChangedEvent,
                                         decodeGripperModeChangedEvent>},
    {.method = 2, .stamp = suture::codec::stampIn<wire::GripperEvents::StoppedParams>},
    {.method = 3,
     .stamp = suture::codec::stampIn<wire::GripperEvents::ArrivedParams>,
     .payload = suture::codec::messageOf<wire::GripperEvents::ArrivedParams, PoseStampedSlot,
                                         encodeGripperArrivedEvent, decodeGripperArrivedEvent>},
    {.method = 4,
     .stamp = suture::codec::stampIn<wire::GripperEvents::MovedParams>,
     .payload = suture::codec::messageOf<wire::GripperEvents::MovedParams, ArmMovedPayload,
                                         encodeGripperMovedEvent, decodeGripperMovedEvent>},
    {.method = 5,
     .stamp = suture::codec::stampIn<wire::GripperEvents::GrippedParams>,
     .payload = suture::codec::messageOf<wire::GripperEvents::GrippedParams, GripperGrippedPayload,
                                         encodeGripperGrippedEvent, decodeGripperGrippedEvent>},
};

}  // namespace

const suture::codec::Codec& gripperCodec() {
  static const auto kCommands = suture::extended<14>(
      suture::interfaceInfo<robots::Arm>().codec().commands, kGripperCommandCodecs);
  static const suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Gripper>,
      .contract = capnp::typeId<wire::Gripper>(),
      .subscriber = capnp::typeId<wire::GripperEvents>(),
      .commands = kCommands,
      .events = kGripperEventCodecs,
      .row = suture::codec::rowOf<wire::GripperEvents::StateParams, wire::GripperStateRow,
                                  encodeGripperColumn, decodeGripperColumn>,
  };
  return kCodec;
}

// --- Names as Cap'n Proto

namespace {

void encodeNamesQueue(const NamesQueueArguments& slot, wire::Names::QueueParams::Builder out) {
  out.setName(slot.name);
}
suture::Errc decodeNamesQueue(wire::Names::QueueParams::Reader in, NamesQueueArguments& slot,
                              suture::Duration) {
  slot.name = in.getName();
  return suture::Errc{};
}

void encodeNamesTitle(const NamesNameArguments& slot, wire::Names::TitleParams::Builder out) {
  out.setRange(slot.range);
  out.setSlot(slot.slot);
  out.setStore(slot.store);
}
suture::Errc decodeNamesTitle(wire::Names::TitleParams::Reader in, NamesNameArguments& slot,
                              suture::Duration) {
  slot.range = in.getRange();
  slot.slot = in.getSlot();
  slot.store = in.getStore();
  return suture::Errc{};
}

void encodeNamesTitleResult(const std::uint8_t& slot, wire::Names::TitleResults::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeNamesTitleResult(wire::Names::TitleResults::Reader in, std::uint8_t& slot,
                                    suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeNamesRangeResult(const double& slot, wire::Names::RangeResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeNamesRangeResult(wire::Names::RangeResults::Reader in, double& slot,
                                    suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeNamesLatchedEvent(const double& slot, wire::NamesEvents::LatchedParams::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeNamesLatchedEvent(wire::NamesEvents::LatchedParams::Reader in, double& slot,
                                     suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeNamesRangeColumn(const double& slot, wire::NamesStateRow::Builder out) {
  out.setRange(slot);
}
suture::Errc decodeNamesRangeColumn(wire::NamesStateRow::Reader in, double& slot,
                                    suture::Duration) {
  slot = in.getRange();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeNamesColumn(unsigned column, const std::byte* memory, wire::NamesStateRow::Builder out) {
  switch (column) {
    case NamesColumn::range: return encodeNamesRangeColumn(suture::slotIn<double>(memory), out);
  }
}
suture::Errc decodeNamesColumn(wire::NamesStateRow::Reader in, unsigned column, std::byte* memory,
                               suture::Duration shift) {
  switch (column) {
    case NamesColumn::range:
      return decodeNamesRangeColumn(in, suture::newSlot<double>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kNamesCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Names>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Names::QueueParams>,
     .arguments = suture::codec::messageOf<wire::Names::QueueParams, NamesQueueArguments,
                                           encodeNamesQueue, decodeNamesQueue>},
    {.interface = capnp::typeId<wire::Names>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Names::TitleParams>,
     .arguments = suture::codec::messageOf<wire::Names::TitleParams, NamesNameArguments,
                                           encodeNamesTitle, decodeNamesTitle>,
     .result = suture::codec::messageOf<wire::Names::TitleResults, std::uint8_t,
                                        encodeNamesTitleResult, decodeNamesTitleResult>},
    {.interface = capnp::typeId<wire::Names>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Names::RangeParams>,
     .result = suture::codec::messageOf<wire::Names::RangeResults, double, encodeNamesRangeResult,
                                        decodeNamesRangeResult>,
     .stamp = suture::codec::stampIn<wire::Names::RangeResults>},
};

constexpr suture::codec::EventCodec kNamesEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::NamesEvents::LatchedParams>,
     .payload = suture::codec::messageOf<wire::NamesEvents::LatchedParams, double,
                                         encodeNamesLatchedEvent, decodeNamesLatchedEvent>},
};

}  // namespace

const suture::codec::Codec& namesCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Names>,
      .contract = capnp::typeId<wire::Names>(),
      .subscriber = capnp::typeId<wire::NamesEvents>(),
      .commands = kNamesCommandCodecs,
      .events = kNamesEventCodecs,
      .row = suture::codec::rowOf<wire::NamesEvents::StateParams, wire::NamesStateRow,
                                  encodeNamesColumn, decodeNamesColumn>,
  };
  return kCodec;
}

}  // namespace robots
