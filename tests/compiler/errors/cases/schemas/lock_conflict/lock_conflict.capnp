@0xa3a1d9027b76b66f;
# The wire contract of lock_conflict.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("lock_conflict.h");

<<<<<<< HEAD
struct Sample @0xdc331872b9f58ba1 $Meta.cxx("demo::Sample") {
  x @0 :Float64;
}
