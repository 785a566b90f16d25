// Written by suturec from coordinator/emergency_stop.h. Do not edit.
#include "coordinator/emergency_stop.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "coordinator/emergency_stop.capnp.h"

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
static_assert(std::is_same_v<decltype(Permit::granted), bool>);
static_assert(std::is_same_v<decltype(Permit::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(StopNews::pressed), bool>);
static_assert(std::is_same_v<decltype(StopNews::stamp), std::chrono::steady_clock::time_point>);

}  // namespace

bool store(const Permit& value, PermitSlot& slot) {
  bool fits = true;
  fits &= store(value.granted, slot.granted);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const PermitSlot& slot, Permit& value) {
  load(slot.granted, value.granted);
  load(slot.stamp, value.stamp);
}

void shiftStamps(PermitSlot& slot, Duration shift) { slot.stamp = shifted(slot.stamp, shift); }

bool store(const StopNews& value, StopNewsSlot& slot) {
  bool fits = true;
  fits &= store(value.pressed, slot.pressed);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const StopNewsSlot& slot, StopNews& value) {
  load(slot.pressed, value.pressed);
  load(slot.stamp, value.stamp);
}

void shiftStamps(StopNewsSlot& slot, Duration shift) { slot.stamp = shifted(slot.stamp, shift); }

// --- between slots and Cap'n Proto

void toWire(const PermitSlot& slot, wire::Permit::Builder out) {
  out.setGranted(slot.granted != 0);
  out.setStamp(slot.stamp);
}

Errc fromWire(wire::Permit::Reader in, PermitSlot& slot, Duration shift) {
  slot.granted = in.getGranted();
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  return Errc{};
}

bool isValid(const PermitSlot&, FieldPath*) {
  return true;
}

void toWire(const StopNewsSlot& slot, wire::StopNews::Builder out) {
  out.setPressed(slot.pressed != 0);
  out.setStamp(slot.stamp);
}

Errc fromWire(wire::StopNews::Reader in, StopNewsSlot& slot, Duration shift) {
  slot.pressed = in.getPressed();
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  return Errc{};
}

bool isValid(const StopNewsSlot&, FieldPath*) {
  return true;
}

