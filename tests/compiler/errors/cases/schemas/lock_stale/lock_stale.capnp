@0xe93d7e0084405e77;
# The wire contract of lock_stale.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("lock_stale.h");

interface Contract @0xae3f07d9e2f0431e $Meta.cxx("demo::Contract") {
  subscribe @0 (events :ContractEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  move @1 (steps :Int32, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(4);
}

interface ContractEvents @0xe5c41a90a7253ceb $Meta.eventsOf("demo::Contract") {
  # What a subscriber of Contract receives.

  state @0 (row :ContractStateRow) -> ();
  # A new row of the columns asked for.
}

struct ContractStateRow @0xf46d7556c214799f $Meta.stateOf("demo::Contract") {
  # One row of the state table: what the read commands of Contract answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
