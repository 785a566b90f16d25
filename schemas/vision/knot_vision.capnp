@0xad43d496b00ba449;
# The wire contract of vision/knot_vision.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("vision/knot_vision.h");

struct KnotSighting @0x952267eec9de3f8a $Meta.cxx("robots::KnotSighting") {
  # Its points are in the frame of the left camera: x to the right and y downward in the image, z
  # ahead.

  knot @0 :Types.Vec3 $Meta.unit("m");
  leftTip @1 :Types.Vec3 $Meta.cxx("left_tip") $Meta.unit("m");
  rightTip @2 :Types.Vec3 $Meta.cxx("right_tip") $Meta.unit("m");
  stamp @3 :Int64 $Meta.clock("steady");
  # The images were exposed at this time.
  valid @4 :Bool;
  # This is false unless both eyes see all three.
}

interface KnotVision @0xd18623f4fbc55b4a $Meta.cxx("robots::KnotVision") {
  subscribe @0 (events :KnotVisionEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  sighting @1 (sent :Rpc.Sent) -> (value :KnotSighting, stamp :Int64) $Meta.kind("read");
  # Returns what the last pair of images showed.
}

interface KnotVisionEvents @0xe0f71ba712630172 $Meta.eventsOf("robots::KnotVision") {
  # What a subscriber of KnotVision receives.

  state @0 (row :KnotVisionStateRow) -> ();
  # A new row of the columns asked for.
}

struct KnotVisionStateRow @0xfa13a8593a8dcb16 $Meta.stateOf("robots::KnotVision") {
  # One row of the state table: what the read commands of KnotVision answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  sighting @3 :KnotSighting;
}
