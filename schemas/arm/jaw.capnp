@0xbc81ba5b988761fb;
# The wire contract of arm/jaw.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using JointCommands = import "/robot_types/joint_commands.capnp";
using Joints = import "/robot_types/joints.capnp";
using Rpc = import "/suture/rpc.capnp";
using Messages = import "/suture/standard/messages.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("arm/jaw.h");

interface Jaw @0xf5776c4cb1ab9076 extends(Messages.Messages) $Meta.cxx("robots::Jaw") {
  # The arm that holds the instrument provides this as an interface of its own, "Jaw". Commands run
  # in the arm's thread before its next cycle; reads are from the end of its last one. Joint vectors
  # have one entry, the angle between the blades in rad: 0 is closed, and a smaller angle presses
  # them together. It may be -0.698 to 1.396 rad (-40 to 80 degrees) on the large needle driver of a
  # da Vinci.
  #
  # The jaw has the power of its arm, and needs an arm that is enabled: otherwise it ignores
  # commands of motion and says so in a warning, once until it obeys again. When its arm stops being
  # enabled, it stops where it is. Homing the arm leaves it as it is.
  #
  # A command replaces the one before it. A servo stream that falls silent for 0.1 s, or whose
  # client is gone, leaves the set-point where it is.
  #
  # Status, warning and error are the standard messages. Their `code` is an ArmWarning
  # (arm_warning.h).

  subscribe @0 (events :JawEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  configurationJs @1 (sent :Rpc.Sent) -> (value :JointCommands.JointConfiguration, stamp :Int64)
      $Meta.cxx("configuration_js") $Meta.kind("read");
  # Says what the joint is and what it may do. Its effort limit is published
  # (LARGE_NEEDLE_DRIVER_400006.json); its acceleration limit, which is that of moves, is not.
  measuredJs @2 (sent :Rpc.Sent) -> (value :Joints.JointState, stamp :Int64)
      $Meta.cxx("measured_js") $Meta.kind("read");
  # Says where the joint is. The stamp is that of the drives' cycle that measured it.
  setpointJs @3 (sent :Rpc.Sent) -> (value :Joints.JointState, stamp :Int64)
      $Meta.cxx("setpoint_js") $Meta.kind("read");
  # Says where the joint shall be. The effort is that of servo_jf, else 0.
  servoJp @4 (goal :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_jp")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  # Streams goals, newest wins. The set-point goes there no faster than the joint can; a goal
  # beyond a limit leads only to the limit.
  servoJf @5 (goal :JointCommands.JointEffortGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_jf")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  # Streams efforts, newest wins; a negative one closes. The simulated jaw has no mass: an effort
  # moves the set-point at a speed proportional to it.
  moveJp @6 (goal :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("move_jp") $Meta.kind("write")
      $Meta.queue(16);
  # Plans and executes a smooth motion from the set-point and the velocity that it has. Ends with
  # goal_reached.
}

interface JawEvents @0xd6c2953fc4455ac0 $Meta.eventsOf("robots::Jaw") {
  # What a subscriber of Jaw receives.

  state @0 (row :JawStateRow) -> ();
  # A new row of the columns asked for.
  status @1 (value :Messages.Message, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports that something has been done, and nothing is wrong.
  warning @2 (value :Messages.Message, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports that something was refused, or is not as it should be; the component goes on.
  error @3 (value :Messages.Message, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports that something failed, and needs somebody's attention.
  goalReached @4 (value :Bool, stamp :Int64) -> () $Meta.cxx("goal_reached") $Meta.queue(16);
  # Reports the end of a move: true at its goal, false if something else replaced it.
}

struct JawStateRow @0xa03ee03faaaeccdd $Meta.stateOf("robots::Jaw") {
  # One row of the state table: what the read commands of Jaw answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  configurationJs @3 :JointCommands.JointConfiguration $Meta.cxx("configuration_js");
  measuredJs @4 :Joints.JointState $Meta.cxx("measured_js");
  setpointJs @5 :Joints.JointState $Meta.cxx("setpoint_js");
}
