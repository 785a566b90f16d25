// Written by suturec from vision/tracked_object.h. Do not edit.
#include "vision/tracked_object.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "vision/tracked_object.capnp.h"

// Defined in robot_types/cartesian.suture.cpp.
namespace robots {
void toWire(const TwistSlot& slot, wire::Twist::Builder out);
suture::Errc fromWire(wire::Twist::Reader in, TwistSlot& slot, suture::Duration shift);
bool isValid(const TwistSlot& slot, suture::FieldPath* path);
}  // namespace robots

// Defined in robot_types/pose.suture.cpp.
namespace robots {
void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out);
suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift);
bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path);
}  // namespace robots

namespace robots {

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
using suture::shiftSlot;
using suture::slotIn;
using suture::slotSize;

namespace {

// --- TrackedObject over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class TrackedObjectSink final : public suture::rpc::EventSink {
 public:
  explicit TrackedObjectSink(wire::TrackedObjectEvents::Client subscriber) :
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
      const auto& slot = slotIn<PoseStampedSlot>(columns[0]);
      toWire(slot, out.initMeasuredCp());
    }
    if (row.hasValue(1)) {
      const auto& slot = slotIn<TwistSlot>(columns[1]);
      toWire(slot, out.initMeasuredCv());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::TrackedObjectEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class TrackedObjectServant final : public wire::TrackedObject::Server {
 public:
  explicit TrackedObjectServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<TrackedObjectSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> measuredCp(MeasuredCpContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<PoseStampedSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(TrackedObjectCommand::measured_cp), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> measuredCv(MeasuredCvContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<TwistSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(TrackedObjectCommand::measured_cv), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- TrackedObject over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class TrackedObjectReceiver final : public wire::TrackedObjectEvents::Server {
 public:
  explicit TrackedObjectReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<PoseStampedSlot>(0);
      const Errc error =
          in.hasMeasuredCp() ? fromWire(in.getMeasuredCp(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    if (columns.hasValue(1)) {
      auto& slot = port_->column<TwistSlot>(1);
      const Errc error =
          in.hasMeasuredCv() ? fromWire(in.getMeasuredCv(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(1, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class TrackedObjectProxy final : public suture::rpc::Proxy {
 public:
  TrackedObjectProxy(wire::TrackedObject::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<TrackedObjectReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<TrackedObjectCommand>(record.command)) {
      case TrackedObjectCommand::measured_cp: {
        auto request = provider_.measuredCpRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PoseStampedSlot>(call, response.getStamp(), [&](PoseStampedSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case TrackedObjectCommand::measured_cv: {
        auto request = provider_.measuredCvRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<TwistSlot>(call, response.getStamp(), [&](TwistSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::TrackedObject::Client provider_;
  ProxyPort& port_;
};

class TrackedObjectBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<TrackedObjectServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<TrackedObjectProxy>(contract.castAs<wire::TrackedObject>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<TrackedObjectSink>(subscriber.castAs<wire::TrackedObjectEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::TrackedObject>();
  }
};

const suture::rpc::Binding& trackedObjectBinding() {
  static const TrackedObjectBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kTrackedObjectCommands[] = {
    {.name = "measured_cp",
     .kind = CommandKind::Read,
     .resultSize = slotSize<PoseStampedSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<PoseStampedSlot, isValid>,
     .shiftResult = shiftSlot<PoseStampedSlot>},
    {.name = "measured_cv",
     .kind = CommandKind::Read,
     .resultSize = slotSize<TwistSlot>,
     .depth = 16,
     .column = 1,
     .acceptsResult = checkSlot<TwistSlot, isValid>,
     .shiftResult = shiftSlot<TwistSlot>},
};

// The self-description, as in vision/tracked_object.suture.json.
constexpr char kTrackedObjectDescription[] = R"json(
{"name": "robots::TrackedObject",
"doc": "A ball in the frame of the left camera: x to the right and y downward in the image, z ahead. It\nhas no orientation, so that of its pose is the camera's.",
"hash": "6bed34eb9aee4b7278b34e35020ef06a", "crtk": true, "commands": [{"name": "measured_cp",
"kind": "read", "ordinal": 1, "wire": "measuredCp",
"doc": "Where it is at the stamp, which is the tracker's cycle: images are old when they come, and\nthis is what they showed, carried on by its velocity. Not valid unless the last pair of images\nshowed it, and not long ago.",
"result": {"type": {"kind": "struct", "name": "robots::PoseStamped"}}, "queue": 16}, {
"name": "measured_cv", "kind": "read", "ordinal": 2, "wire": "measuredCv",
"doc": "How fast it moves; valid when the pose is.", "result": {"type": {"kind": "struct",
"name": "robots::Twist"}}, "queue": 16}], "events": [], "enums": [], "structs": [{
"name": "robots::PoseStamped",
"doc": "A pose at a time: what CRTK's measured_cp, setpoint_cp and servo_cp carry.", "fields": [{
"name": "pose", "doc": "The moving frame of the interface in its reference frame.", "type": {
"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "stamp",
"doc": "When the pose was true; of a set-point, the stamp of the data it was made from.", "type": {
"kind": "time", "clock": "steady"}}, {"name": "valid", "doc": "False: do not use.", "type": {
"kind": "Bool"}, "default": false}]}, {"name": "robots::Twist",
"doc": "A velocity: CRTK's measured_cv. The cisst libraries' prmVelocityCartesianGet.", "fields": [
{"name": "linear", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1},
"unit": "m/s"}, {"name": "angular", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "rad/s"}, {"name": "moving_frame", "wire": "movingFrame", "type": {
"kind": "UInt32"}, "default": 0}, {"name": "reference_frame", "wire": "referenceFrame", "type": {
"kind": "UInt32"}, "default": 0}, {"name": "stamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "valid", "doc": "False: do not use.", "type": {"kind": "Bool"}, "default": false}]}],
"wire": [{"id": "@0xcf966e39ebac7c24", "kind": "interface", "name": "TrackedObject",
"cxx": "robots::TrackedObject", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xaefa37f144e6fbd6"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "measuredCp",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xe84bc0a4b9a0c529"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 2, "name": "measuredCv", "is": "kind \"read\"", "parameters": [{"at": 0,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "@0xaa62fba3aef11562"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xaefa37f144e6fbd6", "kind": "interface", "name": "TrackedObjectEvents", "members": [{
"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xf542a4f122cd9459"}]}]},
{"id": "@0xf542a4f122cd9459", "kind": "struct", "name": "TrackedObjectStateRow", "members": [{
"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "measuredCp", "is": "@0xe84bc0a4b9a0c529"}, {
"at": 4, "name": "measuredCv", "is": "@0xaa62fba3aef11562"}]}, {"id": "@0xe84bc0a4b9a0c529",
"kind": "struct", "name": "PoseStamped", "members": [{"at": 0, "name": "pose",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 1, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 2, "name": "valid", "is": "Bool"}]}, {
"id": "@0xaa62fba3aef11562", "kind": "struct", "name": "Twist", "members": [{"at": 0,
"name": "linear", "is": "/suture/types.capnp:Vec3 unit \"m/s\""}, {"at": 1, "name": "angular",
"is": "/suture/types.capnp:Vec3 unit \"rad/s\""}, {"at": 2, "name": "movingFrame", "is": "UInt32"},
{"at": 3, "name": "referenceFrame", "is": "UInt32"}, {"at": 4, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 5, "name": "valid", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::TrackedObject>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::TrackedObject",
      .hash = "6bed34eb9aee4b7278b34e35020ef06a",
      .description = robots::kTrackedObjectDescription,
      .commands = robots::kTrackedObjectCommands,
      .events = {},
      .binding = &robots::trackedObjectBinding,
  };
  return kInfo;
}

Errc Provided<robots::TrackedObject>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                              std::byte* result) {
  using ::robots::TrackedObjectCommand;
  switch (static_cast<TrackedObjectCommand>(command)) {
    case TrackedObjectCommand::measured_cp: {
      auto& slot = newSlot<robots::PoseStampedSlot>(result);
      return store(implementation_.measured_cp(), slot) ? Errc{} : Errc::TooLarge;
    }
    case TrackedObjectCommand::measured_cv: {
      auto& slot = newSlot<robots::TwistSlot>(result);
      return store(implementation_.measured_cv(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
