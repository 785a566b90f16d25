// Written by suturec from shapes/moments.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "shapes/moments.capnp.h"
#include "shapes/moments.suture.h"

namespace shapes {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const MomentSlot& slot, wire::Moment::Builder out) {
  out.setSteady(slot.steady);
  out.setSystem(slot.system);
  out.setNumber(slot.number);
}

suture::Errc fromWire(wire::Moment::Reader in, MomentSlot& slot, suture::Duration shift) {
  slot.steady = suture::codec::shifted(in.getSteady(), shift);
  slot.system = in.getSystem();
  slot.number = in.getNumber();
  return suture::Errc{};
}

static void toWire(const suture::SlotEntry<std::int32_t, std::int64_t>& slot,
                   wire::ShapesMomentsEntryOfInt32ToSteadyTime::Builder out) {
  out.setKey(slot.key);
  out.setValue(slot.value);
}

static suture::Errc fromWire(wire::ShapesMomentsEntryOfInt32ToSteadyTime::Reader in,
                             suture::SlotEntry<std::int32_t, std::int64_t>& slot,
                             suture::Duration shift) {
  slot.key = in.getKey();
  slot.value = suture::codec::shifted(in.getValue(), shift);
  return suture::Errc{};
}

static void toWire(const suture::SlotOptional<std::int64_t>& slot,
                   wire::ShapesMomentsOptionalSteadyTime::Builder out) {
  if (slot.present == 0) return out.setNone();
  out.setSome(slot.value);
}

static suture::Errc fromWire(wire::ShapesMomentsOptionalSteadyTime::Reader in,
                             suture::SlotOptional<std::int64_t>& slot, suture::Duration shift) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  slot.value = suture::codec::shifted(in.getSome(), shift);
  return suture::Errc{};
}

static void toWire(const suture::SlotOptional<MomentSlot>& slot,
                   wire::ShapesMomentsOptionalMoment::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(slot.value, out.initSome());
}

static suture::Errc fromWire(wire::ShapesMomentsOptionalMoment::Reader in,
                             suture::SlotOptional<MomentSlot>& slot, suture::Duration shift) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  return fromWire(in.getSome(), slot.value, shift);
}

static void toWire(const suture::SlotTuple<std::int64_t, std::int64_t, MomentSlot>& slot,
                   wire::ShapesMomentsTupleOfInt64AndSteadyTimeAndMoment::Builder out) {
  out.setItem0(suture::item<0>(slot));
  out.setItem1(suture::item<1>(slot));
  toWire(suture::item<2>(slot), out.initItem2());
}

static suture::Errc fromWire(wire::ShapesMomentsTupleOfInt64AndSteadyTimeAndMoment::Reader in,
                             suture::SlotTuple<std::int64_t, std::int64_t, MomentSlot>& slot,
                             suture::Duration shift) {
  suture::item<0>(slot) = in.getItem0();
  suture::item<1>(slot) = suture::codec::shifted(in.getItem1(), shift);
  return fromWire(in.getItem2(), suture::item<2>(slot), shift);
}

static void toWire(const suture::SlotVariant<std::int64_t, std::int64_t, MomentSlot>& slot,
                   wire::ShapesMomentsEitherOfInt64OrSteadyTimeOrMoment::Builder out) {
  if (slot.index == 0) return out.setInt64(suture::alternative<0>(slot));
  if (slot.index == 1) return out.setSteadyTime(suture::alternative<1>(slot));
  if (slot.index == 2) return toWire(suture::alternative<2>(slot), out.initMoment());
}

