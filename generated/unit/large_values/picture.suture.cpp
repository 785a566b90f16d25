// Written by suturec from unit/large_values/picture.h. Do not edit.
#include "unit/large_values/picture.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "unit/large_values/picture.capnp.h"

namespace large_values {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Duration;
using suture::Errc;
using suture::EventInfo;
using suture::FieldPath;
using suture::checkSlot;
using suture::load;
using suture::newSlot;
using suture::refusedAt;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::slotIn;
using suture::slotSize;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(Picture::pixels), std::vector<std::uint8_t>>);

}  // namespace

bool store(const Picture& value, PictureSlot& slot) {
  bool fits = true;
  fits &= store(value.pixels, slot.pixels);
  return fits;
}

void load(const PictureSlot& slot, Picture& value) {
  load(slot.pixels, value.pixels);
}

void reserve(const PictureSlot*, Picture& value) {
  suture::reserveFor<decltype(PictureSlot::pixels)>(value.pixels);
}

bool store(const Picture& picture, GalleryDimmedArguments& slot) {
  return store(picture, slot.picture);
}

bool store(const Picture& picture, GalleryHangArguments& slot) {
  return store(picture, slot.picture);
}

// --- between slots and Cap'n Proto

void toWire(const PictureSlot& slot, wire::Picture::Builder out) {
  toWire(slot.pixels, out.initPixels(slot.pixels.size));
}

Errc fromWire(wire::Picture::Reader in, PictureSlot& slot, Duration) {
  return fromWire(in.getPixels(), slot.pixels);
}

bool isValid(const PictureSlot&, FieldPath*) {
  return true;
}

