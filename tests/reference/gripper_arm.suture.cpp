// Written by suturec from reference/gripper_arm.h. Do not edit.
#include "reference/gripper_arm.suture.h"

#include <suture/wire/codec.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "reference/gripper_arm.capnp.h"

// Defined in reference/arm_types.suture.cpp.
namespace reference {
void toWire(const JointStateSlot& slot, wire::JointState::Builder out);
suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration shift);
bool isValid(const JointStateSlot& slot, suture::FieldPath* path);
wire::Mode wireMode(std::uint8_t slot);
bool isKnownMode(std::uint8_t slot);
suture::Errc fromWire(wire::Mode in, std::uint8_t& slot);
void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out);
suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift);
bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path);
}  // namespace reference

namespace reference {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Errc;
using suture::EventInfo;
using suture::FieldPath;
using suture::checkSlot;
using suture::newSlot;
using suture::refusedAt;
using suture::rpc::CommandCodec;
using suture::rpc::EventCodec;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::messageOf;
using suture::rpc::sentIn;
using suture::rpc::stampIn;
using suture::rpc::toWire;
using suture::slotIn;
using suture::slotSize;
using suture::store;

bool store(const double& width, GripperArmCloseArguments& slot) { return store(width, slot.width); }

bool store(const double& width, GripperArmFitsArguments& slot) { return store(width, slot.width); }

namespace {

bool acceptsGripperArmClose(const GripperArmCloseArguments& slot, FieldPath* path) {
  return isValid(slot.width) || refusedAt(path, "width");
}

bool acceptsGripperArmCloseResult(const double& slot, FieldPath*) { return isValid(slot); }
bool acceptsGripperArmOpeningResult(const double& slot, FieldPath*) { return isValid(slot); }

bool acceptsGripperArmFits(const GripperArmFitsArguments& slot, FieldPath* path) {
  return isValid(slot.width) || refusedAt(path, "width");
}

bool acceptsGripperArmGrippedEvent(const double& slot, FieldPath*) { return isValid(slot); }

// --- GripperArm as Cap'n Proto

void encodeGripperArmClose(const GripperArmCloseArguments& slot,
                           wire::GripperArm::CloseParams::Builder out) {
  out.setWidth(slot.width);
}
Errc decodeGripperArmClose(wire::GripperArm::CloseParams::Reader in, GripperArmCloseArguments& slot,
                           suture::Duration) {
  slot.width = in.getWidth();
  return Errc{};
}

void encodeGripperArmCloseResult(const double& slot, wire::GripperArm::CloseResults::Builder out) {
  out.setValue(slot);
}
Errc decodeGripperArmCloseResult(wire::GripperArm::CloseResults::Reader in, double& slot,
                                 suture::Duration) {
  slot = in.getValue();
  return Errc{};
}

void encodeGripperArmOpeningResult(const double& slot,
                                   wire::GripperArm::OpeningResults::Builder out) {
  out.setValue(slot);
}
Errc decodeGripperArmOpeningResult(wire::GripperArm::OpeningResults::Reader in, double& slot,
                                   suture::Duration) {
  slot = in.getValue();
  return Errc{};
}

void encodeGripperArmFits(const GripperArmFitsArguments& slot,
                          wire::GripperArm::FitsParams::Builder out) {
  out.setWidth(slot.width);
}
Errc decodeGripperArmFits(wire::GripperArm::FitsParams::Reader in, GripperArmFitsArguments& slot,
                          suture::Duration) {
  slot.width = in.getWidth();
  return Errc{};
}

void encodeGripperArmFitsResult(const std::uint8_t& slot,
                                wire::GripperArm::FitsResults::Builder out) {
  out.setValue(slot != 0);
}
Errc decodeGripperArmFitsResult(wire::GripperArm::FitsResults::Reader in, std::uint8_t& slot,
                                suture::Duration) {
  slot = in.getValue();
  return Errc{};
}

void encodeGripperArmModeEvent(const std::uint8_t& slot,
                               wire::GripperArmEvents::ModeParams::Builder out) {
  out.setValue(wireMode(slot));
}
Errc decodeGripperArmModeEvent(wire::GripperArmEvents::ModeParams::Reader in, std::uint8_t& slot,
                               suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeGripperArmArrivedEvent(const PoseStampedSlot& slot,
                                  wire::GripperArmEvents::ArrivedParams::Builder out) {
  toWire(slot, out.initValue());
}
Errc decodeGripperArmArrivedEvent(wire::GripperArmEvents::ArrivedParams::Reader in,
                                  PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : Errc::Invalid;
}

void encodeGripperArmMovedEvent(const ArmLikeMovedPayload& slot,
                                wire::GripperArmEvents::MovedParams::Builder out) {
  toWire(slot.value, out.initValue());
  out.setValue2(slot.value2);
}
Errc decodeGripperArmMovedEvent(wire::GripperArmEvents::MovedParams::Reader in,
                                ArmLikeMovedPayload& slot, suture::Duration shift) {
  slot.value2 = in.getValue2();
  return in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : Errc::Invalid;
}

void encodeGripperArmGrippedEvent(const double& slot,
                                  wire::GripperArmEvents::GrippedParams::Builder out) {
  out.setValue(slot);
}
Errc decodeGripperArmGrippedEvent(wire::GripperArmEvents::GrippedParams::Reader in, double& slot,
                                  suture::Duration) {
  slot = in.getValue();
  return Errc{};
}

// A row of the state has a member for each column, so one function each way converts them all.
void encodeGripperArmColumn(unsigned column, const std::byte* memory,
                            wire::GripperArmStateRow::Builder out) {
  switch (column) {
    case 0: {
      const auto& slot = slotIn<PoseStampedSlot>(memory);
      toWire(slot, out.initMeasuredCp());
      break;
    }
    case 1: {
      const auto& slot = slotIn<JointStateSlot>(memory);
      toWire(slot, out.initMeasuredJs());
      break;
    }
    case 2: {
      const auto& slot = slotIn<double>(memory);
      out.setOpening(slot);
      break;
    }
  }
}
Errc decodeGripperArmColumn(wire::GripperArmStateRow::Reader in, unsigned column, std::byte* memory,
                            suture::Duration shift) {
  switch (column) {
    case 0: {
      auto& slot = newSlot<PoseStampedSlot>(memory);
      return in.hasMeasuredCp() ? fromWire(in.getMeasuredCp(), slot, shift) : Errc::Invalid;
    }
    case 1: {
      auto& slot = newSlot<JointStateSlot>(memory);
      return in.hasMeasuredJs() ? fromWire(in.getMeasuredJs(), slot, shift) : Errc::Invalid;
    }
    case 2: {
      auto& slot = newSlot<double>(memory);
      slot = in.getOpening();
      return Errc{};
    }
  }
  return Errc::Invalid;
}

constexpr CommandCodec kGripperArmCommandCodecs[] = {
    {.interface = capnp::typeId<wire::GripperArm>(),
     .method = 1,
     .sent = sentIn<wire::GripperArm::CloseParams>,
     .arguments = messageOf<wire::GripperArm::CloseParams, GripperArmCloseArguments,
                            encodeGripperArmClose, decodeGripperArmClose>,
     .result = messageOf<wire::GripperArm::CloseResults, double, encodeGripperArmCloseResult,
                         decodeGripperArmCloseResult>},
    {.interface = capnp::typeId<wire::GripperArm>(),
     .method = 2,
     .sent = sentIn<wire::GripperArm::OpeningParams>,
     .result = messageOf<wire::GripperArm::OpeningResults, double, encodeGripperArmOpeningResult,
                         decodeGripperArmOpeningResult>,
     .stamp = stampIn<wire::GripperArm::OpeningResults>},
    {.interface = capnp::typeId<wire::GripperArm>(),
     .method = 3,
     .sent = sentIn<wire::GripperArm::ReleaseParams>},
    {.interface = capnp::typeId<wire::GripperArm>(),
     .method = 4,
     .sent = sentIn<wire::GripperArm::FitsParams>,
     .arguments = messageOf<wire::GripperArm::FitsParams, GripperArmFitsArguments,
                            encodeGripperArmFits, decodeGripperArmFits>,
     .result = messageOf<wire::GripperArm::FitsResults, std::uint8_t, encodeGripperArmFitsResult,
                         decodeGripperArmFitsResult>},
};

constexpr EventCodec kGripperArmEventCodecs[] = {
    {.method = 1,
     .stamp = stampIn<wire::GripperArmEvents::ModeParams>,
     .payload = messageOf<wire::GripperArmEvents::ModeParams, std::uint8_t,
                          encodeGripperArmModeEvent, decodeGripperArmModeEvent>},
    {.method = 2,
     .stamp = stampIn<wire::GripperArmEvents::ArrivedParams>,
     .payload = messageOf<wire::GripperArmEvents::ArrivedParams, PoseStampedSlot,
                          encodeGripperArmArrivedEvent, decodeGripperArmArrivedEvent>},
    {.method = 3, .stamp = stampIn<wire::GripperArmEvents::StoppedParams>},
    {.method = 4,
     .stamp = stampIn<wire::GripperArmEvents::MovedParams>,
     .payload = messageOf<wire::GripperArmEvents::MovedParams, ArmLikeMovedPayload,
                          encodeGripperArmMovedEvent, decodeGripperArmMovedEvent>},
    {.method = 5,
     .stamp = stampIn<wire::GripperArmEvents::GrippedParams>,
     .payload = messageOf<wire::GripperArmEvents::GrippedParams, double,
                          encodeGripperArmGrippedEvent, decodeGripperArmGrippedEvent>},
};

const suture::rpc::Codec& gripperArmCodec() {
  static const auto kCommands = suture::extended<15>(
      suture::interfaceInfo<reference::ArmLike>().codec().commands, kGripperArmCommandCodecs);
  static const suture::rpc::Codec kCodec{
      .schema = suture::rpc::schemaOf<wire::GripperArm>,
      .contract = capnp::typeId<wire::GripperArm>(),
      .subscriber = capnp::typeId<wire::GripperArmEvents>(),
      .commands = kCommands,
      .events = kGripperArmEventCodecs,
      .row = suture::rpc::rowOf<wire::GripperArmEvents::StateParams, wire::GripperArmStateRow,
                                encodeGripperArmColumn, decodeGripperArmColumn>,
  };
  return kCodec;
}

constexpr CommandInfo kGripperArmCommands[] = {
    {.name = "close",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = slotSize<GripperArmCloseArguments>,
     .resultSize = slotSize<double>,
     .depth = 16,
     .accepts = checkSlot<GripperArmCloseArguments, acceptsGripperArmClose>,
     .acceptsResult = checkSlot<double, acceptsGripperArmCloseResult>},
    {.name = "opening",
     .kind = CommandKind::Read,
     .resultSize = slotSize<double>,
     .depth = 16,
     .column = 2,
     .acceptsResult = checkSlot<double, acceptsGripperArmOpeningResult>},
    {.name = "release", .kind = CommandKind::Void, .depth = 16, .inCallersThread = true},
    {.name = "fits",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = slotSize<GripperArmFitsArguments>,
     .resultSize = slotSize<std::uint8_t>,
     .depth = 16,
     .inCallersThread = true,
     .accepts = checkSlot<GripperArmFitsArguments, acceptsGripperArmFits>},
};

constexpr EventInfo kGripperArmEvents[] = {
    {.name = "gripped",
     .payloadSize = slotSize<double>,
     .depth = 16,
     .accepts = checkSlot<double, acceptsGripperArmGrippedEvent>},
};

// The self-description, as in reference/gripper_arm.suture.json.
constexpr char kGripperArmDescription[] = R"json({"name": "reference::GripperArm"})json";

}  // namespace
}  // namespace reference

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<reference::GripperArm>() {
  static const auto kCommands = extended<15>(interfaceInfo<reference::ArmLike>().commands,
                                             reference::kGripperArmCommands);
  static const auto kEvents = extended<5>(interfaceInfo<reference::ArmLike>().events,
                                          reference::kGripperArmEvents);
  static const InterfaceInfo kInfo{
      .name = "reference::GripperArm",
      .hash = "gripper",
      .description = reference::kGripperArmDescription,
      .commands = kCommands,
      .events = kEvents,
      .codec = &reference::gripperArmCodec,
      .base = &interfaceInfo<reference::ArmLike>,
      .toBase = &castToBase<reference::GripperArm, reference::ArmLike>,
  };
  return kInfo;
}

Errc Provided<reference::GripperArm>::execute(std::uint16_t command, const std::byte* arguments,
                                              std::byte* result) {
  using ::reference::GripperArmCommand;
  switch (static_cast<GripperArmCommand>(command)) {
    case GripperArmCommand::close: {
      const auto& slot = slotIn<reference::GripperArmCloseArguments>(arguments);
      load(slot.width, scratch_.close_width);
      auto& answer = newSlot<double>(result);
      return store(implementation_.close(scratch_.close_width), answer) ? Errc{} : Errc::TooLarge;
    }
    case GripperArmCommand::opening: {
      auto& slot = newSlot<double>(result);
      return store(implementation_.opening(), slot) ? Errc{} : Errc::TooLarge;
    }
    case GripperArmCommand::release: {
      implementation_.release();
      return Errc{};
    }
    case GripperArmCommand::fits: {
      const auto& slot = slotIn<reference::GripperArmFitsArguments>(arguments);
      load(slot.width, scratch_.fits_width);
      auto& answer = newSlot<std::uint8_t>(result);
      return store(implementation_.fits(scratch_.fits_width), answer) ? Errc{} : Errc::TooLarge;
    }
  }
  return Provided<reference::ArmLike>::execute(command, arguments, result);
}

}  // namespace suture
