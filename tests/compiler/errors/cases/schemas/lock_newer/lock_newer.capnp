@0x8439772eff28d8d0;
# The wire contract of lock_newer.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("lock_newer.h");

struct Sample @0xdc331872b9f58ba1 $Meta.cxx("demo::Sample") $Meta.encrypted {
  x @0 :Float64;
}
