@0xb37fb3f86c395816;
# The wire contract of foreign/opencv.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("foreign::wire");
$Meta.header("foreign/opencv.h");

struct Point3d @0xd72865b36936b2ff $Meta.cxx("cv::Point3d") {
  x @0 :Float64;
  y @1 :Float64;
  z @2 :Float64;
}

struct Matx33d @0xdd860d932d3f8de3 $Meta.cxx("cv::Matx33d") {
  val @0 :List(Float64) $Meta.shape("9");
}

struct View @0xc334e999633b131f $Meta.cxx("foreign::View") {
  # A camera and what it sees.

  intrinsics @0 :Matx33d;
  points @1 :List(Point3d) $Meta.capacity([4]);
}

interface Camera @0xe5bd0c82c54c1c8c $Meta.cxx("foreign::Camera") {
  # Both sides of it.

  subscribe @0 (events :CameraEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  aim @1 (at :Point3d, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(16);
  view @2 (sent :Rpc.Sent) -> (value :View, stamp :Int64) $Meta.kind("read");
}

interface CameraEvents @0x8cac637286976832 $Meta.eventsOf("foreign::Camera") {
  # What a subscriber of Camera receives.

  state @0 (row :CameraStateRow) -> ();
  # A new row of the columns asked for.
}

struct CameraStateRow @0xb20e8f123205e142 $Meta.stateOf("foreign::Camera") {
  # One row of the state table: what the read commands of Camera answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  view @3 :View;
}
