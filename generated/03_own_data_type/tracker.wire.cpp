// Written by suturec from 03_own_data_type/tracker.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "03_own_data_type/tracker.capnp.h"
#include "03_own_data_type/tracker.suture.h"

// Defined in 03_own_data_type/observation.wire.cpp.
namespace tracking {
void toWire(const ObservationSlot& slot, wire::Observation::Builder out);
suture::Errc fromWire(wire::Observation::Reader in, ObservationSlot& slot, suture::Duration shift);
}  // namespace tracking

namespace tracking {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- Tracker as Cap'n Proto

namespace {

void encodeTrackerObservationResult(const ObservationSlot& slot,
                                    wire::Tracker::ObservationResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeTrackerObservationResult(wire::Tracker::ObservationResults::Reader in,
                                            ObservationSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeTrackerObservationColumn(const ObservationSlot& slot,
                                    wire::TrackerStateRow::Builder out) {
  toWire(slot, out.initObservation());
}
suture::Errc decodeTrackerObservationColumn(wire::TrackerStateRow::Reader in, ObservationSlot& slot,
                                            suture::Duration shift) {
  return in.hasObservation() ? fromWire(in.getObservation(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeTrackerColumn(unsigned column, const std::byte* memory,
                         wire::TrackerStateRow::Builder out) {
  switch (column) {
    case TrackerColumn::observation:
      return encodeTrackerObservationColumn(suture::slotIn<ObservationSlot>(memory), out);
  }
}
suture::Errc decodeTrackerColumn(wire::TrackerStateRow::Reader in, unsigned column,
                                 std::byte* memory, suture::Duration shift) {
  switch (column) {
    case TrackerColumn::observation:
      return decodeTrackerObservationColumn(in, suture::newSlot<ObservationSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kTrackerCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Tracker>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Tracker::ObservationParams>,
     .result = suture::codec::messageOf<wire::Tracker::ObservationResults, ObservationSlot,
                                        encodeTrackerObservationResult,
                                        decodeTrackerObservationResult>,
     .stamp = suture::codec::stampIn<wire::Tracker::ObservationResults>},
};

}  // namespace

const suture::codec::Codec& trackerCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Tracker>,
      .contract = capnp::typeId<wire::Tracker>(),
      .subscriber = capnp::typeId<wire::TrackerEvents>(),
      .commands = kTrackerCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::TrackerEvents::StateParams, wire::TrackerStateRow,
                                  encodeTrackerColumn, decodeTrackerColumn>,
  };
  return kCodec;
}

}  // namespace tracking
