@0xb6d1f1d1a0c5e8f7;
# The wire contract of reference/arm_like.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("reference::wire");
$Meta.header("reference/arm_like.h");

enum Mode @0xd1b7a5e9c3f08246 $Meta.cxx("reference::Mode") $Meta.underlying("UInt8") {
  disabled @0 $Meta.cxx("Disabled") $Meta.value(0);
  enabled @1 $Meta.cxx("Enabled") $Meta.value(1);
}

struct PoseStamped @0xe4f2a8b0c6d71935 $Meta.cxx("reference::PoseStamped") {
  # A pose with its time.

  pose @0 :Types.Pose $Meta.unit("m");
  # tip in base
  stamp @1 :Int64 $Meta.clock("steady");
  valid @2 :Bool;
}

struct JointState @0xf0a1b2c3d4e5f607 $Meta.cxx("reference::JointState") {
  name @0 :List(Text) $Meta.capacity([8, 15]) $Meta.shape("*");
  position @1 :List(Float64) $Meta.capacity([8]) $Meta.shape("*") $Meta.unit("rad");
}

interface ArmLike @0x8a9bacbdcedfe0f1 $Meta.cxx("reference::ArmLike") {
  subscribe @0 (events :ArmLikeEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  servoCp @1 (goal :PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("servo_cp") $Meta.kind("write")
      $Meta.latest $Meta.queue(16) $Meta.ttl(50000000);
  # Follows a stream of poses.
  servoJp @2 (goal :JointState, sent :Rpc.Sent) -> () $Meta.cxx("servo_jp") $Meta.kind("write")
      $Meta.latest $Meta.queue(16);
  hold @3 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(4);
  setMode @4 (mode :Mode, sent :Rpc.Sent) -> () $Meta.cxx("set_mode") $Meta.kind("write")
      $Meta.queue(16);
  measuredCp @5 (sent :Rpc.Sent) -> (value :PoseStamped) $Meta.cxx("measured_cp") $Meta.kind("read");
  measuredJs @6 (sent :Rpc.Sent) -> (value :JointState) $Meta.cxx("measured_js") $Meta.kind("read");
  distance @7 (to :PoseStamped, sent :Rpc.Sent) -> (value :Float64) $Meta.kind("qualifiedRead");
}

interface ArmLikeEvents @0x92a3b4c5d6e7f809 $Meta.eventsOf("reference::ArmLike") {
  # What a subscriber of ArmLike receives.

  state @0 (row :ArmLikeStateRow) -> ();
  # A new row of the columns asked for.
  mode @1 (value :Mode) -> () $Meta.latched $Meta.queue(16);
  arrived @2 (value :PoseStamped) -> () $Meta.queue(4);
  stopped @3 () -> () $Meta.queue(16);
}

struct ArmLikeStateRow @0x9bacbdcedfe0f102 $Meta.stateOf("reference::ArmLike") {
  # One row of the state table: what the read commands of ArmLike answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  measuredCp @2 :PoseStamped $Meta.cxx("measured_cp");
  measuredJs @3 :JointState $Meta.cxx("measured_js");
}
