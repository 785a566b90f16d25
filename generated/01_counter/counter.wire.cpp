// Written by suturec from 01_counter/counter.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "01_counter/counter.capnp.h"
#include "01_counter/counter.suture.h"

namespace counting {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- Counter as Cap'n Proto

namespace {

void encodeCounterAdd(const CounterAddArguments& slot, wire::Counter::AddParams::Builder out) {
  out.setAmount(slot.amount);
}
suture::Errc decodeCounterAdd(wire::Counter::AddParams::Reader in, CounterAddArguments& slot,
                              suture::Duration) {
  slot.amount = in.getAmount();
  return suture::Errc{};
}

void encodeCounterValueResult(const std::int64_t& slot, wire::Counter::ValueResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeCounterValueResult(wire::Counter::ValueResults::Reader in, std::int64_t& slot,
                                      suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeCounterTenMoreEvent(const std::int64_t& slot,
                               wire::CounterEvents::TenMoreParams::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeCounterTenMoreEvent(wire::CounterEvents::TenMoreParams::Reader in,
                                       std::int64_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeCounterValueColumn(const std::int64_t& slot, wire::CounterStateRow::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeCounterValueColumn(wire::CounterStateRow::Reader in, std::int64_t& slot,
                                      suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeCounterColumn(unsigned column, const std::byte* memory,
                         wire::CounterStateRow::Builder out) {
  switch (column) {
    case CounterColumn::value:
      return encodeCounterValueColumn(suture::slotIn<std::int64_t>(memory), out);
  }
}
suture::Errc decodeCounterColumn(wire::CounterStateRow::Reader in, unsigned column,
                                 std::byte* memory, suture::Duration shift) {
  switch (column) {
    case CounterColumn::value:
      return decodeCounterValueColumn(in, suture::newSlot<std::int64_t>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kCounterCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Counter>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Counter::AddParams>,
     .arguments = suture::codec::messageOf<wire::Counter::AddParams, CounterAddArguments,
                                           encodeCounterAdd, decodeCounterAdd>},
    {.interface = capnp::typeId<wire::Counter>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Counter::ValueParams>,
     .result = suture::codec::messageOf<wire::Counter::ValueResults, std::int64_t,
                                        encodeCounterValueResult, decodeCounterValueResult>,
     .stamp = suture::codec::stampIn<wire::Counter::ValueResults>},
};

constexpr suture::codec::EventCodec kCounterEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::CounterEvents::TenMoreParams>,
     .payload = suture::codec::messageOf<wire::CounterEvents::TenMoreParams, std::int64_t,
                                         encodeCounterTenMoreEvent, decodeCounterTenMoreEvent>},
};

}  // namespace

const suture::codec::Codec& counterCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Counter>,
      .contract = capnp::typeId<wire::Counter>(),
      .subscriber = capnp::typeId<wire::CounterEvents>(),
      .commands = kCounterCommandCodecs,
      .events = kCounterEventCodecs,
      .row = suture::codec::rowOf<wire::CounterEvents::StateParams, wire::CounterStateRow,
                                  encodeCounterColumn, decodeCounterColumn>,
  };
  return kCodec;
}

}  // namespace counting
