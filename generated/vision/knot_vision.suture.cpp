// Written by suturec from vision/knot_vision.h. Do not edit.
#include "vision/knot_vision.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "vision/knot_vision.capnp.h"

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
using suture::rpc::firstError;
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
static_assert(std::is_same_v<decltype(KnotSighting::knot), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(KnotSighting::left_tip), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(KnotSighting::right_tip), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(KnotSighting::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(KnotSighting::valid), bool>);

}  // namespace

bool store(const KnotSighting& value, KnotSightingSlot& slot) {
  bool fits = true;
  fits &= store(value.knot, slot.knot);
  fits &= store(value.left_tip, slot.left_tip);
  fits &= store(value.right_tip, slot.right_tip);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const KnotSightingSlot& slot, KnotSighting& value) {
  load(slot.knot, value.knot);
  load(slot.left_tip, value.left_tip);
  load(slot.right_tip, value.right_tip);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(KnotSightingSlot& slot, Duration shift) {
  slot.stamp = shifted(slot.stamp, shift);
}

// --- between slots and Cap'n Proto

void toWire(const KnotSightingSlot& slot, wire::KnotSighting::Builder out) {
  toWire(slot.knot, out.initKnot());
  toWire(slot.left_tip, out.initLeftTip());
  toWire(slot.right_tip, out.initRightTip());
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

Errc fromWire(wire::KnotSighting::Reader in, KnotSightingSlot& slot, Duration shift) {
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return firstError({
      in.hasKnot() ? fromWire(in.getKnot(), slot.knot)
          : fromDefault(KnotSighting().knot, slot.knot),
      in.hasLeftTip() ? fromWire(in.getLeftTip(), slot.left_tip)
          : fromDefault(KnotSighting().left_tip, slot.left_tip),
      in.hasRightTip() ? fromWire(in.getRightTip(), slot.right_tip)
          : fromDefault(KnotSighting().right_tip, slot.right_tip),
  });
}

bool isValid(const KnotSightingSlot& slot, FieldPath* path) {
  if (!isValid(slot.knot, path)) return refusedAt(path, "knot");
  if (!isValid(slot.left_tip, path)) return refusedAt(path, "left_tip");
  return isValid(slot.right_tip, path) || refusedAt(path, "right_tip");
}

namespace {

// --- KnotVision over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class KnotVisionSink final : public suture::rpc::EventSink {
 public:
  explicit KnotVisionSink(wire::KnotVisionEvents::Client subscriber) :
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
      const auto& slot = slotIn<KnotSightingSlot>(columns[0]);
      toWire(slot, out.initSighting());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::KnotVisionEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class KnotVisionServant final : public wire::KnotVision::Server {
 public:
  explicit KnotVisionServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<KnotVisionSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> sighting(SightingContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<KnotSightingSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(KnotVisionCommand::sighting), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- KnotVision over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class KnotVisionReceiver final : public wire::KnotVisionEvents::Server {
 public:
  explicit KnotVisionReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<KnotSightingSlot>(0);
      const Errc error =
          in.hasSighting() ? fromWire(in.getSighting(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class KnotVisionProxy final : public suture::rpc::Proxy {
 public:
  KnotVisionProxy(wire::KnotVision::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<KnotVisionReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<KnotVisionCommand>(record.command)) {
      case KnotVisionCommand::sighting: {
        auto request = provider_.sightingRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<KnotSightingSlot>(call, response.getStamp(), [&](KnotSightingSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::KnotVision::Client provider_;
  ProxyPort& port_;
};

class KnotVisionBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<KnotVisionServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<KnotVisionProxy>(contract.castAs<wire::KnotVision>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<KnotVisionSink>(subscriber.castAs<wire::KnotVisionEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::KnotVision>();
  }
};

const suture::rpc::Binding& knotVisionBinding() {
  static const KnotVisionBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kKnotVisionCommands[] = {
    {.name = "sighting",
     .kind = CommandKind::Read,
     .resultSize = slotSize<KnotSightingSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<KnotSightingSlot, isValid>,
     .shiftResult = shiftSlot<KnotSightingSlot>},
};

// The self-description, as in vision/knot_vision.suture.json.
constexpr char kKnotVisionDescription[] = R"json(
{"name": "robots::KnotVision", "hash": "3501142906d2f97c6ee13fa414de1248", "commands": [{
"name": "sighting", "kind": "read", "ordinal": 1,
"doc": "Answers with what the last pair of images showed.", "result": {"type": {"kind": "struct",
"name": "robots::KnotSighting"}}, "queue": 16}], "events": [], "enums": [], "structs": [{
"name": "robots::KnotSighting",
"doc": "In the frame of the left camera: x to the right and y downward in the image, z ahead.",
"fields": [{"name": "knot", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1
}, "unit": "m"}, {"name": "left_tip", "wire": "leftTip", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}, "unit": "m"}, {"name": "right_tip",
"wire": "rightTip", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1},
"unit": "m"}, {"name": "stamp", "doc": "When the images were exposed.", "type": {"kind": "time",
"clock": "steady"}}, {"name": "valid", "doc": "False unless both eyes see all three.", "type": {
"kind": "Bool"}, "default": false}]}], "wire": [{"id": "@0xd18623f4fbc55b4a", "kind": "interface",
"name": "KnotVision", "cxx": "robots::KnotVision", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xe0f71ba712630172"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "sighting", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0x952267eec9de3f8a"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xe0f71ba712630172", "kind": "interface",
"name": "KnotVisionEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xfa13a8593a8dcb16"}]}]}, {"id": "@0xfa13a8593a8dcb16", "kind": "struct",
"name": "KnotVisionStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "sighting", "is": "@0x952267eec9de3f8a"}]}, {"id": "@0x952267eec9de3f8a", "kind": "struct",
"name": "KnotSighting", "members": [{"at": 0, "name": "knot",
"is": "/suture/types.capnp:Vec3 unit \"m\""}, {"at": 1, "name": "leftTip",
"is": "/suture/types.capnp:Vec3 unit \"m\""}, {"at": 2, "name": "rightTip",
"is": "/suture/types.capnp:Vec3 unit \"m\""}, {"at": 3, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 4, "name": "valid", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::KnotVision>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::KnotVision",
      .hash = "3501142906d2f97c6ee13fa414de1248",
      .description = robots::kKnotVisionDescription,
      .commands = robots::kKnotVisionCommands,
      .events = {},
      .binding = &robots::knotVisionBinding,
  };
  return kInfo;
}

Errc Provided<robots::KnotVision>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                           std::byte* result) {
  using ::robots::KnotVisionCommand;
  switch (static_cast<KnotVisionCommand>(command)) {
    case KnotVisionCommand::sighting: {
      auto& slot = newSlot<robots::KnotSightingSlot>(result);
      return store(implementation_.sighting(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
