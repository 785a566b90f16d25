@0xa67d278646a3f4ef;
# The wire contract of surgeon/knot_surgeon.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("surgeon/knot_surgeon.h");

struct KnotSurgeonParameters @0xa30b5f3d86ca53ce $Meta.cxx("robots::KnotSurgeonParameters") {
  period @0 :Int64 = 1000000 $Meta.period("1/1000000000");
  carry @1 :Types.Vec3 $Meta.unit("m");
  # Both hands go by this from where they first are, in the masters' base frames.
  duration @2 :Float64 = 4.0 $Meta.range(lowest = 0.1, highest = 100) $Meta.unit("s");
  # That takes this long, and after each interruption what is left of it.
  sway @3 :Float64 = 0.005 $Meta.range(lowest = 0, highest = 0.05) $Meta.unit("m");
  # The hands sway this far to the side meanwhile and afterwards, and this often.
  swayFrequency @4 :Float64 = 0.5 $Meta.cxx("sway_frequency") $Meta.range(lowest = 0, highest = 10)
      $Meta.unit("Hz");
}
