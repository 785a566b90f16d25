// Written by suturec from 04_contract_and_loss/joystick.h. Do not edit.
#include "04_contract_and_loss/joystick.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "04_contract_and_loss/joystick.capnp.h"

namespace following {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Errc;
using suture::FieldPath;
using suture::checkSlot;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::slotIn;
using suture::slotSize;

namespace {

bool acceptsJoystickAngleResult(const double& slot, FieldPath*) { return isValid(slot); }

// --- Joystick over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class JoystickSink final : public suture::rpc::EventSink {
 public:
  explicit JoystickSink(wire::JoystickEvents::Client subscriber) :
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
  wire::JoystickEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class JoystickServant final : public wire::Joystick::Server {
 public:
  explicit JoystickServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<JoystickSink>(in.getEvents()), in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> angle(AngleContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(JoystickCommand::angle), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- Joystick over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class JoystickReceiver final : public wire::JoystickEvents::Server {
 public:
  explicit JoystickReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

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
class JoystickProxy final : public suture::rpc::Proxy {
 public:
  JoystickProxy(wire::Joystick::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<JoystickReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<JoystickCommand>(record.command)) {
      case JoystickCommand::angle: {
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
  wire::Joystick::Client provider_;
  ProxyPort& port_;
};

class JoystickBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<JoystickServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<JoystickProxy>(contract.castAs<wire::Joystick>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<JoystickSink>(subscriber.castAs<wire::JoystickEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::Joystick>();
  }
};

const suture::rpc::Binding& joystickBinding() {
  static const JoystickBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kJoystickCommands[] = {
    {.name = "angle",
     .kind = CommandKind::Read,
     .resultSize = slotSize<double>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<double, acceptsJoystickAngleResult>},
};

// The self-description, as in 04_contract_and_loss/joystick.suture.json.
constexpr char kJoystickDescription[] = R"json(
{"name": "following::Joystick", "hash": "fb0e421ba1ec8175508fc619a3be612c", "commands": [{
"name": "angle", "kind": "read", "ordinal": 1, "doc": "How far the stick is turned.", "result": {
"type": {"kind": "Float64"}, "unit": "rad"}, "queue": 16}], "events": [], "enums": [],
"structs": [], "wire": [{"id": "@0xba57d83dcf98cd85", "kind": "interface", "name": "Joystick",
"cxx": "following::Joystick", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xbca1b09e26acd380"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "angle", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Float64 unit \"rad\""}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xbca1b09e26acd380", "kind": "interface", "name": "JoystickEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xddcb191d942f6b5f"}]}]}, {
"id": "@0xddcb191d942f6b5f", "kind": "struct", "name": "JoystickStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "angle", "is": "Float64 unit \"rad\""}]}]})json";

}  // namespace
}  // namespace following

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<following::Joystick>() {
  static constexpr InterfaceInfo kInfo{
      .name = "following::Joystick",
      .hash = "fb0e421ba1ec8175508fc619a3be612c",
      .description = following::kJoystickDescription,
      .commands = following::kJoystickCommands,
      .events = {},
      .binding = &following::joystickBinding,
  };
  return kInfo;
}

Errc Provided<following::Joystick>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                            std::byte* result) {
  using ::following::JoystickCommand;
  switch (static_cast<JoystickCommand>(command)) {
    case JoystickCommand::angle: {
      auto& slot = newSlot<double>(result);
      return store(implementation_.angle(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
