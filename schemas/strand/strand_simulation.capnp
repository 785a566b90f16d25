@0xf323a5a1a758b888;
# The wire contract of strand/strand_simulation.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("strand/strand_simulation.h");

struct StrandParameters @0x831b7f4df78efb84 $Meta.cxx("robots::StrandParameters") {
  period @0 :Int64 = 1000000 $Meta.period("1/1000000000");
  length @1 :Float64 = 0.11 $Meta.range(lowest = 0.02, highest = 1) $Meta.unit("m");
  friction @2 :Float64 = 0.15 $Meta.range(lowest = 0, highest = 1);
  # Strand on strand has this coefficient of friction.
  wrap @3 :Float64 = 9.42 $Meta.range(lowest = 0, highest = 100) $Meta.unit("rad");
  # The strand winds about itself by this angle in the knot.
  removed4 @4 :Float64 = -0.16 $Meta.range(lowest = -1, highest = 1) $Meta.removed("floor")
      $Meta.unit("m");
}
