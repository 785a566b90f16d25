@0xa70fead73b931aa7;
# The wire contract of pedals/foot_pedals.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("pedals/foot_pedals.h");

struct PedalState @0xcff309898affe286 $Meta.cxx("robots::PedalState") {
  # Says what the feet do. It counts only as long as it is fresh: a client that does not receive it
  # any more must assume that all pedals are pressed.

  clutch @0 :Bool;
  # If it is true, masters move without their slaves.
  camera @1 :Bool;
  # If it is true, masters move the camera instead of their slaves. The components here simulate
  # no camera that masters move: slaves only hold.
  coagulation @2 :Bool;
  # If it is true, energy is applied to the tissue.
  stamp @3 :Int64 $Meta.clock("steady");
  # The stamp is that of the cycle in which they were looked at.
}

interface FootPedals @0xeef483a34001461c $Meta.cxx("robots::FootPedals") {
  # The names are the da Vinci Research Kit's.

  subscribe @0 (events :FootPedalsEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  pedals @1 (sent :Rpc.Sent) -> (value :PedalState, stamp :Int64) $Meta.kind("read");
}

interface FootPedalsEvents @0xeb48eb818a9b108b $Meta.eventsOf("robots::FootPedals") {
  # What a subscriber of FootPedals receives.

  state @0 (row :FootPedalsStateRow) -> ();
  # A new row of the columns asked for.
  clutch @1 (value :Bool, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports each press and release, and the present state to a client that connects.
  camera @2 (value :Bool, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  coagulation @3 (value :Bool, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
}

struct FootPedalsStateRow @0xec8fc265517e6c7c $Meta.stateOf("robots::FootPedals") {
  # One row of the state table: what the read commands of FootPedals answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  pedals @3 :PedalState;
}
