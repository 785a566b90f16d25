@0xd9d7c3cacc4b8d9e;
# The wire contract of vision/tracked_object.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Cartesian = import "/robot_types/cartesian.capnp";
using Pose = import "/robot_types/pose.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("vision/tracked_object.h");

interface TrackedObject @0xcf966e39ebac7c24 $Meta.cxx("robots::TrackedObject") {
  # A TrackedObject is a ball in the frame of the left camera: x to the right and y downward in the
  # image, z ahead. It has no orientation, so that of its pose is the camera's.

  subscribe @0 (events :TrackedObjectEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  measuredCp @1 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64)
      $Meta.cxx("measured_cp") $Meta.kind("read");
  # Says where it is at the stamp, which is that of the tracker's cycle: images are old when they
  # come, and this is what they showed, extrapolated by its velocity. It is not valid unless the
  # last pair of images showed it, and not long ago.
  measuredCv @2 (sent :Rpc.Sent) -> (value :Cartesian.Twist, stamp :Int64) $Meta.cxx("measured_cv")
      $Meta.kind("read");
  # Says how fast it moves; it is valid when the pose is.
}

interface TrackedObjectEvents @0xaefa37f144e6fbd6 $Meta.eventsOf("robots::TrackedObject") {
  # What a subscriber of TrackedObject receives.

  state @0 (row :TrackedObjectStateRow) -> ();
  # A new row of the columns asked for.
}

struct TrackedObjectStateRow @0xf542a4f122cd9459 $Meta.stateOf("robots::TrackedObject") {
  # One row of the state table: what the read commands of TrackedObject answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  measuredCp @3 :Pose.PoseStamped $Meta.cxx("measured_cp");
  measuredCv @4 :Cartesian.Twist $Meta.cxx("measured_cv");
}
