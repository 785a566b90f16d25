@0xd89f2b9e03c4e3df;
# The wire contract of arm/crtk_arm.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Cartesian = import "/robot_types/cartesian.capnp";
using JointCommands = import "/robot_types/joint_commands.capnp";
using Joints = import "/robot_types/joints.capnp";
using Messages = import "/robot_types/messages.capnp";
using OperatingState = import "/robot_types/operating_state.capnp";
using Pose = import "/robot_types/pose.capnp";
using Rpc = import "/suture/rpc.capnp";
using SuturestandardMessages = import "/suture/standard/messages.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("arm/crtk_arm.h");

interface CrtkArm @0xe327df5d82aa8eea extends(SuturestandardMessages.Messages)
    $Meta.cxx("robots::CrtkArm") {
  # Commands run in the arm's own thread before its next cycle; reads are from the end of its last
  # one. `local_` poses are of the tool tip in the arm's base frame, all others in the reference
  # frame, in which base_frame() is the arm's base. A servo command replaces the one before it, of
  # whichever space; a stream of velocities or efforts that falls silent for 0.1 s ends as hold().
  # Relative goals are relative to the set-point. Status, warning and error are the standard
  # messages; what an arm refuses it tells in `warning`.

  subscribe @0 (events :CrtkArmEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  configurationJs @1 (sent :Rpc.Sent) -> (value :JointCommands.JointConfiguration, stamp :Int64)
      $Meta.cxx("configuration_js") $Meta.kind("read");
  # What the joints are and may do.
  operatingState @2 (sent :Rpc.Sent) -> (value :OperatingState.OperatingState, stamp :Int64)
      $Meta.cxx("operating_state") $Meta.kind("read");
  periodStatistics @3 (sent :Rpc.Sent) -> (value :Messages.IntervalStatistics, stamp :Int64)
      $Meta.cxx("period_statistics") $Meta.kind("read");
  # How regularly the arm's task ran in the last second.
  enable @4 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Gives the drives power; the arm holds its position.
  disable @5 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Stops at once, without power, and ignores motion until enabled again.
  pause @6 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Stops where the joints are and ignores motion until resume().
  resume @7 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  home @8 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Moves to the home position; needs an enabled arm. Ends with goal_reached.
  unhome @9 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Forgets that it is homed.
  stateCommand @10 (name :Text $Meta.capacity([15]), sent :Rpc.Sent) -> ()
      $Meta.cxx("state_command") $Meta.kind("write") $Meta.queue(16);
  # One of the six above, by name; anything else is an `error`.
  measuredJs @11 (sent :Rpc.Sent) -> (value :Joints.JointState, stamp :Int64)
      $Meta.cxx("measured_js") $Meta.kind("read");
  setpointJs @12 (sent :Rpc.Sent) -> (value :Joints.JointState, stamp :Int64)
      $Meta.cxx("setpoint_js") $Meta.kind("read");
  goalJs @13 (sent :Rpc.Sent) -> (value :Joints.JointState, stamp :Int64) $Meta.cxx("goal_js")
      $Meta.kind("read");
  # Where the move under way ends; without one, the set-point.
  measuredCp @14 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64)
      $Meta.cxx("measured_cp") $Meta.kind("read");
  setpointCp @15 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64)
      $Meta.cxx("setpoint_cp") $Meta.kind("read");
  goalCp @16 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64) $Meta.cxx("goal_cp")
      $Meta.kind("read");
  # Where the move under way ends; without one, the set-point.
  localMeasuredCp @17 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64)
      $Meta.cxx("local_measured_cp") $Meta.kind("read");
  localSetpointCp @18 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64)
      $Meta.cxx("local_setpoint_cp") $Meta.kind("read");
  measuredCv @19 (sent :Rpc.Sent) -> (value :Cartesian.Twist, stamp :Int64)
      $Meta.cxx("measured_cv") $Meta.kind("read");
  # Of the tip, in the directions of the reference frame.
  setpointCv @20 (sent :Rpc.Sent) -> (value :Cartesian.Twist, stamp :Int64)
      $Meta.cxx("setpoint_cv") $Meta.kind("read");
  bodyMeasuredCf @21 (sent :Rpc.Sent) -> (value :Cartesian.Wrench, stamp :Int64)
      $Meta.cxx("body_measured_cf") $Meta.kind("read");
  # Force on the tip in its own directions.
  spatialMeasuredCf @22 (sent :Rpc.Sent) -> (value :Cartesian.Wrench, stamp :Int64)
      $Meta.cxx("spatial_measured_cf") $Meta.kind("read");
  # Force on the tip in the directions of the arm's base frame.
  measuredCs @23 (sent :Rpc.Sent) -> (value :Cartesian.CartesianState, stamp :Int64)
      $Meta.cxx("measured_cs") $Meta.kind("read");
  # Pose, velocity and force of one cycle, in the reference frame.
  bodyJacobian @24 (sent :Rpc.Sent) -> (value :JointCommands.Jacobian, stamp :Int64)
      $Meta.cxx("body_jacobian") $Meta.kind("read");
  # From joint velocities to those of the tip, in its own directions.
  spatialJacobian @25 (sent :Rpc.Sent) -> (value :JointCommands.Jacobian, stamp :Int64)
      $Meta.cxx("spatial_jacobian") $Meta.kind("read");
  # The same in the directions of the arm's base frame.
  baseFrame @26 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64) $Meta.cxx("base_frame")
      $Meta.kind("read");
  setBaseFrame @27 (frame :Pose.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("set_base_frame")
      $Meta.kind("write") $Meta.queue(16);
  hold @28 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Drops what is under way; the set-point stays where it is.
  free @29 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Lets go: the set-point follows the joints until another command.
  useGravityCompensation @30 (use :Bool, sent :Rpc.Sent) -> ()
      $Meta.cxx("use_gravity_compensation") $Meta.kind("write") $Meta.queue(16);
  servoJp @31 (goal :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_jp")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  servoJr @32 (step :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_jr")
      $Meta.kind("write") $Meta.queue(16) $Meta.ttl(20000000);
  servoJv @33 (goal :JointCommands.JointVelocityGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_jv")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  servoJf @34 (goal :JointCommands.JointEffortGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_jf")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  servoCp @35 (goal :Pose.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("servo_cp")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  servoCr @36 (step :Pose.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("servo_cr")
      $Meta.kind("write") $Meta.queue(16) $Meta.ttl(20000000);
  # The step's translation in the reference frame; its rotation turns the tip about itself.
  servoCv @37 (goal :Cartesian.TwistGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_cv")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  bodyServoCf @38 (goal :Cartesian.WrenchGoal, sent :Rpc.Sent) -> () $Meta.cxx("body_servo_cf")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  # In the tip's own directions.
  spatialServoCf @39 (goal :Cartesian.WrenchGoal, sent :Rpc.Sent) -> ()
      $Meta.cxx("spatial_servo_cf") $Meta.kind("write") $Meta.latest $Meta.queue(16)
      $Meta.ttl(20000000);
  # In the directions of the arm's base frame.
  moveJp @40 (goal :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("move_jp")
      $Meta.kind("write") $Meta.queue(16);
  # Moves plan and execute a smooth motion from the set-point. Each ends with goal_reached.
  moveJr @41 (step :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("move_jr")
      $Meta.kind("write") $Meta.queue(16);
  moveCp @42 (goal :Pose.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("move_cp")
      $Meta.kind("write") $Meta.queue(16);
  moveCr @43 (step :Pose.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("move_cr")
      $Meta.kind("write") $Meta.queue(16);
  trajectoryJSetRatio @44 (ratio :Float64 $Meta.range(lowest = 0.01, highest = 1), sent :Rpc.Sent) -> ()
      $Meta.cxx("trajectory_j_set_ratio") $Meta.kind("write") $Meta.queue(16);
  # How fast moves are, of what the joints can do: velocity and acceleration together.
  trajectoryJSetRatioV @45 (ratio :Float64 $Meta.range(lowest = 0.01, highest = 1), sent :Rpc.Sent) -> ()
      $Meta.cxx("trajectory_j_set_ratio_v") $Meta.kind("write") $Meta.queue(16);
  trajectoryJSetRatioA @46 (ratio :Float64 $Meta.range(lowest = 0.01, highest = 1), sent :Rpc.Sent) -> ()
      $Meta.cxx("trajectory_j_set_ratio_a") $Meta.kind("write") $Meta.queue(16);
  trajectoryJRatio @47 (sent :Rpc.Sent) -> (value :Float64, stamp :Int64)
      $Meta.cxx("trajectory_j_ratio") $Meta.kind("read");
  # The smaller of the two below.
  trajectoryJRatioV @48 (sent :Rpc.Sent) -> (value :Float64, stamp :Int64)
      $Meta.cxx("trajectory_j_ratio_v") $Meta.kind("read");
  trajectoryJRatioA @49 (sent :Rpc.Sent) -> (value :Float64, stamp :Int64)
      $Meta.cxx("trajectory_j_ratio_a") $Meta.kind("read");
  forwardKinematics @50 (q :Joints.JointGoal, sent :Rpc.Sent) -> (value :Pose.PoseStamped)
      $Meta.cxx("forward_kinematics") $Meta.kind("qualifiedRead");
  # The tool tip for a joint vector; not valid if it has the wrong length.
  inverseKinematics @51 (goal :Pose.PoseStamped, sent :Rpc.Sent) -> (value :Joints.JointSolution)
      $Meta.cxx("inverse_kinematics") $Meta.kind("qualifiedRead");
  # A joint vector for a tool tip, searched from the present set-point.
  queryCp @52 (q :Joints.JointGoal, sent :Rpc.Sent) -> (value :Pose.PoseStamped)
      $Meta.cxx("query_cp") $Meta.kind("qualifiedRead");
  # The pose of the link behind as many joints as the vector has, at most all: none, the base.
  localQueryCp @53 (q :Joints.JointGoal, sent :Rpc.Sent) -> (value :Pose.PoseStamped)
      $Meta.cxx("local_query_cp") $Meta.kind("qualifiedRead");
  # The same in the arm's base frame.
}

interface CrtkArmEvents @0xeed86c20664eeafb $Meta.eventsOf("robots::CrtkArm") {
  # What a subscriber of CrtkArm receives.

  state @0 (row :CrtkArmStateRow) -> ();
  # A new row of the columns asked for.
  status @1 (value :SuturestandardMessages.Message) -> () $Meta.latched $Meta.queue(16);
  # All is well; something has been done.
  warning @2 (value :SuturestandardMessages.Message) -> () $Meta.latched $Meta.queue(16);
  # Something was refused, or is not as it should be; the component goes on.
  error @3 (value :SuturestandardMessages.Message) -> () $Meta.latched $Meta.queue(16);
  # Something failed, and somebody should see to it.
  operatingState @4 (value :OperatingState.OperatingState) -> () $Meta.cxx("operating_state")
      $Meta.latched $Meta.queue(16);
  # Each change of the operating state, and the last one to whoever connects.
  desiredState @5 (value :OperatingState.ArmState) -> () $Meta.cxx("desired_state") $Meta.latched
      $Meta.queue(16);
  # The state that a command asked for.
  goalReached @6 (value :Bool) -> () $Meta.cxx("goal_reached") $Meta.queue(16);
  # A move ended: true at its goal, false when something else replaced it.
  gravityCompensation @7 (value :Bool) -> () $Meta.cxx("gravity_compensation") $Meta.latched
      $Meta.queue(16);
  trajectoryJRatio @8 (value :Float64) -> () $Meta.cxx("trajectory_j_ratio") $Meta.latched
      $Meta.queue(16);
  trajectoryJRatioV @9 (value :Float64) -> () $Meta.cxx("trajectory_j_ratio_v") $Meta.latched
      $Meta.queue(16);
  trajectoryJRatioA @10 (value :Float64) -> () $Meta.cxx("trajectory_j_ratio_a") $Meta.latched
      $Meta.queue(16);
}

struct CrtkArmStateRow @0xaf91381bef91dec1 $Meta.stateOf("robots::CrtkArm") {
  # One row of the state table: what the read commands of CrtkArm answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  configurationJs @3 :JointCommands.JointConfiguration $Meta.cxx("configuration_js");
  operatingState @4 :OperatingState.OperatingState $Meta.cxx("operating_state");
  periodStatistics @5 :Messages.IntervalStatistics $Meta.cxx("period_statistics");
  measuredJs @6 :Joints.JointState $Meta.cxx("measured_js");
  setpointJs @7 :Joints.JointState $Meta.cxx("setpoint_js");
  goalJs @8 :Joints.JointState $Meta.cxx("goal_js");
  measuredCp @9 :Pose.PoseStamped $Meta.cxx("measured_cp");
  setpointCp @10 :Pose.PoseStamped $Meta.cxx("setpoint_cp");
  goalCp @11 :Pose.PoseStamped $Meta.cxx("goal_cp");
  localMeasuredCp @12 :Pose.PoseStamped $Meta.cxx("local_measured_cp");
  localSetpointCp @13 :Pose.PoseStamped $Meta.cxx("local_setpoint_cp");
  measuredCv @14 :Cartesian.Twist $Meta.cxx("measured_cv");
  setpointCv @15 :Cartesian.Twist $Meta.cxx("setpoint_cv");
  bodyMeasuredCf @16 :Cartesian.Wrench $Meta.cxx("body_measured_cf");
  spatialMeasuredCf @17 :Cartesian.Wrench $Meta.cxx("spatial_measured_cf");
  measuredCs @18 :Cartesian.CartesianState $Meta.cxx("measured_cs");
  bodyJacobian @19 :JointCommands.Jacobian $Meta.cxx("body_jacobian");
  spatialJacobian @20 :JointCommands.Jacobian $Meta.cxx("spatial_jacobian");
  baseFrame @21 :Pose.PoseStamped $Meta.cxx("base_frame");
  trajectoryJRatio @22 :Float64 $Meta.cxx("trajectory_j_ratio");
  trajectoryJRatioV @23 :Float64 $Meta.cxx("trajectory_j_ratio_v");
  trajectoryJRatioA @24 :Float64 $Meta.cxx("trajectory_j_ratio_a");
}
