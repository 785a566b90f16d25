@0xaa79289cf9333b18;
# The wire contract of arm/arm.h, written by suturec --update-lock: commit it, never edit it.

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
$Meta.header("arm/arm.h");

enum ArmWarning @0xa4117f14f97ed1bb $Meta.cxx("robots::ArmWarning") $Meta.removed("ArmWarning")
    $Meta.underlying("UInt8") {
  notEnabled @0 $Meta.cxx("NotEnabled") $Meta.value(0);
  outOfReach @1 $Meta.cxx("OutOfReach") $Meta.value(1);
  malformed @2 $Meta.cxx("Malformed") $Meta.value(2);
  clientGone @3 $Meta.cxx("ClientGone") $Meta.value(3);
  wrongState @4 $Meta.cxx("WrongState") $Meta.value(4);
  followingError @5 $Meta.cxx("FollowingError") $Meta.value(5);
  atLimit @6 $Meta.cxx("AtLimit") $Meta.value(6);
  stepTooFar @7 $Meta.cxx("StepTooFar") $Meta.value(7);
  powerLost @8 $Meta.cxx("PowerLost") $Meta.value(8);
  drivesSilent @9 $Meta.cxx("DrivesSilent") $Meta.value(9);
}

interface Arm @0xd2a6fc6237d6fd07 extends(SuturestandardMessages.Messages) $Meta.cxx("robots::Arm")
    $Meta.major(2) $Meta.version(2) {
  # Commands run in the arm's own thread before its next cycle; reads are from the end of its last
  # one. How a client calls and subscribes is in docs/howto/calling.md. Where a joint is prismatic,
  # its units are m, m/s, m/s2 and N in place of rad, rad/s, rad/s2 and N.m.
  #
  # States are those of CRTK. An arm starts, and restarts, in Undefined. When its drives answer and
  # power is permitted it becomes Disabled, and is not homed. Motion commands need state Enabled; in
  # any other the arm refuses them. It enters Fault by itself, and leaves it by enable() or
  # disable().
  #
  # An arm that is not homed, or not any more after an encoder jumped or unhome(), does not know
  # where its tip is: it refuses all Cartesian motion commands (`servo_c*`, `*_servo_cf`,
  # `interpolate_c*`, `move_c*`), and obeys those of joints.
  #
  # An arm that works through a cannula also refuses Cartesian motion until its wrist is far enough
  # beyond the remote centre: for a da Vinci it must be 45 mm beyond; once it was less, 47 mm.
  # home() and joint commands move the wrist through the cannula.
  #
  # `local_` poses are of the tool tip in the arm's base frame, all others in the reference frame of
  # the interface, in which base_frame() is the arm's base. The two frames are the same until some
  # client calls set_base_frame(), which counts for all clients.
  #
  # Motion does not queue: each motion command replaces the one before it, of joints or of the tip,
  # and relative goals are relative to the set-point. A servo stream that falls silent for 0.1 s
  # ends as with hold(), and so does any stream whose client is gone.
  #
  # The arm reports each refusal, and what happens to it, by the events warning and error, whose
  # `code` is an ArmWarning (arm_warning.h). A refused motion command is reported once until the arm
  # obeys again; a refused state command is reported each time.

  subscribe @0 (events :ArmEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  enable @1 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Gives the drives power. The arm holds its position.
  disable @2 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Stops the arm at once and takes its power. It refuses motion until it is enabled again.
  home @3 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Moves the arm to its home position, if it is enabled. The move ends with goal_reached.
  hold @4 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Drops what is under way; the set-point stays where it is.
  servoCp @5 (goal :Pose.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("servo_cp")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  # Streams Cartesian goals, newest wins. Beyond a joint limit the arm slides along it, at the
  # nearest point that the limits admit, and warns of AtLimit. A goal that is out of reach, or
  # farther from the set-point than the rate limits admit, is dropped with a warning, OutOfReach
  # or StepTooFar, and the set-point stays where it was. setpoint_cp keeps the goal's stamp.
  servoJp @6 (goal :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_jp")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  # Streams joint goals, newest wins. A joint whose goal lies beyond its limit stays at the limit.
  moveJp @7 (goal :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("move_jp") $Meta.kind("write")
      $Meta.queue(16);
  # Plans and executes a smooth motion of the joints from the set-point, and from the velocity
  # that it has: a move may replace another under way. It ends at rest and with goal_reached. A
  # goal beyond a joint limit is refused.
  measuredJs @8 (sent :Rpc.Sent) -> (value :Joints.JointState, stamp :Int64)
      $Meta.cxx("measured_js") $Meta.kind("read");
  # Says where the joints are, and what their motors give; `effort` is empty if the drives do not
  # measure it. The stamp is that of the drives' cycle that measured them.
  setpointJs @9 (sent :Rpc.Sent) -> (value :Joints.JointState, stamp :Int64)
      $Meta.cxx("setpoint_js") $Meta.kind("read");
  # Says where the joints are commanded to be in this cycle.
  measuredCp @10 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64)
      $Meta.cxx("measured_cp") $Meta.kind("read");
  # Says where the tool tip is. The stamp is that of the drives' cycle that measured the joints.
  setpointCp @11 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64)
      $Meta.cxx("setpoint_cp") $Meta.kind("read");
  # Says where the tool tip is commanded to be in this cycle. The stamp is that of the servo_cp or
  # interpolate_cp goal from which it came, else that of the arm's cycle.
  operatingState @12 (sent :Rpc.Sent) -> (value :OperatingState.OperatingState, stamp :Int64)
      $Meta.cxx("operating_state") $Meta.kind("read");
  # Says in which state of CRTK the arm is, and whether it is homed.
  forwardKinematics @13 (q :Joints.JointGoal, sent :Rpc.Sent) -> (value :Pose.PoseStamped)
      $Meta.cxx("forward_kinematics") $Meta.kind("qualifiedRead");
  # Computes the tool tip for a joint vector; it is not valid if the vector has the wrong length.
  inverseKinematics @14 (goal :Pose.PoseStamped, sent :Rpc.Sent) -> (value :Joints.JointSolution)
      $Meta.cxx("inverse_kinematics") $Meta.kind("qualifiedRead");
  # Computes a joint vector for a tool tip, searched from the present set-point.
  configurationJs @15 (sent :Rpc.Sent) -> (value :JointCommands.JointConfiguration, stamp :Int64)
      $Meta.cxx("configuration_js") $Meta.kind("read");
  # Says what the joints are and what they may do. Velocities are their rate limits, accelerations
  # those of moves, efforts the most that the motors give. For a da Vinci the efforts are from the
  # literature, the accelerations our own. A list is empty if it bounds no joint.
  periodStatistics @16 (sent :Rpc.Sent) -> (value :Messages.IntervalStatistics, stamp :Int64)
      $Meta.cxx("period_statistics") $Meta.kind("read");
  # Says how regularly the arm's task ran in the last second.
  pause @17 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Stops the arm where the joints are. It refuses motion until resume().
  resume @18 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Ends a pause: the arm is enabled and holds.
  unhome @19 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Makes the arm forget that it is homed, and ends home(): the arm holds where it is.
  stateCommand @20 (name :Text $Meta.capacity([15]), sent :Rpc.Sent) -> ()
      $Meta.cxx("state_command") $Meta.kind("write") $Meta.queue(16);
  # Does what its name says: "enable", "disable", "pause", "resume", "home" or "unhome". Any other
  # name is reported as an error.
  goalJs @21 (sent :Rpc.Sent) -> (value :Joints.JointState, stamp :Int64) $Meta.cxx("goal_js")
      $Meta.kind("read");
  # Says where the present move ends; without one, it is the set-point.
  goalCp @22 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64) $Meta.cxx("goal_cp")
      $Meta.kind("read");
  # Says where the present move ends; without one, it is the set-point.
  localMeasuredCp @23 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64)
      $Meta.cxx("local_measured_cp") $Meta.kind("read");
  # Says where the tool tip is in the arm's base frame.
  localSetpointCp @24 (sent :Rpc.Sent) -> (value :Pose.PoseStamped, stamp :Int64)
      $Meta.cxx("local_setpoint_cp") $Meta.kind("read");
  # Says where the tool tip is commanded to be, in the arm's base frame.
  measuredCv @25 (sent :Rpc.Sent) -> (value :Cartesian.Twist, stamp :Int64)
      $Meta.cxx("measured_cv") $Meta.kind("read");
  # Says how the tip moves, in the directions of the reference frame.
  setpointCv @26 (sent :Rpc.Sent) -> (value :Cartesian.Twist, stamp :Int64)
      $Meta.cxx("setpoint_cv") $Meta.kind("read");
  # Says how the set-point moves, whatever moves it, in the directions of the reference frame. If
  # it jumped, and in the first cycle of a motion, this is 0. The stamp is that of the arm's
  # cycle.
  bodyMeasuredCf @27 (sent :Rpc.Sent) -> (value :Cartesian.Wrench, stamp :Int64)
      $Meta.cxx("body_measured_cf") $Meta.kind("read");
  # Says with which wrench the arm presses at its tip, in the tip's own directions: the motors'
  # efforts, less the arm's weight by its model, through the transposed Jacobian. It includes
  # friction, inertia and the errors of that model, so it is near a contact's force only if the
  # arm is slow and presses hard. Its sign is that of body_servo_cf, as in the da Vinci Research
  # Kit; what touches the tip presses on it with the opposite. It is not valid if the drives
  # measure no effort, without power, and near a singularity. The stamp is that of the drives'
  # cycle that measured the joints.
  spatialMeasuredCf @28 (sent :Rpc.Sent) -> (value :Cartesian.Wrench, stamp :Int64)
      $Meta.cxx("spatial_measured_cf") $Meta.kind("read");
  # Says what body_measured_cf says, in the directions of the arm's base frame.
  measuredCs @29 (sent :Rpc.Sent) -> (value :Cartesian.CartesianState, stamp :Int64)
      $Meta.cxx("measured_cs") $Meta.kind("read");
  # Gives pose, velocity and force of one cycle, in the reference frame.
  bodyJacobian @30 (sent :Rpc.Sent) -> (value :JointCommands.Jacobian, stamp :Int64)
      $Meta.cxx("body_jacobian") $Meta.kind("read");
  # Maps joint velocities to the velocity of the tip, in the tip's own directions. The stamp is
  # that of the drives' cycle that measured the joints.
  spatialJacobian @31 (sent :Rpc.Sent) -> (value :JointCommands.Jacobian, stamp :Int64)
      $Meta.cxx("spatial_jacobian") $Meta.kind("read");
  # Maps joint velocities to the velocity of the tip, in the directions of the arm's base frame.
  baseFrame @32 (sent :Rpc.Sent) -> (value :Pose.TransformStamped, stamp :Int64)
      $Meta.cxx("base_frame") $Meta.kind("read");
  # Says where the arm's base is in the reference frame of this interface.
  setBaseFrame @33 (base :Pose.TransformStamped, sent :Rpc.Sent) -> () $Meta.cxx("set_base_frame")
      $Meta.kind("write") $Meta.queue(16);
  # Sets where the arm's base is in the reference frame of this interface, for all clients. It is
  # refused if `base` names another reference frame than the interface's, while the arm moves or
  # follows a stream, and until no goal of a Cartesian stream in the reference frame, obeyed or
  # refused, has come for 0.1 s: the next one would be about the previous base.
  free @34 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Lets the set-point follow the joints until another command. Drives that control efforts
  # release the joints: their motors do no more than carry the arm, if they are to.
  useGravityCompensation @35 (use :Bool, sent :Rpc.Sent) -> ()
      $Meta.cxx("use_gravity_compensation") $Meta.kind("write") $Meta.queue(16);
  # Says if the motors carry the arm's weight, in every state that has power; at first they do.
  # Drives that control efforts obey it. Without it a joint that is held sinks until its
  # controller carries it, and one that is released falls.
  servoJr @36 (step :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_jr")
      $Meta.kind("write") $Meta.queue(16) $Meta.ttl(20000000);
  # Steps the set-point by joint positions.
  servoJv @37 (goal :JointCommands.JointVelocityGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_jv")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  # Streams joint velocities, newest wins: the set-point moves so fast, within the rate limits.
  servoJf @38 (goal :JointCommands.JointEffortGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_jf")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  # Streams what the motors give beside carrying the arm, newest wins. The joints are released;
  # those outside of the mask are held. If the drives control no effort, it moves the set-point at
  # a speed proportional to it.
  servoCr @39 (step :Pose.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("servo_cr")
      $Meta.kind("write") $Meta.queue(16) $Meta.ttl(20000000);
  # Steps the set-point: the translation is in the reference frame, the rotation turns the tip
  # about itself.
  servoCv @40 (goal :Cartesian.TwistGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_cv")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  # Streams velocities of the tip, in the directions of the reference frame, newest wins.
  bodyServoCf @41 (goal :Cartesian.WrenchGoal, sent :Rpc.Sent) -> () $Meta.cxx("body_servo_cf")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  # Streams the wrench that the tip presses with beside carrying the arm, in the tip's own
  # directions, newest wins. The joints are released as by servo_jf; drives that control no effort
  # move the set-point at a speed proportional to the wrench.
  spatialServoCf @42 (goal :Cartesian.WrenchGoal, sent :Rpc.Sent) -> ()
      $Meta.cxx("spatial_servo_cf") $Meta.kind("write") $Meta.latest $Meta.queue(16)
      $Meta.ttl(20000000);
  # Streams wrenches as body_servo_cf does, in the directions of the arm's base frame.
  interpolateJp @43 (goal :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("interpolate_jp")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(200000000);
  # Streams goals that come more slowly than the arm's cycles, newest wins. The set-point goes to
  # each in a straight line of the joints, in as much time as lay between it and the goal before
  # it, but no faster than the joints can, and stays there. Limits and reach are those of servo
  # commands.
  interpolateJr @44 (step :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("interpolate_jr")
      $Meta.kind("write") $Meta.queue(16) $Meta.ttl(200000000);
  # Steps the goal of interpolate_jp by joint positions.
  interpolateCp @45 (goal :Pose.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("interpolate_cp")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(200000000);
  # Streams Cartesian goals that come more slowly than the arm's cycles, as interpolate_jp does.
  interpolateCr @46 (step :Pose.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("interpolate_cr")
      $Meta.kind("write") $Meta.queue(16) $Meta.ttl(200000000);
  # Steps the goal of interpolate_cp as servo_cr steps the set-point.
  moveJr @47 (step :Joints.JointGoal, sent :Rpc.Sent) -> () $Meta.cxx("move_jr")
      $Meta.kind("write") $Meta.queue(16);
  # Moves as move_jp does, by joint positions from the set-point.
  moveCp @48 (goal :Pose.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("move_cp")
      $Meta.kind("write") $Meta.queue(16);
  # Moves the tip to a pose, by the motion of the joints that move_jp plans: the path is not
  # straight in space. A goal that the joints cannot reach within their limits is refused.
  moveCr @49 (step :Pose.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("move_cr")
      $Meta.kind("write") $Meta.queue(16);
  # Moves as move_cp does, by a step from the set-point that is given as servo_cr's.
  trajectoryJSetRatio @50 (ratio :Float64 $Meta.range(lowest = 0.01, highest = 1), sent :Rpc.Sent) -> ()
      $Meta.cxx("trajectory_j_set_ratio") $Meta.kind("write") $Meta.queue(16);
  # Sets the fraction of the joints' velocity and acceleration limits that moves use.
  trajectoryJSetRatioV @51 (ratio :Float64 $Meta.range(lowest = 0.01, highest = 1), sent :Rpc.Sent) -> ()
      $Meta.cxx("trajectory_j_set_ratio_v") $Meta.kind("write") $Meta.queue(16);
  # Sets the fraction of the velocity limits alone.
  trajectoryJSetRatioA @52 (ratio :Float64 $Meta.range(lowest = 0.01, highest = 1), sent :Rpc.Sent) -> ()
      $Meta.cxx("trajectory_j_set_ratio_a") $Meta.kind("write") $Meta.queue(16);
  # Sets the fraction of the acceleration limits alone.
  trajectoryJRatio @53 (sent :Rpc.Sent) -> (value :Float64, stamp :Int64)
      $Meta.cxx("trajectory_j_ratio") $Meta.kind("read");
  # Says the smaller of trajectory_j_ratio_v and trajectory_j_ratio_a.
  trajectoryJRatioV @54 (sent :Rpc.Sent) -> (value :Float64, stamp :Int64)
      $Meta.cxx("trajectory_j_ratio_v") $Meta.kind("read");
  # Says what trajectory_j_set_ratio_v has set.
  trajectoryJRatioA @55 (sent :Rpc.Sent) -> (value :Float64, stamp :Int64)
      $Meta.cxx("trajectory_j_ratio_a") $Meta.kind("read");
  # Says what trajectory_j_set_ratio_a has set.
  queryCp @56 (q :Joints.JointGoal, sent :Rpc.Sent) -> (value :Pose.PoseStamped)
      $Meta.cxx("query_cp") $Meta.kind("qualifiedRead");
  # Computes the pose of link n for a vector of n joints, at most all of them; that of the base
  # for an empty one.
  localQueryCp @57 (q :Joints.JointGoal, sent :Rpc.Sent) -> (value :Pose.PoseStamped)
      $Meta.cxx("local_query_cp") $Meta.kind("qualifiedRead");
  # Computes what query_cp does, in the arm's base frame.
}

interface ArmEvents @0xdcbc184d8af1d03c $Meta.eventsOf("robots::Arm") {
  # What a subscriber of Arm receives.

  state @0 (row :ArmStateRow) -> ();
  # A new row of the columns asked for.
  operatingState @1 (value :OperatingState.OperatingState, stamp :Int64) -> ()
      $Meta.cxx("operating_state") $Meta.latched $Meta.queue(16);
  # Reports each change of the operating state, and the last one to a client that connects.
  goalReached @2 (value :Bool, stamp :Int64) -> () $Meta.cxx("goal_reached") $Meta.queue(16);
  # Reports the end of a move: true at its goal, false if anything else ended it.
  warning @3 (value :SuturestandardMessages.Message, stamp :Int64) -> () $Meta.latched
      $Meta.queue(16);
  # Reports that something was refused, or is not as it should be; the component goes on.
  status @4 (value :SuturestandardMessages.Message, stamp :Int64) -> () $Meta.latched
      $Meta.queue(16);
  # Reports that something has been done, and nothing is wrong.
  error @5 (value :SuturestandardMessages.Message, stamp :Int64) -> () $Meta.latched
      $Meta.queue(16);
  # Reports that something failed, and needs somebody's attention.
  desiredState @6 (value :OperatingState.ArmState, stamp :Int64) -> () $Meta.cxx("desired_state")
      $Meta.latched $Meta.queue(16);
  # Reports the state that a command asked for.
  gravityCompensation @7 (value :Bool, stamp :Int64) -> () $Meta.cxx("gravity_compensation")
      $Meta.latched $Meta.queue(16);
  # Reports what use_gravity_compensation has set.
  trajectoryJRatio @8 (value :Float64, stamp :Int64) -> () $Meta.cxx("trajectory_j_ratio")
      $Meta.latched $Meta.queue(16);
  # Reports a change of the fraction that trajectory_j_ratio says.
  trajectoryJRatioV @9 (value :Float64, stamp :Int64) -> () $Meta.cxx("trajectory_j_ratio_v")
      $Meta.latched $Meta.queue(16);
  # Reports a change of the fraction of the velocity limits.
  trajectoryJRatioA @10 (value :Float64, stamp :Int64) -> () $Meta.cxx("trajectory_j_ratio_a")
      $Meta.latched $Meta.queue(16);
  # Reports a change of the fraction of the acceleration limits.
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
  configurationJs @8 :JointCommands.JointConfiguration $Meta.cxx("configuration_js");
  periodStatistics @9 :Messages.IntervalStatistics $Meta.cxx("period_statistics");
  goalJs @10 :Joints.JointState $Meta.cxx("goal_js");
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
  baseFrame @21 :Pose.TransformStamped $Meta.cxx("base_frame");
  trajectoryJRatio @22 :Float64 $Meta.cxx("trajectory_j_ratio");
  trajectoryJRatioV @23 :Float64 $Meta.cxx("trajectory_j_ratio_v");
  trajectoryJRatioA @24 :Float64 $Meta.cxx("trajectory_j_ratio_a");
}
