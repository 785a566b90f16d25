@0xfc8ac49a626e1aeb;
# The wire contract of shapes/large.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("shapes::wire");
$Meta.header("shapes/large.h");

struct ShapesLargeAnyMatrixOfFloat32 @0xca1e0a0ee662b822 {
  rows @0 :UInt32;
  columns @1 :UInt32;
  data @2 :List(Float32);
  # Column after column.
}

struct ShapesLargeOptionalTrace @0xc87395fec67d1a0c {
  union {
    none @0 :Void;
    some @1 :Trace;
  }
}

struct ShapesLargeTupleOfInt8AndTraceAndListOfInt64 @0xc7ad720f0b29a7d8 {
  item0 @0 :Int8;
  item1 @1 :Trace;
  item2 @2 :List(Int64);
}

struct ShapesLargeEntryOfUInt16ToFloat64 @0xf5be256905eaa78a {
  key @0 :UInt16;
  value @1 :Float64;
}

struct ShapesLargeEitherOfNothingOrTraceOrListOfFloat32 @0xa253bae889c69fa2 {
  union {
    nothing @0 :Void;
    trace @1 :Trace;
    listOfFloat32 @2 :List(Float32);
  }
}

struct Trace @0xc0c3f1634ee6c87a $Meta.cxx("shapes::Trace") {
  # A list within whatever holds this.

  channel @0 :UInt32;
  samples @1 :List(Float64) $Meta.capacity([100]);
  gain @2 :Float64 = 1.0;
}

struct Large @0x873542a36beeb5ba $Meta.cxx("shapes::Large") {
  # A large level in each place where one can be.

  first @0 :Float64;
  text @1 :Text $Meta.capacity([300]);
  name @2 :Text $Meta.capacity([8]);
  # too small to tell what is used of it
  traces @3 :List(Trace) $Meta.capacity([5]);
  image @4 :ShapesLargeAnyMatrixOfFloat32 $Meta.capacity([20, 30]);
  inner @5 :Trace;
  maybe @6 :ShapesLargeOptionalTrace;
  both @7 :ShapesLargeTupleOfInt8AndTraceAndListOfInt64 $Meta.capacity([40]);
  gains @8 :List(ShapesLargeEntryOfUInt16ToFloat64) $Meta.capacity([50]);
  pair @9 :List(Trace) $Meta.shape("2");
  # travels whole
  choice @10 :ShapesLargeEitherOfNothingOrTraceOrListOfFloat32 $Meta.capacity([70]);
  # travels whole
  last @11 :Int64;
}

interface Recorder @0xedaff88b9a8c5a49 $Meta.cxx("shapes::Recorder") {
  # Carries them as arguments, results and payloads.

  subscribe @0 (events :RecorderEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  keep @1 (values :List(Float64) $Meta.capacity([64]), rest :Large, sent :Rpc.Sent) -> ()
      $Meta.kind("write") $Meta.queue(16);
  rename @2 (name :Text $Meta.capacity([8]), sent :Rpc.Sent) -> () $Meta.kind("write")
      $Meta.queue(16);
  kept @3 (sent :Rpc.Sent) -> (value :Large, stamp :Int64) $Meta.kind("read");
}

interface RecorderEvents @0xb2575c70bf6c42b1 $Meta.eventsOf("shapes::Recorder") {
  # What a subscriber of Recorder receives.

  state @0 (row :RecorderStateRow) -> ();
  # A new row of the columns asked for.
  heard @1 (value :Trace, stamp :Int64) -> () $Meta.queue(16);
  said @2 (value :Int32, value2 :Large, stamp :Int64) -> () $Meta.queue(16);
}

struct RecorderStateRow @0xbc917f42f869eb04 $Meta.stateOf("shapes::Recorder") {
  # One row of the state table: what the read commands of Recorder answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  kept @3 :Large;
}
