// Written by suturec from suture/standard/task_timing.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "suture/standard/task_timing.capnp.h"
#include "suture/standard/task_timing.suture.h"

namespace suture {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const DurationSummarySlot& slot, wire::DurationSummary::Builder out) {
  out.setMean(slot.mean);
  out.setDeviation(slot.deviation);
  out.setMin(slot.min);
  out.setMax(slot.max);
  out.setP99(slot.p99);
}

suture::Errc fromWire(wire::DurationSummary::Reader in, DurationSummarySlot& slot,
                      suture::Duration) {
  slot.mean = in.getMean();
  slot.deviation = in.getDeviation();
  slot.min = in.getMin();
  slot.max = in.getMax();
  slot.p99 = in.getP99();
  return suture::Errc{};
}

void toWire(const TaskWindowSlot& slot, wire::TaskWindow::Builder out) {
  out.setBegin(slot.begin);
  out.setEnd(slot.end);
  out.setCycles(slot.cycles);
  out.setSkipped(slot.skipped);
  toWire(slot.period, out.initPeriod());
  toWire(slot.compute, out.initCompute());
}

suture::Errc fromWire(wire::TaskWindow::Reader in, TaskWindowSlot& slot, suture::Duration shift) {
  slot.begin = suture::codec::shifted(in.getBegin(), shift);
  slot.end = suture::codec::shifted(in.getEnd(), shift);
  slot.cycles = in.getCycles();
  slot.skipped = in.getSkipped();
  return suture::codec::firstError({
      fromWire(in.getPeriod(), slot.period, shift),
      fromWire(in.getCompute(), slot.compute, shift),
  });
}

// --- TaskTiming as Cap'n Proto

namespace {

void encodeTaskTimingWindowResult(const TaskWindowSlot& slot,
                                  wire::TaskTiming::WindowResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeTaskTimingWindowResult(wire::TaskTiming::WindowResults::Reader in,
                                          TaskWindowSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeTaskTimingCyclesResult(const std::uint64_t& slot,
                                  wire::TaskTiming::CyclesResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeTaskTimingCyclesResult(wire::TaskTiming::CyclesResults::Reader in,
                                          std::uint64_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeTaskTimingSkippedResult(const std::uint64_t& slot,
                                   wire::TaskTiming::SkippedResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeTaskTimingSkippedResult(wire::TaskTiming::SkippedResults::Reader in,
                                           std::uint64_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeTaskTimingWindowColumn(const TaskWindowSlot& slot,
                                  wire::TaskTimingStateRow::Builder out) {
  toWire(slot, out.initWindow());
}
suture::Errc decodeTaskTimingWindowColumn(wire::TaskTimingStateRow::Reader in, TaskWindowSlot& slot,
                                          suture::Duration shift) {
  return in.hasWindow() ? fromWire(in.getWindow(), slot, shift) : suture::Errc::Invalid;
}

void encodeTaskTimingCyclesColumn(const std::uint64_t& slot,
                                  wire::TaskTimingStateRow::Builder out) {
  out.setCycles(slot);
}
suture::Errc decodeTaskTimingCyclesColumn(wire::TaskTimingStateRow::Reader in, std::uint64_t& slot,
                                          suture::Duration) {
  slot = in.getCycles();
  return suture::Errc{};
}

void encodeTaskTimingSkippedColumn(const std::uint64_t& slot,
                                   wire::TaskTimingStateRow::Builder out) {
  out.setSkipped(slot);
}
suture::Errc decodeTaskTimingSkippedColumn(wire::TaskTimingStateRow::Reader in, std::uint64_t& slot,
                                           suture::Duration) {
  slot = in.getSkipped();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeTaskTimingColumn(unsigned column, const std::byte* memory,
                            wire::TaskTimingStateRow::Builder out) {
  switch (column) {
    case TaskTimingColumn::window:
      return encodeTaskTimingWindowColumn(suture::slotIn<TaskWindowSlot>(memory), out);
    case TaskTimingColumn::cycles:
      return encodeTaskTimingCyclesColumn(suture::slotIn<std::uint64_t>(memory), out);
    case TaskTimingColumn::skipped:
      return encodeTaskTimingSkippedColumn(suture::slotIn<std::uint64_t>(memory), out);
  }
}
suture::Errc decodeTaskTimingColumn(wire::TaskTimingStateRow::Reader in, unsigned column,
                                    std::byte* memory, suture::Duration shift) {
  switch (column) {
    case TaskTimingColumn::window:
      return decodeTaskTimingWindowColumn(in, suture::newSlot<TaskWindowSlot>(memory), shift);
    case TaskTimingColumn::cycles:
      return decodeTaskTimingCyclesColumn(in, suture::newSlot<std::uint64_t>(memory), shift);
    case TaskTimingColumn::skipped:
      return decodeTaskTimingSkippedColumn(in, suture::newSlot<std::uint64_t>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kTaskTimingCommandCodecs[] = {
    {.interface = capnp::typeId<wire::TaskTiming>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::TaskTiming::WindowParams>,
     .result = suture::codec::messageOf<wire::TaskTiming::WindowResults, TaskWindowSlot,
                                        encodeTaskTimingWindowResult, decodeTaskTimingWindowResult>,
     .stamp = suture::codec::stampIn<wire::TaskTiming::WindowResults>},
    {.interface = capnp::typeId<wire::TaskTiming>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::TaskTiming::CyclesParams>,
     .result = suture::codec::messageOf<wire::TaskTiming::CyclesResults, std::uint64_t,
                                        encodeTaskTimingCyclesResult, decodeTaskTimingCyclesResult>,
     .stamp = suture::codec::stampIn<wire::TaskTiming::CyclesResults>},
    {.interface = capnp::typeId<wire::TaskTiming>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::TaskTiming::SkippedParams>,
     .result = suture::codec::messageOf<wire::TaskTiming::SkippedResults, std::uint64_t,
                                        encodeTaskTimingSkippedResult,
                                        decodeTaskTimingSkippedResult>,
     .stamp = suture::codec::stampIn<wire::TaskTiming::SkippedResults>},
};

}  // namespace

const suture::codec::Codec& taskTimingCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::TaskTiming>,
      .contract = capnp::typeId<wire::TaskTiming>(),
      .subscriber = capnp::typeId<wire::TaskTimingEvents>(),
      .commands = kTaskTimingCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::TaskTimingEvents::StateParams, wire::TaskTimingStateRow,
                                  encodeTaskTimingColumn, decodeTaskTimingColumn>,
  };
  return kCodec;
}

}  // namespace suture

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const suture::DurationSummary& value) {
  return codec::encodeAs<suture::wire::DurationSummary, suture::DurationSummarySlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, suture::DurationSummary& value) {
  return codec::decodeAs<suture::wire::DurationSummary, suture::DurationSummarySlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const suture::TaskWindow& value) {
  return codec::encodeAs<suture::wire::TaskWindow, suture::TaskWindowSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, suture::TaskWindow& value) {
  return codec::decodeAs<suture::wire::TaskWindow, suture::TaskWindowSlot>(bytes, value);
}

}  // namespace suture
