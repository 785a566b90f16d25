#pragma once
// The contract of an arm, master or slave: CRTK (collaborative-robotics.github.io) with what the da
// Vinci Research Kit adds to it.

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
/// one. An arm starts, and restarts, undefined; once it hears of its drives, and they may have
/// power, it is disabled and not homed. Until it is enabled it ignores motion commands.
///
/// An arm that is not homed, or not any more after an encoder jumped or unhome(), does not know
/// where its tip is. It refuses Cartesian motion, servo, interpolation and moves, and obeys joint
/// commands.
///
/// So does an arm that works through a cannula until its wrist is far enough beyond the remote
/// centre: a da Vinci's is 45 mm beyond it, and 2 mm more to begin. Joint commands and homing are
/// what inserts it.
///
/// `local_` poses are of the tool tip in the arm's base frame, all others in the reference frame of
/// the interface, in which base_frame() is the arm's base; the two are one until somebody sets
/// another. A motion command replaces the one before it, of whichever space; relative goals are
/// relative to the set-point. A servo stream that falls silent for 0.1 s ends as hold(), and so
/// does any stream whose client is gone.
///
/// Status, warning and error are the standard messages. Their `code` is an ArmWarning
/// (arm_warning.h) where the arm refuses a command or something has befallen it; each reason is
/// told once until the arm obeys again, a refused state command each time.
class SUTURE_INTERFACE(crtk(), version(2)) Arm : public suture::Messages {
 public:
  // --- state

  /// What the joints are and may do. Velocities are their rate limits, accelerations those of
  /// moves. Efforts are the most that the motors give; of a da Vinci they are published
  /// (dynamics/davinci_inertia.cpp: ftmax), accelerations are not. Where nothing is bounded the
  /// lists are empty.
  SUTURE_COMMAND() virtual const JointConfiguration& configuration_js() const = 0;
  SUTURE_COMMAND() virtual const OperatingState& operating_state() const = 0;
  /// How regularly the arm's task ran in the last second.
  SUTURE_COMMAND() virtual IntervalStatistics period_statistics() const = 0;

  /// Gives the drives power; the arm holds its position.
  SUTURE_COMMAND() virtual void enable() = 0;
  /// Stops at once, without power, and ignores motion until enabled again.
  SUTURE_COMMAND() virtual void disable() = 0;
  /// Stops where the joints are and ignores motion until resume().
  SUTURE_COMMAND() virtual void pause() = 0;
  SUTURE_COMMAND() virtual void resume() = 0;
  /// Moves to the home position; needs an enabled arm. Ends with goal_reached.
  SUTURE_COMMAND() virtual void home() = 0;
  /// Forgets that it is homed.
  SUTURE_COMMAND() virtual void unhome() = 0;
  /// One of the six above, by name; anything else is an `error`.
  SUTURE_COMMAND()
  virtual void state_command(SUTURE_FIELD(capacity(15)) const std::string& name) = 0;

  // --- where it is and shall be

  /// Where the joints are, and what their motors give, which is empty of drives that do not measure
  /// it. Stamp: the drives' cycle that measured them.
  SUTURE_COMMAND() virtual const JointState& measured_js() const = 0;
  /// Where the joints shall be.
  SUTURE_COMMAND() virtual const JointState& setpoint_js() const = 0;
  /// Where the move under way ends; without one, the set-point.
  SUTURE_COMMAND() virtual const JointState& goal_js() const = 0;
  /// Where the tool tip is. Stamp: the drives' cycle that measured the joints.
  SUTURE_COMMAND() virtual PoseStamped measured_cp() const = 0;
  /// Where the tool tip shall be. Stamp: that of the servo_cp or interpolate_cp goal it came from,
  /// else the arm's cycle.
  SUTURE_COMMAND() virtual PoseStamped setpoint_cp() const = 0;
  /// Where the move under way ends; without one, the set-point.
  SUTURE_COMMAND() virtual PoseStamped goal_cp() const = 0;
  SUTURE_COMMAND() virtual PoseStamped local_measured_cp() const = 0;
  SUTURE_COMMAND() virtual PoseStamped local_setpoint_cp() const = 0;
  /// How the tip moves, in the directions of the reference frame, which the twist names.
  SUTURE_COMMAND() virtual const Twist& measured_cv() const = 0;
  /// How the set-point moves, whatever moves it, in the same directions. Where it jumped, and in
  /// the first cycle of a motion, it is 0. Stamp: the arm's cycle.
  SUTURE_COMMAND() virtual const Twist& setpoint_cv() const = 0;
  /// This is the wrench that the arm presses with at its tip, in the tip's own directions: the
  /// motors' efforts, less the arm's weight as its model has it, through the transposed Jacobian.
  /// Friction, inertia and what that model has wrong are in it, so it is near a contact's force
  /// only when the arm is slow and presses hard. Its sign is that of servo_cf, as in the da Vinci
  /// Research Kit; what touches the tip presses on it with the opposite. Not valid where the drives
  /// measure no effort, without power, and beside a singularity. Stamp: the drives' cycle that
  /// measured the joints.
  SUTURE_COMMAND() virtual const Wrench& body_measured_cf() const = 0;
  /// The same in the directions of the arm's base frame.
  SUTURE_COMMAND() virtual const Wrench& spatial_measured_cf() const = 0;
  /// Pose, velocity and force of one cycle, in the reference frame.
  SUTURE_COMMAND() virtual const CartesianState& measured_cs() const = 0;
  /// From joint velocities to those of the tip, in its own directions. Stamp: the drives' cycle
  /// that measured the joints.
  SUTURE_COMMAND() virtual const Jacobian& body_jacobian() const = 0;
  /// The same in the directions of the arm's base frame.
  SUTURE_COMMAND() virtual const Jacobian& spatial_jacobian() const = 0;
  SUTURE_COMMAND() virtual const TransformStamped& base_frame() const = 0;
  /// The arm's base in the reference frame of this interface. Refused if it is given in another
  /// one, and while the arm moves or follows a stream.
  SUTURE_COMMAND() virtual void set_base_frame(const TransformStamped& base) = 0;

