@0xbfb1450190ad6776;
# The wire contract of coordinator/coordinator.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("coordinator/coordinator.h");

struct CoordinatorParameters @0xd3f3d59d64dba2a2 $Meta.cxx("robots::CoordinatorParameters") {
  period @0 :Int64 = 1000000 $Meta.period("1/1000000000");
  # The permit is renewed once in this period, and a command to stop may wait as long.
  buttons @1 :List(Text) $Meta.capacity([8, 63]);
  # Names the clients without which nobody could press the stop, such as "desk:Panel/Stop". One
  # whose connection ends presses it, and it is not released before all are connected.
}
