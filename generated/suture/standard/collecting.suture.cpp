// Written by suturec from suture/standard/collecting.h. Do not edit.
#include "suture/standard/collecting.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "suture/standard/collecting.capnp.h"

namespace suture {

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
using suture::rpc::fromWire;
using suture::rpc::inRange;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::slotIn;
using suture::slotSize;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(CollectedCounts::collected), std::uint64_t>);
static_assert(std::is_same_v<decltype(CollectedCounts::passedOver), std::uint64_t>);
static_assert(std::is_same_v<decltype(CollectedCounts::missed), std::uint64_t>);
static_assert(std::is_same_v<decltype(CollectingInterval::every), std::uint32_t>);
static_assert(std::is_same_v<decltype(CollectingInterval::atLeast), std::chrono::nanoseconds>);

}  // namespace

bool store(const CollectedCounts& value, CollectedCountsSlot& slot) {
  bool fits = true;
  fits &= store(value.collected, slot.collected);
  fits &= store(value.passedOver, slot.passedOver);
  fits &= store(value.missed, slot.missed);
  return fits;
}

void load(const CollectedCountsSlot& slot, CollectedCounts& value) {
  load(slot.collected, value.collected);
  load(slot.passedOver, value.passedOver);
  load(slot.missed, value.missed);
}

bool store(const CollectingInterval& value, CollectingIntervalSlot& slot) {
  bool fits = true;
  fits &= store(value.every, slot.every);
  fits &= store(value.atLeast, slot.atLeast);
  return fits;
}

void load(const CollectingIntervalSlot& slot, CollectingInterval& value) {
  load(slot.every, value.every);
  load(slot.atLeast, value.atLeast);
}

bool store(const CollectingInterval& interval, CollectingSetIntervalArguments& slot) {
  return store(interval, slot.interval);
}

// --- between slots and Cap'n Proto

void toWire(const CollectedCountsSlot& slot, wire::CollectedCounts::Builder out) {
  out.setCollected(slot.collected);
  out.setPassedOver(slot.passedOver);
  out.setMissed(slot.missed);
}

Errc fromWire(wire::CollectedCounts::Reader in, CollectedCountsSlot& slot, Duration) {
  slot.collected = in.getCollected();
  slot.passedOver = in.getPassedOver();
  slot.missed = in.getMissed();
  return Errc{};
}

bool isValid(const CollectedCountsSlot&, FieldPath*) {
  return true;
}

void toWire(const CollectingIntervalSlot& slot, wire::CollectingInterval::Builder out) {
  out.setEvery(slot.every);
  out.setAtLeast(slot.atLeast);
}

Errc fromWire(wire::CollectingInterval::Reader in, CollectingIntervalSlot& slot, Duration) {
  slot.every = in.getEvery();
  slot.atLeast = in.getAtLeast();
  return Errc{};
}

bool isValid(const CollectingIntervalSlot& slot, FieldPath* path) {
  return inRange(slot.every, 1, 4294967295) || refusedAt(path, "every");
}

