@0x869409b7f808b4a0;
# The wire contract of suture/standard/collecting.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("suture::wire");
$Meta.header("suture/standard/collecting.h");

struct CollectedCounts @0x8130e847fbf0eac6 $Meta.cxx("suture::CollectedCounts") {
  # Says what became of the rows or events of a time of collecting. Once the collector has caught up
  # with its provider, the three add up to what was produced.

  collected @0 :UInt64;
  # passed to the sink, and kept
  passedOver @1 :UInt64;
  # left out on purpose, between two that the interval asks for
  missed @2 :UInt64;
  # lost: overwritten before the collector came, or not kept
}

struct CollectingInterval @0xc55fb930b38c9647 $Meta.cxx("suture::CollectingInterval") {
  # Says how much is collected.

  every @0 :UInt32 = 1 $Meta.range(lowest = 1, highest = 4294967295);
  # every n-th row or event
  atLeast @1 :Int64 $Meta.period("1/1000000000");
  # between the stamps of two
}

interface Collecting @0xe3eaf7ddf2538295 $Meta.cxx("suture::Collecting") {
  # Collecting is the provided interface of that name of every collector (record/state_collector.h,
  # record/event_collector.h). Its commands run in the collector's own thread; the task that is
  # observed has no part in them.

  subscribe @0 (events :CollectingEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  startCollecting @1 (sent :Rpc.Sent) -> () $Meta.cxx("start_collecting") $Meta.kind("void")
      $Meta.queue(16);
  # Begins to record what is produced from now on. Counts begin anew, unless it is collecting
  # already.
  stopCollecting @2 (sent :Rpc.Sent) -> () $Meta.cxx("stop_collecting") $Meta.kind("void")
      $Meta.queue(16);
  # Stops recording: what is produced from now on is discarded without being counted.
  setInterval @3 (interval :CollectingInterval, sent :Rpc.Sent) -> (value :Bool)
      $Meta.cxx("set_interval") $Meta.kind("writeReturn") $Meta.queue(16);
  # Sets the interval from the next row or event on. Returns false, and changes nothing, for every
  # 0th one or a negative time.
  interval @4 (sent :Rpc.Sent) -> (value :CollectingInterval, stamp :Int64) $Meta.kind("read");
  collecting @5 (sent :Rpc.Sent) -> (value :Bool, stamp :Int64) $Meta.kind("read");
  counts @6 (sent :Rpc.Sent) -> (value :CollectedCounts, stamp :Int64) $Meta.kind("read");
  # Counts what the present time of collecting has written, or the last one.
}

interface CollectingEvents @0xe8cbe73a9ddc44ad $Meta.eventsOf("suture::Collecting") {
  # What a subscriber of Collecting receives.

  state @0 (row :CollectingStateRow) -> ();
  # A new row of the columns asked for.
}

struct CollectingStateRow @0xdf1d86976a49db70 $Meta.stateOf("suture::Collecting") {
  # One row of the state table: what the read commands of Collecting answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  interval @3 :CollectingInterval;
  collecting @4 :Bool;
  counts @5 :CollectedCounts;
}
