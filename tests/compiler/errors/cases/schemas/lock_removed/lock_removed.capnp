@0xa3119cc93b955c0d;
# The wire contract of lock_removed.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("lock_removed.h");

struct Sample @0xdc331872b9f58ba1 $Meta.cxx("demo::Sample") {
  x @0 :Float64;
  y @1 :Float64;
}
