@0xf43479cef81ee230;
# The wire contract of unit/large_values/picture.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("large_values::wire");
$Meta.header("unit/large_values/picture.h");

struct Picture @0xe2f1b542ae737d95 $Meta.cxx("large_values::Picture") {
  pixels @0 :Data $Meta.capacity([1048576]);
}

interface Gallery @0x8fb9bfa9541b2aa5 $Meta.cxx("large_values::Gallery") {
  subscribe @0 (events :GalleryEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  newest @1 (sent :Rpc.Sent) -> (value :Picture, stamp :Int64) $Meta.kind("read");
  oldest @2 (sent :Rpc.Sent) -> (value :Picture, stamp :Int64) $Meta.kind("read");
  dimmed @3 (picture :Picture, sent :Rpc.Sent) -> (value :Picture) $Meta.kind("qualifiedRead");
  hang @4 (picture :Picture, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(2);
}

interface GalleryEvents @0xc01f74a8ea49ad06 $Meta.eventsOf("large_values::Gallery") {
  # What a subscriber of Gallery receives.

  state @0 (row :GalleryStateRow) -> ();
  # A new row of the columns asked for.
  hung @1 (value :Picture, stamp :Int64) -> () $Meta.latest $Meta.queue(16);
}

struct GalleryStateRow @0xca1846eae9ffa1ee $Meta.stateOf("large_values::Gallery") {
  # One row of the state table: what the read commands of Gallery answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  newest @3 :Picture;
  oldest @4 :Picture;
}
