@0x819b692a9727067b;
# The wire contract of vision/synthetic_endoscope.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("vision/synthetic_endoscope.h");

struct EndoscopeParameters @0x81c804e92c547797 $Meta.cxx("robots::EndoscopeParameters") {
  # Blur, dropouts and latency are our own figures: none was found for an endoscope of this kind.

  period @0 :Int64 = 66667000 $Meta.period("1/1000000000");
  # 15 images a second, as the da Vinci Research Kit's stereo launch file has it; where there is
  # room, 60.
  noise @1 :Float64 = 3.0 $Meta.range(lowest = 0, highest = 5);
  # Standard deviation of each channel of each pixel, of 255.
  blur @2 :Float64 = 0.6 $Meta.range(lowest = 0, highest = 3) $Meta.unit("px");
  # Standard deviation of a point's light.
  dropout @3 :Float64 = 0.01 $Meta.range(lowest = 0, highest = 1);
  # Share of the pairs that are lost on their way.
  latency @4 :Int64 = 30000000 $Meta.default("10000000") $Meta.period("1/1000000000");
  # From the exposure until a pair is there; the time that drawing takes comes on top. Beyond what
  # the strand keeps of its past, half a second, nothing is seen.
  vergence @5 :Float64 $Meta.range(lowest = -0.1, highest = 0.1) $Meta.unit("rad");
  # By how much the right camera is turned toward the left one's axis, which nobody is told.
}
