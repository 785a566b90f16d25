// Written by suturec from shapes/large.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "shapes/large.capnp.h"
#include "shapes/large.suture.h"

namespace shapes {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const TraceSlot& slot, wire::Trace::Builder out) {
  out.setChannel(slot.channel);
  toWire(slot.samples, out.initSamples(sizeOf(slot.samples)));
  out.setGain(slot.gain);
}

suture::Errc fromWire(wire::Trace::Reader in, TraceSlot& slot, suture::Duration) {
  slot.channel = in.getChannel();
  slot.gain = in.getGain();
  return fromWire(in.getSamples(), slot.samples);
}

static void toWire(const suture::SlotOptional<TraceSlot>& slot,
                   wire::ShapesLargeOptionalTrace::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(slot.value, out.initSome());
}

static suture::Errc fromWire(wire::ShapesLargeOptionalTrace::Reader in,
                             suture::SlotOptional<TraceSlot>& slot, suture::Duration shift) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  return fromWire(in.getSome(), slot.value, shift);
}

static void toWire(const suture::SlotTuple<std::int8_t, TraceSlot, suture::BoundedList<std::int64_t, 40>>& slot,
                   wire::ShapesLargeTupleOfInt8AndTraceAndListOfInt64::Builder out) {
  out.setItem0(suture::item<0>(slot));
  toWire(suture::item<1>(slot), out.initItem1());
  toWire(suture::item<2>(slot), out.initItem2(sizeOf(suture::item<2>(slot))));
}

static suture::Errc fromWire(wire::ShapesLargeTupleOfInt8AndTraceAndListOfInt64::Reader in,
                             suture::SlotTuple<std::int8_t, TraceSlot, suture::BoundedList<std::int64_t, 40>>& slot,
                             suture::Duration shift) {
  suture::item<0>(slot) = in.getItem0();
  return suture::codec::firstError({
      fromWire(in.getItem1(), suture::item<1>(slot), shift),
      fromWire(in.getItem2(), suture::item<2>(slot)),
  });
}

static void toWire(const suture::SlotEntry<std::uint16_t, double>& slot,
                   wire::ShapesLargeEntryOfUInt16ToFloat64::Builder out) {
  out.setKey(slot.key);
  out.setValue(slot.value);
}

static suture::Errc fromWire(wire::ShapesLargeEntryOfUInt16ToFloat64::Reader in,
                             suture::SlotEntry<std::uint16_t, double>& slot, suture::Duration) {
  slot.key = in.getKey();
  slot.value = in.getValue();
  return suture::Errc{};
}

static void toWire(const suture::SlotVariant<suture::SlotNothing, TraceSlot, suture::BoundedList<float, 70>>& slot,
                   wire::ShapesLargeEitherOfNothingOrTraceOrListOfFloat32::Builder out) {
  if (slot.index == 0) return out.setNothing();
  if (slot.index == 1) return toWire(suture::alternative<1>(slot), out.initTrace());
  if (slot.index == 2) return toWire(suture::alternative<2>(slot),
                                     out.initListOfFloat32(sizeOf(suture::alternative<2>(slot))));
}

static suture::Errc fromWire(wire::ShapesLargeEitherOfNothingOrTraceOrListOfFloat32::Reader in,
                             suture::SlotVariant<suture::SlotNothing, TraceSlot, suture::BoundedList<float, 70>>& slot,
                             suture::Duration shift) {
  if (in.isNothing()) {
    slot.index = 0;
    return suture::Errc{};
  }
  if (in.isTrace()) {
    slot.index = 1;
    return fromWire(in.getTrace(), suture::alternative<1>(slot), shift);
  }
  if (in.isListOfFloat32()) {
    slot.index = 2;
    return fromWire(in.getListOfFloat32(), suture::alternative<2>(slot));
  }
  return suture::Errc::Invalid;
}

