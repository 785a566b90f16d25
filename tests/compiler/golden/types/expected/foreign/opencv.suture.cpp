// Written by suturec from foreign/opencv.h. Do not edit.
#include "foreign/opencv.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "foreign/opencv.capnp.h"

namespace foreign {

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
using suture::rpc::allOf;
using suture::rpc::firstError;
using suture::rpc::fromDefault;
using suture::rpc::fromWire;
using suture::rpc::fromWireList;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::rpc::toWireList;
using suture::slotIn;
using suture::slotSize;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(cv::Point3d::x), double>);
static_assert(std::is_same_v<decltype(cv::Point3d::y), double>);
static_assert(std::is_same_v<decltype(cv::Point3d::z), double>);
static_assert(std::is_same_v<decltype(cv::Matx33d::val), double[9]>);
static_assert(std::is_same_v<decltype(View::intrinsics), cv::Matx33d>);
static_assert(std::is_same_v<decltype(View::points), std::vector<cv::Point3d>>);

}  // namespace

bool store(const cv::Point3d& value, cvPoint3dSlot& slot) {
  bool fits = true;
  fits &= store(value.x, slot.x);
  fits &= store(value.y, slot.y);
  fits &= store(value.z, slot.z);
  return fits;
}

void load(const cvPoint3dSlot& slot, cv::Point3d& value) {
  load(slot.x, value.x);
  load(slot.y, value.y);
  load(slot.z, value.z);
}

bool store(const cv::Matx33d& value, cvMatx33dSlot& slot) {
  bool fits = true;
  fits &= store(value.val, slot.val);
  return fits;
}

void load(const cvMatx33dSlot& slot, cv::Matx33d& value) {
  load(slot.val, value.val);
}

bool store(const View& value, ViewSlot& slot) {
  bool fits = true;
  fits &= store(value.intrinsics, slot.intrinsics);
  fits &= store(value.points, slot.points);
  return fits;
}

void load(const ViewSlot& slot, View& value) {
  load(slot.intrinsics, value.intrinsics);
  load(slot.points, value.points);
}

void reserve(const ViewSlot*, View& value) {
  suture::reserveFor<decltype(ViewSlot::points)>(value.points);
}

bool store(const cv::Point3d& at, CameraAimArguments& slot) { return store(at, slot.at); }

// --- between slots and Cap'n Proto

void toWire(const cvPoint3dSlot& slot, wire::Point3d::Builder out) {
  out.setX(slot.x);
  out.setY(slot.y);
  out.setZ(slot.z);
}

Errc fromWire(wire::Point3d::Reader in, cvPoint3dSlot& slot, Duration) {
  slot.x = in.getX();
  slot.y = in.getY();
  slot.z = in.getZ();
  return Errc{};
}

bool isValid(const cvPoint3dSlot& slot, FieldPath* path) {
  if (!isValid(slot.x)) return refusedAt(path, "x");
  if (!isValid(slot.y)) return refusedAt(path, "y");
  return isValid(slot.z) || refusedAt(path, "z");
}

void toWire(const cvMatx33dSlot& slot, wire::Matx33d::Builder out) {
  toWire(slot.val, out.initVal(9));
}

Errc fromWire(wire::Matx33d::Reader in, cvMatx33dSlot& slot, Duration) {
  return in.getVal().size() != 0 ? fromWire(in.getVal(), slot.val)
      : fromDefault(cv::Matx33d().val, slot.val);
}

bool isValid(const cvMatx33dSlot& slot, FieldPath* path) {
  return isValid(slot.val, path) || refusedAt(path, "val");
}

void toWire(const ViewSlot& slot, wire::View::Builder out) {
  toWire(slot.intrinsics, out.initIntrinsics());
  toWireList(slot.points, out.initPoints(slot.points.size),
             [](const cvPoint3dSlot& element, auto list, std::uint32_t i) {
               toWire(element, list[i]);
             });
}

Errc fromWire(wire::View::Reader in, ViewSlot& slot, Duration shift) {
  return firstError({
      fromWire(in.getIntrinsics(), slot.intrinsics, shift),
      fromWireList(in.getPoints(), slot.points, [&](auto item, cvPoint3dSlot& target) {
        return fromWire(item, target, shift);
      }),
  });
}

bool isValid(const ViewSlot& slot, FieldPath* path) {
  if (!isValid(slot.intrinsics, path)) return refusedAt(path, "intrinsics");
  if (!allOf(slot.points, path, [path](const cvPoint3dSlot& element) {
    return isValid(element, path);
  })) {
    return refusedAt(path, "points");
  }
  return true;
}

