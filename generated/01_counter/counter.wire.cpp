// Written by suturec from 01_counter/counter.h. Do not edit.
#include <suture/wire/codec.h>
#include <suture/wire/wire.h>

#include "01_counter/counter.capnp.h"
#include "01_counter/counter.suture.h"

namespace counting {

using suture::rpc::fromWire;
using suture::rpc::toWire;

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

constexpr suture::rpc::CommandCodec kCounterCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Counter>(),
     .method = 1,
     .sent = suture::rpc::sentIn<wire::Counter::AddParams>,
     .arguments = suture::rpc::messageOf<wire::Counter::AddParams, CounterAddArguments,
                                         encodeCounterAdd, decodeCounterAdd>},
    {.interface = capnp::typeId<wire::Counter>(),
     .method = 2,
     .sent = suture::rpc::sentIn<wire::Counter::ValueParams>,
     .result = suture::rpc::messageOf<wire::Counter::ValueResults, std::int64_t,
                                      encodeCounterValueResult, decodeCounterValueResult>,
     .stamp = suture::rpc::stampIn<wire::Counter::ValueResults>},
};

constexpr suture::rpc::EventCodec kCounterEventCodecs[] = {
    {.method = 1,
     .stamp = suture::rpc::stampIn<wire::CounterEvents::TenMoreParams>,
     .payload = suture::rpc::messageOf<wire::CounterEvents::TenMoreParams, std::int64_t,
                                       encodeCounterTenMoreEvent, decodeCounterTenMoreEvent>},
};

}  // namespace

const suture::rpc::Codec& counterCodec() {
  static constexpr suture::rpc::Codec kCodec{
      .schema = suture::rpc::schemaOf<wire::Counter>,
      .contract = capnp::typeId<wire::Counter>(),
      .subscriber = capnp::typeId<wire::CounterEvents>(),
      .commands = kCounterCommandCodecs,
      .events = kCounterEventCodecs,
      .row = suture::rpc::rowOf<wire::CounterEvents::StateParams, wire::CounterStateRow,
                                encodeCounterColumn, decodeCounterColumn>,
  };
  return kCodec;
}

}  // namespace counting
