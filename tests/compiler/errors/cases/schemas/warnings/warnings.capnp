@0xebc13af18ff05937;
# The wire contract of warnings.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("warnings.h");

struct Fields @0xf8746822564976b9 $Meta.cxx("demo::Fields") {
  size @0 :UInt64;
  whole @1 :Int64;
  all @2 :List(UInt64);
  fine @3 :Int64;
  also @4 :Int64 $Meta.period("1/1");
  braces @5 :Int32;
}
