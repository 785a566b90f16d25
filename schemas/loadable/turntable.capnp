@0xa28765c560e633e5;
# The wire contract of loadable/turntable.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("loadable::wire");
$Meta.header("loadable/turntable.h");

interface Turntable @0xcb8648112327d0b9 $Meta.cxx("loadable::Turntable") {
  subscribe @0 (events :TurntableEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  turn @1 (angle :Float64 $Meta.unit("rad"), sent :Rpc.Sent) -> () $Meta.kind("write")
      $Meta.queue(16);
  angle @2 (sent :Rpc.Sent) -> (value :Float64, stamp :Int64) $Meta.kind("read");
}

interface TurntableEvents @0xbe9023e02a0b50c9 $Meta.eventsOf("loadable::Turntable") {
  # What a subscriber of Turntable receives.

  state @0 (row :TurntableStateRow) -> ();
  # A new row of the columns asked for.
}

struct TurntableStateRow @0xce3772f691497d20 $Meta.stateOf("loadable::Turntable") {
  # One row of the state table: what the read commands of Turntable answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  angle @3 :Float64;
}
