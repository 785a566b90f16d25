// Written by suturec from unit/shm/logbook.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "unit/shm/logbook.capnp.h"
#include "unit/shm/logbook.suture.h"

namespace logs {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- Counter as Cap'n Proto

namespace {

void encodeCounterCount(const CounterCountArguments& slot,
                        wire::Counter::CountParams::Builder out) {
  out.setEntries(slot.entries);
}
suture::Errc decodeCounterCount(wire::Counter::CountParams::Reader in, CounterCountArguments& slot,
                                suture::Duration) {
  slot.entries = in.getEntries();
  return suture::Errc{};
}

void encodeCounterEntriesResult(const std::int32_t& slot,
                                wire::Counter::EntriesResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeCounterEntriesResult(wire::Counter::EntriesResults::Reader in,
                                        std::int32_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeCounterEntriesColumn(const std::int32_t& slot, wire::CounterStateRow::Builder out) {
  out.setEntries(slot);
}
suture::Errc decodeCounterEntriesColumn(wire::CounterStateRow::Reader in, std::int32_t& slot,
                                        suture::Duration) {
  slot = in.getEntries();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeCounterColumn(unsigned column, const std::byte* memory,
                         wire::CounterStateRow::Builder out) {
  switch (column) {
    case CounterColumn::entries:
      return encodeCounterEntriesColumn(suture::slotIn<std::int32_t>(memory), out);
  }
}
suture::Errc decodeCounterColumn(wire::CounterStateRow::Reader in, unsigned column,
                                 std::byte* memory, suture::Duration shift) {
  switch (column) {
    case CounterColumn::entries:
      return decodeCounterEntriesColumn(in, suture::newSlot<std::int32_t>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kCounterCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Counter>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Counter::CountParams>,
     .arguments = suture::codec::messageOf<wire::Counter::CountParams, CounterCountArguments,
                                           encodeCounterCount, decodeCounterCount>},
    {.interface = capnp::typeId<wire::Counter>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Counter::EntriesParams>,
     .result = suture::codec::messageOf<wire::Counter::EntriesResults, std::int32_t,
                                        encodeCounterEntriesResult, decodeCounterEntriesResult>,
     .stamp = suture::codec::stampIn<wire::Counter::EntriesResults>},
};

}  // namespace

const suture::codec::Codec& counterCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Counter>,
      .contract = capnp::typeId<wire::Counter>(),
      .subscriber = capnp::typeId<wire::CounterEvents>(),
      .commands = kCounterCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::CounterEvents::StateParams, wire::CounterStateRow,
                                  encodeCounterColumn, decodeCounterColumn>,
  };
  return kCodec;
}

// --- Logbook as Cap'n Proto

namespace {

void encodeLogbookTextResult(const suture::OpenText& slot,
                             wire::Logbook::TextResults::Builder out) {
  toWire(slot, out.initValue(sizeOf(slot)));
}
suture::Errc decodeLogbookTextResult(wire::Logbook::TextResults::Reader in, suture::OpenText& slot,
                                     suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeLogbookEntriesColumn(const std::int32_t& slot, wire::LogbookStateRow::Builder out) {
  out.setEntries(slot);
}
suture::Errc decodeLogbookEntriesColumn(wire::LogbookStateRow::Reader in, std::int32_t& slot,
                                        suture::Duration) {
  slot = in.getEntries();
  return suture::Errc{};
}

void encodeLogbookTextColumn(const suture::OpenText& slot, wire::LogbookStateRow::Builder out) {
  toWire(slot, out.initText(sizeOf(slot)));
}
suture::Errc decodeLogbookTextColumn(wire::LogbookStateRow::Reader in, suture::OpenText& slot,
                                     suture::Duration) {
  return fromWire(in.getText(), slot);
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeLogbookColumn(unsigned column, const std::byte* memory,
                         wire::LogbookStateRow::Builder out) {
  switch (column) {
    case LogbookColumn::entries:
      return encodeLogbookEntriesColumn(suture::slotIn<std::int32_t>(memory), out);
    case LogbookColumn::text:
      return encodeLogbookTextColumn(suture::slotIn<suture::OpenText>(memory), out);
  }
}
suture::Errc decodeLogbookColumn(wire::LogbookStateRow::Reader in, unsigned column,
                                 std::byte* memory, suture::Duration shift) {
  switch (column) {
    case LogbookColumn::entries:
      return decodeLogbookEntriesColumn(in, suture::newSlot<std::int32_t>(memory), shift);
    case LogbookColumn::text:
      return decodeLogbookTextColumn(in, suture::newSlot<suture::OpenText>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kLogbookCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Logbook>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Logbook::TextParams>,
     .result = suture::codec::messageOf<wire::Logbook::TextResults, suture::OpenText,
                                        encodeLogbookTextResult, decodeLogbookTextResult>,
     .stamp = suture::codec::stampIn<wire::Logbook::TextResults>},
};

}  // namespace

const suture::codec::Codec& logbookCodec() {
  static const auto kCommands = suture::extended<3>(
      suture::interfaceInfo<logs::Counter>().codec().commands, kLogbookCommandCodecs);
  static const suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Logbook>,
      .contract = capnp::typeId<wire::Logbook>(),
      .subscriber = capnp::typeId<wire::LogbookEvents>(),
      .commands = kCommands,
      .events = {},
      .row = suture::codec::rowOf<wire::LogbookEvents::StateParams, wire::LogbookStateRow,
                                  encodeLogbookColumn, decodeLogbookColumn>,
  };
  return kCodec;
}

}  // namespace logs
