#pragma once
// This is the contract of an arm, master or slave: CRTK (collaborative-robotics.github.io) with
// what the da Vinci Research Kit adds to it.

#include <suture/annotate.h>
#include <suture/standard/messages.h>

#include <string>

#include "robot_types/cartesian.h"
#include "robot_types/joint_commands.h"
#include "robot_types/joints.h"
#include "robot_types/messages.h"
#include "robot_types/operating_state.h"
#include "robot_types/pose.h"

namespace robots {

/// Commands run in the arm's own thread before its next cycle; reads are from the end of its last
/// one. How a client calls and subscribes is in docs/howto/calling.md. Where a joint is prismatic,
/// its units are m, m/s, m/s2 and N in place of rad, rad/s, rad/s2 and N.m.
///
/// States are those of CRTK. An arm starts, and restarts, in Undefined. When its drives answer and
/// power is permitted it becomes Disabled, and is not homed. Motion commands need state Enabled; in
/// any other the arm refuses them. It enters Fault by itself, and leaves it by enable() or
/// disable().
///
/// An arm that is not homed, or not any more after an encoder jumped or unhome(), does not know
/// where its tip is: it refuses all Cartesian motion commands (`servo_c*`, `*_servo_cf`,
/// `interpolate_c*`, `move_c*`), and obeys those of joints.
///
/// An arm that works through a cannula also refuses Cartesian motion until its wrist is far enough
/// beyond the remote centre: for a da Vinci it must be 45 mm beyond; once it was less, 47 mm.
/// home() and joint commands move the wrist through the cannula.
///
/// `local_` poses are of the tool tip in the arm's base frame, all others in the reference frame of
/// the interface, in which base_frame() is the arm's base. The two frames are the same until some
/// client calls set_base_frame(), which counts for all clients.
///
/// Motion does not queue: each motion command replaces the one before it, of joints or of the tip,
/// and relative goals are relative to the set-point. A servo stream that falls silent for 0.1 s
/// ends as with hold(), and so does any stream whose client is gone.
///
/// The arm reports each refusal, and what happens to it, by the events warning and error, whose
/// `code` is an ArmWarning (arm_warning.h). A refused motion command is reported once until the arm
/// obeys again; a refused state command is reported each time.
class SUTURE_INTERFACE(crtk(), version(2)) Arm : public suture::Messages {
 public:
  // --- state

  /// Says what the joints are and what they may do. Velocities are their rate limits, accelerations
  /// those of moves, efforts the most that the motors give. For a da Vinci the efforts are from the
  /// literature, the accelerations our own. A list is empty if it bounds no joint.
  SUTURE_COMMAND() virtual const JointConfiguration& configuration_js() const = 0;
  /// Says in which state of CRTK the arm is, and whether it is homed.
  SUTURE_COMMAND() virtual const OperatingState& operating_state() const = 0;
  /// Says how regularly the arm's task ran in the last second.
  SUTURE_COMMAND() virtual IntervalStatistics period_statistics() const = 0;

  /// Gives the drives power. The arm holds its position.
  SUTURE_COMMAND() virtual void enable() = 0;
  /// Stops the arm at once and takes its power. It refuses motion until it is enabled again.
  SUTURE_COMMAND() virtual void disable() = 0;
  /// Stops the arm where the joints are. It refuses motion until resume().
  SUTURE_COMMAND() virtual void pause() = 0;
  /// Ends a pause: the arm is enabled and holds.
  SUTURE_COMMAND() virtual void resume() = 0;
  /// Moves the arm to its home position, if it is enabled. The move ends with goal_reached.
  SUTURE_COMMAND() virtual void home() = 0;
  /// Makes the arm forget that it is homed, and ends home(): the arm holds where it is.
  SUTURE_COMMAND() virtual void unhome() = 0;
  /// Does what its name says: "enable", "disable", "pause", "resume", "home" or "unhome". Any other
  /// name is reported as an error.
  SUTURE_COMMAND()
  virtual void state_command(SUTURE_FIELD(capacity(15)) const std::string& name) = 0;

  // --- where it is and is commanded to be

