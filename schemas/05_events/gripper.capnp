@0x8bff72fd12df518e;
# The wire contract of 05_events/gripper.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("gripping::wire");
$Meta.header("05_events/gripper.h");

enum Jaws @0xf21766ccd2556dea $Meta.cxx("gripping::Jaws") $Meta.underlying("UInt8") {
  open @0 $Meta.cxx("Open") $Meta.value(0);
  closing @1 $Meta.cxx("Closing") $Meta.value(1);
  holding @2 $Meta.cxx("Holding") $Meta.value(2);
}

interface Gripper @0x94d688a82ce7d169 $Meta.cxx("gripping::Gripper") {
  subscribe @0 (events :GripperEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  grasp @1 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Begins to close the jaws.
  release @2 (sent :Rpc.Sent) -> (value :Bool) $Meta.kind("voidReturn") $Meta.queue(16);
  # Opens the jaws. Returns true if they held something.
}

interface GripperEvents @0xb6c3be53b63b21bb $Meta.eventsOf("gripping::Gripper") {
  # What a subscriber of Gripper receives.

  state @0 (row :GripperStateRow) -> ();
  # A new row of the columns asked for.
  jawsChanged @1 (value :Jaws, stamp :Int64) -> () $Meta.cxx("jaws_changed") $Meta.latched
      $Meta.queue(16);
  # Reports a state: a client that subscribes late receives the last one at once.
  touched @2 (value :Float64 $Meta.unit("N"), stamp :Int64) -> () $Meta.queue(16);
  # Reports something that happens. Each touch counts, so up to 16 wait for a busy subscriber.
}

struct GripperStateRow @0x996aaf9b482d97d6 $Meta.stateOf("gripping::Gripper") {
  # One row of the state table: what the read commands of Gripper answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
