// Written by suturec from 01_counter/counter.h. Do not edit.
#include "01_counter/counter.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "01_counter/counter.capnp.h"

namespace counting {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Errc;
using suture::EventInfo;
using suture::newSlot;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::numberOf;
using suture::slotIn;
using suture::slotSize;
using suture::store;

bool store(const std::int32_t& amount, CounterAddArguments& slot) {
  return store(amount, slot.amount);
}

namespace {

// --- Counter over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class CounterSink final : public suture::rpc::EventSink {
 public:
  explicit CounterSink(wire::CounterEvents::Client subscriber) : subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(CounterEvent::ten_more): {
        const auto& slot = slotIn<std::int64_t>(payload);
        auto request = subscriber_.tenMoreRequest();
        request.setValue(slot);
        return request.send().ignoreResult();
      }
    }
    return kj::READY_NOW;
  }

  kj::Promise<void> row(const suture::rt::StateTable::Row& row,
                        std::span<const std::byte* const> columns) override {
    auto request = subscriber_.stateRequest();
    auto out = request.initRow();
    out.setStamp(suture::toNanoseconds(row.stamp));
    out.setEvaluated(row.valid | row.invalid);
    out.setTooLarge(row.tooLarge | row.invalid);
    if (row.hasValue(0)) {
      const auto& slot = slotIn<std::int64_t>(columns[0]);
      out.setValue(slot);
    }
    return request.send().ignoreResult();
  }

 private:
  wire::CounterEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class CounterServant final : public wire::Counter::Server {
 public:
  explicit CounterServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<CounterSink>(in.getEvents()), in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> add(AddContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<CounterAddArguments>(memory);
      slot.amount = in.getAmount();
      return Errc{};
    };
    return port_->command(numberOf(CounterCommand::add), in.getSent(), fill);
  }

  kj::Promise<void> value(ValueContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<std::int64_t>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(CounterCommand::value), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- Counter over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class CounterReceiver final : public wire::CounterEvents::Server {
 public:
  explicit CounterReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<std::int64_t>(0);
      slot = in.getValue();
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> tenMore(TenMoreContext context) override {
    auto in = context.getParams();
    return port_->event<std::int64_t>(numberOf(CounterEvent::ten_more), [&](std::int64_t& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class CounterProxy final : public suture::rpc::Proxy {
 public:
  CounterProxy(wire::Counter::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<CounterReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<CounterCommand>(record.command)) {
      case CounterCommand::add: {
        const auto& slot = slotIn<CounterAddArguments>(record.arguments());
        auto request = provider_.addRequest();
        request.setAmount(slot.amount);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case CounterCommand::value: {
        auto request = provider_.valueRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::int64_t>(call, response.getStamp(), [&](std::int64_t& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::Counter::Client provider_;
  ProxyPort& port_;
};

class CounterBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<CounterServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<CounterProxy>(contract.castAs<wire::Counter>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<CounterSink>(subscriber.castAs<wire::CounterEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::Counter>();
  }
};

const suture::rpc::Binding& counterBinding() {
  static const CounterBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kCounterCommands[] = {
    {.name = "add",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<CounterAddArguments>,
     .depth = 8},
    {.name = "value",
     .kind = CommandKind::Read,
     .resultSize = slotSize<std::int64_t>,
     .depth = 16,
     .column = 0},
};

constexpr EventInfo kCounterEvents[] = {
    {.name = "ten_more", .payloadSize = slotSize<std::int64_t>, .depth = 16},
};

// The self-description, as in 01_counter/counter.suture.json.
constexpr char kCounterDescription[] = R"json(
{"name": "counting::Counter", "hash": "38931bde09fe12583e55c15888548c0c", "commands": [{
"name": "add", "kind": "write", "ordinal": 1,
"doc": "Adds to the count. Runs in the provider's thread.", "parameters": [{"name": "amount",
"type": {"kind": "Int32"}}], "queue": 8}, {"name": "value", "kind": "read", "ordinal": 2,
"doc": "The newest count; never waits for anyone.", "result": {"type": {"kind": "Int64"}},
"queue": 16}], "events": [{"name": "ten_more", "kind": "write", "ordinal": 1, "wire": "tenMore",
"doc": "The count has passed a multiple of ten.", "payload": {"type": {"kind": "Int64"}},
"queue": 16}], "enums": [], "structs": [], "wire": [{"id": "@0xd6d42f0aed709948",
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
"at": 0, "name": "value", "is": "Int64"}]}]}, {"id": "@0xbfec877b65b98c5c", "kind": "struct",
"name": "CounterStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "value", "is": "Int64"}, {"at": 3,
"name": "tooLarge", "is": "UInt64"}]}]})json";

}  // namespace
}  // namespace counting

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<counting::Counter>() {
  static constexpr InterfaceInfo kInfo{
      .name = "counting::Counter",
      .hash = "38931bde09fe12583e55c15888548c0c",
      .description = counting::kCounterDescription,
      .commands = counting::kCounterCommands,
      .events = counting::kCounterEvents,
      .binding = &counting::counterBinding,
  };
  return kInfo;
}

Errc Provided<counting::Counter>::execute(std::uint16_t command, const std::byte* arguments,
                                          std::byte* result) {
  using ::counting::CounterCommand;
  switch (static_cast<CounterCommand>(command)) {
    case CounterCommand::add: {
      const auto& slot = slotIn<counting::CounterAddArguments>(arguments);
      load(slot.amount, scratch_.add_amount);
      implementation_.add(scratch_.add_amount);
      return Errc{};
    }
    case CounterCommand::value: {
      auto& slot = newSlot<std::int64_t>(result);
      return store(implementation_.value(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
