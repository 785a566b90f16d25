@0xc0b75a8234544fe5;
# The wire contract of reference/simulated_arm.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("reference::wire");
$Meta.header("reference/simulated_arm.h");

struct SimulatedArmParameters @0xcfc69aa353123bc5 $Meta.cxx("reference::SimulatedArmParameters") {
  # Parameters of SimulatedArm.

  period @0 :Float64 = 0.001 $Meta.range(lowest = 1e-04, highest = 1) $Meta.unit("s");
  home @1 :List(Float64) $Meta.shape("3") $Meta.unit("m");
  model @2 :Text;
}
