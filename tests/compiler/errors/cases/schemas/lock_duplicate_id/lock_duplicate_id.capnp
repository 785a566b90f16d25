@0xaf56b96131a9743a;
# The wire contract of lock_duplicate_id.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("lock_duplicate_id.h");

struct Sample @0xdc331872b9f58ba1 $Meta.cxx("demo::Sample") {
  x @0 :Float64;
}

struct Other @0xdc331872b9f58ba1 $Meta.cxx("demo::Other") {
  x @0 :Float64;
}