  // --- motion

  /// Drops what is under way; the set-point stays where it is.
  SUTURE_COMMAND() virtual void hold() = 0;
  /// Lets go: the set-point follows the joints until another command.
  SUTURE_COMMAND() virtual void free() = 0;
  /// For the record: it is told in gravity_compensation and changes no motor, which is the business
  /// of the drives.
  SUTURE_COMMAND() virtual void use_gravity_compensation(bool use) = 0;

  /// Streams joint goals, newest wins. A joint whose goal lies beyond its limit stays at that.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jp(const JointGoal& goal) = 0;
  SUTURE_COMMAND(ttl(20ms)) virtual void servo_jr(const JointGoal& step) = 0;
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jv(const JointVelocityGoal& goal) = 0;
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jf(const JointEffortGoal& goal) = 0;
  /// Streams Cartesian goals, newest wins. Beyond a joint limit the arm slides along that, at the
  /// nearest that the limits leave; a goal out of reach, or too far for one step, leaves the
  /// set-point. It says so. setpoint_cp keeps the goal's stamp.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_cp(const PoseStamped& goal) = 0;
  /// The step's translation in the reference frame; its rotation turns the tip about itself.
  SUTURE_COMMAND(ttl(20ms)) virtual void servo_cr(const PoseStamped& step) = 0;
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_cv(const TwistGoal& goal) = 0;
  /// In the tip's own directions.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void body_servo_cf(const WrenchGoal& goal) = 0;
  /// In the directions of the arm's base frame.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void spatial_servo_cf(const WrenchGoal& goal) = 0;

  /// Goals that come more slowly than the arm's cycles, newest wins. The set-point goes to each in
  /// a straight line of the joints, in as much time as lay between it and the goal before it, but
  /// no faster than the joints can, and stays there. Limits and reach are as of servo commands.
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

  /// How fast moves are, of what the joints can do: velocity and acceleration together.
  SUTURE_COMMAND()
  virtual void trajectory_j_set_ratio(SUTURE_FIELD(range(0.01, 1)) double ratio) = 0;
  SUTURE_COMMAND()
  virtual void trajectory_j_set_ratio_v(SUTURE_FIELD(range(0.01, 1)) double ratio) = 0;
  SUTURE_COMMAND()
  virtual void trajectory_j_set_ratio_a(SUTURE_FIELD(range(0.01, 1)) double ratio) = 0;
  /// The smaller of the two below.
  SUTURE_COMMAND() virtual double trajectory_j_ratio() const = 0;
  SUTURE_COMMAND() virtual double trajectory_j_ratio_v() const = 0;
  SUTURE_COMMAND() virtual double trajectory_j_ratio_a() const = 0;

  // --- questions

  /// The tool tip for a joint vector; not valid if it has the wrong length.
  SUTURE_COMMAND() virtual PoseStamped forward_kinematics(const JointGoal& q) const = 0;
  /// A joint vector for a tool tip, searched from the present set-point.
  SUTURE_COMMAND() virtual JointSolution inverse_kinematics(const PoseStamped& goal) const = 0;
  /// The pose of the link behind as many joints as the vector has, at most all: none, the base.
  SUTURE_COMMAND() virtual PoseStamped query_cp(const JointGoal& q) const = 0;
  /// The same in the arm's base frame.
  SUTURE_COMMAND() virtual PoseStamped local_query_cp(const JointGoal& q) const = 0;

  // --- events

  /// Each change of the operating state, and the last one to whoever connects.
  SUTURE_EVENT(latched(), name("operating_state"))
  suture::EventOf<OperatingState> operating_state_event;
  /// The state that a command asked for.
  SUTURE_EVENT(latched()) suture::EventOf<ArmState> desired_state;
  /// A move ended: true at its goal, false when something else replaced it.
  SUTURE_EVENT() suture::EventOf<bool> goal_reached;
  SUTURE_EVENT(latched(), name("gravity_compensation")) suture::EventOf<bool> gravity_event;
  SUTURE_EVENT(latched(), name("trajectory_j_ratio")) suture::EventOf<double> ratio_event;
  SUTURE_EVENT(latched(), name("trajectory_j_ratio_v")) suture::EventOf<double> ratio_v_event;
  SUTURE_EVENT(latched(), name("trajectory_j_ratio_a")) suture::EventOf<double> ratio_a_event;
};

}  // namespace robots
