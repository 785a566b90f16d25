@0xada579141debe7c2;
# The wire contract of shapes/containers.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("shapes::wire");
$Meta.header("shapes/containers.h");

enum Level @0xa46142666f1d7c70 $Meta.cxx("shapes::Level") $Meta.underlying("Int16") {
  # Sparse, negative, and ready for what later versions add.

  unknown @0 $Meta.cxx("Unknown") $Meta.fallback $Meta.value(-1);
  low @1 $Meta.cxx("Low") $Meta.value(10);
  high @2 $Meta.cxx("High") $Meta.value(300);
}

struct ShapesContainersEntryOfTextToFloat64 @0xe48709dcb204eab3 {
  key @0 :Text;
  value @1 :Float64;
}

struct ShapesContainersEntryOfUInt16ToPoint @0x802b99a8ef527e43 {
  key @0 :UInt16;
  value @1 :Point;
}

struct ShapesContainersEntryOfTextToListOfFloat32 @0xe8944577cbd7d345 {
  key @0 :Text;
  value @1 :List(Float32);
}

struct ShapesContainersEntryOfLevelToFloat64 @0xd457ac67cfb958f3 {
  key @0 :Level;
  value @1 :Float64;
}

struct ShapesContainersOptionalFloat64 @0x9a6cebde1c465fb4 {
  union {
    none @0 :Void;
    some @1 :Float64;
  }
}

struct ShapesContainersOptionalBool @0x87471a777724acdf {
  union {
    none @0 :Void;
    some @1 :Bool;
  }
}

struct ShapesContainersOptionalText @0xa13ea2f47ac175b5 {
  union {
    none @0 :Void;
    some @1 :Text;
  }
}

struct ShapesContainersOptionalPoint @0x93456d793990e99b {
  union {
    none @0 :Void;
    some @1 :Point;
  }
}

struct ShapesContainersOptionalListOfPoint @0x87412f55480b65f2 {
  union {
    none @0 :Void;
    some @1 :List(Point);
  }
}

struct ShapesContainersOptionalInt32 @0x89f4ac8eee93a31a {
  union {
    none @0 :Void;
    some @1 :Int32;
  }
}

struct ShapesContainersOptionalOptionalInt32 @0x997d382cf61c2bb6 {
  union {
    none @0 :Void;
    some @1 :ShapesContainersOptionalInt32;
  }
}

struct ShapesContainersOptionalVec3 @0x93f6eb2708268fd2 {
  union {
    none @0 :Void;
    some @1 :Types.Vec3;
  }
}

struct ShapesContainersTupleOfInt32AndFloat64 @0xa8fca31255af753f {
  item0 @0 :Int32;
  item1 @1 :Float64;
}

struct ShapesContainersTupleOfBoolAndTextAndPoint @0xd1cc96f9d5534dc0 {
  item0 @0 :Bool;
  item1 @1 :Text;
  item2 @2 :Point;
}

struct ShapesContainersEitherOfNothingOrFloat64OrPointOrTextOrFloat64 @0xaf3aba732f52a3c6 {
  union {
    nothing @0 :Void;
    float64 @1 :Float64;
    point @2 :Point;
    text @3 :Text;
    float64At4 @4 :Float64;
  }
}

struct ShapesContainersEitherOfLevelOrOptionalPoint @0xb44eaa716e9d1cae {
  union {
    level @0 :Level;
    optionalPoint @1 :ShapesContainersOptionalPoint;
  }
}

struct ShapesContainersAnyMatrixOfFloat64 @0xe30c2c9ae5b373ec {
  rows @0 :UInt32;
  columns @1 :UInt32;
  data @2 :List(Float64);
  # Column after column.
}

struct ShapesContainersAnyMatrixOfInt32 @0xcf91b55ab5eb9027 {
  rows @0 :UInt32;
  columns @1 :UInt32;
  data @2 :List(Int32);
  # Column after column.
}

struct ShapesContainersTupleOfFloat64AndLevel @0xfdb609e41c4ccca5 {
  item0 @0 :Float64;
  item1 @1 :Level;
}

struct ShapesContainersEitherOfFloat64OrPoint @0x8f220204a5e1de49 {
  union {
    float64 @0 :Float64;
    point @1 :Point;
  }
}

struct Point @0xb51a57f43829556b $Meta.cxx("shapes::Point") {
  # Parts of other types.

  x @0 :Float64 $Meta.range(lowest = -10, highest = 10) $Meta.unit("m");
  y @1 :Float64;
}

struct Sequences @0xdd7a64a833e189af $Meta.cxx("shapes::Sequences") {
  # Sequences, sets and maps.

