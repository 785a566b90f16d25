// Written by suturec from pedals/operator_presence.h. Do not edit.
#include "pedals/operator_presence.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "pedals/operator_presence.capnp.h"

namespace robots {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Duration;
using suture::Errc;
using suture::EventInfo;
using suture::FieldPath;
using suture::checkSlot;
using suture::load;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::shifted;
using suture::rpc::toWire;
using suture::shiftSlot;
using suture::slotIn;
using suture::slotSize;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(Presence::present), bool>);
static_assert(std::is_same_v<decltype(Presence::stamp), std::chrono::steady_clock::time_point>);

}  // namespace

bool store(const Presence& value, PresenceSlot& slot) {
  bool fits = true;
  fits &= store(value.present, slot.present);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const PresenceSlot& slot, Presence& value) {
  load(slot.present, value.present);
  load(slot.stamp, value.stamp);
}

void shiftStamps(PresenceSlot& slot, Duration shift) { slot.stamp = shifted(slot.stamp, shift); }

// --- between slots and Cap'n Proto

void toWire(const PresenceSlot& slot, wire::Presence::Builder out) {
  out.setPresent(slot.present != 0);
  out.setStamp(slot.stamp);
}

Errc fromWire(wire::Presence::Reader in, PresenceSlot& slot, Duration shift) {
  slot.present = in.getPresent();
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  return Errc{};
}

bool isValid(const PresenceSlot&, FieldPath*) {
  return true;
}

namespace {

// --- OperatorPresence over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class OperatorPresenceSink final : public suture::rpc::EventSink {
 public:
  explicit OperatorPresenceSink(wire::OperatorPresenceEvents::Client subscriber) :
      subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(OperatorPresenceEvent::operator_present): {
        const auto& slot = slotIn<std::uint8_t>(payload);
        auto request = subscriber_.operatorPresentRequest();
        request.setValue(slot != 0);
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
      const auto& slot = slotIn<PresenceSlot>(columns[0]);
      toWire(slot, out.initPresence());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::OperatorPresenceEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class OperatorPresenceServant final : public wire::OperatorPresence::Server {
 public:
  explicit OperatorPresenceServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<OperatorPresenceSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> presence(PresenceContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<PresenceSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(OperatorPresenceCommand::presence), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- OperatorPresence over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class OperatorPresenceReceiver final : public wire::OperatorPresenceEvents::Server {
 public:
  explicit OperatorPresenceReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<PresenceSlot>(0);
      const Errc error =
          in.hasPresence() ? fromWire(in.getPresence(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> operatorPresent(OperatorPresentContext context) override {
    auto in = context.getParams();
    return port_->event<std::uint8_t>(numberOf(OperatorPresenceEvent::operator_present),
                                      [&](std::uint8_t& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class OperatorPresenceProxy final : public suture::rpc::Proxy {
 public:
  OperatorPresenceProxy(wire::OperatorPresence::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<OperatorPresenceReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<OperatorPresenceCommand>(record.command)) {
      case OperatorPresenceCommand::presence: {
        auto request = provider_.presenceRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PresenceSlot>(call, response.getStamp(), [&](PresenceSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::OperatorPresence::Client provider_;
  ProxyPort& port_;
};

class OperatorPresenceBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<OperatorPresenceServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<OperatorPresenceProxy>(contract.castAs<wire::OperatorPresence>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<OperatorPresenceSink>(subscriber.castAs<wire::OperatorPresenceEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::OperatorPresence>();
  }
};

const suture::rpc::Binding& operatorPresenceBinding() {
  static const OperatorPresenceBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kOperatorPresenceCommands[] = {
    {.name = "presence",
     .kind = CommandKind::Read,
     .resultSize = slotSize<PresenceSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<PresenceSlot, isValid>,
     .shiftResult = shiftSlot<PresenceSlot>},
};

constexpr EventInfo kOperatorPresenceEvents[] = {
    {.name = "operator_present",
     .payloadSize = slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true},
};

// The self-description, as in pedals/operator_presence.suture.json.
constexpr char kOperatorPresenceDescription[] = R"json(
{"name": "robots::OperatorPresence", "hash": "204d16d24012e4b5ccec084c08b6a398", "commands": [{
"name": "presence", "kind": "read", "ordinal": 1, "result": {"type": {"kind": "struct",
"name": "robots::Presence"}}, "queue": 16}], "events": [{"name": "operator_present",
"kind": "write", "ordinal": 1, "wire": "operatorPresent",
"doc": "Each change, and as it is now to whoever connects.", "payload": {"type": {"kind": "Bool"}},
"queue": 16, "latched": true}], "enums": [], "structs": [{"name": "robots::Presence",
"doc": "A head in the viewer. It counts for as long as it is fresh.", "fields": [{
"name": "present", "type": {"kind": "Bool"}, "default": false}, {"name": "stamp",
"doc": "The cycle that it was looked for in.", "type": {"kind": "time", "clock": "steady"}}]}],
"wire": [{"id": "@0x8946bef4362e465d", "kind": "interface", "name": "OperatorPresence",
"cxx": "robots::OperatorPresence", "members": [{"at": 0, "name": "subscribe", "parameters": [{
"at": 0, "name": "events", "is": "@0xd9df1a4d2e881c27"}, {"at": 1, "name": "eventMask",
"is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "presence",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xa9429a655b83829a"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}]}, {"id": "@0xd9df1a4d2e881c27", "kind": "interface",
"name": "OperatorPresenceEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0x970403e5511b6372"}]}, {"at": 1, "name": "operatorPresent", "parameters": [
{"at": 0, "name": "value", "is": "Bool"}]}]}, {"id": "@0x970403e5511b6372", "kind": "struct",
"name": "OperatorPresenceStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {
"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {
"at": 3, "name": "presence", "is": "@0xa9429a655b83829a"}]}, {"id": "@0xa9429a655b83829a",
"kind": "struct", "name": "Presence", "members": [{"at": 0, "name": "present", "is": "Bool"}, {
"at": 1, "name": "stamp", "is": "Int64 clock \"steady\""}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::OperatorPresence>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::OperatorPresence",
      .hash = "204d16d24012e4b5ccec084c08b6a398",
      .description = robots::kOperatorPresenceDescription,
      .commands = robots::kOperatorPresenceCommands,
      .events = robots::kOperatorPresenceEvents,
      .binding = &robots::operatorPresenceBinding,
  };
  return kInfo;
}

Errc Provided<robots::OperatorPresence>::execute(std::uint16_t command,
                                                 const std::byte* /*arguments*/,
                                                 std::byte* result) {
  using ::robots::OperatorPresenceCommand;
  switch (static_cast<OperatorPresenceCommand>(command)) {
    case OperatorPresenceCommand::presence: {
      auto& slot = newSlot<robots::PresenceSlot>(result);
      return store(implementation_.presence(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
