// Written by suturec from 05_events/gripper.h. Do not edit.
#include "05_events/gripper.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "05_events/gripper.capnp.h"

namespace gripping {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Errc;
using suture::EventInfo;
using suture::FieldPath;
using suture::checkSlot;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::slotIn;
using suture::slotSize;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<Jaws>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(Jaws::Open) == 0);
static_assert(static_cast<std::uint8_t>(Jaws::Closing) == 1);
static_assert(static_cast<std::uint8_t>(Jaws::Holding) == 2);

}  // namespace

// --- between slots and Cap'n Proto

wire::Jaws wireJaws(std::uint8_t slot) {
  switch (static_cast<Jaws>(slot)) {
    case Jaws::Open: return wire::Jaws::OPEN;
    case Jaws::Closing: return wire::Jaws::CLOSING;
    case Jaws::Holding: return wire::Jaws::HOLDING;
  }
  return wire::Jaws{};
}

bool isKnownJaws(std::uint8_t slot) {
  switch (static_cast<Jaws>(slot)) {
    case Jaws::Open:
    case Jaws::Closing:
    case Jaws::Holding:
      return true;
  }
  return false;
}

Errc fromWire(wire::Jaws in, std::uint8_t& slot) {
  switch (in) {
    case wire::Jaws::OPEN: return slot = static_cast<std::uint8_t>(Jaws::Open), Errc{};
    case wire::Jaws::CLOSING: return slot = static_cast<std::uint8_t>(Jaws::Closing), Errc{};
    case wire::Jaws::HOLDING: return slot = static_cast<std::uint8_t>(Jaws::Holding), Errc{};
  }
  return Errc::Invalid;
}

