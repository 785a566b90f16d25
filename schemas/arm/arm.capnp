@0xaa79289cf9333b18;
# The wire contract of arm/arm.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Joints = import "/robot_types/joints.capnp";
using OperatingState = import "/robot_types/operating_state.capnp";
using Pose = import "/robot_types/pose.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("arm/arm.h");

enum ArmWarning @0xa4117f14f97ed1bb $Meta.cxx("robots::ArmWarning") $Meta.underlying("UInt8") {
  # Why an arm does not do what it is asked.

  notEnabled @0 $Meta.cxx("NotEnabled") $Meta.value(0);
  # motion commands need an enabled arm
  outOfReach @1 $Meta.cxx("OutOfReach") $Meta.value(1);
  # no joint vector reaches the goal; for a move, none within limits
  malformed @2 $Meta.cxx("Malformed") $Meta.value(2);
  # the goal has the wrong length, is not finite or not a pose
  clientGone @3 $Meta.cxx("ClientGone") $Meta.value(3);
  # the client whose stream it followed is gone; the arm holds
  wrongState @4 $Meta.cxx("WrongState") $Meta.value(4);
  # the operating state does not admit the command: operating_states.h
  followingError @5 $Meta.cxx("FollowingError") $Meta.value(5);
  # a joint trailed its set-point by more than its bound; the arm is in FAULT
  atLimit @6 $Meta.cxx("AtLimit") $Meta.value(6);
  # what it follows leads beyond a joint limit: the arm slides along it; once
  # until it leads within again
  stepTooFar @7 $Meta.cxx("StepTooFar") $Meta.value(7);
  # a servo goal lies farther from the set-point than the rates allow
  powerLost @8 $Meta.cxx("PowerLost") $Meta.value(8);
  # the drives have no power any more, or may not have it: the arm is disabled
  drivesSilent @9 $Meta.cxx("DrivesSilent") $Meta.value(9);
  # the drives have measured nothing for 250 ms; the arm is in FAULT
}

interface Arm @0xd2a6fc6237d6fd07 $Meta.cxx("robots::Arm") {
  # Commands run in the arm's own thread before its next cycle; reads are from the end of its last
  # one. Poses are of the tool tip in the arm's base frame. An arm starts, and restarts, undefined;
  # once it hears of its drives, and they may have power, it is disabled and not homed. Until it is
  # enabled it ignores motion commands.

  subscribe @0 (events :ArmEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  enable @1 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Gives the drives power; the arm holds its position.
  disable @2 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Stops at once, without power, and ignores motion until enabled again.
  home @3 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Moves to the home position; needs an enabled arm. Ends with goal_reached.
  hold @4 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Drops what is under way; the set-point stays where it is.
  servoCp @5 (goal :Pose.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("servo_cp")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  # Streams Cartesian goals, newest wins. Beyond a joint limit the arm slides along that, at the
  # nearest that the limits leave; a goal out of reach, or too far for one step, leaves the
  # set-point. All three it says in `warning`. setpoint_cp keeps the goal's stamp.
  servoJp @6 (goal :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_jp")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  # Streams joint goals, newest wins. A joint whose goal lies beyond its limit stays at that.
  moveJp @7 (goal :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("move_jp") $Meta.kind("write")
      $Meta.queue(16);
  # Plans and executes a smooth motion from the set-point. Ends with goal_reached.
  measuredJs @8 (sent :Rpc.Sent) -> (value :Joints.JointState, stamp :Int64)
      $Meta.cxx("measured_js") $Meta.kind("read");
  # Where the joints are. Stamp: the drives' cycle that measured them.
  setpointJs @9 (sent :Rpc.Sent) -> (value :Joints.JointState, stamp :Int64)
      $Meta.cxx("setpoint_js") $Meta.kind("read");
  # Where the joints shall be.
  measuredCp @10 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64)
      $Meta.cxx("measured_cp") $Meta.kind("read");
  # Where the tool tip is. Stamp: the drives' cycle that measured the joints.
  setpointCp @11 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64)
      $Meta.cxx("setpoint_cp") $Meta.kind("read");
  # Where the tool tip shall be. Stamp: that of the servo_cp goal it came from, else the arm's
  # cycle.
  operatingState @12 (sent :Rpc.Sent) -> (value :OperatingState.OperatingState, stamp :Int64)
      $Meta.cxx("operating_state") $Meta.kind("read");
  forwardKinematics @13 (q :Joints.JointGoal, sent :Rpc.Sent) -> (value :Pose.PoseStamped)
      $Meta.cxx("forward_kinematics") $Meta.kind("qualifiedRead");
  # The tool tip for a joint vector; not valid if it has the wrong length.
  inverseKinematics @14 (goal :Pose.PoseStamped, sent :Rpc.Sent) -> (value :Joints.JointSolution)
      $Meta.cxx("inverse_kinematics") $Meta.kind("qualifiedRead");
  # A joint vector for a tool tip, searched from the present set-point.
}

interface ArmEvents @0xdcbc184d8af1d03c $Meta.eventsOf("robots::Arm") {
  # What a subscriber of Arm receives.

  state @0 (row :ArmStateRow) -> ();
  # A new row of the columns asked for.
  operatingState @1 (value :OperatingState.OperatingState) -> () $Meta.cxx("operating_state")
      $Meta.latched $Meta.queue(16);
  # Each change of the operating state, and the last one to whoever connects.
  goalReached @2 (value :Bool) -> () $Meta.cxx("goal_reached") $Meta.queue(16);
  # A move ended: true at its goal, false when something else replaced it.
  warning @3 (value :ArmWarning) -> () $Meta.queue(16);
  # The arm refused a command, or something has befallen it. Each reason is told once until the
  # arm obeys again; a refused state command is told each time.
}

struct ArmStateRow @0x8c45d754ae03e800 $Meta.stateOf("robots::Arm") {
  # One row of the state table: what the read commands of Arm answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  measuredJs @2 :Joints.JointState $Meta.cxx("measured_js");
  setpointJs @3 :Joints.JointState $Meta.cxx("setpoint_js");
  measuredCp @4 :Pose.PoseStamped $Meta.cxx("measured_cp");
  setpointCp @5 :Pose.PoseStamped $Meta.cxx("setpoint_cp");
  operatingState @6 :OperatingState.OperatingState $Meta.cxx("operating_state");
  tooLarge @7 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
