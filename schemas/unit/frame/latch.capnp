@0xf0c76ca5b8fb1c2d;
# The wire contract of unit/frame/latch.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("latches::wire");
$Meta.header("unit/frame/latch.h");

interface Latch @0x9cd55911994c89d8 $Meta.cxx("latches::Latch") {
  subscribe @0 (events :LatchEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  close @1 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
}

interface LatchEvents @0x8315f6094677df6b $Meta.eventsOf("latches::Latch") {
  # What a subscriber of Latch receives.

  state @0 (row :LatchStateRow) -> ();
  # A new row of the columns asked for.
  closed @1 (stamp :Int64) -> () $Meta.queue(16);
}

struct LatchStateRow @0xd222b63a4b86bf21 $Meta.stateOf("latches::Latch") {
  # One row of the state table: what the read commands of Latch answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
