@0xcbc20f93922dba58;
# The wire contract of person/axis_range.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("person/axis_range.h");

struct AxisRange @0x84fffca3b307b5df $Meta.cxx("robots::AxisRange") {
  # Holds what an absolute axis of an input device says at its two ends. `evtest` prints it.

  lowest @0 :Int32;
  highest @1 :Int32;
}
