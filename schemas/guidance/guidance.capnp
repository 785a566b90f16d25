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
  # waits for the registration, and for all four arms: connected, enabled, homed,
  # fresh data of each, and slaves that take goals
  blind @1 $Meta.cxx("Blind") $Meta.value(1);
  # the arms are ready, but nobody has seen the knot lately; both slaves hold
  guiding @2 $Meta.cxx("Guiding") $Meta.value(2);
  disabled @3 $Meta.cxx("Disabled") $Meta.value(3);
  # until enable(); also since a slave refused its goals for a reason that stays
  clutched @4 $Meta.cxx("Clutched") $Meta.value(4);
  # a pedal takes the masters from their slaves, or nobody is at the console: both
  # slaves hold, and the masters are the surgeon's to move
}

struct GuidanceProgress @0xb62a9e40cb04e11e $Meta.cxx("robots::GuidanceProgress") {
  knot @0 :Types.Vec3 $Meta.unit("m");
  # The knot is here by the last sighting and by what the tips have moved since, in the scene.
  removed1 @1 :Float64 $Meta.cxx("to_go") $Meta.removed("toGo") $Meta.unit("m");
  removed2 @2 :Float64 $Meta.removed("aside") $Meta.unit("m");
  stamp @3 :Int64 $Meta.clock("steady");
  # The stamp is that of the guide's cycle.
  valid @4 :Bool;
  # This is false unless the knot has been seen lately.
  distanceToTarget @5 :Float64 $Meta.cxx("distance_to_target") $Meta.unit("m");
  # The knot has this distance to go along the line of approach; it is below zero behind the
  # target.
  lateralError @6 :Float64 $Meta.cxx("lateral_error") $Meta.unit("m");
  # The knot has this distance from the line of approach.
}

interface Guidance @0xf839a0ec32e2aeaf $Meta.cxx("robots::Guidance") {
  # Commands run in the guide's own thread before its next cycle; reads are from the end of its last
  # one.

  subscribe @0 (events :GuidanceEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  guidanceState @1 (sent :Rpc.Sent) -> (value :GuidanceState, stamp :Int64)
      $Meta.cxx("guidance_state") $Meta.kind("read");
  progress @2 (sent :Rpc.Sent) -> (value :GuidanceProgress, stamp :Int64) $Meta.kind("read");
  # The guide updates this even while it waits for something, as far as the knot has been seen.
  enable @3 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Enables and homes arms that are not, then guides. This also works after an arm was disabled or
  # restarted. It does not enable an arm in FAULT: the operator who has removed the cause does.
  disable @4 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Stops guiding. Both slaves hold.
  forbiddenMotion @5 (sent :Rpc.Sent) -> (value :ForbiddenMotion, stamp :Int64)
      $Meta.cxx("forbidden_motion") $Meta.kind("read");
  # A client at the masters makes hands feel this, as components/force_feedback says.
}

interface GuidanceEvents @0xf87738b35a660df1 $Meta.eventsOf("robots::Guidance") {
  # What a subscriber of Guidance receives.

  state @0 (row :GuidanceStateRow) -> ();
  # A new row of the columns asked for.
  guidanceState @1 (value :GuidanceState, stamp :Int64) -> () $Meta.cxx("guidance_state")
      $Meta.latched $Meta.queue(16);
  # Reports each change, and the last one to a client that connects.
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
  forbiddenMotion @5 :ForbiddenMotion $Meta.cxx("forbidden_motion");
}

struct ForbiddenMotion @0xae50c2ec0f36c217 $Meta.cxx("robots::ForbiddenMotion") {
  # Says how fast the hands lead each tip where the fixtures let none go, in the scene: what a hand
  # should feel of them. What a fixture only delays is not in it.

  left @0 :Types.Vec3 $Meta.unit("m/s");
  right @1 :Types.Vec3 $Meta.unit("m/s");
  stamp @2 :Int64 $Meta.clock("steady");
  # The stamp is that of the guide's cycle.
  valid @3 :Bool;
  # This is false while the guide does not guide.
}
