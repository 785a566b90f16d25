@0xacd2a0841bf9bd3b;
# The wire contract of lock_moved.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("lock_moved.h");

struct Sample @0xdc331872b9f58ba1 $Meta.cxx("demo::Sample") {
  x @0 :Float64;
}
