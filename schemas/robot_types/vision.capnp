@0x9bfae03c52559fcb;
# The wire contract of robot_types/vision.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robot_types/vision.h");

struct PoseArray @0x82e359ec39f34eeb $Meta.cxx("robots::PoseArray") {
  # A PoseArray has the poses of several tools at once. Corresponds to cisst's
  # prmPositionCartesianArrayGet.

  referenceFrame @0 :Text $Meta.capacity([15]) $Meta.cxx("reference_frame");
  movingFrames @1 :List(Text) $Meta.capacity([16, 15]) $Meta.cxx("moving_frames");
  positions @2 :List(Types.Pose) $Meta.capacity([16]) $Meta.unit("m");
  visible @3 :List(Bool) $Meta.capacity([16]);
  stamp @4 :Int64 $Meta.clock("steady");
  valid @5 :Bool;
}

struct ImageFrame @0xbc8f68d82913b3fb $Meta.cxx("robots::ImageFrame") {
  # Corresponds to cisst's prmImageFrame.

  width @0 :UInt32;
  height @1 :UInt32;
  channels @2 :UInt32;
  data @3 :Data $Meta.capacity([2097152]);
  # Goes row by row, channels interleaved, 8 bits each.
  stamp @4 :Int64 $Meta.clock("steady");
  valid @5 :Bool;
}

struct CameraInfo @0x9e06e5f90a5909e5 $Meta.cxx("robots::CameraInfo") {
  # A CameraInfo is a pinhole camera with its distortion. Corresponds to cisst's prmCameraInfo.

  width @0 :UInt32;
  height @1 :UInt32;
  distortion @2 :List(Float64) $Meta.shape("5");
  # The order is k1, k2, p1, p2, k3 (Brown and Conrady).
  intrinsic @3 :Types.Mat3 $Meta.unit("px");
  rectification @4 :Types.Mat3;
  projection @5 :List(Float64) $Meta.shape("3x4");
  # The matrix is 3 x 4, of the rectified image.
  stamp @6 :Int64 $Meta.clock("steady");
  valid @7 :Bool;
}

struct DepthMap @0xc2fcffc3788a4bec $Meta.cxx("robots::DepthMap") {
  # A DepthMap is a cloud of coloured points. Corresponds to cisst's prmDepthMap.

  referenceFrame @0 :Text $Meta.capacity([15]) $Meta.cxx("reference_frame");
  width @1 :UInt32;
  height @2 :UInt32;
  points @3 :List(Float32) $Meta.capacity([196608]) $Meta.unit("m");
  # Each point has three entries: x, y, z.
  color @4 :Data $Meta.capacity([196608]);
  # Each point has three entries: red, green, blue.
  stamp @5 :Int64 $Meta.clock("steady");
  valid @6 :Bool;
}