  bytes @0 :Data $Meta.capacity([8]);
  one @1 :UInt8;
  row @2 :List(Float64) $Meta.shape("3");
  grid @3 :List(List(Int32)) $Meta.shape("2,3");
  corners @4 :List(Point) $Meta.shape("2");
  path @5 :List(Point) $Meta.capacity([3]);
  bits @6 :List(Bool) $Meta.capacity([4]);
  flags @7 :List(Bool) $Meta.capacity([4]);
  numbers @8 :List(Int32) $Meta.capacity([4]) $Meta.distinct([0]);
  words @9 :List(Text) $Meta.capacity([3, 6]) $Meta.distinct([0]);
  levels @10 :List(Level) $Meta.capacity([3]) $Meta.distinct([0]);
  gains @11 :List(ShapesContainersEntryOfTextToFloat64) $Meta.capacity([3, 6]);
  points @12 :List(ShapesContainersEntryOfUInt16ToPoint) $Meta.capacity([3]);
  series @13 :List(ShapesContainersEntryOfTextToListOfFloat32) $Meta.capacity([2, 4, 3]);
  shares @14 :List(ShapesContainersEntryOfLevelToFloat64) $Meta.capacity([3])
      $Meta.range(lowest = 0, highest = 1);
}

struct Choices @0xbda4c87a7b3da61e $Meta.cxx("shapes::Choices") {
  # What holds one thing or another, or some of each.

  gain @0 :ShapesContainersOptionalFloat64;
  share @1 :ShapesContainersOptionalFloat64 $Meta.range(lowest = 0, highest = 1);
  answer @2 :ShapesContainersOptionalBool;
  frame @3 :ShapesContainersOptionalText $Meta.capacity([8]);
  target @4 :ShapesContainersOptionalPoint;
  polygon @5 :ShapesContainersOptionalListOfPoint $Meta.capacity([2]);
  twice @6 :ShapesContainersOptionalOptionalInt32;
  seen @7 :List(ShapesContainersOptionalVec3) $Meta.capacity([3]);
  entry @8 :ShapesContainersTupleOfInt32AndFloat64;
  triple @9 :ShapesContainersTupleOfBoolAndTextAndPoint $Meta.capacity([4]);
  either @10 :ShapesContainersEitherOfNothingOrFloat64OrPointOrTextOrFloat64 $Meta.capacity([4]);
  nested @11 :ShapesContainersEitherOfLevelOrOptionalPoint;
  owned @12 :ShapesContainersOptionalPoint;
  rated @13 :ShapesContainersTupleOfFloat64AndLevel;
}

struct Matrices @0xd5b880c1c2797353 $Meta.cxx("shapes::Matrices") {
  # Eigen types of all kinds.

  joints @0 :List(Float64) $Meta.capacity([4]) $Meta.unit("rad");
  row @1 :List(Float64) $Meta.capacity([3]);
  any @2 :ShapesContainersAnyMatrixOfFloat64 $Meta.capacity([2, 3]);
  counts @3 :ShapesContainersAnyMatrixOfInt32 $Meta.capacity([2, 2]);
  columns @4 :List(Float64) $Meta.capacity([4]) $Meta.shape("*,3x1");
  limited @5 :List(Float32) $Meta.capacity([5]);
  fixed @6 :List(Float64) $Meta.shape("4x5");
  cloud @7 :List(Float64) $Meta.capacity([3]) $Meta.shape("*,3x1");
  wrenches @8 :List(Float32) $Meta.capacity([3]) $Meta.shape("*,6x1");
  scaled @9 :Types.Pose $Meta.shape("affine");
  wait @10 :Float64 $Meta.period("1/1000");
}

interface Store @0xbb0be3e4bb1e6be9 $Meta.cxx("shapes::Store") {
  # Composites right in a contract.

  subscribe @0 (events :StoreEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  put @1 (value :Sequences, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(16);
  choose @2 (gain :ShapesContainersOptionalFloat64, sent :Rpc.Sent) -> () $Meta.kind("write")
      $Meta.queue(16);
  sequences @3 (sent :Rpc.Sent) -> (value :Sequences, stamp :Int64) $Meta.kind("read");
  choices @4 (sent :Rpc.Sent) -> (value :Choices, stamp :Int64) $Meta.kind("read");
  matrices @5 (sent :Rpc.Sent) -> (value :Matrices, stamp :Int64) $Meta.kind("read");
  reading @6 (sent :Rpc.Sent) -> (value :ShapesContainersTupleOfFloat64AndLevel, stamp :Int64)
      $Meta.kind("read");
}

interface StoreEvents @0xe1e2cc5c73c90fe5 $Meta.eventsOf("shapes::Store") {
  # What a subscriber of Store receives.

  state @0 (row :StoreStateRow) -> ();
  # A new row of the columns asked for.
  changed @1 (value :ShapesContainersEitherOfFloat64OrPoint, stamp :Int64) -> () $Meta.queue(16);
}

struct StoreStateRow @0xca120faf75e33fa7 $Meta.stateOf("shapes::Store") {
  # One row of the state table: what the read commands of Store answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  sequences @3 :Sequences;
  choices @4 :Choices;
  matrices @5 :Matrices;
  reading @6 :ShapesContainersTupleOfFloat64AndLevel;
}
