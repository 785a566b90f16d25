@0xb83be40e72064fb9;
# The wire contract of strand/strand_view.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("strand/strand_view.h");

struct StrandState @0xa7b70b5e253db6a2 $Meta.cxx("robots::StrandState") {
  nodes @0 :List(Float64) $Meta.shape("3x61") $Meta.unit("m");
  # Go from the left tip over the knot, which is the middle column, to the right tip, in the
  # scene's frame.
  leftLength @1 :Float64 $Meta.cxx("left_length") $Meta.unit("m");
  # The strand has this length between the left tip and the knot.
  leftTension @2 :Float64 $Meta.cxx("left_tension") $Meta.unit("N");
  # The tensions pull at the links beside the knot, from either side.
  rightTension @3 :Float64 $Meta.cxx("right_tension") $Meta.unit("N");
  stamp @4 :Int64 $Meta.clock("steady");
  valid @5 :Bool;
  # This is false before both tips are known, and apart from each other.
}

interface StrandView @0xffcefa0bd4f32fb9 $Meta.cxx("robots::StrandView") {
  subscribe @0 (events :StrandViewEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  strand @1 (sent :Rpc.Sent) -> (value :StrandState, stamp :Int64) $Meta.kind("read");
  # Returns the strand as it is at the end of the simulation's last cycle, which is its stamp.
}

interface StrandViewEvents @0xf34a05754eaad965 $Meta.eventsOf("robots::StrandView") {
  # What a subscriber of StrandView receives.

  state @0 (row :StrandViewStateRow) -> ();
  # A new row of the columns asked for.
}

struct StrandViewStateRow @0xe319b7f6e1bccccd $Meta.stateOf("robots::StrandView") {
  # One row of the state table: what the read commands of StrandView answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  strand @3 :StrandState;
}
