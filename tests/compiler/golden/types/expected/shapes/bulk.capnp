@0x86a43b32d21a7bd4;
# The wire contract of shapes/bulk.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("shapes::wire");
$Meta.header("shapes/bulk.h");

struct ShapesBulkBulkMatrixOfFloat64 @0xd4dcdfa05a1a2879 {
  rows @0 :UInt32;
  columns @1 :UInt32;
  data @2 :Data $Meta.bulk("Float64");
  # Column after column.
}

struct Bulk @0xafafe161bf69179e $Meta.cxx("shapes::Bulk") {
  # One of each that may be bulk().

  samples @0 :Data $Meta.bulk("Float64") $Meta.capacity([6]) $Meta.unit("m");
  triple @1 :Data $Meta.bulk("Int16") $Meta.range(lowest = -5, highest = 5) $Meta.shape("3");
  bytes @2 :Data $Meta.bulk("UInt8") $Meta.capacity([4]);
  line @3 :Data $Meta.bulk("Float32") $Meta.capacity([5]);
  jacobian @4 :Data $Meta.bulk("Float64") $Meta.shape("6x7");
  image @5 :ShapesBulkBulkMatrixOfFloat64 $Meta.capacity([3, 4]);
}
