@0x938cff53f31b4597;
# The wire contract of robots/simulated_arm.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Arm = import "/robots/arm.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robots/simulated_arm.h");

struct ArmParameters @0xb1e811bf96bf0bda $Meta.cxx("robots::ArmParameters") {
  # How a simulated arm behaves.

  rate @0 :Float64 = 1000.0 $Meta.range(lowest = 1, highest = 4000) $Meta.unit("Hz");
  name @1 :Text;
  start @2 :Arm.Mode = disabled;
}
