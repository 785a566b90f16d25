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
/// one. An arm starts, and restarts, undefined. Once it hears of its drives, and they may have
/// power, it is disabled and not homed. Until it is enabled it ignores motion commands.
///
/// An arm that is not homed, or not any more after an encoder jumped or unhome(), does not know
/// where its tip is. It refuses Cartesian motion, servo, interpolation and moves, and obeys joint
/// commands.
///
/// An arm that works through a cannula does the same until its wrist is far enough beyond the
/// remote centre: a da Vinci's must be 45 mm beyond it, and 2 mm more to begin. Joint commands and
/// homing insert it.
///
/// `local_` poses are of the tool tip in the arm's base frame, all others in the reference frame of
/// the interface, in which base_frame() is the arm's base; the two are the same until a client sets
/// another. A motion command replaces the one before it, of either space; relative goals are
/// relative to the set-point. A servo stream that falls silent for 0.1 s ends as with hold(), and
/// so does any stream whose client is gone.
///
/// Status, warning and error are the standard messages. Their `code` is an ArmWarning
/// (arm_warning.h) if the arm refuses a command or something has happened to it. Each reason is
/// reported once until the arm obeys again, a refused state command each time.
class SUTURE_INTERFACE(crtk(), version(2)) Arm : public suture::Messages {
 public:
  // --- state

  /// Says what the joints are and what they may do. Velocities are their rate limits, accelerations
  /// those of moves. Efforts are the most that the motors give; for a da Vinci they are published
  /// (dynamics/davinci_inertia.cpp: ftmax), accelerations are not. If nothing is bounded the lists
  /// are empty.
  SUTURE_COMMAND() virtual const JointConfiguration& configuration_js() const = 0;
  SUTURE_COMMAND() virtual const OperatingState& operating_state() const = 0;
  /// Says how regularly the arm's task ran in the last second.
  SUTURE_COMMAND() virtual IntervalStatistics period_statistics() const = 0;

  /// Gives the drives power. The arm holds its position.
  SUTURE_COMMAND() virtual void enable() = 0;
  /// Stops the arm at once, without power. It ignores motion until it is enabled again.
  SUTURE_COMMAND() virtual void disable() = 0;
  /// Stops the arm where the joints are. It ignores motion until resume().
  SUTURE_COMMAND() virtual void pause() = 0;
  SUTURE_COMMAND() virtual void resume() = 0;
  /// Moves the arm to its home position, if it is enabled. The move ends with goal_reached.
  SUTURE_COMMAND() virtual void home() = 0;
  /// Makes the arm forget that it is homed.
  SUTURE_COMMAND() virtual void unhome() = 0;
  /// Does one of the six above, by its name; any other name is an `error`.
  SUTURE_COMMAND()
  virtual void state_command(SUTURE_FIELD(capacity(15)) const std::string& name) = 0;

  // --- where it is and shall be

