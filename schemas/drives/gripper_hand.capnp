@0xcaa0770b310823ad;
# The wire contract of drives/gripper_hand.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("drives/gripper_hand.h");

interface GripperHand @0xfdcd88fcdd8f3434 $Meta.cxx("robots::GripperHand") {
  # Simulated drives of a master provide this as "Hand", because real ones have a surgeon's.
  # Commands run in the drives' own thread before its next cycle.

  subscribe @0 (events :GripperHandEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  squeeze @1 (angle :Float64 $Meta.unit("rad"), sent :Rpc.Sent) -> () $Meta.kind("write")
      $Meta.latest $Meta.queue(16) $Meta.ttl(100000000);
  # Makes the fingers press the handles to this angle, newest wins. It stays there until another
  # one comes. The gripper follows with the lag of the drives, and no further than its stops.
}

interface GripperHandEvents @0xc0df5b70383bca9d $Meta.eventsOf("robots::GripperHand") {
  # What a subscriber of GripperHand receives.

  state @0 (row :GripperHandStateRow) -> ();
  # A new row of the columns asked for.
}

struct GripperHandStateRow @0xda979129fce1c077 $Meta.stateOf("robots::GripperHand") {
  # One row of the state table: what the read commands of GripperHand answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