  /// Says where the joints are, and what their motors give; `effort` is empty if the drives do not
  /// measure it. The stamp is that of the drives' cycle that measured them.
  SUTURE_COMMAND() virtual const JointState& measured_js() const = 0;
  /// Says where the joints are commanded to be in this cycle.
  SUTURE_COMMAND() virtual const JointState& setpoint_js() const = 0;
  /// Says where the present move ends; without one, it is the set-point.
  SUTURE_COMMAND() virtual const JointState& goal_js() const = 0;
  /// Says where the tool tip is. The stamp is that of the drives' cycle that measured the joints.
  SUTURE_COMMAND() virtual PoseStamped measured_cp() const = 0;
  /// Says where the tool tip is commanded to be in this cycle. The stamp is that of the servo_cp or
  /// interpolate_cp goal from which it came, else that of the arm's cycle.
  SUTURE_COMMAND() virtual PoseStamped setpoint_cp() const = 0;
  /// Says where the present move ends; without one, it is the set-point.
  SUTURE_COMMAND() virtual PoseStamped goal_cp() const = 0;
  /// Says where the tool tip is in the arm's base frame.
  SUTURE_COMMAND() virtual PoseStamped local_measured_cp() const = 0;
  /// Says where the tool tip is commanded to be, in the arm's base frame.
  SUTURE_COMMAND() virtual PoseStamped local_setpoint_cp() const = 0;
  /// Says how the tip moves, in the directions of the reference frame.
  SUTURE_COMMAND() virtual const Twist& measured_cv() const = 0;
  /// Says how the set-point moves, whatever moves it, in the directions of the reference frame. If
  /// it jumped, and in the first cycle of a motion, this is 0. The stamp is that of the arm's
  /// cycle.
  SUTURE_COMMAND() virtual const Twist& setpoint_cv() const = 0;
  /// Says with which wrench the arm presses at its tip, in the tip's own directions: the motors'
  /// efforts, less the arm's weight by its model, through the transposed Jacobian. It includes
  /// friction, inertia and the errors of that model, so it is near a contact's force only if the
  /// arm is slow and presses hard. Its sign is that of body_servo_cf, as in the da Vinci Research
  /// Kit; what touches the tip presses on it with the opposite. It is not valid if the drives
  /// measure no effort, without power, and near a singularity. The stamp is that of the drives'
  /// cycle that measured the joints.
  SUTURE_COMMAND() virtual const Wrench& body_measured_cf() const = 0;
  /// Says what body_measured_cf says, in the directions of the arm's base frame.
  SUTURE_COMMAND() virtual const Wrench& spatial_measured_cf() const = 0;
  /// Gives pose, velocity and force of one cycle, in the reference frame.
  SUTURE_COMMAND() virtual const CartesianState& measured_cs() const = 0;
  /// Maps joint velocities to the velocity of the tip, in the tip's own directions. The stamp is
  /// that of the drives' cycle that measured the joints.
  SUTURE_COMMAND() virtual const Jacobian& body_jacobian() const = 0;
  /// Maps joint velocities to the velocity of the tip, in the directions of the arm's base frame.
  SUTURE_COMMAND() virtual const Jacobian& spatial_jacobian() const = 0;
  /// Says where the arm's base is in the reference frame of this interface.
  SUTURE_COMMAND() virtual const TransformStamped& base_frame() const = 0;
  /// Sets where the arm's base is in the reference frame of this interface, for all clients. It is
  /// refused if `base` names another reference frame than the interface's, while the arm moves or
  /// follows a stream, and until no goal of a Cartesian stream in the reference frame, obeyed or
  /// refused, has come for 0.1 s: the next one would be about the previous base.
  SUTURE_COMMAND() virtual void set_base_frame(const TransformStamped& base) = 0;

  // --- motion

  /// Drops what is under way; the set-point stays where it is.
  SUTURE_COMMAND() virtual void hold() = 0;
  /// Lets the set-point follow the joints until another command. Drives that control efforts
  /// release the joints: their motors do no more than carry the arm, if they are to.
  SUTURE_COMMAND() virtual void free() = 0;
  /// Says if the motors carry the arm's weight, in every state that has power; at first they do.
  /// Drives that control efforts obey it. Without it a joint that is held sinks until its
  /// controller carries it, and one that is released falls.
  SUTURE_COMMAND() virtual void use_gravity_compensation(bool use) = 0;

  /// Streams joint goals, newest wins. A joint whose goal lies beyond its limit stays at the limit.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jp(const JointGoal& goal) = 0;
  /// Steps the set-point by joint positions.
  SUTURE_COMMAND(ttl(20ms)) virtual void servo_jr(const JointGoal& step) = 0;
  /// Streams joint velocities, newest wins: the set-point moves so fast, within the rate limits.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jv(const JointVelocityGoal& goal) = 0;
  /// Streams what the motors give beside carrying the arm, newest wins. The joints are released;
  /// those outside of the mask are held. If the drives control no effort, it moves the set-point at
  /// a speed proportional to it.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jf(const JointEffortGoal& goal) = 0;
  /// Streams Cartesian goals, newest wins. Beyond a joint limit the arm slides along it, at the
  /// nearest point that the limits admit, and warns of AtLimit. A goal that is out of reach, or
  /// farther from the set-point than the rate limits admit, is dropped with a warning, OutOfReach
  /// or StepTooFar, and the set-point stays where it was. setpoint_cp keeps the goal's stamp.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_cp(const PoseStamped& goal) = 0;
  /// Steps the set-point: the translation is in the reference frame, the rotation turns the tip
  /// about itself.
  SUTURE_COMMAND(ttl(20ms)) virtual void servo_cr(const PoseStamped& step) = 0;
  /// Streams velocities of the tip, in the directions of the reference frame, newest wins.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_cv(const TwistGoal& goal) = 0;
  /// Streams the wrench that the tip presses with beside carrying the arm, in the tip's own
  /// directions, newest wins. The joints are released as by servo_jf; drives that control no effort
  /// move the set-point at a speed proportional to the wrench.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void body_servo_cf(const WrenchGoal& goal) = 0;
  /// Streams wrenches as body_servo_cf does, in the directions of the arm's base frame.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void spatial_servo_cf(const WrenchGoal& goal) = 0;

