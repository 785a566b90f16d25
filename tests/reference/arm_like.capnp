@0xe47bd7d53be132a0;
# The wire contract of reference/arm_like.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("reference::wire");
$Meta.header("reference/arm_like.h");

enum Mode @0x89daa6df134ae03e $Meta.cxx("reference::Mode") $Meta.underlying("UInt8") {
  disabled @0 $Meta.cxx("Disabled") $Meta.value(0);
  enabled @1 $Meta.cxx("Enabled") $Meta.value(1);
}

struct PoseStamped @0x9e5a942c3e52a9b7 $Meta.cxx("reference::PoseStamped") {
  # A pose with its time.

  pose @0 :Types.Pose $Meta.unit("m");
  # tip in base
  stamp @1 :Int64 $Meta.clock("steady");
  valid @2 :Bool;
}

struct JointState @0xe82fac248b31c66b $Meta.cxx("reference::JointState") {
  name @0 :List(Text) $Meta.capacity([8, 15]);
  position @1 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad");
}

interface ArmLike @0xeba4d683d0a91822 $Meta.cxx("reference::ArmLike") {
  subscribe @0 (events :ArmLikeEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  servoCp @1 (goal :PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("servo_cp") $Meta.kind("write")
      $Meta.latest $Meta.queue(16) $Meta.ttl(500000000);
  # Follows a stream of poses.
  servoJp @2 (goal :JointState, sent :Rpc.Sent) -> () $Meta.cxx("servo_jp") $Meta.kind("write")
      $Meta.latest $Meta.queue(16);
  hold @3 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(4);
  setMode @4 (mode :Mode, sent :Rpc.Sent) -> () $Meta.cxx("set_mode") $Meta.kind("write")
      $Meta.queue(16);
  measuredCp @5 (sent :Rpc.Sent) -> (value :PoseStamped, stamp :Int64) $Meta.cxx("measured_cp")
      $Meta.kind("read");
  measuredJs @6 (sent :Rpc.Sent) -> (value :JointState, stamp :Int64) $Meta.cxx("measured_js")
      $Meta.kind("read");
  distance @7 (to :PoseStamped, sent :Rpc.Sent) -> (value :Float64) $Meta.kind("qualifiedRead");
  move @8 (goal :PoseStamped, speed :Float64 $Meta.range(lowest = 0, highest = 1), reason :Text $Meta.capacity([15]), sent :Rpc.Sent) -> (value :Bool)
      $Meta.deadline(200000000) $Meta.kind("writeReturn") $Meta.queue(16);
  # Moves along a line; answers whether it can.
  reset @9 (sent :Rpc.Sent) -> (value :UInt32) $Meta.kind("voidReturn") $Meta.queue(16);
  # Forgets what it was told; answers how much that was.
  limit @10 (speed :Float64, mode :Mode, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(2);
  park @11 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.optional $Meta.queue(16);
  # Folds the arm.
}

interface ArmLikeEvents @0xdb1787086decafde $Meta.eventsOf("reference::ArmLike") {
  # What a subscriber of ArmLike receives.

  state @0 (row :ArmLikeStateRow) -> ();
  # A new row of the columns asked for.
  mode @1 (value :Mode) -> () $Meta.latched $Meta.queue(16);
  arrived @2 (value :PoseStamped) -> () $Meta.queue(4);
  stopped @3 () -> () $Meta.queue(16);
  moved @4 (value :PoseStamped, value2 :Float64) -> () $Meta.queue(16);
  # Where it is and how fast.
}

struct ArmLikeStateRow @0xd6b993de04cbfb08 $Meta.stateOf("reference::ArmLike") {
  # One row of the state table: what the read commands of ArmLike answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  measuredCp @2 :PoseStamped $Meta.cxx("measured_cp");
  measuredJs @3 :JointState $Meta.cxx("measured_js");
  tooLarge @4 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