  /// Says where the joints are, and what their motors give; that list is empty if the drives do not
  /// measure it. The stamp is that of the drives' cycle that measured them.
  SUTURE_COMMAND() virtual const JointState& measured_js() const = 0;
  /// Says where the joints shall be.
  SUTURE_COMMAND() virtual const JointState& setpoint_js() const = 0;
  /// Says where the present move ends; without one, it is the set-point.
  SUTURE_COMMAND() virtual const JointState& goal_js() const = 0;
  /// Says where the tool tip is. The stamp is that of the drives' cycle that measured the joints.
  SUTURE_COMMAND() virtual PoseStamped measured_cp() const = 0;
  /// Says where the tool tip shall be. The stamp is that of the servo_cp or interpolate_cp goal
  /// from which it came, else that of the arm's cycle.
  SUTURE_COMMAND() virtual PoseStamped setpoint_cp() const = 0;
  /// Says where the present move ends; without one, it is the set-point.
  SUTURE_COMMAND() virtual PoseStamped goal_cp() const = 0;
  SUTURE_COMMAND() virtual PoseStamped local_measured_cp() const = 0;
  SUTURE_COMMAND() virtual PoseStamped local_setpoint_cp() const = 0;
  /// Says how the tip moves, in the directions of the reference frame, which the twist names.
  SUTURE_COMMAND() virtual const Twist& measured_cv() const = 0;
  /// Says how the set-point moves, whatever moves it, in the same directions. If it jumped, and in
  /// the first cycle of a motion, this is 0. The stamp is that of the arm's cycle.
  SUTURE_COMMAND() virtual const Twist& setpoint_cv() const = 0;
  /// Says with which wrench the arm presses at its tip, in the tip's own directions: the motors'
  /// efforts, less the arm's weight by its model, through the transposed Jacobian. It includes
  /// friction, inertia and the errors of that model, so it is near a contact's force only if the
  /// arm is slow and presses hard. Its sign is that of servo_cf, as in the da Vinci Research Kit;
  /// what touches the tip presses on it with the opposite. It is not valid if the drives measure no
  /// effort, without power, and beside a singularity. The stamp is that of the drives' cycle that
  /// measured the joints.
  SUTURE_COMMAND() virtual const Wrench& body_measured_cf() const = 0;
  /// Is the same in the directions of the arm's base frame.
  SUTURE_COMMAND() virtual const Wrench& spatial_measured_cf() const = 0;
  /// Gives pose, velocity and force of one cycle, in the reference frame.
  SUTURE_COMMAND() virtual const CartesianState& measured_cs() const = 0;
  /// Maps joint velocities to those of the tip, in its own directions. The stamp is that of the
  /// drives' cycle that measured the joints.
  SUTURE_COMMAND() virtual const Jacobian& body_jacobian() const = 0;
  /// Is the same in the directions of the arm's base frame.
  SUTURE_COMMAND() virtual const Jacobian& spatial_jacobian() const = 0;
  SUTURE_COMMAND() virtual const TransformStamped& base_frame() const = 0;
  /// Sets the arm's base in the reference frame of this interface. It is refused if it is given in
  /// another frame, and while the arm moves or follows a stream.
  SUTURE_COMMAND() virtual void set_base_frame(const TransformStamped& base) = 0;

  // --- motion

  /// Drops what is under way; the set-point stays where it is.
  SUTURE_COMMAND() virtual void hold() = 0;
  /// Lets the set-point follow the joints until another command.
  SUTURE_COMMAND() virtual void free() = 0;
  /// Is only noted: the event gravity_compensation reports it. It changes no motor, because
  /// compensation belongs to the drives.
  SUTURE_COMMAND() virtual void use_gravity_compensation(bool use) = 0;

  /// Streams joint goals, newest wins. A joint whose goal lies beyond its limit stays at the limit.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jp(const JointGoal& goal) = 0;
  SUTURE_COMMAND(ttl(20ms)) virtual void servo_jr(const JointGoal& step) = 0;
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jv(const JointVelocityGoal& goal) = 0;
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jf(const JointEffortGoal& goal) = 0;
  /// Streams Cartesian goals, newest wins. Beyond a joint limit the arm slides along it, at the
  /// nearest point that the limits admit. A goal that is out of reach, or too far for one step,
  /// leaves the set-point. The arm reports both. setpoint_cp keeps the goal's stamp.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_cp(const PoseStamped& goal) = 0;
  /// Steps the set-point: the translation is in the reference frame, the rotation turns the tip
  /// about itself.
  SUTURE_COMMAND(ttl(20ms)) virtual void servo_cr(const PoseStamped& step) = 0;
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_cv(const TwistGoal& goal) = 0;
  /// Streams wrenches in the tip's own directions, newest wins.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void body_servo_cf(const WrenchGoal& goal) = 0;
  /// Streams wrenches in the directions of the arm's base frame, newest wins.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void spatial_servo_cf(const WrenchGoal& goal) = 0;

