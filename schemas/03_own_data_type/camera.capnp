@0xcc3bc3f3a3efe5f6;
# The wire contract of 03_own_data_type/camera.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Observation = import "/03_own_data_type/observation.capnp";
$Cxx.namespace("tracking::wire");
$Meta.header("03_own_data_type/camera.h");

struct CameraParameters @0xae270534326f144a $Meta.cxx("tracking::CameraParameters") {
  # The deployment file gives these as JSON, including the whole observation.

  first @0 :Observation.Observation;
  # The camera sees this first.
  turnRate @1 :Float64 = 0.5 $Meta.cxx("turn_rate") $Meta.range(lowest = -10, highest = 10)
      $Meta.unit("rad/s");
  # The instrument turns this fast about its own z axis.
}
