@0xecdb751b44661efb;
# The wire contract of allowed.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("allowed.h");

struct Words @0xa67d4853bd4c75cb $Meta.cxx("demo::Words") {
  length @0 :Float64 $Meta.unit("m");
  import @1 :Int32;
  annotation @2 :Bool = true;
  interface @3 :Float64;
  void @4 :Float32 $Meta.cxx("Void");
  text @5 :Int32;
  angle @6 :Float64 $Meta.cxx("winkelÄ");
  struct @7 :Int32 $Meta.cxx("kind");
  true @8 :Bool = true $Meta.cxx("yes");
}

interface Contract @0xae3f07d9e2f0431e $Meta.cxx("demo::Contract") {
  subscribe @0 (events :ContractEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  emit @1 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  name @2 (range :Int32, queue :Int32, unit :Int32, sent :Rpc.Sent) -> () $Meta.kind("write")
      $Meta.queue(16);
  queue @3 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(2);
  range @4 (sent :Rpc.Sent) -> (value :Words, stamp :Int64) $Meta.kind("read");
}

interface ContractEvents @0xe5c41a90a7253ceb $Meta.eventsOf("demo::Contract") {
  # What a subscriber of Contract receives.

  state @0 (row :ContractStateRow) -> ();
  # A new row of the columns asked for.
  on @1 (stamp :Int64) -> () $Meta.queue(16);
  counted @2 (value :Int64, stamp :Int64) -> () $Meta.queue(16);
}

struct ContractStateRow @0xf46d7556c214799f $Meta.stateOf("demo::Contract") {
  # One row of the state table: what the read commands of Contract answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  range @2 :Words;
  tooLarge @3 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
