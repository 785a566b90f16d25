@0xb1c95e7f02d48a9b;
# The wire contract of gone.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("gone.h");

struct Part @0xb1c95e7f02d48a91 $Meta.cxx("demo::Part") {
  y @0 :Float64;
}
