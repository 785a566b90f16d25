// Written by suturec from 01_counter/counter.h. Do not edit.
#include "01_counter/counter.suture.h"

#include <suture/wire/codec.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "01_counter/counter.capnp.h"

namespace counting {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

bool store(const std::int32_t& amount, CounterAddArguments& slot) {
  return store(amount, slot.amount);
}

namespace {

// --- Counter as Cap'n Proto

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
  switch (static_cast<CounterColumn>(column)) {
    case CounterColumn::value:
      return encodeCounterValueColumn(suture::slotIn<std::int64_t>(memory), out);
  }
}
suture::Errc decodeCounterColumn(wire::CounterStateRow::Reader in, unsigned column,
                                 std::byte* memory, suture::Duration shift) {
  switch (static_cast<CounterColumn>(column)) {
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

constexpr suture::CommandInfo kCounterCommands[] = {
    {.name = "add",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<CounterAddArguments>,
     .depth = 8},
    {.name = "value",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::int64_t>,
     .depth = 16,
     .column = static_cast<int>(CounterColumn::value)},
};

constexpr suture::EventInfo kCounterEvents[] = {
    {.name = "ten_more", .payloadSize = suture::slotSize<std::int64_t>, .depth = 16},
};

// The self-description, as in 01_counter/counter.suture.json.
constexpr char kCounterDescription[] = R"json(
{"name": "counting::Counter", "hash": "d0b9cec53f4001af7aba4e29b891fbe9", "commands": [{
"name": "add", "kind": "write", "ordinal": 1, "doc": "Adds to the count, in the provider's thread.",
"parameters": [{"name": "amount", "type": {"kind": "Int32"}}], "queue": 8}, {"name": "value",
"kind": "read", "ordinal": 2, "doc": "Returns the newest count; never waits for anyone.",
"result": {"type": {"kind": "Int64"}}, "queue": 16}], "events": [{"name": "ten_more",
"kind": "write", "ordinal": 1, "wire": "tenMore",
"doc": "Reports that the count has passed a multiple of ten.", "payload": {"type": {"kind": "Int64"
}}, "queue": 16}], "enums": [], "structs": [], "wire": [{"id": "@0xd6d42f0aed709948",
"kind": "interface", "name": "Counter", "cxx": "counting::Counter", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0xab8aa54e33362c79"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {
"at": 1, "name": "add", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "amount",
"is": "Int32"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 2,
"name": "value", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Int64"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}]}, {"id": "@0xab8aa54e33362c79", "kind": "interface",
"name": "CounterEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xbfec877b65b98c5c"}]}, {"at": 1, "name": "tenMore", "parameters": [{
"at": 0, "name": "value", "is": "Int64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xbfec877b65b98c5c", "kind": "struct", "name": "CounterStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "value", "is": "Int64"}, {"at": 3, "name": "tooLarge", "is": "UInt64"}]}]})json";

}  // namespace
}  // namespace counting

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<counting::Counter>() {
  static constexpr InterfaceInfo kInfo{
      .name = "counting::Counter",
      .hash = "d0b9cec53f4001af7aba4e29b891fbe9",
      .description = counting::kCounterDescription,
      .commands = counting::kCounterCommands,
      .events = counting::kCounterEvents,
      .codec = &counting::counterCodec,
  };
  return kInfo;
}

// A function for each command of counting::Counter, so that a stack in a debugger names it.
struct Provided<counting::Counter>::Dispatch {
  static Errc execute_add(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<counting::CounterAddArguments>(arguments);
    load(slot.amount, scratch.add_amount);
    implementation.add(scratch.add_amount);
    return Errc{};
  }

  static Errc execute_value(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::int64_t>(result);
    return store(implementation.value(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<counting::Counter>::execute(std::uint16_t command, const std::byte* arguments,
                                          std::byte* result) {
  using ::counting::CounterCommand;
  switch (static_cast<CounterCommand>(command)) {
    case CounterCommand::add: return Dispatch::execute_add(implementation_, scratch_, arguments);
    case CounterCommand::value: return Dispatch::execute_value(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
