// Written by suturec from arm/jaw.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "arm/jaw.capnp.h"
#include "arm/jaw.suture.h"

// Defined in robot_types/joint_commands.wire.cpp.
namespace robots {
void toWire(const JointConfigurationSlot& slot, wire::JointConfiguration::Builder out);
suture::Errc fromWire(wire::JointConfiguration::Reader in, JointConfigurationSlot& slot,
                      suture::Duration shift);
void toWire(const JointEffortGoalSlot& slot, wire::JointEffortGoal::Builder out);
suture::Errc fromWire(wire::JointEffortGoal::Reader in, JointEffortGoalSlot& slot,
                      suture::Duration shift);
}  // namespace robots

// Defined in robot_types/joints.wire.cpp.
namespace robots {
void toWire(const JointGoalSlot& slot, wire::JointGoal::Builder out);
suture::Errc fromWire(wire::JointGoal::Reader in, JointGoalSlot& slot, suture::Duration shift);
void toWire(const JointStateSlot& slot, wire::JointState::Builder out);
suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration shift);
}  // namespace robots

// Defined in suture/standard/messages.wire.cpp.
namespace suture {
void toWire(const MessageSlot& slot, wire::Message::Builder out);
suture::Errc fromWire(wire::Message::Reader in, MessageSlot& slot, suture::Duration shift);
}  // namespace suture

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- Jaw as Cap'n Proto

