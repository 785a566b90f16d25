@0xa68c210fc5e48e17;
# The wire contract of evolution/sample.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("evolution::wire");
$Meta.header("evolution/sample.h");

enum Mode @0xc7e824ac7ff42451 $Meta.cxx("evolution::Mode") $Meta.underlying("Int32") {
  off @0 $Meta.cxx("Off") $Meta.value(1);
  on @1 $Meta.cxx("On") $Meta.value(0);
  fast @2 $Meta.cxx("Fast") $Meta.value(2);
}

struct Sample @0xf2844f25fa4ab653 $Meta.cxx("evolution::Sample") {
  east @0 :Float64 $Meta.unit("m");
  count @1 :Int32 = 7 $Meta.default("9");
  label @2 :Text $Meta.capacity([32]);
  values @3 :List(Float64) $Meta.capacity([4]);
  mode @4 :Mode;
  period @5 :Int64 $Meta.period("1/1000");
  seen @6 :Int64 $Meta.clock("steady");
  pair @7 :List(Float32) $Meta.shape("2");
  point @8 :Types.Vec3;
  removed9 @9 :Float64 $Meta.removed("gone");
  weight @10 :Float64 = 2.5;
  note @11 :Text $Meta.capacity([8]);
}

interface Feed @0xc412b75937f82c5b $Meta.cxx("evolution::Feed") {
  subscribe @0 (events :FeedEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  put @1 (sample :Sample, speed :Float64, sent :Rpc.Sent, now :Bool) -> () $Meta.kind("write")
      $Meta.queue(16);
  mode @2 (sent :Rpc.Sent) -> (value :Mode, stamp :Int64) $Meta.kind("read");
  clear @3 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
}

interface FeedEvents @0xa66981bc7ce3187d $Meta.eventsOf("evolution::Feed") {
  # What a subscriber of Feed receives.

  state @0 (row :FeedStateRow) -> ();
  # A new row of the columns asked for.
  moved @1 (value :Sample, stamp :Int64) -> () $Meta.queue(16);
}

struct FeedStateRow @0xfb7574b60a5416b5 $Meta.stateOf("evolution::Feed") {
  # One row of the state table: what the read commands of Feed answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  mode @2 :Mode;
  tooLarge @3 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}

interface Switch @0x804537fdb3c05e17 $Meta.cxx("evolution::Switch") {
  # Does not carry a Sample.

  subscribe @0 (events :SwitchEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  toggle @1 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
}

interface SwitchEvents @0xdeb7cc462a1b1347 $Meta.eventsOf("evolution::Switch") {
  # What a subscriber of Switch receives.

  state @0 (row :SwitchStateRow) -> ();
  # A new row of the columns asked for.
}

struct SwitchStateRow @0xe296374df27732a2 $Meta.stateOf("evolution::Switch") {
  # One row of the state table: what the read commands of Switch answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
