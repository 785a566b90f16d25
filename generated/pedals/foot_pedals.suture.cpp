// Written by suturec from pedals/foot_pedals.h. Do not edit.
#include "pedals/foot_pedals.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "pedals/foot_pedals.capnp.h"

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
static_assert(std::is_same_v<decltype(PedalState::clutch), bool>);
static_assert(std::is_same_v<decltype(PedalState::camera), bool>);
static_assert(std::is_same_v<decltype(PedalState::coagulation), bool>);
static_assert(std::is_same_v<decltype(PedalState::stamp), std::chrono::steady_clock::time_point>);

}  // namespace

bool store(const PedalState& value, PedalStateSlot& slot) {
  bool fits = true;
  fits &= store(value.clutch, slot.clutch);
  fits &= store(value.camera, slot.camera);
  fits &= store(value.coagulation, slot.coagulation);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const PedalStateSlot& slot, PedalState& value) {
  load(slot.clutch, value.clutch);
  load(slot.camera, value.camera);
  load(slot.coagulation, value.coagulation);
  load(slot.stamp, value.stamp);
}

void shiftStamps(PedalStateSlot& slot, Duration shift) { slot.stamp = shifted(slot.stamp, shift); }

// --- between slots and Cap'n Proto

void toWire(const PedalStateSlot& slot, wire::PedalState::Builder out) {
  out.setClutch(slot.clutch != 0);
  out.setCamera(slot.camera != 0);
  out.setCoagulation(slot.coagulation != 0);
  out.setStamp(slot.stamp);
}

Errc fromWire(wire::PedalState::Reader in, PedalStateSlot& slot, Duration shift) {
  slot.clutch = in.getClutch();
  slot.camera = in.getCamera();
  slot.coagulation = in.getCoagulation();
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  return Errc{};
}

bool isValid(const PedalStateSlot&, FieldPath*) {
  return true;
}

