// Written by suturec from vision/stereo_images.h. Do not edit.
#include "vision/stereo_images.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "vision/stereo_images.capnp.h"

// Defined in robot_types/vision.suture.cpp.
namespace robots {
void toWire(const ImageFrameSlot& slot, wire::ImageFrame::Builder out);
suture::Errc fromWire(wire::ImageFrame::Reader in, ImageFrameSlot& slot, suture::Duration shift);
bool isValid(const ImageFrameSlot& slot, suture::FieldPath* path);
}  // namespace robots

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
static_assert(std::is_same_v<decltype(StereoPair::left), ImageFrame>);
static_assert(std::is_same_v<decltype(StereoPair::right), ImageFrame>);

}  // namespace

bool store(const StereoPair& value, StereoPairSlot& slot) {
  bool fits = true;
  fits &= store(value.left, slot.left);
  fits &= store(value.right, slot.right);
  return fits;
}

void load(const StereoPairSlot& slot, StereoPair& value) {
  load(slot.left, value.left);
  load(slot.right, value.right);
}

void reserve(const StereoPairSlot*, StereoPair& value) {
  suture::reserveFor<decltype(StereoPairSlot::left)>(value.left);
  suture::reserveFor<decltype(StereoPairSlot::right)>(value.right);
}

void shiftStamps(StereoPairSlot& slot, Duration shift) {
  shiftStamps(slot.left, shift);
  shiftStamps(slot.right, shift);
}

// --- between slots and Cap'n Proto

void toWire(const StereoPairSlot& slot, wire::StereoPair::Builder out) {
  toWire(slot.left, out.initLeft());
  toWire(slot.right, out.initRight());
}

Errc fromWire(wire::StereoPair::Reader in, StereoPairSlot& slot, Duration shift) {
  return firstError({
      fromWire(in.getLeft(), slot.left, shift),
      fromWire(in.getRight(), slot.right, shift),
  });
}

bool isValid(const StereoPairSlot& slot, FieldPath* path) {
  if (!isValid(slot.left, path)) return refusedAt(path, "left");
  return isValid(slot.right, path) || refusedAt(path, "right");
}

