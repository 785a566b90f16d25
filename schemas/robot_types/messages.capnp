@0xd1c776242b65972f;
# The wire contract of robot_types/messages.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robot_types/messages.h");

struct IntervalStatistics @0xff815195ac6343a7 $Meta.cxx("robots::IntervalStatistics") {
  # Says how regularly a task ran, over its last window.

  periodAverage @0 :Float64 $Meta.cxx("period_average") $Meta.unit("s");
  periodDeviation @1 :Float64 $Meta.cxx("period_deviation") $Meta.unit("s");
  periodMin @2 :Float64 $Meta.cxx("period_min") $Meta.unit("s");
  periodMax @3 :Float64 $Meta.cxx("period_max") $Meta.unit("s");
  samples @4 :UInt32;
  stamp @5 :Int64 $Meta.clock("steady");
  valid @6 :Bool;
}

struct KeyValue @0xf3874f7cf68c260c $Meta.cxx("robots::KeyValue") {
  # Corresponds to cisst's prmKeyValue.

  key @0 :Text $Meta.capacity([31]);
  value @1 :Text $Meta.capacity([127]);
}