namespace {

bool acceptsCollectingSetInterval(const CollectingSetIntervalArguments& slot, FieldPath* path) {
  return isValid(slot.interval, path) || refusedAt(path, "interval");
}

// --- Collecting over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class CollectingSink final : public suture::rpc::EventSink {
 public:
  explicit CollectingSink(wire::CollectingEvents::Client subscriber) :
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
      const auto& slot = slotIn<CollectingIntervalSlot>(columns[0]);
      toWire(slot, out.initInterval());
    }
    if (row.hasValue(1)) {
      const auto& slot = slotIn<std::uint8_t>(columns[1]);
      out.setCollecting(slot != 0);
    }
    if (row.hasValue(2)) {
      const auto& slot = slotIn<CollectedCountsSlot>(columns[2]);
      toWire(slot, out.initCounts());
    }
    return request.send().ignoreResult();
  }

 private:
  wire::CollectingEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class CollectingServant final : public wire::Collecting::Server {
 public:
  explicit CollectingServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<CollectingSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> startCollecting(StartCollectingContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(CollectingCommand::start_collecting), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> stopCollecting(StopCollectingContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(CollectingCommand::stop_collecting), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> setInterval(SetIntervalContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<CollectingSetIntervalArguments>(memory);
      return in.hasInterval() ? fromWire(in.getInterval(), slot.interval, port_->shift())
          : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<std::uint8_t>(result);
      auto out = context.getResults();
      out.setValue(slot != 0);
    };
    return port_->call(numberOf(CollectingCommand::set_interval), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> interval(IntervalContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<CollectingIntervalSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(CollectingCommand::interval), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> collecting(CollectingContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<std::uint8_t>(result);
      auto out = context.getResults();
      out.setValue(slot != 0);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(CollectingCommand::collecting), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> counts(CountsContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<CollectedCountsSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(CollectingCommand::counts), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- Collecting over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class CollectingReceiver final : public wire::CollectingEvents::Server {
 public:
  explicit CollectingReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<CollectingIntervalSlot>(0);
      const Errc error =
          in.hasInterval() ? fromWire(in.getInterval(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    if (columns.hasValue(1)) {
      auto& slot = port_->column<std::uint8_t>(1);
      slot = in.getCollecting();
    }
    if (columns.hasValue(2)) {
      auto& slot = port_->column<CollectedCountsSlot>(2);
      const Errc error =
          in.hasCounts() ? fromWire(in.getCounts(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(2, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class CollectingProxy final : public suture::rpc::Proxy {
 public:
  CollectingProxy(wire::Collecting::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<CollectingReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<CollectingCommand>(record.command)) {
      case CollectingCommand::start_collecting: {
        auto request = provider_.startCollectingRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case CollectingCommand::stop_collecting: {
        auto request = provider_.stopCollectingRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case CollectingCommand::set_interval: {
        const auto& slot = slotIn<CollectingSetIntervalArguments>(record.arguments());
        auto request = provider_.setIntervalRequest();
        toWire(slot.interval, request.initInterval());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::uint8_t>(call, [&](std::uint8_t& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case CollectingCommand::interval: {
        auto request = provider_.intervalRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<CollectingIntervalSlot>(call, response.getStamp(),
                                               [&](CollectingIntervalSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case CollectingCommand::collecting: {
        auto request = provider_.collectingRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::uint8_t>(call, response.getStamp(), [&](std::uint8_t& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case CollectingCommand::counts: {
        auto request = provider_.countsRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<CollectedCountsSlot>(call, response.getStamp(),
                                            [&](CollectedCountsSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::Collecting::Client provider_;
  ProxyPort& port_;
};

class CollectingBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<CollectingServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<CollectingProxy>(contract.castAs<wire::Collecting>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<CollectingSink>(subscriber.castAs<wire::CollectingEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::Collecting>();
  }
};

const suture::rpc::Binding& collectingBinding() {
  static const CollectingBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kCollectingCommands[] = {
    {.name = "start_collecting", .kind = CommandKind::Void, .depth = 16},
    {.name = "stop_collecting", .kind = CommandKind::Void, .depth = 16},
    {.name = "set_interval",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = slotSize<CollectingSetIntervalArguments>,
     .resultSize = slotSize<std::uint8_t>,
     .depth = 16,
     .accepts = checkSlot<CollectingSetIntervalArguments, acceptsCollectingSetInterval>},
    {.name = "interval",
     .kind = CommandKind::Read,
     .resultSize = slotSize<CollectingIntervalSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<CollectingIntervalSlot, isValid>},
    {.name = "collecting",
     .kind = CommandKind::Read,
     .resultSize = slotSize<std::uint8_t>,
     .depth = 16,
     .column = 1},
    {.name = "counts",
     .kind = CommandKind::Read,
     .resultSize = slotSize<CollectedCountsSlot>,
     .depth = 16,
     .column = 2,
     .acceptsResult = checkSlot<CollectedCountsSlot, isValid>},
};

// The self-description, as in suture/standard/collecting.suture.json.
constexpr char kCollectingDescription[] = R"json(
{"name": "suture::Collecting",
"doc": "The provided interface \"Collecting\" of every collector (record/state_collector.h,\nrecord/event_collector.h). Its commands run in the collector's own thread; the task that is\nobserved has no part in them.",
"hash": "7d0a0ee41d0e6b9b9423123184f2f5b4", "commands": [{"name": "start_collecting",
"kind": "void", "ordinal": 1, "wire": "startCollecting",
"doc": "What is produced from now on is kept; counts begin anew, unless it is collecting already.",
"queue": 16}, {"name": "stop_collecting", "kind": "void", "ordinal": 2, "wire": "stopCollecting",
"doc": "What is produced from now on is let go, uncounted.", "queue": 16}, {"name": "set_interval",
"kind": "write with return", "ordinal": 3, "wire": "setInterval",
"doc": "From the next row or event on. False: every 0th, or less than no time; nothing changes.",
"parameters": [{"name": "interval", "type": {"kind": "struct", "name": "suture::CollectingInterval"
}}], "result": {"type": {"kind": "Bool"}}, "queue": 16}, {"name": "interval", "kind": "read",
"ordinal": 4, "result": {"type": {"kind": "struct", "name": "suture::CollectingInterval"}},
"queue": 16}, {"name": "collecting", "kind": "read", "ordinal": 5, "result": {"type": {
"kind": "Bool"}}, "queue": 16}, {"name": "counts", "kind": "read", "ordinal": 6,
"doc": "Counts what the present time of collecting has written, or the last one.", "result": {
"type": {"kind": "struct", "name": "suture::CollectedCounts"}}, "queue": 16}], "events": [],
"enums": [], "structs": [{"name": "suture::CollectingInterval", "doc": "How much is collected.",
"fields": [{"name": "every", "doc": "every n-th row or event", "type": {"kind": "UInt32"},
"range": [1.0, 4294967295.0], "default": 1}, {"name": "atLeast", "doc": "between the stamps of two",
"type": {"kind": "duration", "period": "1/1000000000"}, "default": 0.0}]}, {
"name": "suture::CollectedCounts",
"doc": "What became of the rows or events of a time of collecting. Once the collector has caught up with\nits provider, the three add up to what was produced.",
"fields": [{"name": "collected", "doc": "handed to the sink", "type": {"kind": "UInt64"},
"default": 0}, {"name": "passedOver",
"doc": "left out on purpose: between two that the interval asks for", "type": {"kind": "UInt64"},
"default": 0}, {"name": "missed",
"doc": "lost: overwritten or dropped before the collector came to them", "type": {"kind": "UInt64"
}, "default": 0}]}], "wire": [{"id": "@0xe3eaf7ddf2538295", "kind": "interface",
"name": "Collecting", "cxx": "suture::Collecting", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xe8cbe73a9ddc44ad"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "startCollecting", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "stopCollecting", "is": "kind \"void\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 3,
"name": "setInterval", "is": "kind \"writeReturn\"", "parameters": [{"at": 0, "name": "interval",
"is": "@0xc55fb930b38c9647"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "Bool"}]}, {"at": 4, "name": "interval",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xc55fb930b38c9647"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 5, "name": "collecting", "is": "kind \"read\"", "parameters": [{"at": 0,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Bool"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 6, "name": "counts",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0x8130e847fbf0eac6"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}]}, {"id": "@0xe8cbe73a9ddc44ad", "kind": "interface", "name": "CollectingEvents",
"members": [{"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row",
"is": "@0xdf1d86976a49db70"}]}]}, {"id": "@0xdf1d86976a49db70", "kind": "struct",
"name": "CollectingStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "interval", "is": "@0xc55fb930b38c9647"}, {"at": 4, "name": "collecting", "is": "Bool"}, {
"at": 5, "name": "counts", "is": "@0x8130e847fbf0eac6"}]}, {"id": "@0xc55fb930b38c9647",
"kind": "struct", "name": "CollectingInterval", "members": [{"at": 0, "name": "every",
"is": "UInt32 = 1"}, {"at": 1, "name": "atLeast", "is": "Int64 period \"1/1000000000\""}]}, {
"id": "@0x8130e847fbf0eac6", "kind": "struct", "name": "CollectedCounts", "members": [{"at": 0,
"name": "collected", "is": "UInt64"}, {"at": 1, "name": "passedOver", "is": "UInt64"}, {"at": 2,
"name": "missed", "is": "UInt64"}]}]})json";

}  // namespace
}  // namespace suture

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<suture::Collecting>() {
  static constexpr InterfaceInfo kInfo{
      .name = "suture::Collecting",
      .hash = "7d0a0ee41d0e6b9b9423123184f2f5b4",
      .description = suture::kCollectingDescription,
      .commands = suture::kCollectingCommands,
      .events = {},
      .binding = &suture::collectingBinding,
  };
  return kInfo;
}

Errc Provided<suture::Collecting>::execute(std::uint16_t command, const std::byte* arguments,
                                           std::byte* result) {
  using ::suture::CollectingCommand;
  switch (static_cast<CollectingCommand>(command)) {
    case CollectingCommand::start_collecting: {
      implementation_.start_collecting();
      return Errc{};
    }
    case CollectingCommand::stop_collecting: {
      implementation_.stop_collecting();
      return Errc{};
    }
    case CollectingCommand::set_interval: {
      const auto& slot = slotIn<suture::CollectingSetIntervalArguments>(arguments);
      load(slot.interval, scratch_.set_interval_interval);
      auto& answer = newSlot<std::uint8_t>(result);
      return store(implementation_.set_interval(scratch_.set_interval_interval), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case CollectingCommand::interval: {
      auto& slot = newSlot<CollectingIntervalSlot>(result);
      return store(implementation_.interval(), slot) ? Errc{} : Errc::TooLarge;
    }
    case CollectingCommand::collecting: {
      auto& slot = newSlot<std::uint8_t>(result);
      return store(implementation_.collecting(), slot) ? Errc{} : Errc::TooLarge;
    }
    case CollectingCommand::counts: {
      auto& slot = newSlot<CollectedCountsSlot>(result);
      return store(implementation_.counts(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
