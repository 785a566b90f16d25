@0x819b692a9727067b;
# The wire contract of vision/synthetic_endoscope.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("vision/synthetic_endoscope.h");

struct EndoscopeParameters @0x81c804e92c547797 $Meta.cxx("robots::EndoscopeParameters") {
  # Blur, dropouts and latency are our own numbers, because none was found for an endoscope of this
  # kind.

  period @0 :Int64 = 66667000 $Meta.period("1/1000000000");
  # Gives 15 images a second, as in the da Vinci Research Kit's stereo launch file; a fast machine
  # can have 60.
  noise @1 :Float64 = 3.0 $Meta.range(lowest = 0, highest = 5);
  # Each channel of each pixel has noise of this standard deviation, of 255.
  blur @2 :Float64 = 0.6 $Meta.range(lowest = 0, highest = 3) $Meta.unit("px");
  # A point's light is spread with this standard deviation.
  dropout @3 :Float64 = 0.01 $Meta.range(lowest = 0, highest = 1);
  # This share of the pairs is lost on its way.
  latency @4 :Int64 = 30000000 $Meta.default("10000000") $Meta.period("1/1000000000");
  # A pair is there this long after its exposure; the time that drawing takes is added. It is half
  # a second at most, because the strand keeps no more of its past.
  vergence @5 :Float64 $Meta.range(lowest = -0.1, highest = 0.1) $Meta.unit("rad");
  # The right camera is turned by this toward the left one's axis, which nobody is told.
}
