// Written by suturec from drives/gripper_hand.h. Do not edit.
#include "drives/gripper_hand.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "drives/gripper_hand.capnp.h"

namespace robots {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Duration;
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

bool store(const double& angle, GripperHandSqueezeArguments& slot) {
  return store(angle, slot.angle);
}

namespace {

bool acceptsGripperHandSqueeze(const GripperHandSqueezeArguments& slot, FieldPath* path) {
  return isValid(slot.angle) || refusedAt(path, "angle");
}

// --- GripperHand over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class GripperHandSink final : public suture::rpc::EventSink {
 public:
  explicit GripperHandSink(wire::GripperHandEvents::Client subscriber) :
      subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t, const std::byte*) override { return kj::READY_NOW; }

  kj::Promise<void> row(const suture::rt::StateTable::Row& row,
                        std::span<const std::byte* const>) override {
    auto request = subscriber_.stateRequest();
    auto out = request.initRow();
    out.setStamp(suture::toNanoseconds(row.stamp));
    out.setEvaluated(row.valid | row.invalid);
    out.setTooLarge(row.tooLarge | row.invalid);
    return request.send().ignoreResult();
  }

 private:
  wire::GripperHandEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class GripperHandServant final : public wire::GripperHand::Server {
 public:
  explicit GripperHandServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<GripperHandSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> squeeze(SqueezeContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<GripperHandSqueezeArguments>(memory);
      slot.angle = in.getAngle();
      return Errc{};
    };
    return port_->command(numberOf(GripperHandCommand::squeeze), in.getSent(), fill);
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- GripperHand over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class GripperHandReceiver final : public wire::GripperHandEvents::Server {
 public:
  explicit GripperHandReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class GripperHandProxy final : public suture::rpc::Proxy {
 public:
  GripperHandProxy(wire::GripperHand::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<GripperHandReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<GripperHandCommand>(record.command)) {
      case GripperHandCommand::squeeze: {
        const auto& slot = slotIn<GripperHandSqueezeArguments>(record.arguments());
        auto request = provider_.squeezeRequest();
        request.setAngle(slot.angle);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::GripperHand::Client provider_;
  ProxyPort& port_;
};

class GripperHandBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<GripperHandServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<GripperHandProxy>(contract.castAs<wire::GripperHand>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<GripperHandSink>(subscriber.castAs<wire::GripperHandEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::GripperHand>();
  }
};

const suture::rpc::Binding& gripperHandBinding() {
  static const GripperHandBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kGripperHandCommands[] = {
    {.name = "squeeze",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<GripperHandSqueezeArguments>,
     .depth = 16,
     .latest = true,
     .ttl = Duration(100'000'000),
     .accepts = checkSlot<GripperHandSqueezeArguments, acceptsGripperHandSqueeze>},
};

// The self-description, as in drives/gripper_hand.suture.json.
constexpr char kGripperHandDescription[] = R"json(
{"name": "robots::GripperHand",
"doc": "Simulated drives of a master provide it as \"Hand\", for real ones have a surgeon's. Commands run\nin the drives' own thread before its next cycle.",
"hash": "2f170b4de6ff45ce5d5a523ed80fb21b", "commands": [{"name": "squeeze", "kind": "write",
"ordinal": 1,
"doc": "The fingers press the handles to this angle, newest wins: there it stays until another one.\nThe gripper follows with the lag of the drives, and no further than its stops.",
"parameters": [{"name": "angle", "type": {"kind": "Float64"}, "unit": "rad"}], "queue": 16,
"latest": true, "ttl": 0.1}], "events": [], "enums": [], "structs": [], "wire": [{
"id": "@0xfdcd88fcdd8f3434", "kind": "interface", "name": "GripperHand",
"cxx": "robots::GripperHand", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xc0df5b70383bca9d"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "squeeze",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "angle", "is": "Float64 unit \"rad\""}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}]}, {"id": "@0xc0df5b70383bca9d",
"kind": "interface", "name": "GripperHandEvents", "members": [{"at": 0, "name": "state",
"parameters": [{"at": 0, "name": "row", "is": "@0xda979129fce1c077"}]}]}, {
"id": "@0xda979129fce1c077", "kind": "struct", "name": "GripperHandStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::GripperHand>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::GripperHand",
      .hash = "2f170b4de6ff45ce5d5a523ed80fb21b",
      .description = robots::kGripperHandDescription,
      .commands = robots::kGripperHandCommands,
      .events = {},
      .binding = &robots::gripperHandBinding,
  };
  return kInfo;
}

Errc Provided<robots::GripperHand>::execute(std::uint16_t command, const std::byte* arguments,
                                            std::byte* /*result*/) {
  using ::robots::GripperHandCommand;
  switch (static_cast<GripperHandCommand>(command)) {
    case GripperHandCommand::squeeze: {
      const auto& slot = slotIn<robots::GripperHandSqueezeArguments>(arguments);
      load(slot.angle, scratch_.squeeze_angle);
      implementation_.squeeze(scratch_.squeeze_angle);
      return Errc{};
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
