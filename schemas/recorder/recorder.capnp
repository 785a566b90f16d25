@0xc8bb3e9841202df8;
# The wire contract of recorder/recorder.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("recorder/recorder.h");

struct RecorderParameters @0xf93ade88705176f1 $Meta.cxx("robots::RecorderParameters") {
  period @0 :Int64 $Meta.default("1000000") $Meta.period("1/1000000000");
  # Must be at least as fast as the arm, or cycles are missed.
  file @1 :Text $Meta.capacity([255]);
  # The file gets one JSON line for each record. It is replaced at the start.
}
