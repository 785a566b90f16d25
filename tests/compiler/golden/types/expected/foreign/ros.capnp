@0xc7c1f4dd5ea1cf1d;
# The wire contract of foreign/ros.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("foreign::wire");
$Meta.header("foreign/ros.h");

struct Time @0xd469dfdb02a85800 $Meta.cxx("ros::Time") {
  sec @0 :UInt32;
  nsec @1 :UInt32;
}

struct Header @0x874b955740817b26 $Meta.cxx("foreign::Header") {
  seq @0 :UInt32;
  stamp @1 :Time;
  frameId @2 :Text $Meta.capacity([16]) $Meta.cxx("frame_id");
}

struct Point @0xbb6808216c2f0dab $Meta.cxx("foreign::Point") {
  x @0 :Float64 $Meta.unit("m");
  y @1 :Float64 $Meta.unit("m");
  z @2 :Float64 $Meta.unit("m");
}

struct Quaternion @0xbf1a8ebef33ed708 $Meta.cxx("foreign::Quaternion") {
  x @0 :Float64;
  y @1 :Float64;
  z @2 :Float64;
  w @3 :Float64;
}

struct Pose @0xc187602190c09932 $Meta.cxx("foreign::Pose") {
  position @0 :Point;
  orientation @1 :Quaternion;
}

struct PoseStamped @0x9a63f82b15817226 $Meta.cxx("foreign::PoseStamped") {
  header @0 :Header;
  pose @1 :Pose;
}

struct JointState @0xb128de350f6d225c $Meta.cxx("foreign::JointState") {
  header @0 :Header;
  name @1 :List(Text) $Meta.capacity([4, 12]);
  position @2 :List(Float64) $Meta.capacity([4]) $Meta.unit("rad");
  velocity @3 :List(Float64) $Meta.capacity([4]);
  effort @4 :List(Float64) $Meta.capacity([4]);
}