namespace {

void encodeJawConfigurationJsResult(const JointConfigurationSlot& slot,
                                    wire::Jaw::ConfigurationJsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeJawConfigurationJsResult(wire::Jaw::ConfigurationJsResults::Reader in,
                                            JointConfigurationSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeJawMeasuredJsResult(const JointStateSlot& slot,
                               wire::Jaw::MeasuredJsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeJawMeasuredJsResult(wire::Jaw::MeasuredJsResults::Reader in,
                                       JointStateSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeJawSetpointJsResult(const JointStateSlot& slot,
                               wire::Jaw::SetpointJsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeJawSetpointJsResult(wire::Jaw::SetpointJsResults::Reader in,
                                       JointStateSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeJawServoJp(const JawServoJpArguments& slot, wire::Jaw::ServoJpParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeJawServoJp(wire::Jaw::ServoJpParams::Reader in, JawServoJpArguments& slot,
                              suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeJawServoJf(const JawServoJfArguments& slot, wire::Jaw::ServoJfParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeJawServoJf(wire::Jaw::ServoJfParams::Reader in, JawServoJfArguments& slot,
                              suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeJawMoveJp(const JawMoveJpArguments& slot, wire::Jaw::MoveJpParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeJawMoveJp(wire::Jaw::MoveJpParams::Reader in, JawMoveJpArguments& slot,
                             suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeJawStatusEvent(const suture::MessageSlot& slot,
                          wire::JawEvents::StatusParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeJawStatusEvent(wire::JawEvents::StatusParams::Reader in,
                                  suture::MessageSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeJawWarningEvent(const suture::MessageSlot& slot,
                           wire::JawEvents::WarningParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeJawWarningEvent(wire::JawEvents::WarningParams::Reader in,
                                   suture::MessageSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeJawErrorEvent(const suture::MessageSlot& slot,
                         wire::JawEvents::ErrorParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeJawErrorEvent(wire::JawEvents::ErrorParams::Reader in, suture::MessageSlot& slot,
                                 suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeJawGoalReachedEvent(const std::uint8_t& slot,
                               wire::JawEvents::GoalReachedParams::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeJawGoalReachedEvent(wire::JawEvents::GoalReachedParams::Reader in,
                                       std::uint8_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeJawConfigurationJsColumn(const JointConfigurationSlot& slot,
                                    wire::JawStateRow::Builder out) {
  toWire(slot, out.initConfigurationJs());
}
suture::Errc decodeJawConfigurationJsColumn(wire::JawStateRow::Reader in,
                                            JointConfigurationSlot& slot, suture::Duration shift) {
  return in.hasConfigurationJs() ? fromWire(in.getConfigurationJs(), slot, shift)
      : suture::Errc::Invalid;
}

void encodeJawMeasuredJsColumn(const JointStateSlot& slot, wire::JawStateRow::Builder out) {
  toWire(slot, out.initMeasuredJs());
}
suture::Errc decodeJawMeasuredJsColumn(wire::JawStateRow::Reader in, JointStateSlot& slot,
                                       suture::Duration shift) {
  return in.hasMeasuredJs() ? fromWire(in.getMeasuredJs(), slot, shift) : suture::Errc::Invalid;
}

void encodeJawSetpointJsColumn(const JointStateSlot& slot, wire::JawStateRow::Builder out) {
  toWire(slot, out.initSetpointJs());
}
suture::Errc decodeJawSetpointJsColumn(wire::JawStateRow::Reader in, JointStateSlot& slot,
                                       suture::Duration shift) {
  return in.hasSetpointJs() ? fromWire(in.getSetpointJs(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeJawColumn(unsigned column, const std::byte* memory, wire::JawStateRow::Builder out) {
  switch (column) {
    case JawColumn::configuration_js:
      return encodeJawConfigurationJsColumn(suture::slotIn<JointConfigurationSlot>(memory), out);
    case JawColumn::measured_js:
      return encodeJawMeasuredJsColumn(suture::slotIn<JointStateSlot>(memory), out);
    case JawColumn::setpoint_js:
      return encodeJawSetpointJsColumn(suture::slotIn<JointStateSlot>(memory), out);
  }
}
suture::Errc decodeJawColumn(wire::JawStateRow::Reader in, unsigned column, std::byte* memory,
                             suture::Duration shift) {
  switch (column) {
    case JawColumn::configuration_js:
      return decodeJawConfigurationJsColumn(in, suture::newSlot<JointConfigurationSlot>(memory),
                                            shift);
    case JawColumn::measured_js:
      return decodeJawMeasuredJsColumn(in, suture::newSlot<JointStateSlot>(memory), shift);
    case JawColumn::setpoint_js:
      return decodeJawSetpointJsColumn(in, suture::newSlot<JointStateSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kJawCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Jaw>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Jaw::ConfigurationJsParams>,
     .result = suture::codec::messageOf<wire::Jaw::ConfigurationJsResults, JointConfigurationSlot,
                                        encodeJawConfigurationJsResult,
                                        decodeJawConfigurationJsResult>,
     .stamp = suture::codec::stampIn<wire::Jaw::ConfigurationJsResults>},
    {.interface = capnp::typeId<wire::Jaw>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Jaw::MeasuredJsParams>,
     .result = suture::codec::messageOf<wire::Jaw::MeasuredJsResults, JointStateSlot,
                                        encodeJawMeasuredJsResult, decodeJawMeasuredJsResult>,
     .stamp = suture::codec::stampIn<wire::Jaw::MeasuredJsResults>},
    {.interface = capnp::typeId<wire::Jaw>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Jaw::SetpointJsParams>,
     .result = suture::codec::messageOf<wire::Jaw::SetpointJsResults, JointStateSlot,
                                        encodeJawSetpointJsResult, decodeJawSetpointJsResult>,
     .stamp = suture::codec::stampIn<wire::Jaw::SetpointJsResults>},
    {.interface = capnp::typeId<wire::Jaw>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Jaw::ServoJpParams>,
     .arguments = suture::codec::messageOf<wire::Jaw::ServoJpParams, JawServoJpArguments,
                                           encodeJawServoJp, decodeJawServoJp>},
    {.interface = capnp::typeId<wire::Jaw>(),
     .method = 5,
     .sent = suture::codec::sentIn<wire::Jaw::ServoJfParams>,
     .arguments = suture::codec::messageOf<wire::Jaw::ServoJfParams, JawServoJfArguments,
                                           encodeJawServoJf, decodeJawServoJf>},
    {.interface = capnp::typeId<wire::Jaw>(),
     .method = 6,
     .sent = suture::codec::sentIn<wire::Jaw::MoveJpParams>,
     .arguments = suture::codec::messageOf<wire::Jaw::MoveJpParams, JawMoveJpArguments,
                                           encodeJawMoveJp, decodeJawMoveJp>},
};

constexpr suture::codec::EventCodec kJawEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::JawEvents::StatusParams>,
     .payload = suture::codec::messageOf<wire::JawEvents::StatusParams, suture::MessageSlot,
                                         encodeJawStatusEvent, decodeJawStatusEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::JawEvents::WarningParams>,
     .payload = suture::codec::messageOf<wire::JawEvents::WarningParams, suture::MessageSlot,
                                         encodeJawWarningEvent, decodeJawWarningEvent>},
    {.method = 3,
     .stamp = suture::codec::stampIn<wire::JawEvents::ErrorParams>,
     .payload = suture::codec::messageOf<wire::JawEvents::ErrorParams, suture::MessageSlot,
                                         encodeJawErrorEvent, decodeJawErrorEvent>},
    {.method = 4,
     .stamp = suture::codec::stampIn<wire::JawEvents::GoalReachedParams>,
     .payload = suture::codec::messageOf<wire::JawEvents::GoalReachedParams, std::uint8_t,
                                         encodeJawGoalReachedEvent, decodeJawGoalReachedEvent>},
};

}  // namespace

const suture::codec::Codec& jawCodec() {
  static const suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Jaw>,
      .contract = capnp::typeId<wire::Jaw>(),
      .subscriber = capnp::typeId<wire::JawEvents>(),
      .commands = kJawCommandCodecs,
      .events = kJawEventCodecs,
      .row = suture::codec::rowOf<wire::JawEvents::StateParams, wire::JawStateRow, encodeJawColumn,
                                  decodeJawColumn>,
  };
  return kCodec;
}

}  // namespace robots
