@0xc4d02cc871c4f51f;
# The wire contract of bench/loop.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Pose = import "/robot_types/pose.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("bench::wire");
$Meta.header("bench/loop.h");

interface LoopServer @0xf31a590efb54d189 $Meta.cxx("bench::LoopServer") {
  # What the server of a loop offers.

  subscribe @0 (events :LoopServerEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  put @1 (value :Pose.PosePrm, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(16);
  # Server, client, server: takes back what value() answered and measures how long it was away.
  bounce @2 (value :Pose.PosePrm, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(16);
  # Client, server, client: sends the value back as the event echo.
  value @3 (sent :Rpc.Sent) -> (value :Pose.PosePrm, stamp :Int64) $Meta.kind("read");
  # A pose, stamped when it is evaluated.
}

interface LoopServerEvents @0xa1763febd61d7208 $Meta.eventsOf("bench::LoopServer") {
  # What a subscriber of LoopServer receives.

  state @0 (row :LoopServerStateRow) -> ();
  # A new row of the columns asked for.
  echo @1 (value :Pose.PosePrm, stamp :Int64) -> () $Meta.queue(16);
  # The value that bounce() took.
}

struct LoopServerStateRow @0xcf8261ed0f1fe7b7 $Meta.stateOf("bench::LoopServer") {
  # One row of the state table: what the read commands of LoopServer answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  value @2 :Pose.PosePrm;
  tooLarge @3 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
