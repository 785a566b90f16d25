@0x83eb54d61bf2e1cc;
# The wire contract of unit/large_values/hall.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
using Picture = import "/unit/large_values/picture.capnp";
$Cxx.namespace("large_values::wire");
$Meta.header("unit/large_values/hall.h");

interface Hall @0xe68070b1d5e11ac8 $Meta.cxx("large_values::Hall") {
  subscribe @0 (events :HallEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  fill @1 (picture :Picture.Picture, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(2000);
}

interface HallEvents @0x98f03f3ca3726066 $Meta.eventsOf("large_values::Hall") {
  # What a subscriber of Hall receives.

  state @0 (row :HallStateRow) -> ();
  # A new row of the columns asked for.
}

struct HallStateRow @0xea33b916749bc050 $Meta.stateOf("large_values::Hall") {
  # One row of the state table: what the read commands of Hall answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