namespace {

// --- StereoImages over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class StereoImagesSink final : public suture::rpc::EventSink {
 public:
  explicit StereoImagesSink(wire::StereoImagesEvents::Client subscriber) :
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
      const auto& slot = slotIn<StereoPairSlot>(columns[0]);
      toWire(slot, out.initImages());
    }
    if (row.hasValue(1)) {
      const auto& slot = slotIn<std::int64_t>(columns[1]);
      out.setExposed(slot);
    }
    return request.send().ignoreResult();
  }

 private:
  wire::StereoImagesEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class StereoImagesServant final : public wire::StereoImages::Server {
 public:
  explicit StereoImagesServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<StereoImagesSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> images(ImagesContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<StereoPairSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(StereoImagesCommand::images), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> exposed(ExposedContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<std::int64_t>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(StereoImagesCommand::exposed), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- StereoImages over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class StereoImagesReceiver final : public wire::StereoImagesEvents::Server {
 public:
  explicit StereoImagesReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<StereoPairSlot>(0);
      const Errc error =
          in.hasImages() ? fromWire(in.getImages(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    if (columns.hasValue(1)) {
      auto& slot = port_->column<std::int64_t>(1);
      slot = suture::rpc::shifted(in.getExposed(), port_->shift());
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class StereoImagesProxy final : public suture::rpc::Proxy {
 public:
  StereoImagesProxy(wire::StereoImages::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<StereoImagesReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<StereoImagesCommand>(record.command)) {
      case StereoImagesCommand::images: {
        auto request = provider_.imagesRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<StereoPairSlot>(call, response.getStamp(), [&](StereoPairSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case StereoImagesCommand::exposed: {
        auto request = provider_.exposedRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::int64_t>(call, response.getStamp(), [&](std::int64_t& answer) {
            answer = suture::rpc::shifted(response.getValue(), port_.shift());
            return Errc{};
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::StereoImages::Client provider_;
  ProxyPort& port_;
};

class StereoImagesBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<StereoImagesServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<StereoImagesProxy>(contract.castAs<wire::StereoImages>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<StereoImagesSink>(subscriber.castAs<wire::StereoImagesEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::StereoImages>();
  }
};

const suture::rpc::Binding& stereoImagesBinding() {
  static const StereoImagesBinding kBinding;
  return kBinding;
}

void shiftStereoImagesExposedResult(std::int64_t& slot, Duration shift) {
  slot = shifted(slot, shift);
}

constexpr CommandInfo kStereoImagesCommands[] = {
    {.name = "images",
     .kind = CommandKind::Read,
     .resultSize = slotSize<StereoPairSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<StereoPairSlot, isValid>,
     .shiftResult = shiftSlot<StereoPairSlot>},
    {.name = "exposed",
     .kind = CommandKind::Read,
     .resultSize = slotSize<std::int64_t>,
     .depth = 16,
     .column = 1,
     .shiftResult = shiftSlot<std::int64_t, shiftStereoImagesExposedResult>},
};

// The self-description, as in vision/stereo_images.suture.json.
constexpr char kStereoImagesDescription[] = R"json(
{"name": "robots::StereoImages", "hash": "afed174675115ccf925dea30a59e7bd5", "commands": [{
"name": "images", "kind": "read", "ordinal": 1,
"doc": "The last pair; invalid while there is nothing to see.", "result": {"type": {
"kind": "struct", "name": "robots::StereoPair"}}, "queue": 16}, {"name": "exposed", "kind": "read",
"ordinal": 2,
"doc": "The stamp of the last pair, and 0 while there is nothing to see: who asks this first copies\nmegabytes only if they are new.",
"result": {"type": {"kind": "time", "clock": "steady"}}, "queue": 16}], "events": [], "enums": [],
"structs": [{"name": "robots::ImageFrame", "doc": "prmImageFrame.", "fields": [{"name": "width",
"type": {"kind": "UInt32"}, "default": 0}, {"name": "height", "type": {"kind": "UInt32"},
"default": 0}, {"name": "channels", "type": {"kind": "UInt32"}, "default": 0}, {"name": "data",
"doc": "Row by row, channels interleaved, 8 bits each.", "type": {"kind": "list", "element": {
"kind": "UInt8"}, "capacity": 2097152}}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}, {"name": "valid", "type": {"kind": "Bool"}, "default": false}]}, {
"name": "robots::StereoPair",
"doc": "Two rectified images of one moment; both stamps are that of the exposure.", "fields": [{
"name": "left", "type": {"kind": "struct", "name": "robots::ImageFrame"}}, {"name": "right",
"type": {"kind": "struct", "name": "robots::ImageFrame"}}]}], "wire": [{
"id": "@0xefa57eee714fcf37", "kind": "interface", "name": "StereoImages",
"cxx": "robots::StereoImages", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xed57a378bacd9ffb"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "images", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xc5ad7542a285d330"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 2, "name": "exposed", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Int64 clock \"steady\""}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xed57a378bacd9ffb", "kind": "interface", "name": "StereoImagesEvents", "members": [{
"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xe5a2d9c7d98a1e0c"}]}]},
{"id": "@0xe5a2d9c7d98a1e0c", "kind": "struct", "name": "StereoImagesStateRow", "members": [{
"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "images", "is": "@0xc5ad7542a285d330"}, {
"at": 4, "name": "exposed", "is": "Int64 clock \"steady\""}]}, {"id": "@0xc5ad7542a285d330",
"kind": "struct", "name": "StereoPair", "members": [{"at": 0, "name": "left",
"is": "@0xbc8f68d82913b3fb"}, {"at": 1, "name": "right", "is": "@0xbc8f68d82913b3fb"}]}, {
"id": "@0xbc8f68d82913b3fb", "kind": "struct", "name": "ImageFrame", "members": [{"at": 0,
"name": "width", "is": "UInt32"}, {"at": 1, "name": "height", "is": "UInt32"}, {"at": 2,
"name": "channels", "is": "UInt32"}, {"at": 3, "name": "data", "is": "Data"}, {"at": 4,
"name": "stamp", "is": "Int64 clock \"steady\""}, {"at": 5, "name": "valid", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::StereoImages>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::StereoImages",
      .hash = "afed174675115ccf925dea30a59e7bd5",
      .description = robots::kStereoImagesDescription,
      .commands = robots::kStereoImagesCommands,
      .events = {},
      .binding = &robots::stereoImagesBinding,
  };
  return kInfo;
}

Errc Provided<robots::StereoImages>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                             std::byte* result) {
  using ::robots::StereoImagesCommand;
  switch (static_cast<StereoImagesCommand>(command)) {
    case StereoImagesCommand::images: {
      auto& slot = newSlot<robots::StereoPairSlot>(result);
      return store(implementation_.images(), slot) ? Errc{} : Errc::TooLarge;
    }
    case StereoImagesCommand::exposed: {
      auto& slot = newSlot<std::int64_t>(result);
      return store(implementation_.exposed(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
