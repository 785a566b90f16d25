@0x854c63a2522ab075;
# The wire contract of shapes/guest.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("shapes::wire");
$Meta.header("shapes/guest.h");

struct Limits @0xce8c1d08b5688782 $Meta.cxx("guest::Limits") {
  low @0 :Float64 = -1.0 $Meta.unit("N");
  high @1 :Float64 = 1.0 $Meta.unit("N");
}
