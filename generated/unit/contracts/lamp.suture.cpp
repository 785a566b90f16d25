// Written by suturec from unit/contracts/lamp.h. Do not edit.
#include "unit/contracts/lamp.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "unit/contracts/lamp.capnp.h"

// Defined in suture/standard/messages.suture.cpp.
namespace suture {
void toWire(const MessageSlot& slot, wire::Message::Builder out);
suture::Errc fromWire(wire::Message::Reader in, MessageSlot& slot, suture::Duration shift);
bool isValid(const MessageSlot& slot, suture::FieldPath* path);
}  // namespace suture

namespace contracts {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Errc;
using suture::newSlot;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::fromWire;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::slotIn;
using suture::slotSize;
using suture::store;

bool store(const bool& on, LampLightArguments& slot) { return store(on, slot.on); }

namespace {

// --- Lamp over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class LampSink final : public suture::rpc::EventSink {
 public:
  explicit LampSink(wire::LampEvents::Client subscriber) : subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(suture::MessagesEvent::status): {
        const auto& slot = slotIn<suture::MessageSlot>(payload);
        auto request = subscriber_.statusRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case numberOf(suture::MessagesEvent::warning): {
        const auto& slot = slotIn<suture::MessageSlot>(payload);
        auto request = subscriber_.warningRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case numberOf(suture::MessagesEvent::error): {
        const auto& slot = slotIn<suture::MessageSlot>(payload);
        auto request = subscriber_.errorRequest();
        toWire(slot, request.initValue());
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
      const auto& slot = slotIn<std::uint8_t>(columns[0]);
      out.setLit(slot != 0);
    }
    return request.send().ignoreResult();
  }

 private:
  wire::LampEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class LampServant final : public wire::Lamp::Server {
 public:
  explicit LampServant(kj::Own<ServantPort> port)
      : base_(suture::interfaceInfo<suture::Messages>().binding().makeServant(kj::addRef(*port))),
        port_(kj::mv(port)) {}

  DispatchCallResult dispatchCall(std::uint64_t contract, std::uint16_t method,
                                  suture::rpc::AnyCall call) override {
    if (contract != capnp::typeId<wire::Lamp>()) {
      return base_->dispatchCall(contract, method, call);
    }
    return wire::Lamp::Server::dispatchCall(contract, method, call);
  }

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<LampSink>(in.getEvents()), in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> light(LightContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<LampLightArguments>(memory);
      slot.on = in.getOn();
      return Errc{};
    };
    return port_->command(numberOf(LampCommand::light), in.getSent(), fill);
  }

  kj::Promise<void> lit(LitContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<std::uint8_t>(result);
      auto out = context.getResults();
      out.setValue(slot != 0);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(LampCommand::lit), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<capnp::Capability::Server> base_;
  kj::Own<ServantPort> port_;
};

// --- Lamp over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class LampReceiver final : public wire::LampEvents::Server {
 public:
  explicit LampReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<std::uint8_t>(0);
      slot = in.getLit();
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> status(StatusContext context) override {
    auto in = context.getParams();
    return port_->event<suture::MessageSlot>(numberOf(suture::MessagesEvent::status),
                                             [&](suture::MessageSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

  kj::Promise<void> warning(WarningContext context) override {
    auto in = context.getParams();
    return port_->event<suture::MessageSlot>(numberOf(suture::MessagesEvent::warning),
                                             [&](suture::MessageSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

  kj::Promise<void> error(ErrorContext context) override {
    auto in = context.getParams();
    return port_->event<suture::MessageSlot>(numberOf(suture::MessagesEvent::error),
                                             [&](suture::MessageSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class LampProxy final : public suture::rpc::Proxy {
 public:
  LampProxy(wire::Lamp::Client provider, ProxyPort& port)
      : base_(suture::interfaceInfo<suture::Messages>().binding().makeProxy(provider, port)),
        provider_(kj::mv(provider)),
        port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<LampReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<LampCommand>(record.command)) {
      case LampCommand::light: {
        const auto& slot = slotIn<LampLightArguments>(record.arguments());
        auto request = provider_.lightRequest();
        request.setOn(slot.on != 0);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case LampCommand::lit: {
        auto request = provider_.litRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::uint8_t>(call, response.getStamp(), [&](std::uint8_t& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
    }
    return base_->send(record);
  }

 private:
  kj::Own<suture::rpc::Proxy> base_;
  wire::Lamp::Client provider_;
  ProxyPort& port_;
};

class LampBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<LampServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<LampProxy>(contract.castAs<wire::Lamp>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<LampSink>(subscriber.castAs<wire::LampEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::Lamp>();
  }
};

const suture::rpc::Binding& lampBinding() {
  static const LampBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kLampCommands[] = {
    {.name = "light",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<LampLightArguments>,
     .depth = 16},
    {.name = "lit",
     .kind = CommandKind::Read,
     .resultSize = slotSize<std::uint8_t>,
     .depth = 16,
     .column = 0},
};

// The self-description, as in unit/contracts/lamp.suture.json.
constexpr char kLampDescription[] = R"json(
{"name": "contracts::Lamp", "hash": "01b08049b7531e674d0093087c2ac2b3", "base": "suture::Messages",
"commands": [{"name": "light", "kind": "write", "ordinal": 1, "parameters": [{"name": "on",
"type": {"kind": "Bool"}}], "queue": 16}, {"name": "lit", "kind": "read", "ordinal": 2, "result": {
"type": {"kind": "Bool"}}, "queue": 16}], "events": [{"name": "status", "kind": "write",
"ordinal": 1, "doc": "All is well; something has been done.", "payload": {"type": {
"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages"}, {"name": "warning", "kind": "write", "ordinal": 2,
"doc": "Something was refused, or is not as it should be; the component goes on.", "payload": {
"type": {"kind": "struct", "name": "suture::Message"}}, "queue": 16, "latched": true,
"from": "suture::Messages"}, {"name": "error", "kind": "write", "ordinal": 3,
"doc": "Something failed, and somebody should see to it.", "payload": {"type": {"kind": "struct",
"name": "suture::Message"}}, "queue": 16, "latched": true, "from": "suture::Messages"}],
"enums": [], "structs": [{"name": "suture::Message", "fields": [{"name": "text",
"doc": "UTF-8, for people. Those who send cut what is longer, and end it in \"...\" then.",
"type": {"kind": "text", "capacity": 255}}, {"name": "code",
"doc": "What it is about, by numbers that its sender documents; 0: nothing in particular.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "counter",
"doc": "Counts the messages of its sender, of all three kinds together, from 1: a gap says that the\nlistener has missed some, a number seen before that the last one has been told again.",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}]}], "wire": [{"id": "@0xd4cb2344bc7abacc", "kind": "interface", "name": "Lamp",
"cxx": "contracts::Lamp", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xd29be22d5548c1be"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "light", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "on", "is": "Bool"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "lit", "is": "kind \"read\"", "parameters": [{
"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Bool"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xb16d80f0d2b50980",
"kind": "interface", "name": "Messages", "cxx": "suture::Messages", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0xa02813b154cdd1d8"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}]}, {
"id": "@0xa02813b154cdd1d8", "kind": "interface", "name": "MessagesEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0x814f9864e019fa96"}]}, {"at": 1,
"name": "status", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}]}, {
"at": 2, "name": "warning", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}]
}, {"at": 3, "name": "error", "parameters": [{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"
}]}]}, {"id": "@0x814f9864e019fa96", "kind": "struct", "name": "MessagesStateRow", "members": [{
"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}]}, {"id": "@0xbd6bc34f74980c5d", "kind": "struct",
"name": "Message", "members": [{"at": 0, "name": "text", "is": "Text"}, {"at": 1, "name": "code",
"is": "UInt32"}, {"at": 2, "name": "counter", "is": "UInt32"}, {"at": 3, "name": "stamp",
"is": "Int64 clock \"steady\""}]}, {"id": "@0xd29be22d5548c1be", "kind": "interface",
"name": "LampEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row",
"is": "@0xc60e3f090bda1270"}]}, {"at": 1, "name": "status", "parameters": [{"at": 0,
"name": "value", "is": "@0xbd6bc34f74980c5d"}]}, {"at": 2, "name": "warning", "parameters": [{
"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}]}, {"at": 3, "name": "error", "parameters": [
{"at": 0, "name": "value", "is": "@0xbd6bc34f74980c5d"}]}]}, {"id": "@0xc60e3f090bda1270",
"kind": "struct", "name": "LampStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {
"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {
"at": 3, "name": "lit", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace contracts

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<contracts::Lamp>() {
  static const InterfaceInfo kInfo{
      .name = "contracts::Lamp",
      .hash = "01b08049b7531e674d0093087c2ac2b3",
      .description = contracts::kLampDescription,
      .commands = contracts::kLampCommands,
      .events = interfaceInfo<suture::Messages>().events,
      .binding = &contracts::lampBinding,
      .base = &interfaceInfo<suture::Messages>,
      .toBase = &castToBase<contracts::Lamp, suture::Messages>,
  };
  return kInfo;
}

Errc Provided<contracts::Lamp>::execute(std::uint16_t command, const std::byte* arguments,
                                        std::byte* result) {
  using ::contracts::LampCommand;
  switch (static_cast<LampCommand>(command)) {
    case LampCommand::light: {
      const auto& slot = slotIn<contracts::LampLightArguments>(arguments);
      load(slot.on, scratch_.light_on);
      implementation_.light(scratch_.light_on);
      return Errc{};
    }
    case LampCommand::lit: {
      auto& slot = newSlot<std::uint8_t>(result);
      return store(implementation_.lit(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Provided<suture::Messages>::execute(command, arguments, result);
}

}  // namespace suture
