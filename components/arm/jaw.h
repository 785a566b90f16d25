#pragma once
// This is the contract of the jaw of a slave's instrument, in CRTK's words.

#include <suture/annotate.h>
#include <suture/standard/messages.h>

#include "robot_types/joint_commands.h"
#include "robot_types/joints.h"

namespace robots {

/// The arm that holds the instrument provides this as an interface of its own, "Jaw". Commands run
/// in the arm's thread before its next cycle; reads are from the end of its last one. Joint vectors
/// have one entry, the angle between the blades in rad: 0 is closed, and a smaller angle presses
/// them together. It may be -0.698 to 1.396 rad (-40 to 80 degrees) on the large needle driver of a
/// da Vinci.
///
/// The jaw has the power of its arm, and needs an arm that is enabled: otherwise it ignores
/// commands of motion and says so in a warning, once until it obeys again. When its arm stops being
/// enabled, it stops where it is. Homing the arm leaves it as it is.
///
/// A command replaces the one before it. A servo stream that falls silent for 0.1 s, or whose
/// client is gone, leaves the set-point where it is.
///
/// Status, warning and error are the standard messages. Their `code` is an ArmWarning
/// (arm_warning.h).
class SUTURE_INTERFACE(crtk(), version(1)) Jaw : public suture::Messages {
 public:
  /// Says what the joint is and what it may do. Its effort limit is published
  /// (LARGE_NEEDLE_DRIVER_400006.json); its acceleration limit, which is that of moves, is not.
  SUTURE_COMMAND() virtual const JointConfiguration& configuration_js() const = 0;
  /// Says where the joint is. The stamp is that of the drives' cycle that measured it.
  SUTURE_COMMAND() virtual const JointState& measured_js() const = 0;
  /// Says where the joint shall be. The effort is that of servo_jf, else 0.
  SUTURE_COMMAND() virtual const JointState& setpoint_js() const = 0;

  /// Streams goals, newest wins. The set-point goes there no faster than the joint can; a goal
  /// beyond a limit leads only to the limit.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jp(const JointGoal& goal) = 0;
  /// Streams efforts, newest wins; a negative one closes. The simulated jaw has no mass: an effort
  /// moves the set-point at a speed proportional to it.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jf(const JointEffortGoal& goal) = 0;
  /// Plans and executes a smooth motion from the set-point and the velocity that it has. Ends with
  /// goal_reached.
  SUTURE_COMMAND() virtual void move_jp(const JointGoal& goal) = 0;

  /// Reports the end of a move: true at its goal, false if something else replaced it.
  SUTURE_EVENT() suture::EventOf<bool> goal_reached;
};

}  // namespace robots
