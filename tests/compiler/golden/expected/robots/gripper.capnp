@0xcbbad0365bef56c0;
# The wire contract of robots/gripper.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Arm = import "/robots/arm.capnp";
using Geometry = import "/robots/geometry.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robots/gripper.h");

interface Gripper @0xb9e926d064e78714 extends(Arm.Arm) $Meta.cxx("robots::Gripper") $Meta.since(2)
    $Meta.version(2) {
  # An arm with a gripper.

  subscribe @0 (events :GripperEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  open @1 (width :Float64 $Meta.unit("m"), sent :Rpc.Sent) -> () $Meta.kind("write")
      $Meta.queue(16);
  opening @2 (sent :Rpc.Sent) -> (value :Float64, stamp :Int64) $Meta.kind("read") $Meta.since(2);
  fits @3 (width :Float64, sent :Rpc.Sent) -> (value :Bool) $Meta.concurrent
      $Meta.kind("qualifiedRead");
}

interface GripperEvents @0x9acb6a7a5fa48866 $Meta.eventsOf("robots::Gripper") {
  # What a subscriber of Gripper receives.

  state @0 (row :GripperStateRow) -> ();
  # A new row of the columns asked for.
  modeChanged @1 (value :Arm.Mode, stamp :Int64) -> () $Meta.cxx("mode_changed") $Meta.latched
      $Meta.queue(8);
  stopped @2 (stamp :Int64) -> () $Meta.queue(16);
  arrived @3 (value :Geometry.PoseStamped, stamp :Int64) -> () $Meta.queue(16);
  moved @4 (value :Geometry.PoseStamped, value2 :Float64, value3 :Arm.Mode, stamp :Int64) -> ()
      $Meta.latched $Meta.queue(16);
  # Where, how fast and why.
  gripped @5 (value :Float64, value2 :Bool, stamp :Int64) -> () $Meta.queue(16) $Meta.since(2);
}

struct GripperStateRow @0x8d73a8caf926376a $Meta.stateOf("robots::Gripper") {
  # One row of the state table: what the read commands of Gripper answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  measuredCp @3 :Geometry.PoseStamped $Meta.cxx("measured_cp");
  mode @4 :Arm.Mode;
  everything @5 :Arm.Everything;
  load @6 :Float64 $Meta.optional;
  opening @7 :Float64;
}

interface Names @0xa213f67f20043abb $Meta.cxx("robots::Names") {
  # Members that are called as arguments of the annotations are.

  subscribe @0 (events :NamesEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  queue @1 (name :Int32, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(4);
  title @2 (range :Float64, slot :Float64, store :Float64, sent :Rpc.Sent) -> (value :Bool)
      $Meta.cxx("name") $Meta.kind("writeReturn") $Meta.queue(16);
  range @3 (sent :Rpc.Sent) -> (value :Float64 $Meta.range(lowest = 0, highest = 1), stamp :Int64)
      $Meta.kind("read");
}

interface NamesEvents @0xf43423c9c422881d $Meta.eventsOf("robots::Names") {
  # What a subscriber of Names receives.

  state @0 (row :NamesStateRow) -> ();
  # A new row of the columns asked for.
  latched @1 (value :Float64, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
}

struct NamesStateRow @0x87faafafa7e923b7 $Meta.stateOf("robots::Names") {
  # One row of the state table: what the read commands of Names answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  range @3 :Float64 $Meta.range(lowest = 0, highest = 1);
}
