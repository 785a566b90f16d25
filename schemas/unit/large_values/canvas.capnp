@0xa32598924eb3d4ea;
# The wire contract of unit/large_values/canvas.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("large_values::wire");
$Meta.header("unit/large_values/canvas.h");

struct Dot @0xc7cc6c4fbf707416 $Meta.cxx("large_values::Dot") {
  shade @0 :UInt8;
}

struct Dots @0x965fb8c5e0caec3b $Meta.cxx("large_values::Dots") {
  dots @0 :List(Dot) $Meta.capacity([2500000]);
}

interface Canvas @0xc159bcffb8adc514 $Meta.cxx("large_values::Canvas") {
  subscribe @0 (events :CanvasEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  resize @1 (dots :UInt32, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(16);
  # Makes a painting of so many dots.
  paint @2 (dots :Dots, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(2);
  painting @3 (sent :Rpc.Sent) -> (value :Dots, stamp :Int64) $Meta.kind("read");
  copy @4 (dots :UInt32, sent :Rpc.Sent) -> (value :Dots) $Meta.kind("qualifiedRead");
}

interface CanvasEvents @0xce5d1a720715af93 $Meta.eventsOf("large_values::Canvas") {
  # What a subscriber of Canvas receives.

  state @0 (row :CanvasStateRow) -> ();
  # A new row of the columns asked for.
  painted @1 (value :Dots, stamp :Int64) -> () $Meta.queue(2);
}

struct CanvasStateRow @0xc0b6e93694d3278a $Meta.stateOf("large_values::Canvas") {
  # One row of the state table: what the read commands of Canvas answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  painting @3 :Dots;
}
