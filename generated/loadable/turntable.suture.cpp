// Written by suturec from loadable/turntable.h. Do not edit.
#include "loadable/turntable.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "loadable/turntable.capnp.h"

namespace loadable {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Errc;
using suture::FieldPath;
using suture::checkSlot;
using suture::newSlot;
using suture::refusedAt;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::slotIn;
using suture::slotSize;
using suture::store;

bool store(const double& angle, TurntableTurnArguments& slot) { return store(angle, slot.angle); }

namespace {

bool acceptsTurntableTurn(const TurntableTurnArguments& slot, FieldPath* path) {
  return isValid(slot.angle) || refusedAt(path, "angle");
}

bool acceptsTurntableAngleResult(const double& slot, FieldPath*) { return isValid(slot); }

// --- Turntable over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class TurntableSink final : public suture::rpc::EventSink {
 public:
  explicit TurntableSink(wire::TurntableEvents::Client subscriber) :
      subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t, const std::byte*) override { return kj::READY_NOW; }

  kj::Promise<void> row(const suture::rt::StateTable::Row& row,
                        std::span<const std::byte* const> columns) override {
    auto request = subscriber_.stateRequest();
    auto out = request.initRow();
    out.setStamp(suture::toNanoseconds(row.stamp));
    out.setEvaluated(row.valid | row.invalid);
    out.setTooLarge(row.tooLarge | row.invalid);
    if (row.hasValue(0)) {
      const auto& slot = slotIn<double>(columns[0]);
      out.setAngle(slot);
    }
    return request.send().ignoreResult();
  }

 private:
  wire::TurntableEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class TurntableServant final : public wire::Turntable::Server {
 public:
  explicit TurntableServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<TurntableSink>(in.getEvents()), in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> turn(TurnContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<TurntableTurnArguments>(memory);
      slot.angle = in.getAngle();
      return Errc{};
    };
    return port_->command(numberOf(TurntableCommand::turn), in.getSent(), fill);
  }

  kj::Promise<void> angle(AngleContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(TurntableCommand::angle), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- Turntable over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class TurntableReceiver final : public wire::TurntableEvents::Server {
 public:
  explicit TurntableReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<double>(0);
      slot = in.getAngle();
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class TurntableProxy final : public suture::rpc::Proxy {
 public:
  TurntableProxy(wire::Turntable::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<TurntableReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<TurntableCommand>(record.command)) {
      case TurntableCommand::turn: {
        const auto& slot = slotIn<TurntableTurnArguments>(record.arguments());
        auto request = provider_.turnRequest();
        request.setAngle(slot.angle);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case TurntableCommand::angle: {
        auto request = provider_.angleRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, response.getStamp(), [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::Turntable::Client provider_;
  ProxyPort& port_;
};

class TurntableBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<TurntableServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<TurntableProxy>(contract.castAs<wire::Turntable>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<TurntableSink>(subscriber.castAs<wire::TurntableEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::Turntable>();
  }
};

const suture::rpc::Binding& turntableBinding() {
  static const TurntableBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kTurntableCommands[] = {
    {.name = "turn",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<TurntableTurnArguments>,
     .depth = 16,
     .accepts = checkSlot<TurntableTurnArguments, acceptsTurntableTurn>},
    {.name = "angle",
     .kind = CommandKind::Read,
     .resultSize = slotSize<double>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<double, acceptsTurntableAngleResult>},
};

// The self-description, as in loadable/turntable.suture.json.
constexpr char kTurntableDescription[] = R"json(
{"name": "loadable::Turntable", "hash": "1c89821b895e377a0e23c36f654949b9", "commands": [{
"name": "turn", "kind": "write", "ordinal": 1, "parameters": [{"name": "angle", "type": {
"kind": "Float64"}, "unit": "rad"}], "queue": 16}, {"name": "angle", "kind": "read", "ordinal": 2,
"result": {"type": {"kind": "Float64"}}, "queue": 16}], "events": [], "enums": [], "structs": [],
"wire": [{"id": "@0xcb8648112327d0b9", "kind": "interface", "name": "Turntable",
"cxx": "loadable::Turntable", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xbe9023e02a0b50c9"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "turn", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "angle", "is": "Float64 unit \"rad\""}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "angle", "is": "kind \"read\"", "parameters": [
{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xbe9023e02a0b50c9",
"kind": "interface", "name": "TurntableEvents", "members": [{"at": 0, "name": "state",
"parameters": [{"at": 0, "name": "row", "is": "@0xce3772f691497d20"}]}]}, {
"id": "@0xce3772f691497d20", "kind": "struct", "name": "TurntableStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "angle", "is": "Float64"}]}]})json";

}  // namespace
}  // namespace loadable

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<loadable::Turntable>() {
  static constexpr InterfaceInfo kInfo{
      .name = "loadable::Turntable",
      .hash = "1c89821b895e377a0e23c36f654949b9",
      .description = loadable::kTurntableDescription,
      .commands = loadable::kTurntableCommands,
      .events = {},
      .binding = &loadable::turntableBinding,
  };
  return kInfo;
}

Errc Provided<loadable::Turntable>::execute(std::uint16_t command, const std::byte* arguments,
                                            std::byte* result) {
  using ::loadable::TurntableCommand;
  switch (static_cast<TurntableCommand>(command)) {
    case TurntableCommand::turn: {
      const auto& slot = slotIn<loadable::TurntableTurnArguments>(arguments);
      load(slot.angle, scratch_.turn_angle);
      implementation_.turn(scratch_.turn_angle);
      return Errc{};
    }
    case TurntableCommand::angle: {
      auto& slot = newSlot<double>(result);
      return store(implementation_.angle(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
