// Written by suturec from drives/drives.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "drives/drives.capnp.h"
#include "drives/drives.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::DrivePower wireDrivePower(std::uint8_t slot) {
  switch (static_cast<DrivePower>(slot)) {
    case DrivePower::NotReady: return wire::DrivePower::NOT_READY;
    case DrivePower::Stopped: return wire::DrivePower::STOPPED;
    case DrivePower::Off: return wire::DrivePower::OFF;
    case DrivePower::On: return wire::DrivePower::ON;
  }
  return wire::DrivePower{};
}

suture::Errc fromWire(wire::DrivePower in, std::uint8_t& slot) {
  switch (in) {
    case wire::DrivePower::NOT_READY: return slot =
        static_cast<std::uint8_t>(DrivePower::NotReady), suture::Errc{};
    case wire::DrivePower::STOPPED: return slot =
        static_cast<std::uint8_t>(DrivePower::Stopped), suture::Errc{};
    case wire::DrivePower::OFF: return slot =
        static_cast<std::uint8_t>(DrivePower::Off), suture::Errc{};
    case wire::DrivePower::ON: return slot =
        static_cast<std::uint8_t>(DrivePower::On), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

void toWire(const DriveFeedbackSlot& slot, wire::DriveFeedback::Builder out) {
  toWire(slot.position, out.initPosition(8));
  toWire(slot.velocity, out.initVelocity(8));
  out.setJoints(slot.joints);
  out.setPower(wireDrivePower(slot.power));
  out.setPermitted(slot.permitted);
  out.setStamp(slot.stamp);
  toWire(slot.effort, out.initEffort(8));
  out.setMeasuresEffort(slot.measures_effort != 0);
  out.setControlsEffort(slot.controls_effort != 0);
}

suture::Errc fromWire(wire::DriveFeedback::Reader in, DriveFeedbackSlot& slot,
                      suture::Duration shift) {
  slot.joints = in.getJoints();
  slot.permitted = suture::codec::shifted(in.getPermitted(), shift);
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.measures_effort = in.getMeasuresEffort();
  slot.controls_effort = in.getControlsEffort();
  return suture::codec::firstError({
      fromWire(in.getPosition(), slot.position),
      fromWire(in.getVelocity(), slot.velocity),
      fromWire(in.getPower(), slot.power),
      fromWire(in.getEffort(), slot.effort),
  });
}

void toWire(const DriveGoalSlot& slot, wire::DriveGoal::Builder out) {
  toWire(slot.position, out.initPosition(8));
  out.setJoints(slot.joints);
  toWire(slot.effort, out.initEffort(8));
  toWire(slot.released, out.initReleased(8));
  out.setGravityCompensation(slot.gravity_compensation != 0);
}

suture::Errc fromWire(wire::DriveGoal::Reader in, DriveGoalSlot& slot, suture::Duration) {
  slot.joints = in.getJoints();
  slot.gravity_compensation = in.getGravityCompensation();
  return suture::codec::firstError({
      fromWire(in.getPosition(), slot.position),
      fromWire(in.getEffort(), slot.effort),
      fromWire(in.getReleased(), slot.released),
  });
}

// --- Drives as Cap'n Proto

namespace {

void encodeDrivesPowerOn(const DrivesPowerOnArguments& slot,
                         wire::Drives::PowerOnParams::Builder out) {
  out.setPermitted(slot.permitted);
}
suture::Errc decodeDrivesPowerOn(wire::Drives::PowerOnParams::Reader in,
                                 DrivesPowerOnArguments& slot, suture::Duration shift) {
  slot.permitted = suture::codec::shifted(in.getPermitted(), shift);
  return suture::Errc{};
}

void encodeDrivesServoJp(const DrivesServoJpArguments& slot,
                         wire::Drives::ServoJpParams::Builder out) {
  toWire(slot.goal, out.initGoal());
}
suture::Errc decodeDrivesServoJp(wire::Drives::ServoJpParams::Reader in,
                                 DrivesServoJpArguments& slot, suture::Duration shift) {
  return in.hasGoal() ? fromWire(in.getGoal(), slot.goal, shift) : suture::Errc::Invalid;
}

void encodeDrivesFeedbackResult(const DriveFeedbackSlot& slot,
                                wire::Drives::FeedbackResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeDrivesFeedbackResult(wire::Drives::FeedbackResults::Reader in,
                                        DriveFeedbackSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeDrivesPowerEvent(const std::uint8_t& slot,
                            wire::DrivesEvents::PowerParams::Builder out) {
  out.setValue(wireDrivePower(slot));
}
suture::Errc decodeDrivesPowerEvent(wire::DrivesEvents::PowerParams::Reader in, std::uint8_t& slot,
                                    suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeDrivesFeedbackColumn(const DriveFeedbackSlot& slot, wire::DrivesStateRow::Builder out) {
  toWire(slot, out.initFeedback());
}
suture::Errc decodeDrivesFeedbackColumn(wire::DrivesStateRow::Reader in, DriveFeedbackSlot& slot,
                                        suture::Duration shift) {
  return in.hasFeedback() ? fromWire(in.getFeedback(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeDrivesColumn(unsigned column, const std::byte* memory,
                        wire::DrivesStateRow::Builder out) {
  switch (column) {
    case DrivesColumn::feedback:
      return encodeDrivesFeedbackColumn(suture::slotIn<DriveFeedbackSlot>(memory), out);
  }
}
suture::Errc decodeDrivesColumn(wire::DrivesStateRow::Reader in, unsigned column, std::byte* memory,
                                suture::Duration shift) {
  switch (column) {
    case DrivesColumn::feedback:
      return decodeDrivesFeedbackColumn(in, suture::newSlot<DriveFeedbackSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kDrivesCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Drives>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Drives::PowerOnParams>,
     .arguments = suture::codec::messageOf<wire::Drives::PowerOnParams, DrivesPowerOnArguments,
                                           encodeDrivesPowerOn, decodeDrivesPowerOn>},
    {.interface = capnp::typeId<wire::Drives>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Drives::PowerOffParams>},
    {.interface = capnp::typeId<wire::Drives>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Drives::ServoJpParams>,
     .arguments = suture::codec::messageOf<wire::Drives::ServoJpParams, DrivesServoJpArguments,
                                           encodeDrivesServoJp, decodeDrivesServoJp>},
    {.interface = capnp::typeId<wire::Drives>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Drives::FeedbackParams>,
     .result = suture::codec::messageOf<wire::Drives::FeedbackResults, DriveFeedbackSlot,
                                        encodeDrivesFeedbackResult, decodeDrivesFeedbackResult>,
     .stamp = suture::codec::stampIn<wire::Drives::FeedbackResults>},
};

constexpr suture::codec::EventCodec kDrivesEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::DrivesEvents::PowerParams>,
     .payload = suture::codec::messageOf<wire::DrivesEvents::PowerParams, std::uint8_t,
                                         encodeDrivesPowerEvent, decodeDrivesPowerEvent>},
};

}  // namespace

const suture::codec::Codec& drivesCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Drives>,
      .contract = capnp::typeId<wire::Drives>(),
      .subscriber = capnp::typeId<wire::DrivesEvents>(),
      .commands = kDrivesCommandCodecs,
      .events = kDrivesEventCodecs,
      .row = suture::codec::rowOf<wire::DrivesEvents::StateParams, wire::DrivesStateRow,
                                  encodeDrivesColumn, decodeDrivesColumn>,
  };
  return kCodec;
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::DriveFeedback& value) {
  return codec::encodeAs<robots::wire::DriveFeedback, robots::DriveFeedbackSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::DriveFeedback& value) {
  return codec::decodeAs<robots::wire::DriveFeedback, robots::DriveFeedbackSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::DriveGoal& value) {
  return codec::encodeAs<robots::wire::DriveGoal, robots::DriveGoalSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::DriveGoal& value) {
  return codec::decodeAs<robots::wire::DriveGoal, robots::DriveGoalSlot>(bytes, value);
}

}  // namespace suture
