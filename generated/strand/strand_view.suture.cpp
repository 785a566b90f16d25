// Written by suturec from strand/strand_view.h. Do not edit.
#include "strand/strand_view.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "strand/strand_view.capnp.h"

namespace robots {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Duration;
using suture::Errc;
using suture::FieldPath;
using suture::checkSlot;
using suture::load;
using suture::refusedAt;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::fromDefault;
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
static_assert(std::is_same_v<decltype(StrandState::nodes), Eigen::Matrix<double, 3, 61>>);
static_assert(std::is_same_v<decltype(StrandState::left_length), double>);
static_assert(std::is_same_v<decltype(StrandState::left_tension), double>);
static_assert(std::is_same_v<decltype(StrandState::right_tension), double>);
static_assert(std::is_same_v<decltype(StrandState::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(StrandState::valid), bool>);

}  // namespace

bool store(const StrandState& value, StrandStateSlot& slot) {
  bool fits = true;
  fits &= store(value.nodes, slot.nodes);
  fits &= store(value.left_length, slot.left_length);
  fits &= store(value.left_tension, slot.left_tension);
  fits &= store(value.right_tension, slot.right_tension);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const StrandStateSlot& slot, StrandState& value) {
  load(slot.nodes, value.nodes);
  load(slot.left_length, value.left_length);
  load(slot.left_tension, value.left_tension);
  load(slot.right_tension, value.right_tension);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(StrandStateSlot& slot, Duration shift) { slot.stamp = shifted(slot.stamp, shift); }

// --- between slots and Cap'n Proto

void toWire(const StrandStateSlot& slot, wire::StrandState::Builder out) {
  toWire(slot.nodes, out.initNodes(183));
  out.setLeftLength(slot.left_length);
  out.setLeftTension(slot.left_tension);
  out.setRightTension(slot.right_tension);
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

Errc fromWire(wire::StrandState::Reader in, StrandStateSlot& slot, Duration shift) {
  slot.left_length = in.getLeftLength();
  slot.left_tension = in.getLeftTension();
  slot.right_tension = in.getRightTension();
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return in.getNodes().size() != 0 ? fromWire(in.getNodes(), slot.nodes)
      : fromDefault(StrandState().nodes, slot.nodes);
}

bool isValid(const StrandStateSlot& slot, FieldPath* path) {
  if (!isValid(slot.nodes)) return refusedAt(path, "nodes");
  if (!isValid(slot.left_length)) return refusedAt(path, "left_length");
  if (!isValid(slot.left_tension)) return refusedAt(path, "left_tension");
  return isValid(slot.right_tension) || refusedAt(path, "right_tension");
}

namespace {

// --- StrandView over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class StrandViewSink final : public suture::rpc::EventSink {
 public:
  explicit StrandViewSink(wire::StrandViewEvents::Client subscriber) :
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
      const auto& slot = slotIn<StrandStateSlot>(columns[0]);
      toWire(slot, out.initStrand());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::StrandViewEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class StrandViewServant final : public wire::StrandView::Server {
 public:
  explicit StrandViewServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<StrandViewSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> strand(StrandContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<StrandStateSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(StrandViewCommand::strand), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- StrandView over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class StrandViewReceiver final : public wire::StrandViewEvents::Server {
 public:
  explicit StrandViewReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<StrandStateSlot>(0);
      const Errc error =
          in.hasStrand() ? fromWire(in.getStrand(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class StrandViewProxy final : public suture::rpc::Proxy {
 public:
  StrandViewProxy(wire::StrandView::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<StrandViewReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<StrandViewCommand>(record.command)) {
      case StrandViewCommand::strand: {
        auto request = provider_.strandRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<StrandStateSlot>(call, response.getStamp(), [&](StrandStateSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::StrandView::Client provider_;
  ProxyPort& port_;
};

class StrandViewBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<StrandViewServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<StrandViewProxy>(contract.castAs<wire::StrandView>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<StrandViewSink>(subscriber.castAs<wire::StrandViewEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::StrandView>();
  }
};

const suture::rpc::Binding& strandViewBinding() {
  static const StrandViewBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kStrandViewCommands[] = {
    {.name = "strand",
     .kind = CommandKind::Read,
     .resultSize = slotSize<StrandStateSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<StrandStateSlot, isValid>,
     .shiftResult = shiftSlot<StrandStateSlot>},
};

// The self-description, as in strand/strand_view.suture.json.
constexpr char kStrandViewDescription[] = R"json(
{"name": "robots::StrandView", "hash": "3d0e0f11a53e375943417b4b324a46bf", "commands": [{
"name": "strand", "kind": "read", "ordinal": 1,
"doc": "As it is at the end of the simulation's last cycle, which is its stamp.", "result": {
"type": {"kind": "struct", "name": "robots::StrandState"}}, "queue": 16}], "events": [],
"enums": [], "structs": [{"name": "robots::StrandState", "fields": [{"name": "nodes",
"doc": "From the left tip over the knot, the middle column, to the right tip; in the scene's frame.",
"type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 61}, "unit": "m"}, {
"name": "left_length", "wire": "leftLength", "doc": "Strand between the left tip and the knot.",
"type": {"kind": "Float64"}, "unit": "m", "default": 0.0}, {"name": "left_tension",
"wire": "leftTension", "doc": "The tensions pull at the links beside the knot, from either side.",
"type": {"kind": "Float64"}, "unit": "N", "default": 0.0}, {"name": "right_tension",
"wire": "rightTension", "type": {"kind": "Float64"}, "unit": "N", "default": 0.0}, {
"name": "stamp", "type": {"kind": "time", "clock": "steady"}}, {"name": "valid",
"doc": "False before both tips are known, and apart from each other.", "type": {"kind": "Bool"},
"default": false}]}], "wire": [{"id": "@0xffcefa0bd4f32fb9", "kind": "interface",
"name": "StrandView", "cxx": "robots::StrandView", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xf34a05754eaad965"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "strand", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xa7b70b5e253db6a2"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xf34a05754eaad965", "kind": "interface",
"name": "StrandViewEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xe319b7f6e1bccccd"}]}]}, {"id": "@0xe319b7f6e1bccccd", "kind": "struct",
"name": "StrandViewStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "strand", "is": "@0xa7b70b5e253db6a2"}]}, {"id": "@0xa7b70b5e253db6a2", "kind": "struct",
"name": "StrandState", "members": [{"at": 0, "name": "nodes",
"is": "List(Float64) unit \"m\" shape \"3x61\""}, {"at": 1, "name": "leftLength",
"is": "Float64 unit \"m\""}, {"at": 2, "name": "leftTension", "is": "Float64 unit \"N\""}, {
"at": 3, "name": "rightTension", "is": "Float64 unit \"N\""}, {"at": 4, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 5, "name": "valid", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::StrandView>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::StrandView",
      .hash = "3d0e0f11a53e375943417b4b324a46bf",
      .description = robots::kStrandViewDescription,
      .commands = robots::kStrandViewCommands,
      .events = {},
      .binding = &robots::strandViewBinding,
  };
  return kInfo;
}

Errc Provided<robots::StrandView>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                           std::byte* result) {
  using ::robots::StrandViewCommand;
  switch (static_cast<StrandViewCommand>(command)) {
    case StrandViewCommand::strand: {
      auto& slot = newSlot<robots::StrandStateSlot>(result);
      return store(implementation_.strand(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
