@0xe731f1d83eb65927;
# The wire contract of robot_types/side.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robot_types/side.h");

enum Side @0xc0f52a1d56f2b1f3 $Meta.cxx("robots::Side") $Meta.underlying("UInt8") {
  # Says which of two it is, as the surgeon at the console sees them.

  left @0 $Meta.cxx("Left") $Meta.value(0);
  right @1 $Meta.cxx("Right") $Meta.value(1);
}
