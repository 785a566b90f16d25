@0x9d1924ce5dd34eac;
# The wire contract of harmless_names.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("harmless_names.h");

struct Sample @0xdc331872b9f58ba1 $Meta.cxx("demo::Sample") {
  label @0 :Text $Meta.capacity([8]) $Meta.cxx("name");
  range @1 :Float64 = 1.0 $Meta.range(lowest = 0, highest = 2) $Meta.unit("m");
  deadline @2 :Float64 $Meta.unit("s");
  queue @3 :Int32;
  latest @4 :Int32;
  unit @5 :Int32;
  capacity @6 :Int32;
  version @7 :Int32;
}

interface Contract @0xae3f07d9e2f0431e $Meta.cxx("demo::Contract") {
  subscribe @0 (events :ContractEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  queue @1 (name :Int32, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(4)
      $Meta.ttl(20000000);
  latest @2 (range :Float64, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.latest $Meta.queue(16);
  name @3 (queue :Int32, sent :Rpc.Sent) -> (value :Int32) $Meta.deadline(1000000000)
      $Meta.kind("writeReturn") $Meta.queue(16);
  range @4 (sent :Rpc.Sent) -> (value :Float64, stamp :Int64) $Meta.kind("read") $Meta.optional;
  info @5 (version :Int32, slot :Int32, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(16);
}

interface ContractEvents @0xe5c41a90a7253ceb $Meta.eventsOf("demo::Contract") {
  # What a subscriber of Contract receives.

  state @0 (row :ContractStateRow) -> ();
  # A new row of the columns asked for.
  latched @1 (value :Int32, stamp :Int64) -> () $Meta.latched $Meta.queue(2);
}

struct ContractStateRow @0xf46d7556c214799f $Meta.stateOf("demo::Contract") {
  # One row of the state table: what the read commands of Contract answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  range @2 :Float64 $Meta.optional;
  tooLarge @3 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
