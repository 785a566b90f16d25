@0xef6784ee0738ce77;
# The wire contract of guidance/guidance.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("guidance/guidance.h");

enum GuidanceState @0x909952bd3e04c1b4 $Meta.cxx("robots::GuidanceState") $Meta.underlying("UInt8") {
  preparing @0 $Meta.cxx("Preparing") $Meta.value(0);
  # waits for all four arms: connected, enabled, homed, and fresh data of each
  blind @1 $Meta.cxx("Blind") $Meta.value(1);
  # the arms are ready, but nobody has seen the knot lately; both slaves hold
  guiding @2 $Meta.cxx("Guiding") $Meta.value(2);
}

struct GuidanceProgress @0xb62a9e40cb04e11e $Meta.cxx("robots::GuidanceProgress") {
  knot @0 :Types.Vec3 $Meta.unit("m");
  # Where the knot is by the last sighting and by what the tips have moved since; in the scene.
  toGo @1 :Float64 $Meta.cxx("to_go") $Meta.unit("m");
  # Along the line of approach; below zero behind the target.
  aside @2 :Float64 $Meta.unit("m");
  # From the line of approach.
  stamp @3 :Int64 $Meta.clock("steady");
  valid @4 :Bool;
  # False unless the knot has been seen lately.
}

interface Guidance @0xf839a0ec32e2aeaf $Meta.cxx("robots::Guidance") {
  subscribe @0 (events :GuidanceEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  guidanceState @1 (sent :Rpc.Sent) -> (value :GuidanceState, stamp :Int64)
      $Meta.cxx("guidance_state") $Meta.kind("read");
  progress @2 (sent :Rpc.Sent) -> (value :GuidanceProgress, stamp :Int64) $Meta.kind("read");
}

interface GuidanceEvents @0xf87738b35a660df1 $Meta.eventsOf("robots::Guidance") {
  # What a subscriber of Guidance receives.

  state @0 (row :GuidanceStateRow) -> ();
  # A new row of the columns asked for.
  guidanceState @1 (value :GuidanceState) -> () $Meta.cxx("guidance_state") $Meta.latched
      $Meta.queue(16);
}

struct GuidanceStateRow @0xaa6c5932ff7a6316 $Meta.stateOf("robots::Guidance") {
  # One row of the state table: what the read commands of Guidance answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  guidanceState @3 :GuidanceState $Meta.cxx("guidance_state");
  progress @4 :GuidanceProgress;
}
