@0x819b692a9727067b;
# The wire contract of vision/synthetic_endoscope.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("vision/synthetic_endoscope.h");

struct EndoscopeParameters @0x81c804e92c547797 $Meta.cxx("robots::EndoscopeParameters") {
  period @0 :Int64 = 66667000 $Meta.period("1/1000000000");
  # 15 images a second, as the da Vinci Research Kit's stereo launch file has it.
  noise @1 :Float64 = 3.0 $Meta.range(lowest = 0, highest = 5);
  # Standard deviation of each channel of each pixel, of 255.
}
