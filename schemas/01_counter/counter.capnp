@0x9b87d70f9fe9600f;
# The wire contract of 01_counter/counter.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("counting::wire");
$Meta.header("01_counter/counter.h");

interface Counter @0xd6d42f0aed709948 $Meta.cxx("counting::Counter") {
  subscribe @0 (events :CounterEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  add @1 (amount :Int32, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(8);
  # Adds to the count, in the provider's thread.
  value @2 (sent :Rpc.Sent) -> (value :Int64, stamp :Int64) $Meta.kind("read");
  # Returns the newest count; never waits for anyone.
}

interface CounterEvents @0xab8aa54e33362c79 $Meta.eventsOf("counting::Counter") {
  # What a subscriber of Counter receives.

  state @0 (row :CounterStateRow) -> ();
  # A new row of the columns asked for.
  tenMore @1 (value :Int64, stamp :Int64) -> () $Meta.cxx("ten_more") $Meta.queue(16);
  # Reports that the count has passed a multiple of ten.
}

struct CounterStateRow @0xbfec877b65b98c5c $Meta.stateOf("counting::Counter") {
  # One row of the state table: what the read commands of Counter answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  value @2 :Int64;
  tooLarge @3 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
