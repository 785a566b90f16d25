@0xb1fe6dc822ba0506;
# The wire contract of robot_types/pose.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robot_types/pose.h");

struct PoseStamped @0xe84bc0a4b9a0c529 $Meta.cxx("robots::PoseStamped") {
  # A PoseStamped is a pose at a time: what CRTK's measured_cp, setpoint_cp and servo_cp carry.

  pose @0 :Types.Pose $Meta.unit("m");
  # The pose is that of the interface's moving frame in its reference frame.
  stamp @1 :Int64 $Meta.clock("steady");
  # The pose was true at this time; for a set-point it is the stamp of the data from which it was
  # made.
  valid @2 :Bool;
  # If it is false, do not use it.
}

struct PoseSample @0x9dcf31510b46998d $Meta.cxx("robots::PoseSample") {
  # A PoseSample is the pose of the latency measurements: 120 bytes and no strings.

  rotation @0 :Types.Mat3;
  position @1 :Types.Vec3 $Meta.unit("m");
  stamp @2 :Int64 $Meta.clock("steady");
  sequence @3 :UInt64;
  flags @4 :UInt64;
}

struct PosePrm @0xedd17c97b8723561 $Meta.cxx("robots::PosePrm") {
  # A PosePrm has the fields of the cisst libraries' prmPositionCartesianGet, the type of the
  # paper's measurements.

  timestamp @0 :Int64 $Meta.clock("steady");
  automaticTimestamp @1 :Bool = true $Meta.cxx("automatic_timestamp");
  # This is true if the provider stamps the data itself.
  valid @2 :Bool;
  movingFrame @3 :Text $Meta.capacity([15]) $Meta.cxx("moving_frame");
  referenceFrame @4 :Text $Meta.capacity([15]) $Meta.cxx("reference_frame");
  position @5 :Types.Pose $Meta.unit("m");
  # The moving frame is here in the reference frame.
}

struct TransformStamped @0xee7e9483e69ea03a $Meta.cxx("robots::TransformStamped") {
  # Says where one frame is in another, for a reader that cannot know from the interface which they
  # are.

  transform @0 :Types.Pose $Meta.unit("m");
  # The moving frame is here in the reference frame.
  referenceFrame @1 :UInt32 $Meta.cxx("reference_frame");
  # Each is suture::frameId() of a frame's name; 0 means not named.
  movingFrame @2 :UInt32 $Meta.cxx("moving_frame");
  stamp @3 :Int64 $Meta.clock("steady");
  valid @4 :Bool;
  # If it is false, do not use it.
}
