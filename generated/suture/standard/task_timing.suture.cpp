// Written by suturec from suture/standard/task_timing.h. Do not edit.
#include "suture/standard/task_timing.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "suture/standard/task_timing.capnp.h"

namespace suture {

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
static_assert(std::is_same_v<decltype(DurationSummary::mean), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(DurationSummary::deviation), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(DurationSummary::min), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(DurationSummary::max), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(DurationSummary::p99), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(TaskWindow::begin), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(TaskWindow::end), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(TaskWindow::cycles), std::uint64_t>);
static_assert(std::is_same_v<decltype(TaskWindow::skipped), std::uint64_t>);
static_assert(std::is_same_v<decltype(TaskWindow::period), DurationSummary>);
static_assert(std::is_same_v<decltype(TaskWindow::compute), DurationSummary>);

}  // namespace

bool store(const DurationSummary& value, DurationSummarySlot& slot) {
  bool fits = true;
  fits &= store(value.mean, slot.mean);
  fits &= store(value.deviation, slot.deviation);
  fits &= store(value.min, slot.min);
  fits &= store(value.max, slot.max);
  fits &= store(value.p99, slot.p99);
  return fits;
}

void load(const DurationSummarySlot& slot, DurationSummary& value) {
  load(slot.mean, value.mean);
  load(slot.deviation, value.deviation);
  load(slot.min, value.min);
  load(slot.max, value.max);
  load(slot.p99, value.p99);
}

bool store(const TaskWindow& value, TaskWindowSlot& slot) {
  bool fits = true;
  fits &= store(value.begin, slot.begin);
  fits &= store(value.end, slot.end);
  fits &= store(value.cycles, slot.cycles);
  fits &= store(value.skipped, slot.skipped);
  fits &= store(value.period, slot.period);
  fits &= store(value.compute, slot.compute);
  return fits;
}

void load(const TaskWindowSlot& slot, TaskWindow& value) {
  load(slot.begin, value.begin);
  load(slot.end, value.end);
  load(slot.cycles, value.cycles);
  load(slot.skipped, value.skipped);
  load(slot.period, value.period);
  load(slot.compute, value.compute);
}

void shiftStamps(TaskWindowSlot& slot, Duration shift) {
  slot.begin = shifted(slot.begin, shift);
  slot.end = shifted(slot.end, shift);
}

// --- between slots and Cap'n Proto

void toWire(const DurationSummarySlot& slot, wire::DurationSummary::Builder out) {
  out.setMean(slot.mean);
  out.setDeviation(slot.deviation);
  out.setMin(slot.min);
  out.setMax(slot.max);
  out.setP99(slot.p99);
}

Errc fromWire(wire::DurationSummary::Reader in, DurationSummarySlot& slot, Duration) {
  slot.mean = in.getMean();
  slot.deviation = in.getDeviation();
  slot.min = in.getMin();
  slot.max = in.getMax();
  slot.p99 = in.getP99();
  return Errc{};
}

bool isValid(const DurationSummarySlot&, FieldPath*) {
  return true;
}

void toWire(const TaskWindowSlot& slot, wire::TaskWindow::Builder out) {
  out.setBegin(slot.begin);
  out.setEnd(slot.end);
  out.setCycles(slot.cycles);
  out.setSkipped(slot.skipped);
  toWire(slot.period, out.initPeriod());
  toWire(slot.compute, out.initCompute());
}

Errc fromWire(wire::TaskWindow::Reader in, TaskWindowSlot& slot, Duration shift) {
  slot.begin = suture::rpc::shifted(in.getBegin(), shift);
  slot.end = suture::rpc::shifted(in.getEnd(), shift);
  slot.cycles = in.getCycles();
  slot.skipped = in.getSkipped();
  return firstError({
      fromWire(in.getPeriod(), slot.period, shift),
      fromWire(in.getCompute(), slot.compute, shift),
  });
}

bool isValid(const TaskWindowSlot& slot, FieldPath* path) {
  if (!isValid(slot.period, path)) return refusedAt(path, "period");
  return isValid(slot.compute, path) || refusedAt(path, "compute");
}

