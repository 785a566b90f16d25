// Written by suturec from robots/arm.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "robots/arm.capnp.h"
#include "robots/arm.suture.h"

// Defined in robots/geometry.wire.cpp.
namespace robots {
void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out);
suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift);
}  // namespace robots

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::Mode wireMode(std::int8_t slot) {
  switch (static_cast<Mode>(slot)) {
    case Mode::Disabled: return wire::Mode::DISABLED;
    case Mode::HoldStill: return wire::Mode::HOLD_STILL;
    case Mode::Servo: return wire::Mode::SERVO;
  }
  return wire::Mode{};
}

suture::Errc fromWire(wire::Mode in, std::int8_t& slot) {
  switch (in) {
    case wire::Mode::DISABLED: return slot =
        static_cast<std::int8_t>(Mode::Disabled), suture::Errc{};
    case wire::Mode::HOLD_STILL: return slot =
        static_cast<std::int8_t>(Mode::HoldStill), suture::Errc{};
    case wire::Mode::SERVO: return slot = static_cast<std::int8_t>(Mode::Servo), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

void toWire(const EverythingSlot& slot, wire::Everything::Builder out) {
  out.setOn(slot.on != 0);
  out.setTiny(slot.tiny);
  out.setCount(slot.count);
  out.setSpeed(slot.speed);
  out.setRatio(slot.ratio);
  out.setMode(wireMode(slot.mode));
  toWire(slot.label, out.initLabel(sizeOf(slot.label)));
  toWire(slot.bytes, out.initBytes(sizeOf(slot.bytes)));
  toWire(slot.flags, out.initFlags(sizeOf(slot.flags)));
  toWire(slot.names, out.initNames(sizeOf(slot.names)));
  suture::codec::toWireList(slot.pairs, out.initPairs(sizeOf(slot.pairs)),
                            [](const std::array<double, 2>& element, auto list, std::uint32_t i) {
                              toWire(element, list.init(i, 2));
                            });
  suture::codec::toWireList(slot.modes, out.initModes(2),
                            [](const std::int8_t& element, auto list, std::uint32_t i) {
                              list.set(i, wireMode(element));
                            });
  toWire(slot.goal, out.initGoal());
  suture::codec::toWireList(slot.track, out.initTrack(sizeOf(slot.track)),
                            [](const PoseStampedSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  toWire(slot.point, out.initPoint());
  toWire(slot.plane, out.initPlane(3));
  toWire(slot.inertia, out.initInertia());
  toWire(slot.jacobian, out.initJacobian(42));
  toWire(slot.attitude, out.initAttitude());
  out.setPeriod(slot.period);
  out.setWhen(slot.when);
}

suture::Errc fromWire(wire::Everything::Reader in, EverythingSlot& slot, suture::Duration shift) {
  slot.on = in.getOn();
  slot.tiny = in.getTiny();
  slot.count = in.getCount();
  slot.speed = in.getSpeed();
  slot.ratio = in.getRatio();
  slot.period = in.getPeriod();
  slot.when = suture::codec::shifted(in.getWhen(), shift);
  return suture::codec::firstError({
      fromWire(in.getMode(), slot.mode),
      fromWire(in.getLabel(), slot.label),
      fromWire(in.getBytes(), slot.bytes),
      fromWire(in.getFlags(), slot.flags),
      fromWire(in.getNames(), slot.names),
      suture::codec::fromWireList(in.getPairs(), slot.pairs,
                                  [](auto item, std::array<double, 2>& target) {
                                    return fromWire(item, target);
                                  }),
      suture::codec::fromWireList(in.getModes(), slot.modes, [](auto item, std::int8_t& target) {
        return fromWire(item, target);
      }),
      fromWire(in.getGoal(), slot.goal, shift),
      suture::codec::fromWireList(in.getTrack(), slot.track,
                                  [&](auto item, PoseStampedSlot& target) {
                                    return fromWire(item, target, shift);
                                  }),
      in.hasPoint() ? fromWire(in.getPoint(), slot.point)
          : suture::codec::fromDefault(Everything().point, slot.point),
      in.getPlane().size() != 0 ? fromWire(in.getPlane(), slot.plane)
          : suture::codec::fromDefault(Everything().plane, slot.plane),
      in.hasInertia() ? fromWire(in.getInertia(), slot.inertia)
          : suture::codec::fromDefault(Everything().inertia, slot.inertia),
      in.getJacobian().size() != 0 ? fromWire(in.getJacobian(), slot.jacobian)
          : suture::codec::fromDefault(Everything().jacobian, slot.jacobian),
      in.hasAttitude() ? fromWire(in.getAttitude(), slot.attitude)
          : suture::codec::fromDefault(Everything().attitude, slot.attitude),
  });
}

// --- Arm as Cap'n Proto

namespace {

void encodeArmServoCp(const ArmServoCpArguments& slot, wire::Arm::ServoCpParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeArmServoCp(wire::Arm::ServoCpParams::Reader in, ArmServoCpArguments& slot,
                              suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeArmSetSpeed(const ArmSetSpeedArguments& slot, wire::Arm::SetSpeedParams::Builder out) {
  out.setSpeed(slot.speed);
}
suture::Errc decodeArmSetSpeed(wire::Arm::SetSpeedParams::Reader in, ArmSetSpeedArguments& slot,
                               suture::Duration) {
  slot.speed = in.getSpeed();
  return suture::Errc{};
}

void encodeArmMeasuredCpResult(const PoseStampedSlot& slot,
                               wire::Arm::MeasuredCpResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmMeasuredCpResult(wire::Arm::MeasuredCpResults::Reader in,
                                       PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmModeResult(const std::int8_t& slot, wire::Arm::ModeResults::Builder out) {
  out.setValue(wireMode(slot));
}
suture::Errc decodeArmModeResult(wire::Arm::ModeResults::Reader in, std::int8_t& slot,
                                 suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeArmEverythingResult(const EverythingSlot& slot,
                               wire::Arm::EverythingResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmEverythingResult(wire::Arm::EverythingResults::Reader in,
                                       EverythingSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmInverseKinematics(const ArmInverseKinematicsArguments& slot,
                                wire::Arm::InverseKinematicsParams::Builder out) {
  toWire(slot.x, out.initX());
  out.setTolerance(slot.tolerance);
}
suture::Errc decodeArmInverseKinematics(wire::Arm::InverseKinematicsParams::Reader in,
                                        ArmInverseKinematicsArguments& slot,
                                        suture::Duration shift) {
  slot.tolerance = in.getTolerance();
  return in.hasX() ? fromWire(in.getX(), slot.x, shift) : suture::Errc::Invalid;
}

void encodeArmInverseKinematicsResult(const EverythingSlot& slot,
                                      wire::Arm::InverseKinematicsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmInverseKinematicsResult(wire::Arm::InverseKinematicsResults::Reader in,
                                              EverythingSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmGrasp(const ArmGraspArguments& slot, wire::Arm::GraspParams::Builder out) {
  out.setWidth(slot.width);
  out.setMode(wireMode(slot.mode));
}
suture::Errc decodeArmGrasp(wire::Arm::GraspParams::Reader in, ArmGraspArguments& slot,
                            suture::Duration) {
  slot.width = in.getWidth();
  return fromWire(in.getMode(), slot.mode);
}

void encodeArmGraspResult(const std::uint8_t& slot, wire::Arm::GraspResults::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeArmGraspResult(wire::Arm::GraspResults::Reader in, std::uint8_t& slot,
                                  suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmNextTokenResult(const std::uint32_t& slot, wire::Arm::NextTokenResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeArmNextTokenResult(wire::Arm::NextTokenResults::Reader in, std::uint32_t& slot,
                                      suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmLoadResult(const double& slot, wire::Arm::LoadResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeArmLoadResult(wire::Arm::LoadResults::Reader in, double& slot,
                                 suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeArmModeChangedEvent(const std::int8_t& slot,
                               wire::ArmEvents::ModeChangedParams::Builder out) {
  out.setValue(wireMode(slot));
}
suture::Errc decodeArmModeChangedEvent(wire::ArmEvents::ModeChangedParams::Reader in,
                                       std::int8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeArmArrivedEvent(const PoseStampedSlot& slot,
                           wire::ArmEvents::ArrivedParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArmArrivedEvent(wire::ArmEvents::ArrivedParams::Reader in, PoseStampedSlot& slot,
                                   suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmMovedEvent(const ArmMovedPayload& slot, wire::ArmEvents::MovedParams::Builder out) {
  toWire(slot.value, out.initValue());
  out.setValue2(slot.value2);
  out.setValue3(wireMode(slot.value3));
}
suture::Errc decodeArmMovedEvent(wire::ArmEvents::MovedParams::Reader in, ArmMovedPayload& slot,
                                 suture::Duration shift) {
  slot.value2 = in.getValue2();
  return suture::codec::firstError({
      in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid,
      fromWire(in.getValue3(), slot.value3),
  });
}

void encodeArmMeasuredCpColumn(const PoseStampedSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initMeasuredCp());
}
suture::Errc decodeArmMeasuredCpColumn(wire::ArmStateRow::Reader in, PoseStampedSlot& slot,
                                       suture::Duration shift) {
  return in.hasMeasuredCp() ? fromWire(in.getMeasuredCp(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmModeColumn(const std::int8_t& slot, wire::ArmStateRow::Builder out) {
  out.setMode(wireMode(slot));
}
suture::Errc decodeArmModeColumn(wire::ArmStateRow::Reader in, std::int8_t& slot,
                                 suture::Duration) {
  return fromWire(in.getMode(), slot);
}

void encodeArmEverythingColumn(const EverythingSlot& slot, wire::ArmStateRow::Builder out) {
  toWire(slot, out.initEverything());
}
suture::Errc decodeArmEverythingColumn(wire::ArmStateRow::Reader in, EverythingSlot& slot,
                                       suture::Duration shift) {
  return in.hasEverything() ? fromWire(in.getEverything(), slot, shift) : suture::Errc::Invalid;
}

void encodeArmLoadColumn(const double& slot, wire::ArmStateRow::Builder out) {
  out.setLoad(slot);
}
suture::Errc decodeArmLoadColumn(wire::ArmStateRow::Reader in, double& slot, suture::Duration) {
  slot = in.getLoad();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeArmColumn(unsigned column, const std::byte* memory, wire::ArmStateRow::Builder out) {
  switch (column) {
    case ArmColumn::measured_cp:
      return encodeArmMeasuredCpColumn(suture::slotIn<PoseStampedSlot>(memory), out);
    case ArmColumn::mode: return encodeArmModeColumn(suture::slotIn<std::int8_t>(memory), out);
    case ArmColumn::everything:
      return encodeArmEverythingColumn(suture::slotIn<EverythingSlot>(memory), out);
    case ArmColumn::load: return encodeArmLoadColumn(suture::slotIn<double>(memory), out);
  }
}
suture::Errc decodeArmColumn(wire::ArmStateRow::Reader in, unsigned column, std::byte* memory,
                             suture::Duration shift) {
  switch (column) {
    case ArmColumn::measured_cp:
      return decodeArmMeasuredCpColumn(in, suture::newSlot<PoseStampedSlot>(memory), shift);
    case ArmColumn::mode:
      return decodeArmModeColumn(in, suture::newSlot<std::int8_t>(memory), shift);
    case ArmColumn::everything:
      return decodeArmEverythingColumn(in, suture::newSlot<EverythingSlot>(memory), shift);
    case ArmColumn::load: return decodeArmLoadColumn(in, suture::newSlot<double>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kArmCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Arm::EnableParams>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Arm::ServoCpParams>,
     .arguments = suture::codec::messageOf<wire::Arm::ServoCpParams, ArmServoCpArguments,
                                           encodeArmServoCp, decodeArmServoCp>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Arm::SetSpeedParams>,
     .arguments = suture::codec::messageOf<wire::Arm::SetSpeedParams, ArmSetSpeedArguments,
                                           encodeArmSetSpeed, decodeArmSetSpeed>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Arm::MeasuredCpParams>,
     .result = suture::codec::messageOf<wire::Arm::MeasuredCpResults, PoseStampedSlot,
                                        encodeArmMeasuredCpResult, decodeArmMeasuredCpResult>,
     .stamp = suture::codec::stampIn<wire::Arm::MeasuredCpResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 5,
     .sent = suture::codec::sentIn<wire::Arm::ModeParams>,
     .result = suture::codec::messageOf<wire::Arm::ModeResults, std::int8_t, encodeArmModeResult,
                                        decodeArmModeResult>,
     .stamp = suture::codec::stampIn<wire::Arm::ModeResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 6,
     .sent = suture::codec::sentIn<wire::Arm::EverythingParams>,
     .result = suture::codec::messageOf<wire::Arm::EverythingResults, EverythingSlot,
                                        encodeArmEverythingResult, decodeArmEverythingResult>,
     .stamp = suture::codec::stampIn<wire::Arm::EverythingResults>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 7,
     .sent = suture::codec::sentIn<wire::Arm::InverseKinematicsParams>,
     .arguments = suture::codec::messageOf<wire::Arm::InverseKinematicsParams,
                                           ArmInverseKinematicsArguments,
                                           encodeArmInverseKinematics, decodeArmInverseKinematics>,
     .result = suture::codec::messageOf<wire::Arm::InverseKinematicsResults, EverythingSlot,
                                        encodeArmInverseKinematicsResult,
                                        decodeArmInverseKinematicsResult>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 8,
     .sent = suture::codec::sentIn<wire::Arm::GraspParams>,
     .arguments = suture::codec::messageOf<wire::Arm::GraspParams, ArmGraspArguments,
                                           encodeArmGrasp, decodeArmGrasp>,
     .result = suture::codec::messageOf<wire::Arm::GraspResults, std::uint8_t, encodeArmGraspResult,
                                        decodeArmGraspResult>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 9,
     .sent = suture::codec::sentIn<wire::Arm::NextTokenParams>,
     .result = suture::codec::messageOf<wire::Arm::NextTokenResults, std::uint32_t,
                                        encodeArmNextTokenResult, decodeArmNextTokenResult>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 10,
     .sent = suture::codec::sentIn<wire::Arm::ParkParams>},
    {.interface = capnp::typeId<wire::Arm>(),
     .method = 11,
     .sent = suture::codec::sentIn<wire::Arm::LoadParams>,
     .result = suture::codec::messageOf<wire::Arm::LoadResults, double, encodeArmLoadResult,
                                        decodeArmLoadResult>,
     .stamp = suture::codec::stampIn<wire::Arm::LoadResults>},
};

constexpr suture::codec::EventCodec kArmEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::ArmEvents::ModeChangedParams>,
     .payload = suture::codec::messageOf<wire::ArmEvents::ModeChangedParams, std::int8_t,
                                         encodeArmModeChangedEvent, decodeArmModeChangedEvent>},
    {.method = 2, .stamp = suture::codec::stampIn<wire::ArmEvents::StoppedParams>},
    {.method = 3,
     .stamp = suture::codec::stampIn<wire::ArmEvents::ArrivedParams>,
     .payload = suture::codec::messageOf<wire::ArmEvents::ArrivedParams, PoseStampedSlot,
                                         encodeArmArrivedEvent, decodeArmArrivedEvent>},
    {.method = 4,
     .stamp = suture::codec::stampIn<wire::ArmEvents::MovedParams>,
     .payload = suture::codec::messageOf<wire::ArmEvents::MovedParams, ArmMovedPayload,
                                         encodeArmMovedEvent, decodeArmMovedEvent>},
};

}  // namespace

const suture::codec::Codec& armCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Arm>,
      .contract = capnp::typeId<wire::Arm>(),
      .subscriber = capnp::typeId<wire::ArmEvents>(),
      .commands = kArmCommandCodecs,
      .events = kArmEventCodecs,
      .row = suture::codec::rowOf<wire::ArmEvents::StateParams, wire::ArmStateRow, encodeArmColumn,
                                  decodeArmColumn>,
  };
  return kCodec;
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::Everything& value) {
  return codec::encodeAs<robots::wire::Everything, robots::EverythingSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::Everything& value) {
  return codec::decodeAs<robots::wire::Everything, robots::EverythingSlot>(bytes, value);
}

}  // namespace suture
