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
  # Is the standard deviation of each channel of each pixel, of 255.
  blur @2 :Float64 = 0.6 $Meta.range(lowest = 0, highest = 3) $Meta.unit("px");
  # Is the standard deviation of a point's light.
  dropout @3 :Float64 = 0.01 $Meta.range(lowest = 0, highest = 1);
  # Is the share of the pairs that are lost on their way.
  latency @4 :Int64 = 30000000 $Meta.default("10000000") $Meta.period("1/1000000000");
  # Is the time from the exposure until a pair is there; the time that drawing takes is added. It
  # is half a second at most, because the strand keeps no more of its past.
  vergence @5 :Float64 $Meta.range(lowest = -0.1, highest = 0.1) $Meta.unit("rad");
  # Is by how much the right camera is turned toward the left one's axis, which nobody is told.
}
