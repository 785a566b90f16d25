@0xd2d264638b3509ef;
# The wire contract of suture/standard/task_timing.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("suture::wire");
$Meta.header("suture/standard/task_timing.h");

struct DurationSummary @0x855eca590f7906fe $Meta.cxx("suture::DurationSummary") {
  mean @0 :Int64 $Meta.period("1/1000000000");
  deviation @1 :Int64 $Meta.period("1/1000000000");
  min @2 :Int64 $Meta.period("1/1000000000");
  max @3 :Int64 $Meta.period("1/1000000000");
  p99 @4 :Int64 $Meta.period("1/1000000000");
}

struct TaskWindow @0xaf9c44d28d818274 $Meta.cxx("suture::TaskWindow") {
  begin @0 :Int64 $Meta.clock("steady");
  # when its first cycle began, and the first of the next window
  end @1 :Int64 $Meta.clock("steady");
  # when its first cycle began, and the first of the next window
  cycles @2 :UInt64;
  # that began within
  skipped @3 :UInt64;
  # periods or callbacks that passed without a cycle
  period @4 :DurationSummary;
  # from the beginning of a cycle to that of the next
  compute @5 :DurationSummary;
  # length of a cycle, without those of guests
}

interface TaskTiming @0xcfdd32a232e225bc $Meta.cxx("suture::TaskTiming") {
  # Any task may provide this: `suture::TimingPort timing_{*this};`.

  subscribe @0 (events :TaskTimingEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  window @1 (sent :Rpc.Sent) -> (value :TaskWindow, stamp :Int64) $Meta.kind("read");
  # Returns the last whole window, of 1 s unless the task says otherwise; `end` is unset before
  # the first.
  cycles @2 (sent :Rpc.Sent) -> (value :UInt64, stamp :Int64) $Meta.kind("read");
  # Counts the cycles since the task exists.
  skipped @3 (sent :Rpc.Sent) -> (value :UInt64, stamp :Int64) $Meta.kind("read");
  # Counts the periods or callbacks that passed without a cycle, since the task exists.
}

interface TaskTimingEvents @0xc26eec352b9e05fc $Meta.eventsOf("suture::TaskTiming") {
  # What a subscriber of TaskTiming receives.

  state @0 (row :TaskTimingStateRow) -> ();
  # A new row of the columns asked for.
}

struct TaskTimingStateRow @0xeb8d659f884108a8 $Meta.stateOf("suture::TaskTiming") {
  # One row of the state table: what the read commands of TaskTiming answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  window @3 :TaskWindow;
  cycles @4 :UInt64;
  skipped @5 :UInt64;
}
