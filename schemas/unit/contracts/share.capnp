@0xf06578a46305c7cc;
# The wire contract of unit/contracts/share.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("contracts::wire");
$Meta.header("unit/contracts/share.h");

interface Share @0xbc44383dfd74184a $Meta.cxx("contracts::Share") {
  subscribe @0 (events :ShareEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  share @1 (sent :Rpc.Sent) -> (value :Float64 $Meta.range(lowest = 0, highest = 1), stamp :Int64)
      $Meta.kind("read");
  shares @2 (all :Bool, sent :Rpc.Sent) -> (value :Int32 $Meta.range(lowest = 0, highest = 1))
      $Meta.kind("qualifiedRead");
  take @3 (wanted :Float64, sent :Rpc.Sent) -> (value :Float64 $Meta.range(lowest = 0, highest = 1))
      $Meta.kind("writeReturn") $Meta.queue(16);
  reach @4 (sent :Rpc.Sent) -> (value :Float64 $Meta.range(lowest = 0, highest = inf), stamp :Int64)
      $Meta.kind("read");
}

interface ShareEvents @0x83261bdaea7017eb $Meta.eventsOf("contracts::Share") {
  # What a subscriber of Share receives.

  state @0 (row :ShareStateRow) -> ();
  # A new row of the columns asked for.
}

struct ShareStateRow @0xf191a55d39c3919f $Meta.stateOf("contracts::Share") {
  # One row of the state table: what the read commands of Share answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  share @3 :Float64 $Meta.range(lowest = 0, highest = 1);
  reach @4 :Float64 $Meta.range(lowest = 0, highest = inf);
}