namespace {

// --- TaskTiming over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class TaskTimingSink final : public suture::rpc::EventSink {
 public:
  explicit TaskTimingSink(wire::TaskTimingEvents::Client subscriber) :
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
      const auto& slot = slotIn<TaskWindowSlot>(columns[0]);
      toWire(slot, out.initWindow());
    }
    if (row.hasValue(1)) {
      const auto& slot = slotIn<std::uint64_t>(columns[1]);
      out.setCycles(slot);
    }
    if (row.hasValue(2)) {
      const auto& slot = slotIn<std::uint64_t>(columns[2]);
      out.setSkipped(slot);
    }
    return request.send().ignoreResult();
  }

 private:
  wire::TaskTimingEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class TaskTimingServant final : public wire::TaskTiming::Server {
 public:
  explicit TaskTimingServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<TaskTimingSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> window(WindowContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<TaskWindowSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(TaskTimingCommand::window), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> cycles(CyclesContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<std::uint64_t>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(TaskTimingCommand::cycles), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> skipped(SkippedContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<std::uint64_t>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(TaskTimingCommand::skipped), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- TaskTiming over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class TaskTimingReceiver final : public wire::TaskTimingEvents::Server {
 public:
  explicit TaskTimingReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<TaskWindowSlot>(0);
      const Errc error =
          in.hasWindow() ? fromWire(in.getWindow(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    if (columns.hasValue(1)) {
      auto& slot = port_->column<std::uint64_t>(1);
      slot = in.getCycles();
    }
    if (columns.hasValue(2)) {
      auto& slot = port_->column<std::uint64_t>(2);
      slot = in.getSkipped();
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class TaskTimingProxy final : public suture::rpc::Proxy {
 public:
  TaskTimingProxy(wire::TaskTiming::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<TaskTimingReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<TaskTimingCommand>(record.command)) {
      case TaskTimingCommand::window: {
        auto request = provider_.windowRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<TaskWindowSlot>(call, response.getStamp(), [&](TaskWindowSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case TaskTimingCommand::cycles: {
        auto request = provider_.cyclesRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::uint64_t>(call, response.getStamp(), [&](std::uint64_t& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case TaskTimingCommand::skipped: {
        auto request = provider_.skippedRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::uint64_t>(call, response.getStamp(), [&](std::uint64_t& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::TaskTiming::Client provider_;
  ProxyPort& port_;
};

class TaskTimingBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<TaskTimingServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<TaskTimingProxy>(contract.castAs<wire::TaskTiming>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<TaskTimingSink>(subscriber.castAs<wire::TaskTimingEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::TaskTiming>();
  }
};

const suture::rpc::Binding& taskTimingBinding() {
  static const TaskTimingBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kTaskTimingCommands[] = {
    {.name = "window",
     .kind = CommandKind::Read,
     .resultSize = slotSize<TaskWindowSlot>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<TaskWindowSlot, isValid>,
     .shiftResult = shiftSlot<TaskWindowSlot>},
    {.name = "cycles",
     .kind = CommandKind::Read,
     .resultSize = slotSize<std::uint64_t>,
     .depth = 16,
     .column = 1},
    {.name = "skipped",
     .kind = CommandKind::Read,
     .resultSize = slotSize<std::uint64_t>,
     .depth = 16,
     .column = 2},
};

// The self-description, as in suture/standard/task_timing.suture.json.
constexpr char kTaskTimingDescription[] = R"json(
{"name": "suture::TaskTiming",
"doc": "Every task may offer it: `suture::TimingPort timing_{*this};`.",
"hash": "3f559c6b9501397597b26b0df425de6a", "commands": [{"name": "window", "kind": "read",
"ordinal": 1,
"doc": "The last whole window, of 1 s unless the task says otherwise; `end` is unset before the first.",
"result": {"type": {"kind": "struct", "name": "suture::TaskWindow"}}, "queue": 16}, {
"name": "cycles", "kind": "read", "ordinal": 2, "doc": "Cycles since the task exists.", "result": {
"type": {"kind": "UInt64"}}, "queue": 16}, {"name": "skipped", "kind": "read", "ordinal": 3,
"doc": "Periods or callbacks that passed without a cycle, since the task exists.", "result": {
"type": {"kind": "UInt64"}}, "queue": 16}], "events": [], "enums": [], "structs": [{
"name": "suture::DurationSummary", "fields": [{"name": "mean", "type": {"kind": "duration",
"period": "1/1000000000"}}, {"name": "deviation", "type": {"kind": "duration",
"period": "1/1000000000"}}, {"name": "min", "type": {"kind": "duration", "period": "1/1000000000"}
}, {"name": "max", "type": {"kind": "duration", "period": "1/1000000000"}}, {"name": "p99",
"type": {"kind": "duration", "period": "1/1000000000"}}]}, {"name": "suture::TaskWindow",
"fields": [{"name": "begin", "doc": "of the first cycle, and of the first of the next window",
"type": {"kind": "time", "clock": "steady"}}, {"name": "end",
"doc": "of the first cycle, and of the first of the next window", "type": {"kind": "time",
"clock": "steady"}}, {"name": "cycles", "doc": "that began within", "type": {"kind": "UInt64"},
"default": 0}, {"name": "skipped", "doc": "periods or callbacks that passed without a cycle",
"type": {"kind": "UInt64"}, "default": 0}, {"name": "period",
"doc": "from the beginning of a cycle to that of the next", "type": {"kind": "struct",
"name": "suture::DurationSummary"}}, {"name": "compute",
"doc": "length of a cycle, without those of guests", "type": {"kind": "struct",
"name": "suture::DurationSummary"}}]}], "wire": [{"id": "@0xcfdd32a232e225bc", "kind": "interface",
"name": "TaskTiming", "cxx": "suture::TaskTiming", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xc26eec352b9e05fc"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "window", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xaf9c44d28d818274"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "cycles", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "UInt64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 3,
"name": "skipped", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "UInt64"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}]}, {"id": "@0xc26eec352b9e05fc", "kind": "interface",
"name": "TaskTimingEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xeb8d659f884108a8"}]}]}, {"id": "@0xeb8d659f884108a8", "kind": "struct",
"name": "TaskTimingStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "window", "is": "@0xaf9c44d28d818274"}, {"at": 4, "name": "cycles", "is": "UInt64"}, {
"at": 5, "name": "skipped", "is": "UInt64"}]}, {"id": "@0xaf9c44d28d818274", "kind": "struct",
"name": "TaskWindow", "members": [{"at": 0, "name": "begin", "is": "Int64 clock \"steady\""}, {
"at": 1, "name": "end", "is": "Int64 clock \"steady\""}, {"at": 2, "name": "cycles", "is": "UInt64"
}, {"at": 3, "name": "skipped", "is": "UInt64"}, {"at": 4, "name": "period",
"is": "@0x855eca590f7906fe"}, {"at": 5, "name": "compute", "is": "@0x855eca590f7906fe"}]}, {
"id": "@0x855eca590f7906fe", "kind": "struct", "name": "DurationSummary", "members": [{"at": 0,
"name": "mean", "is": "Int64 period \"1/1000000000\""}, {"at": 1, "name": "deviation",
"is": "Int64 period \"1/1000000000\""}, {"at": 2, "name": "min",
"is": "Int64 period \"1/1000000000\""}, {"at": 3, "name": "max",
"is": "Int64 period \"1/1000000000\""}, {"at": 4, "name": "p99",
"is": "Int64 period \"1/1000000000\""}]}]})json";

}  // namespace
}  // namespace suture

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<suture::TaskTiming>() {
  static constexpr InterfaceInfo kInfo{
      .name = "suture::TaskTiming",
      .hash = "3f559c6b9501397597b26b0df425de6a",
      .description = suture::kTaskTimingDescription,
      .commands = suture::kTaskTimingCommands,
      .events = {},
      .binding = &suture::taskTimingBinding,
  };
  return kInfo;
}

Errc Provided<suture::TaskTiming>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                           std::byte* result) {
  using ::suture::TaskTimingCommand;
  switch (static_cast<TaskTimingCommand>(command)) {
    case TaskTimingCommand::window: {
      auto& slot = newSlot<TaskWindowSlot>(result);
      return store(implementation_.window(), slot) ? Errc{} : Errc::TooLarge;
    }
    case TaskTimingCommand::cycles: {
      auto& slot = newSlot<std::uint64_t>(result);
      return store(implementation_.cycles(), slot) ? Errc{} : Errc::TooLarge;
    }
    case TaskTimingCommand::skipped: {
      auto& slot = newSlot<std::uint64_t>(result);
      return store(implementation_.skipped(), slot) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
