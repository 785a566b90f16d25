@0x8f54fd5873057e94;
# The wire contract of lock_range.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("lock_range.h");

struct Sample @0xdc331872b9f58ba1 $Meta.cxx("demo::Sample") {
  x @0 :Float64 $Meta.range(lowest = 0, highest = 1);
}
