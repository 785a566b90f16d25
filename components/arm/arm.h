#pragma once
// The contract of an arm, master or slave: the part of CRTK (collaborative-robotics.github.io) that
// teleoperation needs.

#include <suture/annotate.h>

#include <cstdint>

#include "robot_types/joints.h"
#include "robot_types/operating_state.h"
#include "robot_types/pose.h"

namespace robots {

/// Why an arm does not do what it is asked.
enum class SUTURE_TYPE() ArmWarning : std::uint8_t {
  NotEnabled,      ///< motion commands need an enabled arm
  OutOfReach,      ///< no joint vector reaches the goal; for a move, none within limits
  Malformed,       ///< the goal has the wrong length, is not finite or not a pose
  ClientGone,      ///< the client whose stream it followed is gone; the arm holds
  WrongState,      ///< the operating state does not admit the command: operating_states.h
  FollowingError,  ///< a joint trailed its set-point by more than its bound; the arm is in FAULT
  AtLimit,         ///< what it follows leads beyond a joint limit: the arm slides along it; once
                   ///< until it leads within again
  StepTooFar,      ///< a servo goal lies farther from the set-point than the rates allow
  PowerLost,       ///< the drives have no power any more, or may not have it: the arm is disabled
  DrivesSilent,    ///< the drives have measured nothing for 250 ms; the arm is in FAULT
};

/// Commands run in the arm's own thread before its next cycle; reads are from the end of its last
/// one. Poses are of the tool tip in the arm's base frame. An arm starts, and restarts, undefined;
/// once it hears of its drives, and they may have power, it is disabled and not homed. Until it is
/// enabled it ignores motion commands.
class SUTURE_INTERFACE() Arm {
 public:
  virtual ~Arm() = default;

  /// Gives the drives power; the arm holds its position.
  SUTURE_COMMAND() virtual void enable() = 0;
  /// Stops at once, without power, and ignores motion until enabled again.
  SUTURE_COMMAND() virtual void disable() = 0;
  /// Moves to the home position; needs an enabled arm. Ends with goal_reached.
  SUTURE_COMMAND() virtual void home() = 0;
  /// Drops what is under way; the set-point stays where it is.
  SUTURE_COMMAND() virtual void hold() = 0;

  /// Streams Cartesian goals, newest wins. Beyond a joint limit the arm slides along that, at the
  /// nearest that the limits leave; a goal out of reach, or too far for one step, leaves the
  /// set-point. All three it says in `warning`. setpoint_cp keeps the goal's stamp.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_cp(const PoseStamped& goal) = 0;
  /// Streams joint goals, newest wins. A joint whose goal lies beyond its limit stays at that.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jp(const JointGoal& goal) = 0;
  /// Plans and executes a smooth motion from the set-point. Ends with goal_reached.
  SUTURE_COMMAND() virtual void move_jp(const JointGoal& goal) = 0;

  /// Where the joints are. Stamp: the drives' cycle that measured them.
  SUTURE_COMMAND() virtual const JointState& measured_js() const = 0;
  /// Where the joints shall be.
  SUTURE_COMMAND() virtual const JointState& setpoint_js() const = 0;
  /// Where the tool tip is. Stamp: the drives' cycle that measured the joints.
  SUTURE_COMMAND() virtual PoseStamped measured_cp() const = 0;
  /// Where the tool tip shall be. Stamp: that of the servo_cp goal it came from, else the arm's
  /// cycle.
  SUTURE_COMMAND() virtual PoseStamped setpoint_cp() const = 0;
  SUTURE_COMMAND() virtual const OperatingState& operating_state() const = 0;

  /// The tool tip for a joint vector; not valid if it has the wrong length.
  SUTURE_COMMAND() virtual PoseStamped forward_kinematics(const JointGoal& q) const = 0;
  /// A joint vector for a tool tip, searched from the present set-point.
  SUTURE_COMMAND() virtual JointSolution inverse_kinematics(const PoseStamped& goal) const = 0;

  /// Each change of the operating state, and the last one to whoever connects.
  SUTURE_EVENT(latched(), name("operating_state"))
  suture::EventOf<OperatingState> operating_state_event;
  /// A move ended: true at its goal, false when something else replaced it.
  SUTURE_EVENT() suture::EventOf<bool> goal_reached;
  /// The arm refused a command, or something has befallen it. Each reason is told once until the
  /// arm obeys again; a refused state command is told each time.
  SUTURE_EVENT(name("warning")) suture::EventOf<ArmWarning> warning_event;
};

}  // namespace robots
