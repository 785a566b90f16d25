@0xca9138a519013e8d;
# The wire contract of shapes/classes.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Containers = import "/shapes/containers.capnp";
$Cxx.namespace("shapes::wire");
$Meta.header("shapes/classes.h");

struct ShapesClassesOptionalTree @0xf7b33907f906a179 {
  union {
    none @0 :Void;
    some @1 :Tree;
  }
}

struct Named @0xccc486c4df2f3461 $Meta.cxx("shapes::Named") {
  # A base.

  name @0 :Text $Meta.capacity([8]);
}

struct Tool @0xe5bd6da39ee5e944 $Meta.cxx("shapes::Tool") {
  # Two bases, an instance of a template before its alias, and what is no part of the value.

  base @0 :Named;
  basePoint @1 :Containers.Point;
  last @2 :StampedPoint;
}

struct StampedPoint @0xec88aa97a6a3894e $Meta.cxx("shapes::StampedPoint") {
  # The names of the instances.

  value @0 :Containers.Point;
  time @1 :Float64 $Meta.unit("s");
}

struct StampedLevel @0x83c7f2fc47da3879 $Meta.cxx("shapes::StampedLevel") {
  value @0 :Containers.Level;
  time @1 :Float64 $Meta.unit("s");
}

struct Counter @0xe463426aa3168b27 $Meta.cxx("shapes::Counter") {
  # Keeps its members to itself.

  count @0 :Int32 $Meta.cxx("count_") $Meta.range(lowest = 0, highest = 100);
}

struct Tree @0xea3562721ddc08ed $Meta.cxx("shapes::Tree") {
  # Holds itself: legal where no slot is needed.

  value @0 :Int32;
  children @1 :List(Tree);
  shadow @2 :ShapesClassesOptionalTree;
}

struct Classes @0x82467f5d9967d4e1 $Meta.cxx("shapes::Classes") {
  # Everything above that has bounds.

  tool @0 :Tool;
  level @1 :StampedLevel;
  counter @2 :Counter;
  polar @3 :Containers.Point;
  spiral @4 :List(Containers.Point) $Meta.capacity([2]);
}
