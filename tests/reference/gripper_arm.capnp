@0x8c51baa4ccd2b31d;
# The wire contract of reference/gripper_arm.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using ArmLike = import "/reference/arm_like.capnp";
using ArmTypes = import "/reference/arm_types.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("reference::wire");
$Meta.header("reference/gripper_arm.h");

interface GripperArm @0xc640d7e85c8505d7 extends(ArmLike.ArmLike)
    $Meta.cxx("reference::GripperArm") {
  # An arm with a gripper.

  subscribe @0 (events :GripperArmEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  close @1 (width :Float64 $Meta.unit("m"), sent :Rpc.Sent) -> (value :Float64)
      $Meta.kind("writeReturn") $Meta.queue(16);
  # Closes to this width; answers the width that it could reach.
  opening @2 (sent :Rpc.Sent) -> (value :Float64, stamp :Int64) $Meta.kind("read");
  release @3 (sent :Rpc.Sent) -> () $Meta.direct $Meta.kind("void") $Meta.queue(16);
  # Lets go at once.
  fits @4 (width :Float64 $Meta.unit("m"), sent :Rpc.Sent) -> (value :Bool) $Meta.concurrent
      $Meta.kind("qualifiedRead");
}

interface GripperArmEvents @0xc4dcbf461eed82fb $Meta.eventsOf("reference::GripperArm") {
  # What a subscriber of GripperArm receives.

  state @0 (row :GripperArmStateRow) -> ();
  # A new row of the columns asked for.
  mode @1 (value :ArmTypes.Mode, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  arrived @2 (value :ArmTypes.PoseStamped, stamp :Int64) -> () $Meta.queue(4);
  stopped @3 (stamp :Int64) -> () $Meta.queue(16);
  moved @4 (value :ArmTypes.PoseStamped, value2 :Float64, stamp :Int64) -> () $Meta.queue(16);
  # Where it is and how fast.
  gripped @5 (value :Float64, stamp :Int64) -> () $Meta.queue(16);
}

struct GripperArmStateRow @0xaad3d7925d80f23f $Meta.stateOf("reference::GripperArm") {
  # One row of the state table: what the read commands of GripperArm answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  measuredCp @3 :ArmTypes.PoseStamped $Meta.cxx("measured_cp");
  measuredJs @4 :ArmTypes.JointState $Meta.cxx("measured_js");
  opening @5 :Float64;
}
