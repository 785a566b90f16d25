// Written by suturec from arm/gripper.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "arm/gripper.capnp.h"
#include "arm/gripper.suture.h"

// Defined in robot_types/joint_commands.wire.cpp.
namespace robots {
void toWire(const JointConfigurationSlot& slot, wire::JointConfiguration::Builder out);
suture::Errc fromWire(wire::JointConfiguration::Reader in, JointConfigurationSlot& slot,
                      suture::Duration shift);
}  // namespace robots

// Defined in robot_types/joints.wire.cpp.
namespace robots {
void toWire(const JointStateSlot& slot, wire::JointState::Builder out);
suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration shift);
}  // namespace robots

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- Gripper as Cap'n Proto

namespace {

void encodeGripperConfigurationJsResult(const JointConfigurationSlot& slot,
                                        wire::Gripper::ConfigurationJsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeGripperConfigurationJsResult(wire::Gripper::ConfigurationJsResults::Reader in,
                                                JointConfigurationSlot& slot,
                                                suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeGripperMeasuredJsResult(const JointStateSlot& slot,
                                   wire::Gripper::MeasuredJsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeGripperMeasuredJsResult(wire::Gripper::MeasuredJsResults::Reader in,
                                           JointStateSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeGripperClosedEvent(const std::uint8_t& slot,
                              wire::GripperEvents::ClosedParams::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeGripperClosedEvent(wire::GripperEvents::ClosedParams::Reader in,
                                      std::uint8_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeGripperConfigurationJsColumn(const JointConfigurationSlot& slot,
                                        wire::GripperStateRow::Builder out) {
  toWire(slot, out.initConfigurationJs());
}
suture::Errc decodeGripperConfigurationJsColumn(wire::GripperStateRow::Reader in,
                                                JointConfigurationSlot& slot,
                                                suture::Duration shift) {
  return in.hasConfigurationJs() ? fromWire(in.getConfigurationJs(), slot, shift)
      : suture::Errc::Invalid;
}

void encodeGripperMeasuredJsColumn(const JointStateSlot& slot, wire::GripperStateRow::Builder out) {
  toWire(slot, out.initMeasuredJs());
}
suture::Errc decodeGripperMeasuredJsColumn(wire::GripperStateRow::Reader in, JointStateSlot& slot,
                                           suture::Duration shift) {
  return in.hasMeasuredJs() ? fromWire(in.getMeasuredJs(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeGripperColumn(unsigned column, const std::byte* memory,
                         wire::GripperStateRow::Builder out) {
  switch (column) {
    case GripperColumn::configuration_js:
      return encodeGripperConfigurationJsColumn(suture::slotIn<JointConfigurationSlot>(memory),
                                                out);
    case GripperColumn::measured_js:
      return encodeGripperMeasuredJsColumn(suture::slotIn<JointStateSlot>(memory), out);
  }
}
suture::Errc decodeGripperColumn(wire::GripperStateRow::Reader in, unsigned column,
                                 std::byte* memory, suture::Duration shift) {
  switch (column) {
    case GripperColumn::configuration_js:
      return decodeGripperConfigurationJsColumn(in, suture::newSlot<JointConfigurationSlot>(memory),
                                                shift);
    case GripperColumn::measured_js:
      return decodeGripperMeasuredJsColumn(in, suture::newSlot<JointStateSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kGripperCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Gripper>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Gripper::ConfigurationJsParams>,
     .result = suture::codec::messageOf<wire::Gripper::ConfigurationJsResults,
                                        JointConfigurationSlot, encodeGripperConfigurationJsResult,
                                        decodeGripperConfigurationJsResult>,
     .stamp = suture::codec::stampIn<wire::Gripper::ConfigurationJsResults>},
    {.interface = capnp::typeId<wire::Gripper>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Gripper::MeasuredJsParams>,
     .result = suture::codec::messageOf<wire::Gripper::MeasuredJsResults, JointStateSlot,
                                        encodeGripperMeasuredJsResult,
                                        decodeGripperMeasuredJsResult>,
     .stamp = suture::codec::stampIn<wire::Gripper::MeasuredJsResults>},
};

constexpr suture::codec::EventCodec kGripperEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::GripperEvents::ClosedParams>,
     .payload = suture::codec::messageOf<wire::GripperEvents::ClosedParams, std::uint8_t,
                                         encodeGripperClosedEvent, decodeGripperClosedEvent>},
};

}  // namespace

const suture::codec::Codec& gripperCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Gripper>,
      .contract = capnp::typeId<wire::Gripper>(),
      .subscriber = capnp::typeId<wire::GripperEvents>(),
      .commands = kGripperCommandCodecs,
      .events = kGripperEventCodecs,
      .row = suture::codec::rowOf<wire::GripperEvents::StateParams, wire::GripperStateRow,
                                  encodeGripperColumn, decodeGripperColumn>,
  };
  return kCodec;
}

}  // namespace robots