namespace {

// --- FootPedals over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class FootPedalsSink final : public suture::rpc::EventSink {
 public:
  explicit FootPedalsSink(wire::FootPedalsEvents::Client subscriber) :
      subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(FootPedalsEvent::clutch): {
        const auto& slot = slotIn<std::uint8_t>(payload);
        auto request = subscriber_.clutchRequest();
        request.setValue(slot != 0);
        return request.send().ignoreResult();
      }
      case numberOf(FootPedalsEvent::camera): {
        const auto& slot = slotIn<std::uint8_t>(payload);
        auto request = subscriber_.cameraRequest();
        request.setValue(slot != 0);
        return request.send().ignoreResult();
      }
      case numberOf(FootPedalsEvent::coagulation): {
        const auto& slot = slotIn<std::uint8_t>(payload);
        auto request = subscriber_.coagulationRequest();
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
      const auto& slot = slotIn<PedalStateSlot>(columns[0]);
      toWire(slot, out.initPedals());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::FootPedalsEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class FootPedalsServant final : public wire::FootPedals::Server {
 public:
  explicit FootPedalsServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<FootPedalsSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> pedals(PedalsContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<PedalStateSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(FootPedalsCommand::pedals), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- FootPedals over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class FootPedalsReceiver final : public wire::FootPedalsEvents::Server {
 public:
  explicit FootPedalsReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<PedalStateSlot>(0);
      const Errc error =
          in.hasPedals() ? fromWire(in.getPedals(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> clutch(ClutchContext context) override {
    auto in = context.getParams();
    return port_->event<std::uint8_t>(numberOf(FootPedalsEvent::clutch), [&](std::uint8_t& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

  kj::Promise<void> camera(CameraContext context) override {
    auto in = context.getParams();
    return port_->event<std::uint8_t>(numberOf(FootPedalsEvent::camera), [&](std::uint8_t& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

  kj::Promise<void> coagulation(CoagulationContext context) override {
    auto in = context.getParams();
    return port_->event<std::uint8_t>(numberOf(FootPedalsEvent::coagulation),
                                      [&](std::uint8_t& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class FootPedalsProxy final : public suture::rpc::Proxy {
 public:
  FootPedalsProxy(wire::FootPedals::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<FootPedalsReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<FootPedalsCommand>(record.command)) {
      case FootPedalsCommand::pedals: {
        auto request = provider_.pedalsRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PedalStateSlot>(call, response.getStamp(), [&](PedalStateSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::FootPedals::Client provider_;
  ProxyPort& port_;
};

class FootPedalsBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<FootPedalsServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<FootPedalsProxy>(contract.castAs<wire::FootPedals>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<FootPedalsSink>(subscriber.castAs<wire::FootPedalsEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::FootPedals>();
  }
};

const suture::rpc::Binding& footPedalsBinding() {
  static const FootPedalsBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kFootPedalsCommands[] = {
    {.name = "pedals",
     .kind = CommandKind::Read,
     .resultSize = slotSize<PedalStateSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<PedalStateSlot, isValid>,
     .shiftResult = shiftSlot<PedalStateSlot>},
};

constexpr EventInfo kFootPedalsEvents[] = {
    {.name = "clutch", .payloadSize = slotSize<std::uint8_t>, .depth = 16, .latched = true},
    {.name = "camera", .payloadSize = slotSize<std::uint8_t>, .depth = 16, .latched = true},
    {.name = "coagulation", .payloadSize = slotSize<std::uint8_t>, .depth = 16, .latched = true},
};

// The self-description, as in pedals/foot_pedals.suture.json.
constexpr char kFootPedalsDescription[] = R"json(
{"name": "robots::FootPedals", "doc": "The names are the da Vinci Research Kit's.",
"hash": "f320d94db1af1de0f1010f2a5a285f2b", "commands": [{"name": "pedals", "kind": "read",
"ordinal": 1, "result": {"type": {"kind": "struct", "name": "robots::PedalState"}}, "queue": 16}],
"events": [{"name": "clutch", "kind": "write", "ordinal": 1,
"doc": "Pressed or released, and as it is now to whoever connects.", "payload": {"type": {
"kind": "Bool"}}, "queue": 16, "latched": true}, {"name": "camera", "kind": "write", "ordinal": 2,
"payload": {"type": {"kind": "Bool"}}, "queue": 16, "latched": true}, {"name": "coagulation",
"kind": "write", "ordinal": 3, "payload": {"type": {"kind": "Bool"}}, "queue": 16, "latched": true}
], "enums": [], "structs": [{"name": "robots::PedalState",
"doc": "What the feet do. It counts for as long as it is fresh: whoever does not hear of the pedals any\nmore must take them for pressed.",
"fields": [{"name": "clutch", "doc": "Masters move without their slaves.", "type": {"kind": "Bool"
}, "default": false}, {"name": "camera", "doc": "Masters move the camera instead of their slaves.",
"type": {"kind": "Bool"}, "default": false}, {"name": "coagulation",
"doc": "Energy is applied to the tissue.", "type": {"kind": "Bool"}, "default": false}, {
"name": "stamp", "doc": "The cycle that they were looked at in.", "type": {"kind": "time",
"clock": "steady"}}]}], "wire": [{"id": "@0xeef483a34001461c", "kind": "interface",
"name": "FootPedals", "cxx": "robots::FootPedals", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xeb48eb818a9b108b"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "pedals", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xcff309898affe286"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xeb48eb818a9b108b", "kind": "interface",
"name": "FootPedalsEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xec8fc265517e6c7c"}]}, {"at": 1, "name": "clutch", "parameters": [{"at": 0,
"name": "value", "is": "Bool"}]}, {"at": 2, "name": "camera", "parameters": [{"at": 0,
"name": "value", "is": "Bool"}]}, {"at": 3, "name": "coagulation", "parameters": [{"at": 0,
"name": "value", "is": "Bool"}]}]}, {"id": "@0xec8fc265517e6c7c", "kind": "struct",
"name": "FootPedalsStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "pedals", "is": "@0xcff309898affe286"}]}, {"id": "@0xcff309898affe286", "kind": "struct",
"name": "PedalState", "members": [{"at": 0, "name": "clutch", "is": "Bool"}, {"at": 1,
"name": "camera", "is": "Bool"}, {"at": 2, "name": "coagulation", "is": "Bool"}, {"at": 3,
"name": "stamp", "is": "Int64 clock \"steady\""}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::FootPedals>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::FootPedals",
      .hash = "f320d94db1af1de0f1010f2a5a285f2b",
      .description = robots::kFootPedalsDescription,
      .commands = robots::kFootPedalsCommands,
      .events = robots::kFootPedalsEvents,
      .binding = &robots::footPedalsBinding,
  };
  return kInfo;
}

Errc Provided<robots::FootPedals>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                           std::byte* result) {
  using ::robots::FootPedalsCommand;
  switch (static_cast<FootPedalsCommand>(command)) {
    case FootPedalsCommand::pedals: {
      auto& slot = newSlot<robots::PedalStateSlot>(result);
      return store(implementation_.pedals(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
