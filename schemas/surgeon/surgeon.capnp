@0xe5a73e95942e8ab5;
# The wire contract of surgeon/surgeon.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("surgeon/surgeon.h");

struct SurgeonParameters @0x87be51985ec39338 $Meta.cxx("robots::SurgeonParameters") {
  period @0 :Int64 $Meta.default("1000000") $Meta.period("1/1000000000");
  amplitude @1 :Float64 = 0.1 $Meta.range(lowest = 0, highest = 0.2) $Meta.unit("m");
  # The hand swings this far along its widest axis.
  turn @2 :Float64 = 0.3 $Meta.range(lowest = 0, highest = 1) $Meta.unit("rad");
  # The hand turns this far about its widest axis.
  frequency @3 :Float64 = 0.3 $Meta.range(lowest = 0.001, highest = 10) $Meta.unit("Hz");
  ramp @4 :Float64 = 1.0 $Meta.range(lowest = 0.1, highest = 100) $Meta.unit("s");
  # It takes this long to reach the full swing.
  opening @5 :Float64 = 0.5 $Meta.range(lowest = 0, highest = 1.047) $Meta.unit("rad");
  # The fingers open the gripper this far, as often as the hand swings.
}
