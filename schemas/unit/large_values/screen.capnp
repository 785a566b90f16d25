@0xe8f9646ef982fdb7;
# The wire contract of unit/large_values/screen.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("large_values::wire");
$Meta.header("unit/large_values/screen.h");

struct Frame @0xc35c3807be9e6ef2 $Meta.cxx("large_values::Frame") {
  number @0 :UInt32;
  pixels @1 :Data $Meta.capacity([65536]) $Meta.range(lowest = 0, highest = 200);
}

struct FramePair @0xc85bb3e3872ae443 $Meta.cxx("large_values::FramePair") {
  left @0 :Frame;
  right @1 :Frame;
}

interface Screen @0xc6cf87c524457ca0 $Meta.cxx("large_values::Screen") {
  subscribe @0 (events :ScreenEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  show @1 (frame :Frame, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(3);
  replace @2 (frame :Frame, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.latest $Meta.queue(16);
  showBoth @3 (frames :FramePair, sent :Rpc.Sent) -> () $Meta.cxx("show_both") $Meta.kind("write")
      $Meta.queue(3);
}

interface ScreenEvents @0xdb6f463c88c3a4fb $Meta.eventsOf("large_values::Screen") {
  # What a subscriber of Screen receives.

  state @0 (row :ScreenStateRow) -> ();
  # A new row of the columns asked for.
  shown @1 (value :Frame, stamp :Int64) -> () $Meta.queue(3);
  newest @2 (value :Frame, stamp :Int64) -> () $Meta.latest $Meta.queue(16);
  both @3 (value :FramePair, stamp :Int64) -> () $Meta.queue(3);
}

struct ScreenStateRow @0x9c4e37e1739c0304 $Meta.stateOf("large_values::Screen") {
  # One row of the state table: what the read commands of Screen answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
