// Written by suturec from vision/tracked_object.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "vision/tracked_object.capnp.h"
#include "vision/tracked_object.suture.h"

// Defined in robot_types/cartesian.wire.cpp.
namespace robots {
void toWire(const TwistSlot& slot, wire::Twist::Builder out);
suture::Errc fromWire(wire::Twist::Reader in, TwistSlot& slot, suture::Duration shift);
}  // namespace robots

// Defined in robot_types/pose.wire.cpp.
namespace robots {
void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out);
suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift);
}  // namespace robots

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- TrackedObject as Cap'n Proto

namespace {

void encodeTrackedObjectMeasuredCpResult(const PoseStampedSlot& slot,
                                         wire::TrackedObject::MeasuredCpResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeTrackedObjectMeasuredCpResult(wire::TrackedObject::MeasuredCpResults::Reader in,
                                                 PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeTrackedObjectMeasuredCvResult(const TwistSlot& slot,
                                         wire::TrackedObject::MeasuredCvResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeTrackedObjectMeasuredCvResult(wire::TrackedObject::MeasuredCvResults::Reader in,
                                                 TwistSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeTrackedObjectMeasuredCpColumn(const PoseStampedSlot& slot,
                                         wire::TrackedObjectStateRow::Builder out) {
  toWire(slot, out.initMeasuredCp());
}
suture::Errc decodeTrackedObjectMeasuredCpColumn(wire::TrackedObjectStateRow::Reader in,
                                                 PoseStampedSlot& slot, suture::Duration shift) {
  return in.hasMeasuredCp() ? fromWire(in.getMeasuredCp(), slot, shift) : suture::Errc::Invalid;
}

void encodeTrackedObjectMeasuredCvColumn(const TwistSlot& slot,
                                         wire::TrackedObjectStateRow::Builder out) {
  toWire(slot, out.initMeasuredCv());
}
suture::Errc decodeTrackedObjectMeasuredCvColumn(wire::TrackedObjectStateRow::Reader in,
                                                 TwistSlot& slot, suture::Duration shift) {
  return in.hasMeasuredCv() ? fromWire(in.getMeasuredCv(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeTrackedObjectColumn(unsigned column, const std::byte* memory,
                               wire::TrackedObjectStateRow::Builder out) {
  switch (column) {
    case TrackedObjectColumn::measured_cp:
      return encodeTrackedObjectMeasuredCpColumn(suture::slotIn<PoseStampedSlot>(memory), out);
    case TrackedObjectColumn::measured_cv:
      return encodeTrackedObjectMeasuredCvColumn(suture::slotIn<TwistSlot>(memory), out);
  }
}
suture::Errc decodeTrackedObjectColumn(wire::TrackedObjectStateRow::Reader in, unsigned column,
                                       std::byte* memory, suture::Duration shift) {
  switch (column) {
    case TrackedObjectColumn::measured_cp:
      return decodeTrackedObjectMeasuredCpColumn(in, suture::newSlot<PoseStampedSlot>(memory),
                                                 shift);
    case TrackedObjectColumn::measured_cv:
      return decodeTrackedObjectMeasuredCvColumn(in, suture::newSlot<TwistSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kTrackedObjectCommandCodecs[] = {
    {.interface = capnp::typeId<wire::TrackedObject>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::TrackedObject::MeasuredCpParams>,
     .result = suture::codec::messageOf<wire::TrackedObject::MeasuredCpResults, PoseStampedSlot,
                                        encodeTrackedObjectMeasuredCpResult,
                                        decodeTrackedObjectMeasuredCpResult>,
     .stamp = suture::codec::stampIn<wire::TrackedObject::MeasuredCpResults>},
    {.interface = capnp::typeId<wire::TrackedObject>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::TrackedObject::MeasuredCvParams>,
     .result = suture::codec::messageOf<wire::TrackedObject::MeasuredCvResults, TwistSlot,
                                        encodeTrackedObjectMeasuredCvResult,
                                        decodeTrackedObjectMeasuredCvResult>,
     .stamp = suture::codec::stampIn<wire::TrackedObject::MeasuredCvResults>},
};

}  // namespace

const suture::codec::Codec& trackedObjectCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::TrackedObject>,
      .contract = capnp::typeId<wire::TrackedObject>(),
      .subscriber = capnp::typeId<wire::TrackedObjectEvents>(),
      .commands = kTrackedObjectCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::TrackedObjectEvents::StateParams,
                                  wire::TrackedObjectStateRow, encodeTrackedObjectColumn,
                                  decodeTrackedObjectColumn>,
  };
  return kCodec;
}

}  // namespace robots
