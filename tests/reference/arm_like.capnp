@0xe47bd7d53be132a0;
# The wire contract of reference/arm_like.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using ArmTypes = import "/reference/arm_types.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("reference::wire");
$Meta.header("reference/arm_like.h");

interface ArmLike @0xeba4d683d0a91822 $Meta.cxx("reference::ArmLike") {
  subscribe @0 (events :ArmLikeEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  servoCp @1 (goal :ArmTypes.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("servo_cp")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(500000000);
  # Follows a stream of poses.
  servoJp @2 (goal :ArmTypes.JointState, sent :Rpc.Sent) -> () $Meta.cxx("servo_jp")
      $Meta.kind("write") $Meta.latest $Meta.queue(16);
  hold @3 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(4);
  setMode @4 (mode :ArmTypes.Mode, sent :Rpc.Sent) -> () $Meta.cxx("set_mode") $Meta.kind("write")
      $Meta.queue(16);
  measuredCp @5 (sent :Rpc.Sent) -> (value :ArmTypes.PoseStamped, stamp :Int64)
      $Meta.cxx("measured_cp") $Meta.kind("read");
  measuredJs @6 (sent :Rpc.Sent) -> (value :ArmTypes.JointState, stamp :Int64)
      $Meta.cxx("measured_js") $Meta.kind("read");
  distance @7 (to :ArmTypes.PoseStamped, sent :Rpc.Sent) -> (value :Float64)
      $Meta.kind("qualifiedRead");
  move @8 (goal :ArmTypes.PoseStamped, speed :Float64 $Meta.range(lowest = 0, highest = 1), reason :Text $Meta.capacity([15]), sent :Rpc.Sent) -> (value :Bool)
      $Meta.deadline(200000000) $Meta.kind("writeReturn") $Meta.queue(16);
  # Moves along a line; answers whether it can.
  reset @9 (sent :Rpc.Sent) -> (value :UInt32) $Meta.kind("voidReturn") $Meta.queue(16);
  # Forgets what it was told; answers how much that was.
  limit @10 (speed :Float64, mode :ArmTypes.Mode, sent :Rpc.Sent) -> () $Meta.kind("write")
      $Meta.queue(2);
  park @11 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.optional $Meta.queue(16);
  # Folds the arm.
}

interface ArmLikeEvents @0xdb1787086decafde $Meta.eventsOf("reference::ArmLike") {
  # What a subscriber of ArmLike receives.

  state @0 (row :ArmLikeStateRow) -> ();
  # A new row of the columns asked for.
  mode @1 (value :ArmTypes.Mode, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  arrived @2 (value :ArmTypes.PoseStamped, stamp :Int64) -> () $Meta.queue(4);
  stopped @3 (stamp :Int64) -> () $Meta.queue(16);
  moved @4 (value :ArmTypes.PoseStamped, value2 :Float64, stamp :Int64) -> () $Meta.queue(16);
  # Where it is and how fast.
}

struct ArmLikeStateRow @0xd6b993de04cbfb08 $Meta.stateOf("reference::ArmLike") {
  # One row of the state table: what the read commands of ArmLike answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  measuredCp @3 :ArmTypes.PoseStamped $Meta.cxx("measured_cp");
  measuredJs @4 :ArmTypes.JointState $Meta.cxx("measured_js");
}
