@0xcfd5086881255bf6;
# The wire contract of echo.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("peers::wire");
$Meta.header("echo.h");

struct Pose @0x8337f47acab9534c $Meta.cxx("peers::Pose") {
  rotation @0 :List(Float64) $Meta.shape("9");
  # row after row
  position @1 :List(Float64) $Meta.shape("3");
  timestamp @2 :Float64;
  valid @3 :Bool;
  frame @4 :Text $Meta.capacity([8]);
  reference @5 :Text $Meta.capacity([8]);
}

struct Blob @0xca0afd527f4c49e8 $Meta.cxx("peers::Blob") {
  timestamp @0 :Float64;
  data @1 :Data $Meta.bulk("Float64") $Meta.capacity([131072]);
}

interface Echo @0x95f34239aebbc5b1 $Meta.cxx("peers::Echo") {
  subscribe @0 (events :EchoEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  bounce @1 (pose :Pose, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(16);
  # The pose comes back as the event bounced.
  ping @2 (pose :Pose, sent :Rpc.Sent) -> (value :Pose) $Meta.kind("writeReturn") $Meta.queue(16);
  # The pose comes back as the return value.
  push @3 (pose :Pose, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(2048);
  # The pose goes one way.
}

interface EchoEvents @0xfac1e5bcc4703ef7 $Meta.eventsOf("peers::Echo") {
  # What a subscriber of Echo receives.

  state @0 (row :EchoStateRow) -> ();
  # A new row of the columns asked for.
  bounced @1 (value :Pose, stamp :Int64) -> () $Meta.queue(16);
}

struct EchoStateRow @0x8a3a22fedac42e31 $Meta.stateOf("peers::Echo") {
  # One row of the state table: what the read commands of Echo answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}

interface BlobEcho @0x9afd4049f2790312 $Meta.cxx("peers::BlobEcho") {
  # It is an interface of its own, for its messages are large.

  subscribe @0 (events :BlobEchoEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  bounce @1 (blob :Blob, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(2);
  # The blob comes back as the event bounced.
}

interface BlobEchoEvents @0x9bcaad7b4c350d8a $Meta.eventsOf("peers::BlobEcho") {
  # What a subscriber of BlobEcho receives.

  state @0 (row :BlobEchoStateRow) -> ();
  # A new row of the columns asked for.
  bounced @1 (value :Blob, stamp :Int64) -> () $Meta.queue(2);
}

struct BlobEchoStateRow @0xdf7386946741d68b $Meta.stateOf("peers::BlobEcho") {
  # One row of the state table: what the read commands of BlobEcho answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}

interface Feed @0xd6c776eb1b747222 $Meta.cxx("peers::Feed") {
  # This is published to everybody.

  subscribe @0 (events :FeedEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
}

interface FeedEvents @0xd84fb057141b0fcd $Meta.eventsOf("peers::Feed") {
  # What a subscriber of Feed receives.

  state @0 (row :FeedStateRow) -> ();
  # A new row of the columns asked for.
  pose @1 (value :Pose, stamp :Int64) -> () $Meta.queue(2048);
}

struct FeedStateRow @0xf4d2c016031aa901 $Meta.stateOf("peers::Feed") {
  # One row of the state table: what the read commands of Feed answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
