@0xd290544155ddda7b;
# The wire contract of 03_own_data_type/observation.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("tracking::wire");
$Meta.header("03_own_data_type/observation.h");

enum Visibility @0xbbada0527d771775 $Meta.cxx("tracking::Visibility") $Meta.underlying("UInt8") {
  hidden @0 $Meta.cxx("Hidden") $Meta.value(0);
  partial @1 $Meta.cxx("Partial") $Meta.value(1);
  full @2 $Meta.cxx("Full") $Meta.value(2);
}

struct Marker @0x8dd86c5318c04d7e $Meta.cxx("tracking::Marker") {
  number @0 :UInt32;
  position @1 :Types.Vec3 $Meta.unit("m");
}

struct Observation @0xb007f771f460d934 $Meta.cxx("tracking::Observation") {
  # An Observation is what a tracking camera knows of a surgical instrument at one moment, in the
  # camera's frame.

  instrument @0 :Text $Meta.capacity([31]);
  visibility @1 :Visibility;
  tip @2 :Types.Pose $Meta.unit("m");
  # The tip of the instrument has this pose.
  markers @3 :List(Marker) $Meta.capacity([8]);
  # The camera sees these markers.
  jawAngle @4 :Float64 $Meta.cxx("jaw_angle") $Meta.range(lowest = 0, highest = 1.6)
      $Meta.unit("rad");
  # The jaws of the instrument are open this far.
}
