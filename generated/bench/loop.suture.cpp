// Written by suturec from bench/loop.h. Do not edit.
#include "bench/loop.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "bench/loop.capnp.h"

// Defined in robot_types/pose.suture.cpp.
namespace robots {
void toWire(const PosePrmSlot& slot, wire::PosePrm::Builder out);
suture::Errc fromWire(wire::PosePrm::Reader in, PosePrmSlot& slot, suture::Duration shift);
bool isValid(const PosePrmSlot& slot, suture::FieldPath* path);
}  // namespace robots

namespace bench {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Duration;
using suture::Errc;
using suture::EventInfo;
using suture::FieldPath;
using suture::checkSlot;
using suture::newSlot;
using suture::refusedAt;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::shiftSlot;
using suture::slotIn;
using suture::slotSize;
using suture::store;

bool store(const robots::PosePrm& value, LoopServerPutArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(LoopServerPutArguments& slot, Duration shift) { shiftStamps(slot.value, shift); }

bool store(const robots::PosePrm& value, LoopServerBounceArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(LoopServerBounceArguments& slot, Duration shift) {
  shiftStamps(slot.value, shift);
}

namespace {

bool acceptsLoopServerPut(const LoopServerPutArguments& slot, FieldPath* path) {
  return isValid(slot.value, path) || refusedAt(path, "value");
}

bool acceptsLoopServerBounce(const LoopServerBounceArguments& slot, FieldPath* path) {
  return isValid(slot.value, path) || refusedAt(path, "value");
}

// --- LoopServer over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class LoopServerSink final : public suture::rpc::EventSink {
 public:
  explicit LoopServerSink(wire::LoopServerEvents::Client subscriber) :
      subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(LoopServerEvent::echo): {
        const auto& slot = slotIn<robots::PosePrmSlot>(payload);
        auto request = subscriber_.echoRequest();
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
      const auto& slot = slotIn<robots::PosePrmSlot>(columns[0]);
      toWire(slot, out.initValue());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::LoopServerEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class LoopServerServant final : public wire::LoopServer::Server {
 public:
  explicit LoopServerServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<LoopServerSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> put(PutContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<LoopServerPutArguments>(memory);
      return in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(LoopServerCommand::put), in.getSent(), fill);
  }

  kj::Promise<void> bounce(BounceContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<LoopServerBounceArguments>(memory);
      return in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(LoopServerCommand::bounce), in.getSent(), fill);
  }

  kj::Promise<void> value(ValueContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<robots::PosePrmSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(LoopServerCommand::value), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- LoopServer over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class LoopServerReceiver final : public wire::LoopServerEvents::Server {
 public:
  explicit LoopServerReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<robots::PosePrmSlot>(0);
      const Errc error =
          in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> echo(EchoContext context) override {
    auto in = context.getParams();
    return port_->event<robots::PosePrmSlot>(numberOf(LoopServerEvent::echo),
                                             [&](robots::PosePrmSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class LoopServerProxy final : public suture::rpc::Proxy {
 public:
  LoopServerProxy(wire::LoopServer::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<LoopServerReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<LoopServerCommand>(record.command)) {
      case LoopServerCommand::put: {
        const auto& slot = slotIn<LoopServerPutArguments>(record.arguments());
        auto request = provider_.putRequest();
        toWire(slot.value, request.initValue());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case LoopServerCommand::bounce: {
        const auto& slot = slotIn<LoopServerBounceArguments>(record.arguments());
        auto request = provider_.bounceRequest();
        toWire(slot.value, request.initValue());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case LoopServerCommand::value: {
        auto request = provider_.valueRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<robots::PosePrmSlot>(call, response.getStamp(),
                                            [&](robots::PosePrmSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::LoopServer::Client provider_;
  ProxyPort& port_;
};

class LoopServerBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<LoopServerServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<LoopServerProxy>(contract.castAs<wire::LoopServer>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<LoopServerSink>(subscriber.castAs<wire::LoopServerEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::LoopServer>();
  }
};

const suture::rpc::Binding& loopServerBinding() {
  static const LoopServerBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kLoopServerCommands[] = {
    {.name = "put",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<LoopServerPutArguments>,
     .depth = 16,
     .accepts = checkSlot<LoopServerPutArguments, acceptsLoopServerPut>,
     .shiftArguments = shiftSlot<LoopServerPutArguments>},
    {.name = "bounce",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<LoopServerBounceArguments>,
     .depth = 16,
     .accepts = checkSlot<LoopServerBounceArguments, acceptsLoopServerBounce>,
     .shiftArguments = shiftSlot<LoopServerBounceArguments>},
    {.name = "value",
     .kind = CommandKind::Read,
     .resultSize = slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftResult = shiftSlot<robots::PosePrmSlot>},
};

constexpr EventInfo kLoopServerEvents[] = {
    {.name = "echo",
     .payloadSize = slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .accepts = checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftPayload = shiftSlot<robots::PosePrmSlot>},
};

// The self-description, as in bench/loop.suture.json.
constexpr char kLoopServerDescription[] = R"json(
{"name": "bench::LoopServer", "doc": "What the server of a loop offers.",
"hash": "39cfa04c06187358856f788402400ce7", "commands": [{"name": "put", "kind": "write",
"ordinal": 1,
"doc": "Server, client, server: takes back what value() answered and measures how long it was away.",
"parameters": [{"name": "value", "type": {"kind": "struct", "name": "robots::PosePrm"}}],
"queue": 16}, {"name": "bounce", "kind": "write", "ordinal": 2,
"doc": "Client, server, client: sends the value back as the event echo.", "parameters": [{
"name": "value", "type": {"kind": "struct", "name": "robots::PosePrm"}}], "queue": 16}, {
"name": "value", "kind": "read", "ordinal": 3, "doc": "A pose, stamped when it is evaluated.",
"result": {"type": {"kind": "struct", "name": "robots::PosePrm"}}, "queue": 16}], "events": [{
"name": "echo", "kind": "write", "ordinal": 1, "doc": "The value that bounce() took.", "payload": {
"type": {"kind": "struct", "name": "robots::PosePrm"}}, "queue": 16}], "enums": [], "structs": [{
"name": "robots::PosePrm",
"doc": "The fields of the cisst libraries' prmPositionCartesianGet, the type of the paper's\nmeasurements.",
"fields": [{"name": "timestamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "automatic_timestamp", "wire": "automaticTimestamp",
"doc": "Whether the provider stamps the data itself.", "type": {"kind": "Bool"}, "default": true}, {
"name": "valid", "type": {"kind": "Bool"}, "default": false}, {"name": "moving_frame",
"wire": "movingFrame", "type": {"kind": "text", "capacity": 15}}, {"name": "reference_frame",
"wire": "referenceFrame", "type": {"kind": "text", "capacity": 15}}, {"name": "position",
"doc": "The moving frame in the reference frame.", "type": {"kind": "isometry", "scalar": "Float64"
}, "unit": "m"}]}], "wire": [{"id": "@0xf31a590efb54d189", "kind": "interface",
"name": "LoopServer", "cxx": "bench::LoopServer", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xa1763febd61d7208"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "put", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "@0xedd17c97b8723561"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 2, "name": "bounce", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "@0xedd17c97b8723561"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 3, "name": "value", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xedd17c97b8723561"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xa1763febd61d7208", "kind": "interface",
"name": "LoopServerEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xcf8261ed0f1fe7b7"}]}, {"at": 1, "name": "echo", "parameters": [{"at": 0,
"name": "value", "is": "@0xedd17c97b8723561"}]}]}, {"id": "@0xcf8261ed0f1fe7b7", "kind": "struct",
"name": "LoopServerStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "value", "is": "@0xedd17c97b8723561"}, {
"at": 3, "name": "tooLarge", "is": "UInt64"}]}, {"id": "@0xedd17c97b8723561", "kind": "struct",
"name": "PosePrm", "members": [{"at": 0, "name": "timestamp", "is": "Int64 clock \"steady\""}, {
"at": 1, "name": "automaticTimestamp", "is": "Bool = true"}, {"at": 2, "name": "valid", "is": "Bool"
}, {"at": 3, "name": "movingFrame", "is": "Text"}, {"at": 4, "name": "referenceFrame", "is": "Text"
}, {"at": 5, "name": "position", "is": "/suture/types.capnp:Pose unit \"m\""}]}]})json";

}  // namespace
}  // namespace bench

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<bench::LoopServer>() {
  static constexpr InterfaceInfo kInfo{
      .name = "bench::LoopServer",
      .hash = "39cfa04c06187358856f788402400ce7",
      .description = bench::kLoopServerDescription,
      .commands = bench::kLoopServerCommands,
      .events = bench::kLoopServerEvents,
      .binding = &bench::loopServerBinding,
  };
  return kInfo;
}

auto Provided<bench::LoopServer>::Scratch::reserved() -> Scratch {
  Scratch scratch{};
  reserveFor<decltype(bench::LoopServerPutArguments::value)>(scratch.put_value);
  reserveFor<decltype(bench::LoopServerBounceArguments::value)>(scratch.bounce_value);
  return scratch;
}

Errc Provided<bench::LoopServer>::execute(std::uint16_t command, const std::byte* arguments,
                                          std::byte* result) {
  using ::bench::LoopServerCommand;
  switch (static_cast<LoopServerCommand>(command)) {
    case LoopServerCommand::put: {
      const auto& slot = slotIn<bench::LoopServerPutArguments>(arguments);
      load(slot.value, scratch_.put_value);
      implementation_.put(scratch_.put_value);
      return Errc{};
    }
    case LoopServerCommand::bounce: {
      const auto& slot = slotIn<bench::LoopServerBounceArguments>(arguments);
      load(slot.value, scratch_.bounce_value);
      implementation_.bounce(scratch_.bounce_value);
      return Errc{};
    }
    case LoopServerCommand::value: {
      auto& slot = newSlot<robots::PosePrmSlot>(result);
      return store(implementation_.value(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
