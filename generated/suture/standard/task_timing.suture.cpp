// Written by suturec from suture/standard/task_timing.h. Do not edit.
#include "suture/standard/task_timing.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace suture {

using suture::isValid;
using suture::load;
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

void shiftStamps(TaskWindowSlot& slot, suture::Duration shift) {
  slot.begin = suture::codec::shifted(slot.begin, shift);
  slot.end = suture::codec::shifted(slot.end, shift);
}

bool isValid(const DurationSummarySlot&, suture::FieldPath*) {
  return true;
}

bool isValid(const TaskWindowSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.period, path)) return suture::refusedAt(path, "period");
  return isValid(slot.compute, path) || suture::refusedAt(path, "compute");
}

// Defined in suture/standard/task_timing.wire.cpp.
const suture::codec::Codec& taskTimingCodec();

namespace {

constexpr suture::CommandInfo kTaskTimingCommands[] = {
    {.name = "window",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<TaskWindowSlot>,
     .depth = 16,
     .column = TaskTimingColumn::window,
     .acceptsResult = suture::checkSlot<TaskWindowSlot, isValid>,
     .shiftResult = suture::shiftSlot<TaskWindowSlot>},
    {.name = "cycles",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::uint64_t>,
     .depth = 16,
     .column = TaskTimingColumn::cycles},
    {.name = "skipped",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::uint64_t>,
     .depth = 16,
     .column = TaskTimingColumn::skipped},
};

// The self-description, as in suture/standard/task_timing.suture.json.
constexpr char kTaskTimingDescription[] = R"json(
{"name": "suture::TaskTiming",
"doc": "Any task may provide this: `suture::TimingPort timing_{*this};`.",
"hash": "3f559c6b9501397597b26b0df425de6a", "commands": [{"name": "window", "kind": "read",
"ordinal": 1,
"doc": "Returns the last whole window, of 1 s unless the task says otherwise; `end` is unset before\nthe first.",
"result": {"type": {"kind": "struct", "name": "suture::TaskWindow"}}, "queue": 16}, {
"name": "cycles", "kind": "read", "ordinal": 2, "doc": "Counts the cycles since the task exists.",
"result": {"type": {"kind": "UInt64"}}, "queue": 16}, {"name": "skipped", "kind": "read",
"ordinal": 3,
"doc": "Counts the periods or callbacks that passed without a cycle, since the task exists.",
"result": {"type": {"kind": "UInt64"}}, "queue": 16}], "events": [], "enums": [], "structs": [{
"name": "suture::DurationSummary", "fields": [{"name": "mean", "type": {"kind": "duration",
"period": "1/1000000000"}}, {"name": "deviation", "type": {"kind": "duration",
"period": "1/1000000000"}}, {"name": "min", "type": {"kind": "duration", "period": "1/1000000000"}
}, {"name": "max", "type": {"kind": "duration", "period": "1/1000000000"}}, {"name": "p99",
"type": {"kind": "duration", "period": "1/1000000000"}}]}, {"name": "suture::TaskWindow",
"fields": [{"name": "begin", "doc": "when its first cycle began, and the first of the next window",
"type": {"kind": "time", "clock": "steady"}}, {"name": "end",
"doc": "when its first cycle began, and the first of the next window", "type": {"kind": "time",
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
      .codec = &suture::taskTimingCodec,
  };
  return kInfo;
}

// A function for each command of suture::TaskTiming, so that a stack in a debugger names it.
struct Provided<suture::TaskTiming>::Dispatch {
  static Errc execute_window(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<TaskWindowSlot>(result);
    return store(implementation.window(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_cycles(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::uint64_t>(result);
    return store(implementation.cycles(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_skipped(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::uint64_t>(result);
    return store(implementation.skipped(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<suture::TaskTiming>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                           std::byte* result) {
  using ::suture::TaskTimingCommand;
  switch (command) {
    case TaskTimingCommand::window: return Dispatch::execute_window(implementation_, result);
    case TaskTimingCommand::cycles: return Dispatch::execute_cycles(implementation_, result);
    case TaskTimingCommand::skipped: return Dispatch::execute_skipped(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
