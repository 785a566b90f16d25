@0xbbff816fbc12322a;
# The wire contract of robots/geometry.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robots/geometry.h");

struct PoseStamped @0xe61654a89cf5f1dd $Meta.cxx("robots::PoseStamped") {
  # A pose with its time.

  pose @0 :Types.Pose;
  stamp @1 :Int64 $Meta.clock("steady");
  valid @2 :Bool;
}
