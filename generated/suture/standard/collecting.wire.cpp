// Written by suturec from suture/standard/collecting.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "suture/standard/collecting.capnp.h"
#include "suture/standard/collecting.suture.h"

namespace suture {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const CollectedCountsSlot& slot, wire::CollectedCounts::Builder out) {
  out.setCollected(slot.collected);
  out.setPassedOver(slot.passedOver);
  out.setMissed(slot.missed);
}

suture::Errc fromWire(wire::CollectedCounts::Reader in, CollectedCountsSlot& slot,
                      suture::Duration) {
  slot.collected = in.getCollected();
  slot.passedOver = in.getPassedOver();
  slot.missed = in.getMissed();
  return suture::Errc{};
}

void toWire(const CollectingIntervalSlot& slot, wire::CollectingInterval::Builder out) {
  out.setEvery(slot.every);
  out.setAtLeast(slot.atLeast);
}

suture::Errc fromWire(wire::CollectingInterval::Reader in, CollectingIntervalSlot& slot,
                      suture::Duration) {
  slot.every = in.getEvery();
  slot.atLeast = in.getAtLeast();
  return suture::Errc{};
}

// --- Collecting as Cap'n Proto

namespace {

void encodeCollectingSetInterval(const CollectingSetIntervalArguments& slot,
                                 wire::Collecting::SetIntervalParams::Builder out) {
  toWire(slot.interval, out.initInterval());
}
suture::Errc decodeCollectingSetInterval(wire::Collecting::SetIntervalParams::Reader in,
                                         CollectingSetIntervalArguments& slot,
                                         suture::Duration shift) {
  return in.hasInterval() ? fromWire(in.getInterval(), slot.interval, shift)
      : suture::Errc::Invalid;
}

void encodeCollectingSetIntervalResult(const std::uint8_t& slot,
                                       wire::Collecting::SetIntervalResults::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeCollectingSetIntervalResult(wire::Collecting::SetIntervalResults::Reader in,
                                               std::uint8_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeCollectingIntervalResult(const CollectingIntervalSlot& slot,
                                    wire::Collecting::IntervalResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeCollectingIntervalResult(wire::Collecting::IntervalResults::Reader in,
                                            CollectingIntervalSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeCollectingCollectingResult(const std::uint8_t& slot,
                                      wire::Collecting::CollectingResults::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeCollectingCollectingResult(wire::Collecting::CollectingResults::Reader in,
                                              std::uint8_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeCollectingCountsResult(const CollectedCountsSlot& slot,
                                  wire::Collecting::CountsResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeCollectingCountsResult(wire::Collecting::CountsResults::Reader in,
                                          CollectedCountsSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeCollectingIntervalColumn(const CollectingIntervalSlot& slot,
                                    wire::CollectingStateRow::Builder out) {
  toWire(slot, out.initInterval());
}
suture::Errc decodeCollectingIntervalColumn(wire::CollectingStateRow::Reader in,
                                            CollectingIntervalSlot& slot, suture::Duration shift) {
  return in.hasInterval() ? fromWire(in.getInterval(), slot, shift) : suture::Errc::Invalid;
}

void encodeCollectingCollectingColumn(const std::uint8_t& slot,
                                      wire::CollectingStateRow::Builder out) {
  out.setCollecting(slot != 0);
}
suture::Errc decodeCollectingCollectingColumn(wire::CollectingStateRow::Reader in,
                                              std::uint8_t& slot, suture::Duration) {
  slot = in.getCollecting();
  return suture::Errc{};
}

void encodeCollectingCountsColumn(const CollectedCountsSlot& slot,
                                  wire::CollectingStateRow::Builder out) {
  toWire(slot, out.initCounts());
}
suture::Errc decodeCollectingCountsColumn(wire::CollectingStateRow::Reader in,
                                          CollectedCountsSlot& slot, suture::Duration shift) {
  return in.hasCounts() ? fromWire(in.getCounts(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeCollectingColumn(unsigned column, const std::byte* memory,
                            wire::CollectingStateRow::Builder out) {
  switch (column) {
    case CollectingColumn::interval:
      return encodeCollectingIntervalColumn(suture::slotIn<CollectingIntervalSlot>(memory), out);
    case CollectingColumn::collecting:
      return encodeCollectingCollectingColumn(suture::slotIn<std::uint8_t>(memory), out);
    case CollectingColumn::counts:
      return encodeCollectingCountsColumn(suture::slotIn<CollectedCountsSlot>(memory), out);
  }
}
suture::Errc decodeCollectingColumn(wire::CollectingStateRow::Reader in, unsigned column,
                                    std::byte* memory, suture::Duration shift) {
  switch (column) {
    case CollectingColumn::interval:
      return decodeCollectingIntervalColumn(in, suture::newSlot<CollectingIntervalSlot>(memory),
                                            shift);
    case CollectingColumn::collecting:
      return decodeCollectingCollectingColumn(in, suture::newSlot<std::uint8_t>(memory), shift);
    case CollectingColumn::counts:
      return decodeCollectingCountsColumn(in, suture::newSlot<CollectedCountsSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kCollectingCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Collecting>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Collecting::StartCollectingParams>},
    {.interface = capnp::typeId<wire::Collecting>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Collecting::StopCollectingParams>},
    {.interface = capnp::typeId<wire::Collecting>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Collecting::SetIntervalParams>,
     .arguments = suture::codec::messageOf<wire::Collecting::SetIntervalParams,
                                           CollectingSetIntervalArguments,
                                           encodeCollectingSetInterval,
                                           decodeCollectingSetInterval>,
     .result = suture::codec::messageOf<wire::Collecting::SetIntervalResults, std::uint8_t,
                                        encodeCollectingSetIntervalResult,
                                        decodeCollectingSetIntervalResult>},
    {.interface = capnp::typeId<wire::Collecting>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Collecting::IntervalParams>,
     .result = suture::codec::messageOf<wire::Collecting::IntervalResults, CollectingIntervalSlot,
                                        encodeCollectingIntervalResult,
                                        decodeCollectingIntervalResult>,
     .stamp = suture::codec::stampIn<wire::Collecting::IntervalResults>},
    {.interface = capnp::typeId<wire::Collecting>(),
     .method = 5,
     .sent = suture::codec::sentIn<wire::Collecting::CollectingParams>,
     .result = suture::codec::messageOf<wire::Collecting::CollectingResults, std::uint8_t,
                                        encodeCollectingCollectingResult,
                                        decodeCollectingCollectingResult>,
     .stamp = suture::codec::stampIn<wire::Collecting::CollectingResults>},
    {.interface = capnp::typeId<wire::Collecting>(),
     .method = 6,
     .sent = suture::codec::sentIn<wire::Collecting::CountsParams>,
     .result = suture::codec::messageOf<wire::Collecting::CountsResults, CollectedCountsSlot,
                                        encodeCollectingCountsResult, decodeCollectingCountsResult>,
     .stamp = suture::codec::stampIn<wire::Collecting::CountsResults>},
};

}  // namespace

const suture::codec::Codec& collectingCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Collecting>,
      .contract = capnp::typeId<wire::Collecting>(),
      .subscriber = capnp::typeId<wire::CollectingEvents>(),
      .commands = kCollectingCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::CollectingEvents::StateParams, wire::CollectingStateRow,
                                  encodeCollectingColumn, decodeCollectingColumn>,
  };
  return kCodec;
}

}  // namespace suture

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const suture::CollectedCounts& value) {
  return codec::encodeAs<suture::wire::CollectedCounts, suture::CollectedCountsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, suture::CollectedCounts& value) {
  return codec::decodeAs<suture::wire::CollectedCounts, suture::CollectedCountsSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const suture::CollectingInterval& value) {
  return codec::encodeAs<suture::wire::CollectingInterval, suture::CollectingIntervalSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, suture::CollectingInterval& value) {
  return codec::decodeAs<suture::wire::CollectingInterval,
                         suture::CollectingIntervalSlot>(bytes, value);
}

}  // namespace suture