namespace {

bool acceptsCameraAim(const CameraAimArguments& slot, FieldPath* path) {
  return isValid(slot.at, path) || refusedAt(path, "at");
}

// --- Camera over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class CameraSink final : public suture::rpc::EventSink {
 public:
  explicit CameraSink(wire::CameraEvents::Client subscriber) : subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t, const std::byte*) override { return kj::READY_NOW; }

  kj::Promise<void> row(const suture::rt::StateTable::Row& row,
                        std::span<const std::byte* const> columns) override {
    auto request = subscriber_.stateRequest();
    auto out = request.initRow();
    out.setStamp(suture::toNanoseconds(row.stamp));
    out.setEvaluated(row.valid | row.invalid);
    out.setTooLarge(row.tooLarge | row.invalid);
    if (row.hasValue(0)) {
      const auto& slot = slotIn<ViewSlot>(columns[0]);
      toWire(slot, out.initView());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::CameraEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class CameraServant final : public wire::Camera::Server {
 public:
  explicit CameraServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<CameraSink>(in.getEvents()), in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> aim(AimContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<CameraAimArguments>(memory);
      return in.hasAt() ? fromWire(in.getAt(), slot.at, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(CameraCommand::aim), in.getSent(), fill);
  }

  kj::Promise<void> view(ViewContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<ViewSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(CameraCommand::view), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- Camera over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class CameraReceiver final : public wire::CameraEvents::Server {
 public:
  explicit CameraReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<ViewSlot>(0);
      const Errc error =
          in.hasView() ? fromWire(in.getView(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class CameraProxy final : public suture::rpc::Proxy {
 public:
  CameraProxy(wire::Camera::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<CameraReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<CameraCommand>(record.command)) {
      case CameraCommand::aim: {
        const auto& slot = slotIn<CameraAimArguments>(record.arguments());
        auto request = provider_.aimRequest();
        toWire(slot.at, request.initAt());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case CameraCommand::view: {
        auto request = provider_.viewRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<ViewSlot>(call, response.getStamp(), [&](ViewSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::Camera::Client provider_;
  ProxyPort& port_;
};

class CameraBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<CameraServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<CameraProxy>(contract.castAs<wire::Camera>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<CameraSink>(subscriber.castAs<wire::CameraEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::Camera>();
  }
};

const suture::rpc::Binding& cameraBinding() {
  static const CameraBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kCameraCommands[] = {
    {.name = "aim",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<CameraAimArguments>,
     .depth = 16,
     .accepts = checkSlot<CameraAimArguments, acceptsCameraAim>},
    {.name = "view",
     .kind = CommandKind::Read,
     .resultSize = slotSize<ViewSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<ViewSlot, isValid>},
};

// The self-description, as in foreign/opencv.suture.json.
constexpr char kCameraDescription[] = R"json(
{"name": "foreign::Camera", "doc": "Both sides of it.", "hash": "bcb581c6a70161984896ecf6f6b5db2e",
"commands": [{"name": "aim", "kind": "write", "ordinal": 1, "parameters": [{"name": "at", "type": {
"kind": "struct", "name": "cv::Point3d"}}], "queue": 16}, {"name": "view", "kind": "read",
"ordinal": 2, "result": {"type": {"kind": "struct", "name": "foreign::View"}}, "queue": 16}],
"events": [], "enums": [], "structs": [{"name": "cv::Point3d", "fields": [{"name": "x", "type": {
"kind": "Float64"}}, {"name": "y", "type": {"kind": "Float64"}}, {"name": "z", "type": {
"kind": "Float64"}}]}, {"name": "cv::Matx33d", "fields": [{"name": "val", "type": {"kind": "array",
"element": {"kind": "Float64"}, "length": 9}}]}, {"name": "foreign::View",
"doc": "A camera and what it sees.", "fields": [{"name": "intrinsics", "type": {"kind": "struct",
"name": "cv::Matx33d"}}, {"name": "points", "type": {"kind": "list", "element": {"kind": "struct",
"name": "cv::Point3d"}, "capacity": 4}}]}], "wire": [{"id": "@0xe5bd0c82c54c1c8c",
"kind": "interface", "name": "Camera", "cxx": "foreign::Camera", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0x8cac637286976832"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {
"at": 1, "name": "aim", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "at",
"is": "@0xd72865b36936b2ff"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 2, "name": "view", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xc334e999633b131f"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0x8cac637286976832", "kind": "interface",
"name": "CameraEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xb20e8f123205e142"}]}]}, {"id": "@0xb20e8f123205e142", "kind": "struct",
"name": "CameraStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "view", "is": "@0xc334e999633b131f"}]}, {"id": "@0xc334e999633b131f", "kind": "struct",
"name": "View", "members": [{"at": 0, "name": "intrinsics", "is": "@0xdd860d932d3f8de3"}, {"at": 1,
"name": "points", "is": "List(@0xd72865b36936b2ff)"}]}, {"id": "@0xdd860d932d3f8de3",
"kind": "struct", "name": "Matx33d", "members": [{"at": 0, "name": "val",
"is": "List(Float64) shape \"9\""}]}, {"id": "@0xd72865b36936b2ff", "kind": "struct",
"name": "Point3d", "members": [{"at": 0, "name": "x", "is": "Float64"}, {"at": 1, "name": "y",
"is": "Float64"}, {"at": 2, "name": "z", "is": "Float64"}]}]})json";

}  // namespace
}  // namespace foreign

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<foreign::Camera>() {
  static constexpr InterfaceInfo kInfo{
      .name = "foreign::Camera",
      .hash = "bcb581c6a70161984896ecf6f6b5db2e",
      .description = foreign::kCameraDescription,
      .commands = foreign::kCameraCommands,
      .events = {},
      .binding = &foreign::cameraBinding,
  };
  return kInfo;
}

Errc Provided<foreign::Camera>::execute(std::uint16_t command, const std::byte* arguments,
                                        std::byte* result) {
  using ::foreign::CameraCommand;
  switch (static_cast<CameraCommand>(command)) {
    case CameraCommand::aim: {
      const auto& slot = slotIn<foreign::CameraAimArguments>(arguments);
      load(slot.at, scratch_.aim_at);
      implementation_.aim(scratch_.aim_at);
      return Errc{};
    }
    case CameraCommand::view: {
      auto& slot = newSlot<foreign::ViewSlot>(result);
      return store(implementation_.view(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
