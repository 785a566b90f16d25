@0x873594c4d618fabd;
# The wire contract of shapes/moments.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("shapes::wire");
$Meta.header("shapes/moments.h");

struct ShapesMomentsEntryOfInt32ToSteadyTime @0xef7b71232d559ed6 {
  key @0 :Int32;
  value @1 :Int64 $Meta.clock("steady");
}

struct ShapesMomentsOptionalSteadyTime @0x86ffd776cef10d3b {
  union {
    none @0 :Void;
    some @1 :Int64 $Meta.clock("steady");
  }
}

struct ShapesMomentsOptionalMoment @0x808a81b58e533e44 {
  union {
    none @0 :Void;
    some @1 :Moment;
  }
}

struct ShapesMomentsTupleOfInt64AndSteadyTimeAndMoment @0xff5b5cd02a32aa90 {
  item0 @0 :Int64;
  item1 @1 :Int64 $Meta.clock("steady");
  item2 @2 :Moment;
}

struct ShapesMomentsEitherOfInt64OrSteadyTimeOrMoment @0xed7215ce608528ed {
  union {
    int64 @0 :Int64;
    steadyTime @1 :Int64 $Meta.clock("steady");
    moment @2 :Moment;
  }
}

struct Moment @0xde2753d08ad0e07b $Meta.cxx("shapes::Moment") {
  # It has a time of each clock, of which only one is shifted.

  steady @0 :Int64 $Meta.clock("steady");
  system @1 :Int64 $Meta.clock("system");
  number @2 :Int64;
}

struct Moments @0xea2eb3c4e250494c $Meta.cxx("shapes::Moments") {
  # One in each container.

  pair @0 :List(Int64) $Meta.clock("steady") $Meta.shape("2");
  list @1 :List(Int64) $Meta.capacity([3]) $Meta.clock("steady");
  moments @2 :List(Moment) $Meta.capacity([2]);
  nested @3 :List(List(Int64)) $Meta.capacity([2, 2]) $Meta.clock("steady");
  byNumber @4 :List(ShapesMomentsEntryOfInt32ToSteadyTime) $Meta.capacity([2]);
  perhaps @5 :ShapesMomentsOptionalSteadyTime;
  moment @6 :ShapesMomentsOptionalMoment;
  entry @7 :ShapesMomentsTupleOfInt64AndSteadyTimeAndMoment;
  either @8 :ShapesMomentsEitherOfInt64OrSteadyTimeOrMoment;
}

interface Journal @0xc3053cb224b0c85f $Meta.cxx("shapes::Journal") {
  # Right in a contract: the arguments, the results and the payloads.

  subscribe @0 (events :JournalEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  put @1 (from :Int64 $Meta.clock("steady"), number :Int64, sent :Rpc.Sent) -> ()
      $Meta.kind("write") $Meta.queue(16);
  count @2 (number :Int64, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(16);
  latest @3 (sent :Rpc.Sent) -> (value :Int64 $Meta.clock("steady"), stamp :Int64)
      $Meta.kind("read");
  moments @4 (sent :Rpc.Sent) -> (value :Moments, stamp :Int64) $Meta.kind("read");
  find @5 (number :Int64, sent :Rpc.Sent) -> (value :ShapesMomentsOptionalMoment)
      $Meta.kind("qualifiedRead");
}

interface JournalEvents @0xf44a38be83c21076 $Meta.eventsOf("shapes::Journal") {
  # What a subscriber of Journal receives.

  state @0 (row :JournalStateRow) -> ();
  # A new row of the columns asked for.
  added @1 (value :Int64 $Meta.clock("steady"), stamp :Int64) -> () $Meta.queue(16);
  changed @2 (value :Moment, value2 :Int64, stamp :Int64) -> () $Meta.queue(16);
  counted @3 (value :Int64, stamp :Int64) -> () $Meta.queue(16);
}

struct JournalStateRow @0xb5363f8a2843600b $Meta.stateOf("shapes::Journal") {
  # One row of the state table: what the read commands of Journal answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  latest @3 :Int64 $Meta.clock("steady");
  moments @4 :Moments;
}

struct Spans @0xafff60048810c698 $Meta.cxx("shapes::Spans") {
  # Lasts as long as the types of C++ can count.

  brief @0 :Float64 $Meta.period("1/1000");
  endless @1 :Float64 = inf $Meta.period("1/1");
  list @2 :List(Float64) $Meta.capacity([2]) $Meta.period("1/1");
}
