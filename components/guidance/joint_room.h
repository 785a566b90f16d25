#pragma once
// The joints of an arm leave its tip so much room for the next step.

#include <Eigen/Core>
#include <limits>
#include <optional>

#include "robot_types/joint_commands.h"
#include "robot_types/joints.h"

namespace robots {

/// The guide looks at the joints of an arm only if it has this many. If it has more, only the arm
/// itself knows how it shares a step among them.
constexpr int kTipJoints = 6;
using TipJoints = Eigen::Matrix<double, kTipJoints, 1>;

/// Says where joints may be, in rad (or m), and how fast, in rad/s (or m/s).
struct JointBounds {
  TipJoints lower, upper, rate;
};

/// Returns what the arm says of its joints; a bound that it does not say is infinite. Returns none
/// for an arm with another number of joints.
std::optional<JointBounds> jointBounds(const JointConfiguration& configuration);

/// Says what has been asked of an arm beyond its set-point, along the axes of its base, as its
/// Jacobian is.
struct TipAhead {
  Eigen::Vector3d moved;   ///< m: of the tip
  Eigen::Vector3d turned;  ///< rad: of the tool, about this axis, with the next step
  Eigen::Vector3d turns;   ///< rad: of that, what is the next step's
};

/// Returns the share, of 0 to 1, of the next step's turn that `bounds` permit while the tip stays
/// where it is. A joint that is beyond a limit may still come back. `setpoint` and `jacobian` must
/// have kTipJoints joints, as `bounds` have. Never allocates.
double turnShare(const JointBounds& bounds, const JointState& setpoint, const Jacobian& jacobian,
                 const TipAhead& ahead, double seconds);

/// Says how the next step of a tip moves the joints of its arm, and how far they may go in it. A
/// JointRoom that is made without bounds forbids nothing.
struct JointRoom {
  /// Each joint goes this far for each m of the tip along the axes of the scene.
  Eigen::Matrix<double, kTipJoints, 3> motion = Eigen::Matrix<double, kTipJoints, 3>::Zero();
  TipJoints least = TipJoints::Constant(-std::numeric_limits<double>::infinity());
  TipJoints most = TipJoints::Constant(std::numeric_limits<double>::infinity());
};

/// Returns the room of a step of `seconds` that begins at `setpoint` and `ahead`. `jacobian` is the
/// spatial one, and `base` turns the axes of the base to those of the scene. `setpoint` and
/// `jacobian` must have kTipJoints joints, as `bounds` have. Never allocates.
JointRoom jointRoom(const JointBounds& bounds, const JointState& setpoint, const Jacobian& jacobian,
                    const TipAhead& ahead, const Eigen::Matrix3d& base, double seconds);

}  // namespace robots
