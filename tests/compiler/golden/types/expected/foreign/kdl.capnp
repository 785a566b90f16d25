@0xddb721a90794c9f4;
# The wire contract of foreign/kdl.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("foreign::wire");
$Meta.header("foreign/kdl.h");

struct Vector @0xbe46bbfe28549eed $Meta.cxx("KDL::Vector") {
  data @0 :List(Float64) $Meta.shape("3") $Meta.unit("m");
}

struct Rotation @0xf7cf6aca287bb3c1 $Meta.cxx("KDL::Rotation") {
  data @0 :List(Float64) $Meta.shape("9");
}

struct Frame @0xc65a4750af37dcb9 $Meta.cxx("KDL::Frame") {
  p @0 :Vector;
  m @1 :Rotation $Meta.cxx("M");
}

struct Twist @0x873ad597f2439552 $Meta.cxx("KDL::Twist") {
  vel @0 :Vector;
  rot @1 :Vector;
}

struct Wrench @0xdc544cb445497a8c $Meta.cxx("KDL::Wrench") {
  force @0 :Vector;
  torque @1 :Vector;
}

struct Joints @0xed540682a9f375b0 $Meta.cxx("KDL::JntArray") {
  data @0 :List(Float64) $Meta.capacity([7]) $Meta.range(lowest = -6.5, highest = 6.5);
}

struct Motion @0xfb97dc0b4d445858 $Meta.cxx("foreign::Motion") {
  # All of them in a struct of ours.

  frame @0 :Frame;
  twist @1 :Twist;
  wrench @2 :Wrench;
  joints @3 :Joints;
}