  /// Streams goals that come more slowly than the arm's cycles, newest wins. The set-point goes to
  /// each in a straight line of the joints, in as much time as lay between it and the goal before
  /// it, but no faster than the joints can, and stays there. Limits and reach are those of servo
  /// commands.
  SUTURE_COMMAND(latest(), ttl(200ms)) virtual void interpolate_jp(const JointGoal& goal) = 0;
  /// Steps the goal of interpolate_jp by joint positions.
  SUTURE_COMMAND(ttl(200ms)) virtual void interpolate_jr(const JointGoal& step) = 0;
  /// Streams Cartesian goals that come more slowly than the arm's cycles, as interpolate_jp does.
  SUTURE_COMMAND(latest(), ttl(200ms)) virtual void interpolate_cp(const PoseStamped& goal) = 0;
  /// Steps the goal of interpolate_cp as servo_cr steps the set-point.
  SUTURE_COMMAND(ttl(200ms)) virtual void interpolate_cr(const PoseStamped& step) = 0;

  /// Plans and executes a smooth motion of the joints from the set-point, and from the velocity
  /// that it has: a move may replace another under way. It ends at rest and with goal_reached. A
  /// goal beyond a joint limit is refused.
  SUTURE_COMMAND() virtual void move_jp(const JointGoal& goal) = 0;
  /// Moves as move_jp does, by joint positions from the set-point.
  SUTURE_COMMAND() virtual void move_jr(const JointGoal& step) = 0;
  /// Moves the tip to a pose, by the motion of the joints that move_jp plans: the path is not
  /// straight in space. A goal that the joints cannot reach within their limits is refused.
  SUTURE_COMMAND() virtual void move_cp(const PoseStamped& goal) = 0;
  /// Moves as move_cp does, by a step from the set-point that is given as servo_cr's.
  SUTURE_COMMAND() virtual void move_cr(const PoseStamped& step) = 0;

  /// Sets the fraction of the joints' velocity and acceleration limits that moves use.
  SUTURE_COMMAND()
  virtual void trajectory_j_set_ratio(SUTURE_FIELD(range(0.01, 1)) double ratio) = 0;
  /// Sets the fraction of the velocity limits alone.
  SUTURE_COMMAND()
  virtual void trajectory_j_set_ratio_v(SUTURE_FIELD(range(0.01, 1)) double ratio) = 0;
  /// Sets the fraction of the acceleration limits alone.
  SUTURE_COMMAND()
  virtual void trajectory_j_set_ratio_a(SUTURE_FIELD(range(0.01, 1)) double ratio) = 0;
  /// Says the smaller of trajectory_j_ratio_v and trajectory_j_ratio_a.
  SUTURE_COMMAND() virtual double trajectory_j_ratio() const = 0;
  /// Says what trajectory_j_set_ratio_v has set.
  SUTURE_COMMAND() virtual double trajectory_j_ratio_v() const = 0;
  /// Says what trajectory_j_set_ratio_a has set.
  SUTURE_COMMAND() virtual double trajectory_j_ratio_a() const = 0;

  // --- questions

  /// Computes the tool tip for a joint vector; it is not valid if the vector has the wrong length.
  SUTURE_COMMAND() virtual PoseStamped forward_kinematics(const JointGoal& q) const = 0;
  /// Computes a joint vector for a tool tip, searched from the present set-point.
  SUTURE_COMMAND() virtual JointSolution inverse_kinematics(const PoseStamped& goal) const = 0;
  /// Computes the pose of link n for a vector of n joints, at most all of them; that of the base
  /// for an empty one.
  SUTURE_COMMAND() virtual PoseStamped query_cp(const JointGoal& q) const = 0;
  /// Computes what query_cp does, in the arm's base frame.
  SUTURE_COMMAND() virtual PoseStamped local_query_cp(const JointGoal& q) const = 0;

  // --- events

  /// Reports each change of the operating state, and the last one to a client that connects.
  SUTURE_EVENT(latched(), name("operating_state"))
  suture::EventOf<OperatingState> operating_state_event;
  /// Reports the state that a command asked for.
  SUTURE_EVENT(latched()) suture::EventOf<ArmState> desired_state;
  /// Reports the end of a move: true at its goal, false if anything else ended it.
  SUTURE_EVENT() suture::EventOf<bool> goal_reached;
  /// Reports what use_gravity_compensation has set.
  SUTURE_EVENT(latched(), name("gravity_compensation")) suture::EventOf<bool> gravity_event;
  /// Reports a change of the fraction that trajectory_j_ratio says.
  SUTURE_EVENT(latched(), name("trajectory_j_ratio")) suture::EventOf<double> ratio_event;
  /// Reports a change of the fraction of the velocity limits.
  SUTURE_EVENT(latched(), name("trajectory_j_ratio_v")) suture::EventOf<double> ratio_v_event;
  /// Reports a change of the fraction of the acceleration limits.
  SUTURE_EVENT(latched(), name("trajectory_j_ratio_a")) suture::EventOf<double> ratio_a_event;
};

}  // namespace robots