namespace {

bool acceptsGalleryDimmed(const GalleryDimmedArguments& slot, FieldPath* path) {
  return isValid(slot.picture, path) || refusedAt(path, "picture");
}

bool acceptsGalleryHang(const GalleryHangArguments& slot, FieldPath* path) {
  return isValid(slot.picture, path) || refusedAt(path, "picture");
}

// --- Gallery over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class GallerySink final : public suture::rpc::EventSink {
 public:
  explicit GallerySink(wire::GalleryEvents::Client subscriber) : subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(GalleryEvent::hung): {
        const auto& slot = slotIn<PictureSlot>(payload);
        auto request = subscriber_.hungRequest();
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
      const auto& slot = slotIn<PictureSlot>(columns[0]);
      toWire(slot, out.initNewest());
    }
    if (row.hasValue(1)) {
      const auto& slot = slotIn<PictureSlot>(columns[1]);
      toWire(slot, out.initOldest());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::GalleryEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class GalleryServant final : public wire::Gallery::Server {
 public:
  explicit GalleryServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<GallerySink>(in.getEvents()), in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> newest(NewestContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<PictureSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(GalleryCommand::newest), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> oldest(OldestContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<PictureSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(GalleryCommand::oldest), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> dimmed(DimmedContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<GalleryDimmedArguments>(memory);
      return in.hasPicture() ? fromWire(in.getPicture(), slot.picture, port_->shift())
          : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<PictureSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(GalleryCommand::dimmed), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> hang(HangContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<GalleryHangArguments>(memory);
      return in.hasPicture() ? fromWire(in.getPicture(), slot.picture, port_->shift())
          : Errc::Invalid;
    };
    return port_->command(numberOf(GalleryCommand::hang), in.getSent(), fill);
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- Gallery over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class GalleryReceiver final : public wire::GalleryEvents::Server {
 public:
  explicit GalleryReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<PictureSlot>(0);
      const Errc error =
          in.hasNewest() ? fromWire(in.getNewest(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    if (columns.hasValue(1)) {
      auto& slot = port_->column<PictureSlot>(1);
      const Errc error =
          in.hasOldest() ? fromWire(in.getOldest(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(1, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> hung(HungContext context) override {
    auto in = context.getParams();
    return port_->event<PictureSlot>(numberOf(GalleryEvent::hung), [&](PictureSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class GalleryProxy final : public suture::rpc::Proxy {
 public:
  GalleryProxy(wire::Gallery::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<GalleryReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<GalleryCommand>(record.command)) {
      case GalleryCommand::newest: {
        auto request = provider_.newestRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PictureSlot>(call, response.getStamp(), [&](PictureSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case GalleryCommand::oldest: {
        auto request = provider_.oldestRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PictureSlot>(call, response.getStamp(), [&](PictureSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case GalleryCommand::dimmed: {
        const auto& slot = slotIn<GalleryDimmedArguments>(record.arguments());
        auto request = provider_.dimmedRequest();
        toWire(slot.picture, request.initPicture());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<PictureSlot>(call, [&](PictureSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case GalleryCommand::hang: {
        const auto& slot = slotIn<GalleryHangArguments>(record.arguments());
        auto request = provider_.hangRequest();
        toWire(slot.picture, request.initPicture());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::Gallery::Client provider_;
  ProxyPort& port_;
};

class GalleryBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<GalleryServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<GalleryProxy>(contract.castAs<wire::Gallery>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<GallerySink>(subscriber.castAs<wire::GalleryEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::Gallery>();
  }
};

const suture::rpc::Binding& galleryBinding() {
  static const GalleryBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kGalleryCommands[] = {
    {.name = "newest",
     .kind = CommandKind::Read,
     .resultSize = slotSize<PictureSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<PictureSlot, isValid>},
    {.name = "oldest",
     .kind = CommandKind::Read,
     .resultSize = slotSize<PictureSlot>,
     .depth = 16,
     .column = 1,
     .acceptsResult = checkSlot<PictureSlot, isValid>},
    {.name = "dimmed",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = slotSize<GalleryDimmedArguments>,
     .resultSize = slotSize<PictureSlot>,
     .depth = 16,
     .accepts = checkSlot<GalleryDimmedArguments, acceptsGalleryDimmed>,
     .acceptsResult = checkSlot<PictureSlot, isValid>},
    {.name = "hang",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<GalleryHangArguments>,
     .depth = 2,
     .accepts = checkSlot<GalleryHangArguments, acceptsGalleryHang>},
};

constexpr EventInfo kGalleryEvents[] = {
    {.name = "hung",
     .payloadSize = slotSize<PictureSlot>,
     .depth = 16,
     .latest = true,
     .accepts = checkSlot<PictureSlot, isValid>},
};

// The self-description, as in unit/large_values/picture.suture.json.
constexpr char kGalleryDescription[] = R"json(
{"name": "large_values::Gallery", "hash": "c27c4c87013183d160e67b10a27a6a3f", "commands": [{
"name": "newest", "kind": "read", "ordinal": 1, "result": {"type": {"kind": "struct",
"name": "large_values::Picture"}}, "queue": 16}, {"name": "oldest", "kind": "read", "ordinal": 2,
"result": {"type": {"kind": "struct", "name": "large_values::Picture"}}, "queue": 16}, {
"name": "dimmed", "kind": "qualified read", "ordinal": 3, "parameters": [{"name": "picture",
"type": {"kind": "struct", "name": "large_values::Picture"}}], "result": {"type": {
"kind": "struct", "name": "large_values::Picture"}}, "queue": 16}, {"name": "hang", "kind": "write",
"ordinal": 4, "parameters": [{"name": "picture", "type": {"kind": "struct",
"name": "large_values::Picture"}}], "queue": 2}], "events": [{"name": "hung", "kind": "write",
"ordinal": 1, "payload": {"type": {"kind": "struct", "name": "large_values::Picture"}}, "queue": 16,
"latest": true}], "enums": [], "structs": [{"name": "large_values::Picture", "fields": [{
"name": "pixels", "type": {"kind": "list", "element": {"kind": "UInt8"}, "capacity": 1048576}}]}],
"wire": [{"id": "@0x8fb9bfa9541b2aa5", "kind": "interface", "name": "Gallery",
"cxx": "large_values::Gallery", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xc01f74a8ea49ad06"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "newest", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xe2f1b542ae737d95"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 2, "name": "oldest", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xe2f1b542ae737d95"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 3, "name": "dimmed",
"is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "picture",
"is": "@0xe2f1b542ae737d95"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xe2f1b542ae737d95"}]}, {"at": 4, "name": "hang",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "picture", "is": "@0xe2f1b542ae737d95"}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}]}, {"id": "@0xc01f74a8ea49ad06",
"kind": "interface", "name": "GalleryEvents", "members": [{"at": 0, "name": "state", "parameters": [
{"at": 0, "name": "row", "is": "@0xca1846eae9ffa1ee"}]}, {"at": 1, "name": "hung", "parameters": [{
"at": 0, "name": "value", "is": "@0xe2f1b542ae737d95"}]}]}, {"id": "@0xca1846eae9ffa1ee",
"kind": "struct", "name": "GalleryStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"},
{"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {
"at": 3, "name": "newest", "is": "@0xe2f1b542ae737d95"}, {"at": 4, "name": "oldest",
"is": "@0xe2f1b542ae737d95"}]}, {"id": "@0xe2f1b542ae737d95", "kind": "struct", "name": "Picture",
"members": [{"at": 0, "name": "pixels", "is": "Data"}]}]})json";

}  // namespace
}  // namespace large_values

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<large_values::Gallery>() {
  static constexpr InterfaceInfo kInfo{
      .name = "large_values::Gallery",
      .hash = "c27c4c87013183d160e67b10a27a6a3f",
      .description = large_values::kGalleryDescription,
      .commands = large_values::kGalleryCommands,
      .events = large_values::kGalleryEvents,
      .binding = &large_values::galleryBinding,
  };
  return kInfo;
}

auto Provided<large_values::Gallery>::Scratch::reserved() -> Scratch {
  Scratch scratch{};
  reserveFor<decltype(large_values::GalleryDimmedArguments::picture)>(scratch.dimmed_picture);
  reserveFor<decltype(large_values::GalleryHangArguments::picture)>(scratch.hang_picture);
  return scratch;
}

Errc Provided<large_values::Gallery>::execute(std::uint16_t command, const std::byte* arguments,
                                              std::byte* result) {
  using ::large_values::GalleryCommand;
  switch (static_cast<GalleryCommand>(command)) {
    case GalleryCommand::newest: {
      auto& slot = newSlot<large_values::PictureSlot>(result);
      return store(implementation_.newest(), slot) ? Errc{} : Errc::TooLarge;
    }
    case GalleryCommand::oldest: {
      auto& slot = newSlot<large_values::PictureSlot>(result);
      return store(implementation_.oldest(), slot) ? Errc{} : Errc::TooLarge;
    }
    case GalleryCommand::dimmed: {
      const auto& slot = slotIn<large_values::GalleryDimmedArguments>(arguments);
      load(slot.picture, scratch_.dimmed_picture);
      auto& answer = newSlot<large_values::PictureSlot>(result);
      return store(implementation_.dimmed(scratch_.dimmed_picture), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case GalleryCommand::hang: {
      const auto& slot = slotIn<large_values::GalleryHangArguments>(arguments);
      load(slot.picture, scratch_.hang_picture);
      implementation_.hang(scratch_.hang_picture);
      return Errc{};
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
