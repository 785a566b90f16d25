@0xd8ab678bb59b95b2;
# The wire contract of lock_renamed_type.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("lock_renamed_type.h");

struct P @0xc562a87ca34d03d7 $Meta.cxx("demo::P") {
  x @0 :Float64;
}

struct Sample @0xdc331872b9f58ba1 $Meta.cxx("demo::Sample") {
  pose @0 :P;
}
