@0xc63466939ee3e432;
# The wire contract of lock_renamed_command.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("lock_renamed_command.h");

interface Arm @0x845f4139c5070e12 $Meta.cxx("demo::Arm") {
  subscribe @0 (events :ArmEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  halt @1 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  speed @2 (sent :Rpc.Sent) -> (value :Float64, stamp :Int64) $Meta.kind("read");
}

interface ArmEvents @0xdbbe1e26cd165bea $Meta.eventsOf("demo::Arm") {
  # What a subscriber of Arm receives.

  state @0 (row :ArmStateRow) -> ();
  # A new row of the columns asked for.
}

struct ArmStateRow @0xdf4c4a3316190978 $Meta.stateOf("demo::Arm") {
  # One row of the state table: what the read commands of Arm answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  speed @3 :Float64;
}
