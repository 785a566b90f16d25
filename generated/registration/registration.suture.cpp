// Written by suturec from registration/registration.h. Do not edit.
#include "registration/registration.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "registration/registration.capnp.h"

namespace robots {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Duration;
using suture::Errc;
using suture::FieldPath;
using suture::checkSlot;
using suture::load;
using suture::newSlot;
using suture::refusedAt;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::firstError;
using suture::rpc::fromDefault;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::slotIn;
using suture::slotSize;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(SceneFrames::left_base), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(SceneFrames::right_base), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(SceneFrames::camera), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(SceneFrames::tissue), double>);
static_assert(std::is_same_v<decltype(SceneFrames::left_master), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(SceneFrames::right_master), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(SceneFrames::display), Eigen::Isometry3d>);

}  // namespace

bool store(const SceneFrames& value, SceneFramesSlot& slot) {
  bool fits = true;
  fits &= store(value.left_base, slot.left_base);
  fits &= store(value.right_base, slot.right_base);
  fits &= store(value.camera, slot.camera);
  fits &= store(value.tissue, slot.tissue);
  fits &= store(value.left_master, slot.left_master);
  fits &= store(value.right_master, slot.right_master);
  fits &= store(value.display, slot.display);
  return fits;
}

void load(const SceneFramesSlot& slot, SceneFrames& value) {
  load(slot.left_base, value.left_base);
  load(slot.right_base, value.right_base);
  load(slot.camera, value.camera);
  load(slot.tissue, value.tissue);
  load(slot.left_master, value.left_master);
  load(slot.right_master, value.right_master);
  load(slot.display, value.display);
}

bool store(const Eigen::Isometry3d& camera, RegistrationSetCameraArguments& slot) {
  return store(camera, slot.camera);
}

// --- between slots and Cap'n Proto

void toWire(const SceneFramesSlot& slot, wire::SceneFrames::Builder out) {
  toWire(slot.left_base, out.initLeftBase());
  toWire(slot.right_base, out.initRightBase());
  toWire(slot.camera, out.initCamera());
  out.setTissue(slot.tissue);
  toWire(slot.left_master, out.initLeftMaster());
  toWire(slot.right_master, out.initRightMaster());
  toWire(slot.display, out.initDisplay());
}

Errc fromWire(wire::SceneFrames::Reader in, SceneFramesSlot& slot, Duration) {
  slot.tissue = in.getTissue();
  return firstError({
      in.hasLeftBase() ? fromWire(in.getLeftBase(), slot.left_base)
          : fromDefault(SceneFrames().left_base, slot.left_base),
      in.hasRightBase() ? fromWire(in.getRightBase(), slot.right_base)
          : fromDefault(SceneFrames().right_base, slot.right_base),
      in.hasCamera() ? fromWire(in.getCamera(), slot.camera)
          : fromDefault(SceneFrames().camera, slot.camera),
      in.hasLeftMaster() ? fromWire(in.getLeftMaster(), slot.left_master)
          : fromDefault(SceneFrames().left_master, slot.left_master),
      in.hasRightMaster() ? fromWire(in.getRightMaster(), slot.right_master)
          : fromDefault(SceneFrames().right_master, slot.right_master),
      in.hasDisplay() ? fromWire(in.getDisplay(), slot.display)
          : fromDefault(SceneFrames().display, slot.display),
  });
}

bool isValid(const SceneFramesSlot& slot, FieldPath* path) {
  if (!isValid(slot.left_base)) return refusedAt(path, "left_base");
  if (!isValid(slot.right_base)) return refusedAt(path, "right_base");
  if (!isValid(slot.camera)) return refusedAt(path, "camera");
  if (!isValid(slot.tissue)) return refusedAt(path, "tissue");
  if (!isValid(slot.left_master)) return refusedAt(path, "left_master");
  if (!isValid(slot.right_master)) return refusedAt(path, "right_master");
  return isValid(slot.display) || refusedAt(path, "display");
}

