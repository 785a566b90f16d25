@0xd0ec6d5e9874d12e;
# The wire contract of pedals/scripted_pedals.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("pedals/scripted_pedals.h");

struct ScriptedPedalsParameters @0xb6e10f137b585887 $Meta.cxx("robots::ScriptedPedalsParameters") {
  period @0 :Int64 = 5000000 $Meta.period("1/1000000000");
  clutchAfter @1 :Int64 $Meta.cxx("clutch_after") $Meta.period("1/1000000000");
  # The clutch is pressed this long after the start, and released this much later; 0 means never.
  clutchFor @2 :Int64 = 1000000000 $Meta.cxx("clutch_for") $Meta.period("1/1000000000");
  leaveAfter @3 :Int64 $Meta.cxx("leave_after") $Meta.period("1/1000000000");
  # The surgeon leaves the viewer this long after the start, and is back this much later; 0 means
  # never.
  leaveFor @4 :Int64 = 1000000000 $Meta.cxx("leave_for") $Meta.period("1/1000000000");
}
