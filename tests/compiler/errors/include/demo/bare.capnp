@0xc00f7d55453c8ac6;
# The wire contract of demo/bare.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("demo/bare.h");

struct Bare @0xdbd73ce217fd4b0f $Meta.cxx("demo::Bare") {
  x @0 :Float64;
}
