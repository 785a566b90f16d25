// Written by suturec from 03_own_data_type/tracker.h. Do not edit.
#include "03_own_data_type/tracker.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "03_own_data_type/tracker.capnp.h"

// Defined in 03_own_data_type/observation.suture.cpp.
namespace tracking {
void toWire(const ObservationSlot& slot, wire::Observation::Builder out);
suture::Errc fromWire(wire::Observation::Reader in, ObservationSlot& slot, suture::Duration shift);
bool isValid(const ObservationSlot& slot, suture::FieldPath* path);
}  // namespace tracking

namespace tracking {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Errc;
using suture::checkSlot;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::slotIn;
using suture::slotSize;

namespace {

// --- Tracker over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class TrackerSink final : public suture::rpc::EventSink {
 public:
  explicit TrackerSink(wire::TrackerEvents::Client subscriber) : subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t, const std::byte*) override { return kj::READY_NOW; }

  kj::Promise<void> row(const suture::rt::StateTable::Row& row,
                        std::span<const std::byte* const> columns) override {
    auto request = subscriber_.stateRequest();
    auto out = request.initRow();
    out.setStamp(suture::toNanoseconds(row.stamp));
    out.setEvaluated(row.valid | row.invalid);
    out.setTooLarge(row.tooLarge | row.invalid);
    if (row.hasValue(0)) {
      const auto& slot = slotIn<ObservationSlot>(columns[0]);
      toWire(slot, out.initObservation());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::TrackerEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class TrackerServant final : public wire::Tracker::Server {
 public:
  explicit TrackerServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<TrackerSink>(in.getEvents()), in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> observation(ObservationContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<ObservationSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(TrackerCommand::observation), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- Tracker over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class TrackerReceiver final : public wire::TrackerEvents::Server {
 public:
  explicit TrackerReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<ObservationSlot>(0);
      const Errc error =
          in.hasObservation() ? fromWire(in.getObservation(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class TrackerProxy final : public suture::rpc::Proxy {
 public:
  TrackerProxy(wire::Tracker::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<TrackerReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<TrackerCommand>(record.command)) {
      case TrackerCommand::observation: {
        auto request = provider_.observationRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<ObservationSlot>(call, response.getStamp(), [&](ObservationSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::Tracker::Client provider_;
  ProxyPort& port_;
};

class TrackerBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<TrackerServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<TrackerProxy>(contract.castAs<wire::Tracker>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<TrackerSink>(subscriber.castAs<wire::TrackerEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::Tracker>();
  }
};

const suture::rpc::Binding& trackerBinding() {
  static const TrackerBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kTrackerCommands[] = {
    {.name = "observation",
     .kind = CommandKind::Read,
     .resultSize = slotSize<ObservationSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<ObservationSlot, isValid>},
};

// The self-description, as in 03_own_data_type/tracker.suture.json.
constexpr char kTrackerDescription[] = R"json(
{"name": "tracking::Tracker", "hash": "f75b729ffec40c77a2db866f16980374", "commands": [{
"name": "observation", "kind": "read", "ordinal": 1,
"doc": "The newest observation; never waits for anyone.", "result": {"type": {"kind": "struct",
"name": "tracking::Observation"}}, "queue": 16}], "events": [], "enums": [{
"name": "tracking::Visibility", "underlying": "UInt8", "enumerators": [{"name": "Hidden",
"value": 0, "wire": "hidden"}, {"name": "Partial", "value": 1, "wire": "partial"}, {"name": "Full",
"value": 2, "wire": "full"}]}], "structs": [{"name": "tracking::Marker", "fields": [{
"name": "number", "type": {"kind": "UInt32"}, "default": 0}, {"name": "position", "type": {
"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}, "unit": "m"}]}, {
"name": "tracking::Observation",
"doc": "What a tracking camera knows of a surgical instrument at one moment, in the camera's frame.",
"fields": [{"name": "instrument", "type": {"kind": "text", "capacity": 31}}, {"name": "visibility",
"type": {"kind": "enum", "name": "tracking::Visibility"}, "default": "Hidden"}, {"name": "tip",
"doc": "The pose of its tip.", "type": {"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {
"name": "markers", "doc": "The markers that are seen.", "type": {"kind": "list", "element": {
"kind": "struct", "name": "tracking::Marker"}, "capacity": 8}}, {"name": "jaw_angle",
"wire": "jawAngle", "doc": "How far its jaws are open.", "type": {"kind": "Float64"}, "unit": "rad",
"range": [0.0, 1.6], "default": 0.0}]}], "wire": [{"id": "@0xfadff631147631f3", "kind": "interface",
"name": "Tracker", "cxx": "tracking::Tracker", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xbe3f6f6614035211"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "observation", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xb007f771f460d934"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xbe3f6f6614035211", "kind": "interface",
"name": "TrackerEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xfa119c601108b062"}]}]}, {"id": "@0xfa119c601108b062", "kind": "struct",
"name": "TrackerStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "observation", "is": "@0xb007f771f460d934"}]}, {"id": "@0xb007f771f460d934",
"kind": "struct", "name": "Observation", "members": [{"at": 0, "name": "instrument", "is": "Text"},
{"at": 1, "name": "visibility", "is": "@0xbbada0527d771775"}, {"at": 2, "name": "tip",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 3, "name": "markers",
"is": "List(@0x8dd86c5318c04d7e)"}, {"at": 4, "name": "jawAngle", "is": "Float64 unit \"rad\""}]}, {
"id": "@0xbbada0527d771775", "kind": "enum", "name": "Visibility", "members": [{"at": 0,
"name": "hidden"}, {"at": 1, "name": "partial"}, {"at": 2, "name": "full"}]}, {
"id": "@0x8dd86c5318c04d7e", "kind": "struct", "name": "Marker", "members": [{"at": 0,
"name": "number", "is": "UInt32"}, {"at": 1, "name": "position",
"is": "/suture/types.capnp:Vec3 unit \"m\""}]}]})json";

}  // namespace
}  // namespace tracking

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<tracking::Tracker>() {
  static constexpr InterfaceInfo kInfo{
      .name = "tracking::Tracker",
      .hash = "f75b729ffec40c77a2db866f16980374",
      .description = tracking::kTrackerDescription,
      .commands = tracking::kTrackerCommands,
      .events = {},
      .binding = &tracking::trackerBinding,
  };
  return kInfo;
}

Errc Provided<tracking::Tracker>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                          std::byte* result) {
  using ::tracking::TrackerCommand;
  switch (static_cast<TrackerCommand>(command)) {
    case TrackerCommand::observation: {
      auto& slot = newSlot<tracking::ObservationSlot>(result);
      return store(implementation_.observation(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