namespace {

bool acceptsGripperJawsChangedEvent(const std::uint8_t& slot, FieldPath*) {
  return isKnownJaws(slot);
}

bool acceptsGripperTouchedEvent(const double& slot, FieldPath*) { return isValid(slot); }

// --- Gripper over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class GripperSink final : public suture::rpc::EventSink {
 public:
  explicit GripperSink(wire::GripperEvents::Client subscriber) : subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(GripperEvent::jaws_changed): {
        const auto& slot = slotIn<std::uint8_t>(payload);
        auto request = subscriber_.jawsChangedRequest();
        request.setValue(wireJaws(slot));
        return request.send().ignoreResult();
      }
      case numberOf(GripperEvent::touched): {
        const auto& slot = slotIn<double>(payload);
        auto request = subscriber_.touchedRequest();
        request.setValue(slot);
        return request.send().ignoreResult();
      }
    }
    return kj::READY_NOW;
  }

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
  wire::GripperEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class GripperServant final : public wire::Gripper::Server {
 public:
  explicit GripperServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<GripperSink>(in.getEvents()), in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> grasp(GraspContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(GripperCommand::grasp), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> release(ReleaseContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<std::uint8_t>(result);
      auto out = context.getResults();
      out.setValue(slot != 0);
    };
    return port_->call(numberOf(GripperCommand::release), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- Gripper over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class GripperReceiver final : public wire::GripperEvents::Server {
 public:
  explicit GripperReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> jawsChanged(JawsChangedContext context) override {
    auto in = context.getParams();
    return port_->event<std::uint8_t>(numberOf(GripperEvent::jaws_changed),
                                      [&](std::uint8_t& slot) {
      return fromWire(in.getValue(), slot);
    });
  }

  kj::Promise<void> touched(TouchedContext context) override {
    auto in = context.getParams();
    return port_->event<double>(numberOf(GripperEvent::touched), [&](double& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class GripperProxy final : public suture::rpc::Proxy {
 public:
  GripperProxy(wire::Gripper::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<GripperReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<GripperCommand>(record.command)) {
      case GripperCommand::grasp: {
        auto request = provider_.graspRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case GripperCommand::release: {
        auto request = provider_.releaseRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::uint8_t>(call, [&](std::uint8_t& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::Gripper::Client provider_;
  ProxyPort& port_;
};

class GripperBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<GripperServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<GripperProxy>(contract.castAs<wire::Gripper>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<GripperSink>(subscriber.castAs<wire::GripperEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::Gripper>();
  }
};

const suture::rpc::Binding& gripperBinding() {
  static const GripperBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kGripperCommands[] = {
    {.name = "grasp", .kind = CommandKind::Void, .depth = 16},
    {.name = "release",
     .kind = CommandKind::VoidReturn,
     .resultSize = slotSize<std::uint8_t>,
     .depth = 16},
};

constexpr EventInfo kGripperEvents[] = {
    {.name = "jaws_changed",
     .payloadSize = slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true,
     .accepts = checkSlot<std::uint8_t, acceptsGripperJawsChangedEvent>},
    {.name = "touched",
     .payloadSize = slotSize<double>,
     .depth = 16,
     .accepts = checkSlot<double, acceptsGripperTouchedEvent>},
};

// The self-description, as in 05_events/gripper.suture.json.
constexpr char kGripperDescription[] = R"json(
{"name": "gripping::Gripper", "hash": "0ec3c7c1bffbeb9abd876bc2ec33b2c8", "commands": [{
"name": "grasp", "kind": "void", "ordinal": 1, "doc": "Begins to close the jaws.", "queue": 16}, {
"name": "release", "kind": "void with return", "ordinal": 2,
"doc": "Opens the jaws. True if they held something.", "result": {"type": {"kind": "Bool"}},
"queue": 16}], "events": [{"name": "jaws_changed", "kind": "write", "ordinal": 1,
"wire": "jawsChanged", "doc": "A state: whoever subscribes late is told the last one at once.",
"payload": {"type": {"kind": "enum", "name": "gripping::Jaws"}}, "queue": 16, "latched": true}, {
"name": "touched", "kind": "write", "ordinal": 2,
"doc": "Something that happens: each one counts, so 16 may wait at a subscriber that is busy.",
"payload": {"type": {"kind": "Float64"}, "unit": "N"}, "queue": 16}], "enums": [{
"name": "gripping::Jaws", "underlying": "UInt8", "enumerators": [{"name": "Open", "value": 0,
"wire": "open"}, {"name": "Closing", "value": 1, "wire": "closing"}, {"name": "Holding", "value": 2,
"wire": "holding"}]}], "structs": [], "wire": [{"id": "@0x94d688a82ce7d169", "kind": "interface",
"name": "Gripper", "cxx": "gripping::Gripper", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xb6c3be53b63b21bb"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "grasp", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "release", "is": "kind \"voidReturn\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Bool"}]}]}, {"id": "@0xb6c3be53b63b21bb", "kind": "interface",
"name": "GripperEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0x996aaf9b482d97d6"}]}, {"at": 1, "name": "jawsChanged", "parameters": [{
"at": 0, "name": "value", "is": "@0xf21766ccd2556dea"}]}, {"at": 2, "name": "touched",
"parameters": [{"at": 0, "name": "value", "is": "Float64 unit \"N\""}]}]}, {
"id": "@0x996aaf9b482d97d6", "kind": "struct", "name": "GripperStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}]}, {"id": "@0xf21766ccd2556dea", "kind": "enum", "name": "Jaws",
"members": [{"at": 0, "name": "open"}, {"at": 1, "name": "closing"}, {"at": 2, "name": "holding"}]}
]})json";

}  // namespace
}  // namespace gripping

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<gripping::Gripper>() {
  static constexpr InterfaceInfo kInfo{
      .name = "gripping::Gripper",
      .hash = "0ec3c7c1bffbeb9abd876bc2ec33b2c8",
      .description = gripping::kGripperDescription,
      .commands = gripping::kGripperCommands,
      .events = gripping::kGripperEvents,
      .binding = &gripping::gripperBinding,
  };
  return kInfo;
}

Errc Provided<gripping::Gripper>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                          std::byte* result) {
  using ::gripping::GripperCommand;
  switch (static_cast<GripperCommand>(command)) {
    case GripperCommand::grasp: {
      implementation_.grasp();
      return Errc{};
    }
    case GripperCommand::release: {
      auto& slot = newSlot<std::uint8_t>(result);
      return store(implementation_.release(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
