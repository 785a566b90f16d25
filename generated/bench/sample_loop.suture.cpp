// Written by suturec from bench/sample_loop.h. Do not edit.
#include "bench/sample_loop.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "bench/sample_loop.capnp.h"

// Defined in robot_types/pose.suture.cpp.
namespace robots {
void toWire(const PoseSampleSlot& slot, wire::PoseSample::Builder out);
suture::Errc fromWire(wire::PoseSample::Reader in, PoseSampleSlot& slot, suture::Duration shift);
bool isValid(const PoseSampleSlot& slot, suture::FieldPath* path);
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

bool store(const robots::PoseSample& value, SampleServerPutArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(SampleServerPutArguments& slot, Duration shift) { shiftStamps(slot.value, shift); }

bool store(const robots::PoseSample& value, SampleServerBounceArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(SampleServerBounceArguments& slot, Duration shift) {
  shiftStamps(slot.value, shift);
}

namespace {

bool acceptsSampleServerPut(const SampleServerPutArguments& slot, FieldPath* path) {
  return isValid(slot.value, path) || refusedAt(path, "value");
}

bool acceptsSampleServerBounce(const SampleServerBounceArguments& slot, FieldPath* path) {
  return isValid(slot.value, path) || refusedAt(path, "value");
}

// --- SampleServer over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class SampleServerSink final : public suture::rpc::EventSink {
 public:
  explicit SampleServerSink(wire::SampleServerEvents::Client subscriber) :
      subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(SampleServerEvent::echo): {
        const auto& slot = slotIn<robots::PoseSampleSlot>(payload);
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
      const auto& slot = slotIn<robots::PoseSampleSlot>(columns[0]);
      toWire(slot, out.initValue());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::SampleServerEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class SampleServerServant final : public wire::SampleServer::Server {
 public:
  explicit SampleServerServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<SampleServerSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> put(PutContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<SampleServerPutArguments>(memory);
      return in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(SampleServerCommand::put), in.getSent(), fill);
  }

  kj::Promise<void> bounce(BounceContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<SampleServerBounceArguments>(memory);
      return in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(SampleServerCommand::bounce), in.getSent(), fill);
  }

  kj::Promise<void> value(ValueContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<robots::PoseSampleSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(SampleServerCommand::value), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- SampleServer over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class SampleServerReceiver final : public wire::SampleServerEvents::Server {
 public:
  explicit SampleServerReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<robots::PoseSampleSlot>(0);
      const Errc error =
          in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> echo(EchoContext context) override {
    auto in = context.getParams();
    return port_->event<robots::PoseSampleSlot>(numberOf(SampleServerEvent::echo),
                                                [&](robots::PoseSampleSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class SampleServerProxy final : public suture::rpc::Proxy {
 public:
  SampleServerProxy(wire::SampleServer::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<SampleServerReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<SampleServerCommand>(record.command)) {
      case SampleServerCommand::put: {
        const auto& slot = slotIn<SampleServerPutArguments>(record.arguments());
        auto request = provider_.putRequest();
        toWire(slot.value, request.initValue());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case SampleServerCommand::bounce: {
        const auto& slot = slotIn<SampleServerBounceArguments>(record.arguments());
        auto request = provider_.bounceRequest();
        toWire(slot.value, request.initValue());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case SampleServerCommand::value: {
        auto request = provider_.valueRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<robots::PoseSampleSlot>(call, response.getStamp(),
                                               [&](robots::PoseSampleSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::SampleServer::Client provider_;
  ProxyPort& port_;
};

class SampleServerBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<SampleServerServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<SampleServerProxy>(contract.castAs<wire::SampleServer>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<SampleServerSink>(subscriber.castAs<wire::SampleServerEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::SampleServer>();
  }
};

const suture::rpc::Binding& sampleServerBinding() {
  static const SampleServerBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kSampleServerCommands[] = {
    {.name = "put",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<SampleServerPutArguments>,
     .depth = 4096,
     .accepts = checkSlot<SampleServerPutArguments, acceptsSampleServerPut>,
     .shiftArguments = shiftSlot<SampleServerPutArguments>},
    {.name = "bounce",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<SampleServerBounceArguments>,
     .depth = 16,
     .accepts = checkSlot<SampleServerBounceArguments, acceptsSampleServerBounce>,
     .shiftArguments = shiftSlot<SampleServerBounceArguments>},
    {.name = "value",
     .kind = CommandKind::Read,
     .resultSize = slotSize<robots::PoseSampleSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<robots::PoseSampleSlot, robots::isValid>,
     .shiftResult = shiftSlot<robots::PoseSampleSlot>},
};

constexpr EventInfo kSampleServerEvents[] = {
    {.name = "echo",
     .payloadSize = slotSize<robots::PoseSampleSlot>,
     .depth = 16,
     .accepts = checkSlot<robots::PoseSampleSlot, robots::isValid>,
     .shiftPayload = shiftSlot<robots::PoseSampleSlot>},
};

// The self-description, as in bench/sample_loop.suture.json.
constexpr char kSampleServerDescription[] = R"json(
{"name": "bench::SampleServer", "hash": "fc81c3d6983bed150e4b6eeb178f075c", "commands": [{
"name": "put", "kind": "write", "ordinal": 1, "doc": "Counted by the provider.", "parameters": [{
"name": "value", "type": {"kind": "struct", "name": "robots::PoseSample"}}], "queue": 4096}, {
"name": "bounce", "kind": "write", "ordinal": 2,
"doc": "Client, server, client: sends the value back as the event echo.", "parameters": [{
"name": "value", "type": {"kind": "struct", "name": "robots::PoseSample"}}], "queue": 16}, {
"name": "value", "kind": "read", "ordinal": 3, "result": {"type": {"kind": "struct",
"name": "robots::PoseSample"}}, "queue": 16}], "events": [{"name": "echo", "kind": "write",
"ordinal": 1, "doc": "The value that bounce() took.", "payload": {"type": {"kind": "struct",
"name": "robots::PoseSample"}}, "queue": 16}], "enums": [], "structs": [{
"name": "robots::PoseSample", "doc": "The pose of the latency figures: 120 bytes and no strings.",
"fields": [{"name": "rotation", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 3}}, {"name": "position", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "m"}, {"name": "stamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "sequence", "type": {"kind": "UInt64"}, "default": 0}, {"name": "flags", "type": {
"kind": "UInt64"}, "default": 0}]}], "wire": [{"id": "@0xa9d747a8e40c3d30", "kind": "interface",
"name": "SampleServer", "cxx": "bench::SampleServer", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xc71bdb510deae77a"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "put", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "@0x9dcf31510b46998d"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 2, "name": "bounce", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "@0x9dcf31510b46998d"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 3, "name": "value", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0x9dcf31510b46998d"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xc71bdb510deae77a", "kind": "interface",
"name": "SampleServerEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xb757a2bfdbcd1cf8"}]}, {"at": 1, "name": "echo", "parameters": [{"at": 0,
"name": "value", "is": "@0x9dcf31510b46998d"}]}]}, {"id": "@0xb757a2bfdbcd1cf8", "kind": "struct",
"name": "SampleServerStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "value", "is": "@0x9dcf31510b46998d"}]}, {"id": "@0x9dcf31510b46998d", "kind": "struct",
"name": "PoseSample", "members": [{"at": 0, "name": "rotation", "is": "/suture/types.capnp:Mat3"}, {
"at": 1, "name": "position", "is": "/suture/types.capnp:Vec3 unit \"m\""}, {"at": 2,
"name": "stamp", "is": "Int64 clock \"steady\""}, {"at": 3, "name": "sequence", "is": "UInt64"}, {
"at": 4, "name": "flags", "is": "UInt64"}]}]})json";

}  // namespace
}  // namespace bench

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<bench::SampleServer>() {
  static constexpr InterfaceInfo kInfo{
      .name = "bench::SampleServer",
      .hash = "fc81c3d6983bed150e4b6eeb178f075c",
      .description = bench::kSampleServerDescription,
      .commands = bench::kSampleServerCommands,
      .events = bench::kSampleServerEvents,
      .binding = &bench::sampleServerBinding,
  };
  return kInfo;
}

Errc Provided<bench::SampleServer>::execute(std::uint16_t command, const std::byte* arguments,
                                            std::byte* result) {
  using ::bench::SampleServerCommand;
  switch (static_cast<SampleServerCommand>(command)) {
    case SampleServerCommand::put: {
      const auto& slot = slotIn<bench::SampleServerPutArguments>(arguments);
      load(slot.value, scratch_.put_value);
      implementation_.put(scratch_.put_value);
      return Errc{};
    }
    case SampleServerCommand::bounce: {
      const auto& slot = slotIn<bench::SampleServerBounceArguments>(arguments);
      load(slot.value, scratch_.bounce_value);
      implementation_.bounce(scratch_.bounce_value);
      return Errc{};
    }
    case SampleServerCommand::value: {
      auto& slot = newSlot<robots::PoseSampleSlot>(result);
      return store(implementation_.value(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
