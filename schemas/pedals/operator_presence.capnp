@0x9244b725b0b1bf24;
# The wire contract of pedals/operator_presence.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("pedals/operator_presence.h");

struct Presence @0xa9429a655b83829a $Meta.cxx("robots::Presence") {
  # Says if a head is in the viewer. It counts only as long as it is fresh.

  present @0 :Bool;
  stamp @1 :Int64 $Meta.clock("steady");
  # The cycle in which the viewer was looked at.
}

interface OperatorPresence @0x8946bef4362e465d $Meta.cxx("robots::OperatorPresence") {
  subscribe @0 (events :OperatorPresenceEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  presence @1 (sent :Rpc.Sent) -> (value :Presence, stamp :Int64) $Meta.kind("read");
}

interface OperatorPresenceEvents @0xd9df1a4d2e881c27 $Meta.eventsOf("robots::OperatorPresence") {
  # What a subscriber of OperatorPresence receives.

  state @0 (row :OperatorPresenceStateRow) -> ();
  # A new row of the columns asked for.
  operatorPresent @1 (value :Bool, stamp :Int64) -> () $Meta.cxx("operator_present") $Meta.latched
      $Meta.queue(16);
  # Reports each change, and the present state to a client that connects.
}

struct OperatorPresenceStateRow @0x970403e5511b6372 $Meta.stateOf("robots::OperatorPresence") {
  # One row of the state table: what the read commands of OperatorPresence answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  presence @3 :Presence;
}