void toWire(const LargeSlot& slot, wire::Large::Builder out) {
  out.setFirst(slot.first);
  toWire(slot.text, out.initText(sizeOf(slot.text)));
  toWire(slot.name, out.initName(sizeOf(slot.name)));
  suture::codec::toWireList(slot.traces, out.initTraces(sizeOf(slot.traces)),
                            [](const TraceSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  toWire(slot.image, out.initImage());
  toWire(slot.inner, out.initInner());
  toWire(slot.maybe, out.initMaybe());
  toWire(slot.both, out.initBoth());
  suture::codec::toWireList(slot.gains, out.initGains(sizeOf(slot.gains)),
                            [](const auto& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  suture::codec::toWireList(slot.pair, out.initPair(2),
                            [](const TraceSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  toWire(slot.choice, out.initChoice());
  out.setLast(slot.last);
}

suture::Errc fromWire(wire::Large::Reader in, LargeSlot& slot, suture::Duration shift) {
  slot.first = in.getFirst();
  slot.last = in.getLast();
  return suture::codec::firstError({
      fromWire(in.getText(), slot.text),
      fromWire(in.getName(), slot.name),
      suture::codec::fromWireList(in.getTraces(), slot.traces, [&](auto item, TraceSlot& target) {
        return fromWire(item, target, shift);
      }),
      fromWire(in.getImage(), slot.image),
      fromWire(in.getInner(), slot.inner, shift),
      fromWire(in.getMaybe(), slot.maybe, shift),
      fromWire(in.getBoth(), slot.both, shift),
      suture::codec::fromWireDistinct(in.getGains(), slot.gains, [&](auto item, auto& target) {
        return fromWire(item, target, shift);
      }),
      suture::codec::fromWireList(in.getPair(), slot.pair, [&](auto item, TraceSlot& target) {
        return fromWire(item, target, shift);
      }),
      fromWire(in.getChoice(), slot.choice, shift),
  });
}

// --- Recorder as Cap'n Proto

namespace {

void encodeRecorderKeep(const RecorderKeepArguments& slot,
                        wire::Recorder::KeepParams::Builder out) {
  toWire(slot.values, out.initValues(sizeOf(slot.values)));
  toWire(slot.rest, out.initRest());
}
suture::Errc decodeRecorderKeep(wire::Recorder::KeepParams::Reader in, RecorderKeepArguments& slot,
                                suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getValues(), slot.values),
      in.hasRest() ? fromWire(in.getRest(), slot.rest, shift) : suture::Errc::Invalid,
  });
}

void encodeRecorderRename(const RecorderRenameArguments& slot,
                          wire::Recorder::RenameParams::Builder out) {
  toWire(slot.name, out.initName(sizeOf(slot.name)));
}
suture::Errc decodeRecorderRename(wire::Recorder::RenameParams::Reader in,
                                  RecorderRenameArguments& slot, suture::Duration) {
  return fromWire(in.getName(), slot.name);
}

void encodeRecorderKeptResult(const LargeSlot& slot, wire::Recorder::KeptResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeRecorderKeptResult(wire::Recorder::KeptResults::Reader in, LargeSlot& slot,
                                      suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeRecorderHeardEvent(const TraceSlot& slot,
                              wire::RecorderEvents::HeardParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeRecorderHeardEvent(wire::RecorderEvents::HeardParams::Reader in, TraceSlot& slot,
                                      suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeRecorderSaidEvent(const RecorderSaidPayload& slot,
                             wire::RecorderEvents::SaidParams::Builder out) {
  out.setValue(slot.value);
  toWire(slot.value2, out.initValue2());
}
suture::Errc decodeRecorderSaidEvent(wire::RecorderEvents::SaidParams::Reader in,
                                     RecorderSaidPayload& slot, suture::Duration shift) {
  slot.value = in.getValue();
  return in.hasValue2() ? fromWire(in.getValue2(), slot.value2, shift) : suture::Errc::Invalid;
}

void encodeRecorderKeptColumn(const LargeSlot& slot, wire::RecorderStateRow::Builder out) {
  toWire(slot, out.initKept());
}
suture::Errc decodeRecorderKeptColumn(wire::RecorderStateRow::Reader in, LargeSlot& slot,
                                      suture::Duration shift) {
  return in.hasKept() ? fromWire(in.getKept(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeRecorderColumn(unsigned column, const std::byte* memory,
                          wire::RecorderStateRow::Builder out) {
  switch (column) {
    case RecorderColumn::kept:
      return encodeRecorderKeptColumn(suture::slotIn<LargeSlot>(memory), out);
  }
}
suture::Errc decodeRecorderColumn(wire::RecorderStateRow::Reader in, unsigned column,
                                  std::byte* memory, suture::Duration shift) {
  switch (column) {
    case RecorderColumn::kept:
      return decodeRecorderKeptColumn(in, suture::newSlot<LargeSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kRecorderCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Recorder>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Recorder::KeepParams>,
     .arguments = suture::codec::messageOf<wire::Recorder::KeepParams, RecorderKeepArguments,
                                           encodeRecorderKeep, decodeRecorderKeep>},
    {.interface = capnp::typeId<wire::Recorder>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Recorder::RenameParams>,
     .arguments = suture::codec::messageOf<wire::Recorder::RenameParams, RecorderRenameArguments,
                                           encodeRecorderRename, decodeRecorderRename>},
    {.interface = capnp::typeId<wire::Recorder>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Recorder::KeptParams>,
     .result = suture::codec::messageOf<wire::Recorder::KeptResults, LargeSlot,
                                        encodeRecorderKeptResult, decodeRecorderKeptResult>,
     .stamp = suture::codec::stampIn<wire::Recorder::KeptResults>},
};

constexpr suture::codec::EventCodec kRecorderEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::RecorderEvents::HeardParams>,
     .payload = suture::codec::messageOf<wire::RecorderEvents::HeardParams, TraceSlot,
                                         encodeRecorderHeardEvent, decodeRecorderHeardEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::RecorderEvents::SaidParams>,
     .payload = suture::codec::messageOf<wire::RecorderEvents::SaidParams, RecorderSaidPayload,
                                         encodeRecorderSaidEvent, decodeRecorderSaidEvent>},
};

}  // namespace

const suture::codec::Codec& recorderCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Recorder>,
      .contract = capnp::typeId<wire::Recorder>(),
      .subscriber = capnp::typeId<wire::RecorderEvents>(),
      .commands = kRecorderCommandCodecs,
      .events = kRecorderEventCodecs,
      .row = suture::codec::rowOf<wire::RecorderEvents::StateParams, wire::RecorderStateRow,
                                  encodeRecorderColumn, decodeRecorderColumn>,
  };
  return kCodec;
}

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Trace& value) {
  return codec::encodeAs<shapes::wire::Trace, shapes::TraceSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Trace& value) {
  return codec::decodeAs<shapes::wire::Trace, shapes::TraceSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Large& value) {
  return codec::encodeAs<shapes::wire::Large, shapes::LargeSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Large& value) {
  return codec::decodeAs<shapes::wire::Large, shapes::LargeSlot>(bytes, value);
}

}  // namespace suture
