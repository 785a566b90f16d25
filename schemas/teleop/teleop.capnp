@0xa6f662633b91810f;
# The wire contract of teleop/teleop.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("teleop/teleop.h");

struct TeleopParameters @0xd4e01364c600f6cf $Meta.cxx("robots::TeleopParameters") {
  period @0 :Int64 $Meta.period("1/1000000000");
  scale @1 :Float64 = 0.2 $Meta.range(lowest = 0.01, highest = 10);
  # Slave metres a master metre.
  maxAge @2 :Int64 $Meta.cxx("max_age") $Meta.period("1/1000000000");
  # Data older than this are not acted on: following ends, and begins anew when they are fresh
  # again.
  enableAtStart @3 :Bool = true $Meta.cxx("enable_at_start");
  # Prepare and follow without waiting for enable().
}
