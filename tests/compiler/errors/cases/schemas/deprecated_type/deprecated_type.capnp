@0xf6e0d5699cd798f1;
# The wire contract of deprecated_type.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("deprecated_type.h");

struct DeprecatedTypeOptionalPlace @0x9df717c2dff38077 {
  union {
    none @0 :Void;
    some @1 :Place;
  }
}

struct Place @0x863b5dc75b1703ca $Meta.cxx("demo::Place") $Meta.deprecated("use Pose")
    $Meta.since(2) {
  x @0 :Float64;
}

struct Sample @0xdc331872b9f58ba1 $Meta.cxx("demo::Sample") {
  place @0 :Place;
  old @1 :Place $Meta.deprecated("use place");
}

interface Contract @0xae3f07d9e2f0431e $Meta.cxx("demo::Contract") {
  subscribe @0 (events :ContractEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  go @1 (to :DeprecatedTypeOptionalPlace, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(16);
  where @2 (sent :Rpc.Sent) -> (value :Place, stamp :Int64) $Meta.kind("read");
  went @3 (to :Place, sent :Rpc.Sent) -> () $Meta.deprecated("use go") $Meta.kind("write")
      $Meta.queue(16);
}

interface ContractEvents @0xe5c41a90a7253ceb $Meta.eventsOf("demo::Contract") {
  # What a subscriber of Contract receives.

  state @0 (row :ContractStateRow) -> ();
  # A new row of the columns asked for.
  moved @1 (value :Place, stamp :Int64) -> () $Meta.queue(16);
}

struct ContractStateRow @0xf46d7556c214799f $Meta.stateOf("demo::Contract") {
  # One row of the state table: what the read commands of Contract answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  where @3 :Place;
}
