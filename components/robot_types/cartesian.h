#pragma once
// These are motion and force of a tool tip: what CRTK's _cv, _cf and _cs carry, and the goals with
// feed-forward that the cisst libraries' prm types have. Frames are named by suture::frameId(),
// because strings would cost too much in control loops; 0 means that a frame is not named.

#include <suture/annotate.h>
#include <suture/base/frames.h>
#include <suture/base/time.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdint>

namespace robots {

/// A Twist is a velocity, as CRTK's measured_cv says it. Corresponds to cisst's
/// prmVelocityCartesianGet.
struct SUTURE_TYPE() Twist {
  SUTURE_FIELD(unit("m/s")) Eigen::Vector3d linear = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("rad/s")) Eigen::Vector3d angular = Eigen::Vector3d::Zero();
  suture::FrameId moving_frame = 0;
  suture::FrameId reference_frame = 0;
  suture::Time stamp;
  /// If it is false, do not use it.
  bool valid = false;
};

/// A TwistGoal is a velocity to follow, by CRTK's servo_cv. Corresponds to cisst's
/// prmVelocityCartesianSet.
struct SUTURE_TYPE() TwistGoal {
  SUTURE_FIELD(unit("m/s")) Eigen::Vector3d linear = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("rad/s")) Eigen::Vector3d angular = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("m/s2")) Eigen::Vector3d linear_acceleration = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("rad/s2")) Eigen::Vector3d angular_acceleration = Eigen::Vector3d::Zero();
  /// Says which of x, y, z and the rotations about them count.
  std::array<bool, 6> mask = {true, true, true, true, true, true};
  suture::Time stamp;
};

/// A Wrench is force and torque at the tool tip, as CRTK's measured_cf says it. Corresponds to
/// cisst's prmForceCartesianGet.
struct SUTURE_TYPE() Wrench {
  SUTURE_FIELD(unit("N")) Eigen::Vector3d force = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("N.m")) Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  /// Says which components are known.
  std::array<bool, 6> mask = {true, true, true, true, true, true};
  suture::FrameId moving_frame = 0;
  suture::FrameId reference_frame = 0;
  suture::Time stamp;
  /// If it is false, do not use it.
  bool valid = false;
};

/// A WrenchGoal is force and torque to apply, by CRTK's servo_cf. Corresponds to cisst's
/// prmForceCartesianSet.
struct SUTURE_TYPE() WrenchGoal {
  SUTURE_FIELD(unit("N")) Eigen::Vector3d force = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("N.m")) Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  /// Says which components count.
  std::array<bool, 6> mask = {true, true, true, true, true, true};
  suture::Time stamp;
};

/// A CartesianState is pose, velocity and force of one instant, as CRTK's measured_cs says it.
/// Corresponds to cisst's prmStateCartesian.
struct SUTURE_TYPE() CartesianState {
  suture::FrameId moving_frame = 0;
  suture::FrameId reference_frame = 0;
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d position = Eigen::Isometry3d::Identity();
  bool position_is_valid = false;
  SUTURE_FIELD(unit("m/s")) Eigen::Vector3d linear_velocity = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("rad/s")) Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();
  bool velocity_is_valid = false;
  SUTURE_FIELD(unit("N")) Eigen::Vector3d force = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("N.m")) Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  bool force_is_valid = false;
  suture::Time stamp;
};

/// A CartesianGoal is a pose to reach, and how to get there. Corresponds to cisst's
/// prmPositionCartesianSet.
struct SUTURE_TYPE() CartesianGoal {
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d goal = Eigen::Isometry3d::Identity();
  SUTURE_FIELD(unit("m/s")) Eigen::Vector3d linear_velocity = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("rad/s")) Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("m/s2")) Eigen::Vector3d linear_acceleration = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("rad/s2")) Eigen::Vector3d angular_acceleration = Eigen::Vector3d::Zero();
  /// Says if position and orientation count.
  std::array<bool, 2> mask = {true, true};
  suture::FrameId moving_frame = 0;
  suture::FrameId reference_frame = 0;
  suture::Time stamp;
  bool valid = false;
};

/// Says what an axis of a mixed servo command follows.
enum class SUTURE_TYPE() ServoMode : std::uint8_t {
  None = 0,
  Position = 1,
  Velocity = 2,
  PositionVelocity = 3,
  Effort = 4,
  PositionEffort = 5,
  VelocityEffort = 6,
  All = 7,
};

/// A ServoCartesian has position, velocity and effort in one servo command. Corresponds to cisst's
/// prmServoCartesian.
struct SUTURE_TYPE() ServoCartesian {
  /// The values below are along the axes of this frame, which is given in the base frame.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d task_frame = Eigen::Isometry3d::Identity();
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d position = Eigen::Isometry3d::Identity();
  SUTURE_FIELD(unit("m/s")) Eigen::Vector3d linear_velocity = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("rad/s")) Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("N")) Eigen::Vector3d force = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("N.m")) Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  /// The modes are those of x, y, z and the rotations about them, in this order.
  std::array<ServoMode, 6> axis_mode{};
  suture::Time stamp;
};

/// Says how stiffly one side of an axis holds: force = p * distance + d * speed + bias beyond the
/// deadband.
struct SUTURE_TYPE() HalfPlaneGains {
  SUTURE_FIELD(unit("N/m")) Eigen::Vector3d p = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("N.s/m")) Eigen::Vector3d d = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("N")) Eigen::Vector3d bias = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("m")) Eigen::Vector3d deadband = Eigen::Vector3d::Zero();
};

/// These gains hold about an axis in the same way.
struct SUTURE_TYPE() AngularHalfPlaneGains {
  SUTURE_FIELD(unit("N.m/rad")) Eigen::Vector3d p = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("N.m.s/rad")) Eigen::Vector3d d = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("N.m")) Eigen::Vector3d bias = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("rad")) Eigen::Vector3d deadband = Eigen::Vector3d::Zero();
};

/// A CartesianImpedance is a spring that holds the tool tip, per axis and side. Corresponds to
/// cisst's prmCartesianImpedance.
struct SUTURE_TYPE() CartesianImpedance {
  /// Holds the axes along which the forces act.
  Eigen::Matrix3d force_orientation = Eigen::Matrix3d::Identity();
  /// The springs rest here.
  SUTURE_FIELD(unit("m")) Eigen::Vector3d force_position = Eigen::Vector3d::Zero();
  /// Holds the axes about which the torques act.
  Eigen::Matrix3d torque_orientation = Eigen::Matrix3d::Identity();
  HalfPlaneGains position_positive, position_negative;
  AngularHalfPlaneGains orientation_positive, orientation_negative;
  suture::Time stamp;
};

}  // namespace robots