static suture::Errc fromWire(wire::ShapesMomentsEitherOfInt64OrSteadyTimeOrMoment::Reader in,
                             suture::SlotVariant<std::int64_t, std::int64_t, MomentSlot>& slot,
                             suture::Duration shift) {
  if (in.isInt64()) {
    slot.index = 0;
    suture::alternative<0>(slot) = in.getInt64();
    return suture::Errc{};
  }
  if (in.isSteadyTime()) {
    slot.index = 1;
    suture::alternative<1>(slot) = suture::codec::shifted(in.getSteadyTime(), shift);
    return suture::Errc{};
  }
  if (in.isMoment()) {
    slot.index = 2;
    return fromWire(in.getMoment(), suture::alternative<2>(slot), shift);
  }
  return suture::Errc::Invalid;
}

void toWire(const MomentsSlot& slot, wire::Moments::Builder out) {
  toWire(slot.pair, out.initPair(2));
  toWire(slot.list, out.initList(sizeOf(slot.list)));
  suture::codec::toWireList(slot.moments, out.initMoments(sizeOf(slot.moments)),
                            [](const MomentSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  suture::codec::toWireList(slot.nested, out.initNested(sizeOf(slot.nested)),
                            [](const suture::BoundedList<std::int64_t, 2>& element, auto list, std::uint32_t i) {
                              toWire(element, list.init(i, sizeOf(element)));
                            });
  suture::codec::toWireList(slot.byNumber, out.initByNumber(sizeOf(slot.byNumber)),
                            [](const auto& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  toWire(slot.perhaps, out.initPerhaps());
  toWire(slot.moment, out.initMoment());
  toWire(slot.entry, out.initEntry());
  toWire(slot.either, out.initEither());
}

suture::Errc fromWire(wire::Moments::Reader in, MomentsSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      suture::codec::fromWireList(in.getPair(), slot.pair, [&](auto item, std::int64_t& target) {
        return target = suture::codec::shifted(item, shift), suture::Errc{};
      }),
      suture::codec::fromWireList(in.getList(), slot.list, [&](auto item, std::int64_t& target) {
        return target = suture::codec::shifted(item, shift), suture::Errc{};
      }),
      suture::codec::fromWireList(in.getMoments(), slot.moments,
                                  [&](auto item, MomentSlot& target) {
                                    return fromWire(item, target, shift);
                                  }),
      suture::codec::fromWireList(in.getNested(), slot.nested,
                                  [&](auto item, suture::BoundedList<std::int64_t, 2>& target) {
                                    return suture::codec::fromWireList(item, target,
                                                                       [&](auto item2, std::int64_t& target2) {
                                                                         return target2 = suture::codec::shifted(item2, shift), suture::Errc{};
                                                                       });
                                  }),
      suture::codec::fromWireDistinct(in.getByNumber(), slot.byNumber,
                                      [&](auto item, auto& target) {
                                        return fromWire(item, target, shift);
                                      }),
      fromWire(in.getPerhaps(), slot.perhaps, shift),
      fromWire(in.getMoment(), slot.moment, shift),
      fromWire(in.getEntry(), slot.entry, shift),
      fromWire(in.getEither(), slot.either, shift),
  });
}

void toWire(const SpansSlot& slot, wire::Spans::Builder out) {
  out.setBrief(slot.brief);
  out.setEndless(slot.endless);
  toWire(slot.list, out.initList(sizeOf(slot.list)));
}

suture::Errc fromWire(wire::Spans::Reader in, SpansSlot& slot, suture::Duration) {
  slot.brief = in.getBrief();
  slot.endless = in.getEndless();
  return fromWire(in.getList(), slot.list);
}

// --- Journal as Cap'n Proto

namespace {

void encodeJournalPut(const JournalPutArguments& slot, wire::Journal::PutParams::Builder out) {
  out.setFrom(slot.from);
  out.setNumber(slot.number);
}
suture::Errc decodeJournalPut(wire::Journal::PutParams::Reader in, JournalPutArguments& slot,
                              suture::Duration shift) {
  slot.from = suture::codec::shifted(in.getFrom(), shift);
  slot.number = in.getNumber();
  return suture::Errc{};
}

void encodeJournalCount(const JournalCountArguments& slot,
                        wire::Journal::CountParams::Builder out) {
  out.setNumber(slot.number);
}
suture::Errc decodeJournalCount(wire::Journal::CountParams::Reader in, JournalCountArguments& slot,
                                suture::Duration) {
  slot.number = in.getNumber();
  return suture::Errc{};
}

void encodeJournalLatestResult(const std::int64_t& slot,
                               wire::Journal::LatestResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeJournalLatestResult(wire::Journal::LatestResults::Reader in, std::int64_t& slot,
                                       suture::Duration shift) {
  slot = suture::codec::shifted(in.getValue(), shift);
  return suture::Errc{};
}

void encodeJournalMomentsResult(const MomentsSlot& slot,
                                wire::Journal::MomentsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeJournalMomentsResult(wire::Journal::MomentsResults::Reader in, MomentsSlot& slot,
                                        suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeJournalFind(const JournalFindArguments& slot, wire::Journal::FindParams::Builder out) {
  out.setNumber(slot.number);
}
suture::Errc decodeJournalFind(wire::Journal::FindParams::Reader in, JournalFindArguments& slot,
                               suture::Duration) {
  slot.number = in.getNumber();
  return suture::Errc{};
}

void encodeJournalFindResult(const suture::SlotOptional<MomentSlot>& slot,
                             wire::Journal::FindResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeJournalFindResult(wire::Journal::FindResults::Reader in,
                                     suture::SlotOptional<MomentSlot>& slot,
                                     suture::Duration shift) {
  return fromWire(in.getValue(), slot, shift);
}

void encodeJournalAddedEvent(const std::int64_t& slot,
                             wire::JournalEvents::AddedParams::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeJournalAddedEvent(wire::JournalEvents::AddedParams::Reader in,
                                     std::int64_t& slot, suture::Duration shift) {
  slot = suture::codec::shifted(in.getValue(), shift);
  return suture::Errc{};
}

void encodeJournalChangedEvent(const JournalChangedPayload& slot,
                               wire::JournalEvents::ChangedParams::Builder out) {
  toWire(slot.value, out.initValue());
  out.setValue2(slot.value2);
}
suture::Errc decodeJournalChangedEvent(wire::JournalEvents::ChangedParams::Reader in,
                                       JournalChangedPayload& slot, suture::Duration shift) {
  slot.value2 = in.getValue2();
  return in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid;
}

void encodeJournalCountedEvent(const std::int64_t& slot,
                               wire::JournalEvents::CountedParams::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeJournalCountedEvent(wire::JournalEvents::CountedParams::Reader in,
                                       std::int64_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeJournalLatestColumn(const std::int64_t& slot, wire::JournalStateRow::Builder out) {
  out.setLatest(slot);
}
suture::Errc decodeJournalLatestColumn(wire::JournalStateRow::Reader in, std::int64_t& slot,
                                       suture::Duration shift) {
  slot = suture::codec::shifted(in.getLatest(), shift);
  return suture::Errc{};
}

void encodeJournalMomentsColumn(const MomentsSlot& slot, wire::JournalStateRow::Builder out) {
  toWire(slot, out.initMoments());
}
suture::Errc decodeJournalMomentsColumn(wire::JournalStateRow::Reader in, MomentsSlot& slot,
                                        suture::Duration shift) {
  return in.hasMoments() ? fromWire(in.getMoments(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeJournalColumn(unsigned column, const std::byte* memory,
                         wire::JournalStateRow::Builder out) {
  switch (column) {
    case JournalColumn::latest:
      return encodeJournalLatestColumn(suture::slotIn<std::int64_t>(memory), out);
    case JournalColumn::moments:
      return encodeJournalMomentsColumn(suture::slotIn<MomentsSlot>(memory), out);
  }
}
suture::Errc decodeJournalColumn(wire::JournalStateRow::Reader in, unsigned column,
                                 std::byte* memory, suture::Duration shift) {
  switch (column) {
    case JournalColumn::latest:
      return decodeJournalLatestColumn(in, suture::newSlot<std::int64_t>(memory), shift);
    case JournalColumn::moments:
      return decodeJournalMomentsColumn(in, suture::newSlot<MomentsSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kJournalCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Journal>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Journal::PutParams>,
     .arguments = suture::codec::messageOf<wire::Journal::PutParams, JournalPutArguments,
                                           encodeJournalPut, decodeJournalPut>},
    {.interface = capnp::typeId<wire::Journal>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Journal::CountParams>,
     .arguments = suture::codec::messageOf<wire::Journal::CountParams, JournalCountArguments,
                                           encodeJournalCount, decodeJournalCount>},
    {.interface = capnp::typeId<wire::Journal>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Journal::LatestParams>,
     .result = suture::codec::messageOf<wire::Journal::LatestResults, std::int64_t,
                                        encodeJournalLatestResult, decodeJournalLatestResult>,
     .stamp = suture::codec::stampIn<wire::Journal::LatestResults>},
    {.interface = capnp::typeId<wire::Journal>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Journal::MomentsParams>,
     .result = suture::codec::messageOf<wire::Journal::MomentsResults, MomentsSlot,
                                        encodeJournalMomentsResult, decodeJournalMomentsResult>,
     .stamp = suture::codec::stampIn<wire::Journal::MomentsResults>},
    {.interface = capnp::typeId<wire::Journal>(),
     .method = 5,
     .sent = suture::codec::sentIn<wire::Journal::FindParams>,
     .arguments = suture::codec::messageOf<wire::Journal::FindParams, JournalFindArguments,
                                           encodeJournalFind, decodeJournalFind>,
     .result = suture::codec::messageOf<wire::Journal::FindResults,
                                        suture::SlotOptional<MomentSlot>, encodeJournalFindResult,
                                        decodeJournalFindResult>},
};

constexpr suture::codec::EventCodec kJournalEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::JournalEvents::AddedParams>,
     .payload = suture::codec::messageOf<wire::JournalEvents::AddedParams, std::int64_t,
                                         encodeJournalAddedEvent, decodeJournalAddedEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::JournalEvents::ChangedParams>,
     .payload = suture::codec::messageOf<wire::JournalEvents::ChangedParams, JournalChangedPayload,
                                         encodeJournalChangedEvent, decodeJournalChangedEvent>},
    {.method = 3,
     .stamp = suture::codec::stampIn<wire::JournalEvents::CountedParams>,
     .payload = suture::codec::messageOf<wire::JournalEvents::CountedParams, std::int64_t,
                                         encodeJournalCountedEvent, decodeJournalCountedEvent>},
};

}  // namespace

const suture::codec::Codec& journalCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Journal>,
      .contract = capnp::typeId<wire::Journal>(),
      .subscriber = capnp::typeId<wire::JournalEvents>(),
      .commands = kJournalCommandCodecs,
      .events = kJournalEventCodecs,
      .row = suture::codec::rowOf<wire::JournalEvents::StateParams, wire::JournalStateRow,
                                  encodeJournalColumn, decodeJournalColumn>,
  };
  return kCodec;
}

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Moment& value) {
  return codec::encodeAs<shapes::wire::Moment, shapes::MomentSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Moment& value) {
  return codec::decodeAs<shapes::wire::Moment, shapes::MomentSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Moments& value) {
  return codec::encodeAs<shapes::wire::Moments, shapes::MomentsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Moments& value) {
  return codec::decodeAs<shapes::wire::Moments, shapes::MomentsSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Spans& value) {
  return codec::encodeAs<shapes::wire::Spans, shapes::SpansSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Spans& value) {
  return codec::decodeAs<shapes::wire::Spans, shapes::SpansSlot>(bytes, value);
}

}  // namespace suture
