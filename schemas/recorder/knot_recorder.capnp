@0xd69c0d35bb4b3eba;
# The wire contract of recorder/knot_recorder.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("recorder/knot_recorder.h");

struct KnotRecorderParameters @0xff35084e9452e5ea $Meta.cxx("robots::KnotRecorderParameters") {
  period @0 :Int64 = 20000000 $Meta.period("1/1000000000");
  file @1 :Text $Meta.capacity([255]);
  # The file gets one JSON line for each row. It is replaced at the start.
}