namespace {

// --- EmergencyStop over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class EmergencyStopSink final : public suture::rpc::EventSink {
 public:
  explicit EmergencyStopSink(wire::EmergencyStopEvents::Client subscriber) :
      subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(EmergencyStopEvent::stop): {
        const auto& slot = slotIn<StopNewsSlot>(payload);
        auto request = subscriber_.stopRequest();
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
      const auto& slot = slotIn<PermitSlot>(columns[0]);
      toWire(slot, out.initPermit());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::EmergencyStopEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class EmergencyStopServant final : public wire::EmergencyStop::Server {
 public:
  explicit EmergencyStopServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<EmergencyStopSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> press(PressContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(EmergencyStopCommand::press), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> release(ReleaseContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(EmergencyStopCommand::release), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> permit(PermitContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<PermitSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(EmergencyStopCommand::permit), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- EmergencyStop over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class EmergencyStopReceiver final : public wire::EmergencyStopEvents::Server {
 public:
  explicit EmergencyStopReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<PermitSlot>(0);
      const Errc error =
          in.hasPermit() ? fromWire(in.getPermit(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> stop(StopContext context) override {
    auto in = context.getParams();
    return port_->event<StopNewsSlot>(numberOf(EmergencyStopEvent::stop), [&](StopNewsSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class EmergencyStopProxy final : public suture::rpc::Proxy {
 public:
  EmergencyStopProxy(wire::EmergencyStop::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<EmergencyStopReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<EmergencyStopCommand>(record.command)) {
      case EmergencyStopCommand::press: {
        auto request = provider_.pressRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case EmergencyStopCommand::release: {
        auto request = provider_.releaseRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case EmergencyStopCommand::permit: {
        auto request = provider_.permitRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PermitSlot>(call, response.getStamp(), [&](PermitSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::EmergencyStop::Client provider_;
  ProxyPort& port_;
};

class EmergencyStopBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<EmergencyStopServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<EmergencyStopProxy>(contract.castAs<wire::EmergencyStop>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<EmergencyStopSink>(subscriber.castAs<wire::EmergencyStopEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::EmergencyStop>();
  }
};

const suture::rpc::Binding& emergencyStopBinding() {
  static const EmergencyStopBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kEmergencyStopCommands[] = {
    {.name = "press", .kind = CommandKind::Void, .depth = 16},
    {.name = "release", .kind = CommandKind::Void, .depth = 16},
    {.name = "permit",
     .kind = CommandKind::Read,
     .resultSize = slotSize<PermitSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<PermitSlot, isValid>,
     .shiftResult = shiftSlot<PermitSlot>},
};

constexpr EventInfo kEmergencyStopEvents[] = {
    {.name = "stop",
     .payloadSize = slotSize<StopNewsSlot>,
     .depth = 16,
     .latched = true,
     .accepts = checkSlot<StopNewsSlot, isValid>,
     .shiftPayload = shiftSlot<StopNewsSlot>},
};

// The self-description, as in coordinator/emergency_stop.suture.json.
constexpr char kEmergencyStopDescription[] = R"json(
{"name": "robots::EmergencyStop",
"doc": "Commands run in the coordinator's thread before its next cycle.",
"hash": "85b7719779d11bd4fea35ac127cd15d7", "commands": [{"name": "press", "kind": "void",
"ordinal": 1, "doc": "All drives stop, and none has power until release().", "queue": 16}, {
"name": "release", "kind": "void", "ordinal": 2,
"doc": "An operator's decision: drives may have power again. Arms stay disabled until somebody enables\nthem, such as a console that brings its system up by itself.",
"queue": 16}, {"name": "permit", "kind": "read", "ordinal": 3, "doc": "Renewed in each cycle.",
"result": {"type": {"kind": "struct", "name": "robots::Permit"}}, "queue": 16}], "events": [{
"name": "stop", "kind": "write", "ordinal": 1,
"doc": "Each press and each release, and the last one to whoever connects.", "payload": {"type": {
"kind": "struct", "name": "robots::StopNews"}}, "queue": 16, "latched": true}], "enums": [],
"structs": [{"name": "robots::Permit",
"doc": "It lets drives have power. It counts for as long as it is fresh, so that whoever does not\nhear of it any more stops too.",
"fields": [{"name": "granted", "type": {"kind": "Bool"}, "default": false}, {"name": "stamp",
"doc": "The cycle that it was renewed in.", "type": {"kind": "time", "clock": "steady"}}]}, {
"name": "robots::StopNews", "doc": "The emergency stop was pressed, or released.", "fields": [{
"name": "pressed", "type": {"kind": "Bool"}, "default": false}, {"name": "stamp", "type": {
"kind": "time", "clock": "steady"}}]}], "wire": [{"id": "@0x85a101cfc49eccfc", "kind": "interface",
"name": "EmergencyStop", "cxx": "robots::EmergencyStop", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xd5baa187cf46a24d"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "press", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "release", "is": "kind \"void\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 3,
"name": "permit", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xd02fe436dab69cbc"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xd5baa187cf46a24d", "kind": "interface",
"name": "EmergencyStopEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xf44715265e64d420"}]}, {"at": 1, "name": "stop", "parameters": [{"at": 0,
"name": "value", "is": "@0xcd5512b8a090183f"}]}]}, {"id": "@0xf44715265e64d420", "kind": "struct",
"name": "EmergencyStopStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "permit", "is": "@0xd02fe436dab69cbc"}]}, {"id": "@0xd02fe436dab69cbc", "kind": "struct",
"name": "Permit", "members": [{"at": 0, "name": "granted", "is": "Bool"}, {"at": 1, "name": "stamp",
"is": "Int64 clock \"steady\""}]}, {"id": "@0xcd5512b8a090183f", "kind": "struct",
"name": "StopNews", "members": [{"at": 0, "name": "pressed", "is": "Bool"}, {"at": 1,
"name": "stamp", "is": "Int64 clock \"steady\""}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::EmergencyStop>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::EmergencyStop",
      .hash = "85b7719779d11bd4fea35ac127cd15d7",
      .description = robots::kEmergencyStopDescription,
      .commands = robots::kEmergencyStopCommands,
      .events = robots::kEmergencyStopEvents,
      .binding = &robots::emergencyStopBinding,
  };
  return kInfo;
}

Errc Provided<robots::EmergencyStop>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                              std::byte* result) {
  using ::robots::EmergencyStopCommand;
  switch (static_cast<EmergencyStopCommand>(command)) {
    case EmergencyStopCommand::press: {
      implementation_.press();
      return Errc{};
    }
    case EmergencyStopCommand::release: {
      implementation_.release();
      return Errc{};
    }
    case EmergencyStopCommand::permit: {
      auto& slot = newSlot<robots::PermitSlot>(result);
      return store(implementation_.permit(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
