@0xb147fe51a98226c6;
# The wire contract of bench/sample_loop.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Pose = import "/robot_types/pose.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("bench::wire");
$Meta.header("bench/sample_loop.h");

interface SampleServer @0xa9d747a8e40c3d30 $Meta.cxx("bench::SampleServer") {
  subscribe @0 (events :SampleServerEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  put @1 (value :Pose.PoseSample, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(4096);
  # Counted by the provider.
  bounce @2 (value :Pose.PoseSample, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(16);
  # Client, server, client: sends the value back as the event echo.
  value @3 (sent :Rpc.Sent) -> (value :Pose.PoseSample, stamp :Int64) $Meta.kind("read");
}

interface SampleServerEvents @0xc71bdb510deae77a $Meta.eventsOf("bench::SampleServer") {
  # What a subscriber of SampleServer receives.

  state @0 (row :SampleServerStateRow) -> ();
  # A new row of the columns asked for.
  echo @1 (value :Pose.PoseSample, stamp :Int64) -> () $Meta.queue(16);
  # The value that bounce() took.
}

struct SampleServerStateRow @0xb757a2bfdbcd1cf8 $Meta.stateOf("bench::SampleServer") {
  # One row of the state table: what the read commands of SampleServer answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  value @3 :Pose.PoseSample;
}