namespace {

bool acceptsRegistrationSetCamera(const RegistrationSetCameraArguments& slot, FieldPath* path) {
  return isValid(slot.camera) || refusedAt(path, "camera");
}

// --- Registration over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class RegistrationSink final : public suture::rpc::EventSink {
 public:
  explicit RegistrationSink(wire::RegistrationEvents::Client subscriber) :
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
      const auto& slot = slotIn<SceneFramesSlot>(columns[0]);
      toWire(slot, out.initFrames());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::RegistrationEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class RegistrationServant final : public wire::Registration::Server {
 public:
  explicit RegistrationServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<RegistrationSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> frames(FramesContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<SceneFramesSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(RegistrationCommand::frames), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> setCamera(SetCameraContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<RegistrationSetCameraArguments>(memory);
      return in.hasCamera() ? fromWire(in.getCamera(), slot.camera) : Errc::Invalid;
    };
    return port_->command(numberOf(RegistrationCommand::set_camera), in.getSent(), fill);
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- Registration over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class RegistrationReceiver final : public wire::RegistrationEvents::Server {
 public:
  explicit RegistrationReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<SceneFramesSlot>(0);
      const Errc error =
          in.hasFrames() ? fromWire(in.getFrames(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class RegistrationProxy final : public suture::rpc::Proxy {
 public:
  RegistrationProxy(wire::Registration::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<RegistrationReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<RegistrationCommand>(record.command)) {
      case RegistrationCommand::frames: {
        auto request = provider_.framesRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<SceneFramesSlot>(call, response.getStamp(), [&](SceneFramesSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case RegistrationCommand::set_camera: {
        const auto& slot = slotIn<RegistrationSetCameraArguments>(record.arguments());
        auto request = provider_.setCameraRequest();
        toWire(slot.camera, request.initCamera());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::Registration::Client provider_;
  ProxyPort& port_;
};

class RegistrationBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<RegistrationServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<RegistrationProxy>(contract.castAs<wire::Registration>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<RegistrationSink>(subscriber.castAs<wire::RegistrationEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::Registration>();
  }
};

const suture::rpc::Binding& registrationBinding() {
  static const RegistrationBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kRegistrationCommands[] = {
    {.name = "frames",
     .kind = CommandKind::Read,
     .resultSize = slotSize<SceneFramesSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<SceneFramesSlot, isValid>},
    {.name = "set_camera",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<RegistrationSetCameraArguments>,
     .depth = 16,
     .accepts = checkSlot<RegistrationSetCameraArguments, acceptsRegistrationSetCamera>},
};

// The self-description, as in registration/registration.suture.json.
constexpr char kRegistrationDescription[] = R"json(
{"name": "robots::Registration", "doc": "Commands run in the registration's own thread.",
"hash": "ab7f70fec1652e961132ed089669aac1", "commands": [{"name": "frames", "kind": "read",
"ordinal": 1,
"doc": "As they were registered last; each rotation is one to 1e-6. Ask with `frames.at(stamp)` for\nwhat an image or a pose of that stamp belongs to.",
"result": {"type": {"kind": "struct", "name": "robots::SceneFrames"}}, "queue": 16}, {
"name": "set_camera", "kind": "write", "ordinal": 2, "wire": "setCamera",
"doc": "The left camera has been moved to there. Ignored, with a warning, unless its rotation is one.",
"parameters": [{"name": "camera", "type": {"kind": "isometry", "scalar": "Float64"}, "unit": "m"}],
"queue": 16}], "events": [], "enums": [], "structs": [{"name": "robots::SceneFrames",
"doc": "Where things are: slaves and camera in the frame of the scene, whose z points away from the\ntissue; masters and display in that of the console.",
"fields": [{"name": "left_base", "wire": "leftBase", "type": {"kind": "isometry",
"scalar": "Float64"}, "unit": "m"}, {"name": "right_base", "wire": "rightBase", "type": {
"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "camera",
"doc": "The left camera: x to the right and y downward in the image, z ahead.", "type": {
"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "tissue",
"doc": "The tissue's surface: its z.", "type": {"kind": "Float64"}, "unit": "m", "default": -0.16},
{"name": "left_master", "wire": "leftMaster", "type": {"kind": "isometry", "scalar": "Float64"},
"unit": "m"}, {"name": "right_master", "wire": "rightMaster", "type": {"kind": "isometry",
"scalar": "Float64"}, "unit": "m"}, {"name": "display",
"doc": "The picture that the surgeon looks at, with the axes of the camera: x to the right and y\ndownward in it, z ahead.",
"type": {"kind": "isometry", "scalar": "Float64"}, "unit": "m"}]}], "wire": [{
"id": "@0xe9484f8fbd271c3f", "kind": "interface", "name": "Registration",
"cxx": "robots::Registration", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xead83c2c10b9a601"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "frames", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xe63e7e972f06e442"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 2, "name": "setCamera", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "camera",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}]}, {"id": "@0xead83c2c10b9a601", "kind": "interface",
"name": "RegistrationEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xf672b219e7b88cf8"}]}]}, {"id": "@0xf672b219e7b88cf8", "kind": "struct",
"name": "RegistrationStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "frames", "is": "@0xe63e7e972f06e442"}]}, {"id": "@0xe63e7e972f06e442", "kind": "struct",
"name": "SceneFrames", "members": [{"at": 0, "name": "leftBase",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 1, "name": "rightBase",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 2, "name": "camera",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 3, "name": "tissue",
"is": "Float64 unit \"m\" = -0.16"}, {"at": 4, "name": "leftMaster",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 5, "name": "rightMaster",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 6, "name": "display",
"is": "/suture/types.capnp:Pose unit \"m\""}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Registration>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::Registration",
      .hash = "ab7f70fec1652e961132ed089669aac1",
      .description = robots::kRegistrationDescription,
      .commands = robots::kRegistrationCommands,
      .events = {},
      .binding = &robots::registrationBinding,
  };
  return kInfo;
}

Errc Provided<robots::Registration>::execute(std::uint16_t command, const std::byte* arguments,
                                             std::byte* result) {
  using ::robots::RegistrationCommand;
  switch (static_cast<RegistrationCommand>(command)) {
    case RegistrationCommand::frames: {
      auto& slot = newSlot<robots::SceneFramesSlot>(result);
      return store(implementation_.frames(), slot) ? Errc{} : Errc::TooLarge;
    }
    case RegistrationCommand::set_camera: {
      const auto& slot = slotIn<robots::RegistrationSetCameraArguments>(arguments);
      load(slot.camera, scratch_.set_camera_camera);
      implementation_.set_camera(scratch_.set_camera_camera);
      return Errc{};
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