  /// Streams goals that come more slowly than the arm's cycles, newest wins. The set-point goes to
  /// each in a straight line of the joints, in as much time as lay between it and the goal before
  /// it, but no faster than the joints can, and stays there. Limits and reach are those of servo
  /// commands.
  SUTURE_COMMAND(latest(), ttl(200ms)) virtual void interpolate_jp(const JointGoal& goal) = 0;
  SUTURE_COMMAND(ttl(200ms)) virtual void interpolate_jr(const JointGoal& step) = 0;
  SUTURE_COMMAND(latest(), ttl(200ms)) virtual void interpolate_cp(const PoseStamped& goal) = 0;
  SUTURE_COMMAND(ttl(200ms)) virtual void interpolate_cr(const PoseStamped& step) = 0;

  /// Moves plan and execute a smooth motion from the set-point, and from the velocity that it has:
  /// one may begin while it moves. Each ends at rest and with goal_reached.
  SUTURE_COMMAND() virtual void move_jp(const JointGoal& goal) = 0;
  SUTURE_COMMAND() virtual void move_jr(const JointGoal& step) = 0;
  SUTURE_COMMAND() virtual void move_cp(const PoseStamped& goal) = 0;
  SUTURE_COMMAND() virtual void move_cr(const PoseStamped& step) = 0;

  /// Sets which share of what the joints can do moves use: of velocity and acceleration together.
  SUTURE_COMMAND()
  virtual void trajectory_j_set_ratio(SUTURE_FIELD(range(0.01, 1)) double ratio) = 0;
  SUTURE_COMMAND()
  virtual void trajectory_j_set_ratio_v(SUTURE_FIELD(range(0.01, 1)) double ratio) = 0;
  SUTURE_COMMAND()
  virtual void trajectory_j_set_ratio_a(SUTURE_FIELD(range(0.01, 1)) double ratio) = 0;
  /// Is the smaller of the two below.
  SUTURE_COMMAND() virtual double trajectory_j_ratio() const = 0;
  SUTURE_COMMAND() virtual double trajectory_j_ratio_v() const = 0;
  SUTURE_COMMAND() virtual double trajectory_j_ratio_a() const = 0;

  // --- questions

  /// Computes the tool tip for a joint vector; it is not valid if the vector has the wrong length.
  SUTURE_COMMAND() virtual PoseStamped forward_kinematics(const JointGoal& q) const = 0;
  /// Computes a joint vector for a tool tip, searched from the present set-point.
  SUTURE_COMMAND() virtual JointSolution inverse_kinematics(const PoseStamped& goal) const = 0;
  /// Computes the pose of the link behind as many joints as the vector has, at most all; without
  /// any, that of the base.
  SUTURE_COMMAND() virtual PoseStamped query_cp(const JointGoal& q) const = 0;
  /// Computes the same in the arm's base frame.
  SUTURE_COMMAND() virtual PoseStamped local_query_cp(const JointGoal& q) const = 0;

  // --- events

  /// Reports each change of the operating state, and the last one to a client that connects.
  SUTURE_EVENT(latched(), name("operating_state"))
  suture::EventOf<OperatingState> operating_state_event;
  /// Reports the state that a command asked for.
  SUTURE_EVENT(latched()) suture::EventOf<ArmState> desired_state;
  /// Reports the end of a move: true at its goal, false if something else replaced it.
  SUTURE_EVENT() suture::EventOf<bool> goal_reached;
  SUTURE_EVENT(latched(), name("gravity_compensation")) suture::EventOf<bool> gravity_event;
  SUTURE_EVENT(latched(), name("trajectory_j_ratio")) suture::EventOf<double> ratio_event;
  SUTURE_EVENT(latched(), name("trajectory_j_ratio_v")) suture::EventOf<double> ratio_v_event;
  SUTURE_EVENT(latched(), name("trajectory_j_ratio_a")) suture::EventOf<double> ratio_a_event;
};

}  // namespace robots
