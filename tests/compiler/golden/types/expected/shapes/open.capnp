@0x892675ae26d282d0;
# The wire contract of shapes/open.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Containers = import "/shapes/containers.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("shapes::wire");
$Meta.header("shapes/open.h");

struct ShapesOpenOptionalRoot @0x91179475335c1f6c {
  union {
    none @0 :Void;
    some @1 :Root;
  }
}

struct ShapesOpenEntryOfTextToRoot @0xbc7d41300052e004 {
  key @0 :Text;
  value @1 :Root;
}

struct ShapesOpenEntryOfTextToListOfPoint @0xa8c3533e6eb12f51 {
  key @0 :Text;
  value @1 :List(Containers.Point);
}

struct ShapesOpenOptionalText @0xf3c25d3461f00058 {
  union {
    none @0 :Void;
    some @1 :Text;
  }
}

struct ShapesOpenEitherOfNothingOrTextOrPoint @0xbb3bebe320b04d4f {
  union {
    nothing @0 :Void;
    text @1 :Text;
    point @2 :Containers.Point;
  }
}

struct ShapesOpenTupleOfInt32AndText @0x869c92dc4e541a10 {
  item0 @0 :Int32;
  item1 @1 :Text;
}

struct ShapesOpenAnyMatrixOfFloat64 @0xcf0d7516d71f233a {
  rows @0 :UInt32;
  columns @1 :UInt32;
  data @2 :List(Float64);
  # Column after column.
}

struct ShapesOpenBulkMatrixOfFloat64 @0x891c2f0f0cffc982 {
  rows @0 :UInt32;
  columns @1 :UInt32;
  data @2 :Data $Meta.bulk("Float64");
  # Column after column.
}

struct Root @0xb6460a48efc46784 $Meta.cxx("shapes::Root") {
  # Holds itself, and another that holds it.

  value @0 :Int32;
  children @1 :List(Root);
  shadow @2 :ShapesOpenOptionalRoot;
  branches @3 :List(Branch);
}

struct Branch @0xd99efb214b19eb29 $Meta.cxx("shapes::Branch") {
  length @0 :Float64 $Meta.range(lowest = 0, highest = 10) $Meta.unit("m");
  roots @1 :List(ShapesOpenEntryOfTextToRoot);
}

struct Open @0xc2c5885ffab9947b $Meta.cxx("shapes::Open") {
  # Each level that may lack its bound, all of it or a part.

  name @0 :Text;
  samples @1 :List(Float64);
  bytes @2 :Data;
  block @3 :Data $Meta.bulk("Float32");
  flags @4 :List(Bool);
  path @5 :List(Containers.Point);
  pair @6 :List(Text) $Meta.shape("2");
  words @7 :List(Text) $Meta.capacity([2, 0]);
  shorts @8 :List(Text) $Meta.capacity([0, 3]);
  keys @9 :List(Text) $Meta.distinct([0]);
  series @10 :List(ShapesOpenEntryOfTextToListOfPoint);
  note @11 :ShapesOpenOptionalText;
  either @12 :ShapesOpenEitherOfNothingOrTextOrPoint;
  entry @13 :ShapesOpenTupleOfInt32AndText;
  joints @14 :List(Float64);
  any @15 :ShapesOpenAnyMatrixOfFloat64 $Meta.range(lowest = -1, highest = 1);
  wide @16 :ShapesOpenAnyMatrixOfFloat64 $Meta.capacity([2, 0]);
  cloud @17 :List(Float64) $Meta.shape("*,3x1");
  image @18 :ShapesOpenBulkMatrixOfFloat64;
  root @19 :Root;
}

interface Archive @0x82933d261358e2a1 $Meta.cxx("shapes::Archive") {
  # What a device may offer.

  subscribe @0 (events :ArchiveEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  put @1 (key :Text, value :Open, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(16);
  # Keeps `value` under `key`.
  remark @2 (text :Text, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.latest $Meta.queue(16);
  newest @3 (sent :Rpc.Sent) -> (value :Open, stamp :Int64) $Meta.kind("read");
  find @4 (pattern :Text, sent :Rpc.Sent) -> (value :List(Text)) $Meta.kind("qualifiedRead");
  replace @5 (value :Open, sent :Rpc.Sent) -> (value :Open) $Meta.kind("writeReturn")
      $Meta.queue(16);
}

interface ArchiveEvents @0xbd8392db1e3ed150 $Meta.eventsOf("shapes::Archive") {
  # What a subscriber of Archive receives.

  state @0 (row :ArchiveStateRow) -> ();
  # A new row of the columns asked for.
  renamed @1 (value :Text, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  grown @2 (value :Text, value2 :Root, stamp :Int64) -> () $Meta.queue(16);
  changed @3 (value :Open, stamp :Int64) -> () $Meta.latest $Meta.queue(16);
}

struct ArchiveStateRow @0xb725b4164d7d1953 $Meta.stateOf("shapes::Archive") {
  # One row of the state table: what the read commands of Archive answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  newest @3 :Open;
}
