#pragma once
// These are joint vectors of drivers and planners: the cisst libraries' prm types beside joints.h.
// Units are those of a revolute joint; a prismatic joint has m, m/s, m/s2 and N in their place.
// Lists are in chain order; an optional one is empty or as long as the first.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace robots {

/// Corresponds to cisst's prmPositionJointGet.
struct SUTURE_TYPE() JointPosition {
  SUTURE_FIELD(capacity(8), unit("rad")) std::vector<double> position;
  /// Say when each joint was read.
  SUTURE_FIELD(capacity(8)) std::vector<suture::Time> stamps;
  suture::Time stamp;
  bool valid = false;
};

/// Corresponds to cisst's prmPositionJointSet.
struct SUTURE_TYPE() JointPositionGoal {
  SUTURE_FIELD(capacity(8), unit("rad")) std::vector<double> goal;
  /// The list may be empty.
  SUTURE_FIELD(capacity(8), unit("rad/s")) std::vector<double> velocity;
  /// The list may be empty.
  SUTURE_FIELD(capacity(8), unit("rad/s2")) std::vector<double> acceleration;
  /// There is no limit if it is 0.
  suture::Duration time_limit{0};
  /// If it is true, all joints arrive together.
  bool is_coordinated = true;
  suture::Time stamp;
};

/// Corresponds to cisst's prmVelocityJointGet.
struct SUTURE_TYPE() JointVelocity {
  SUTURE_FIELD(capacity(8), unit("rad/s")) std::vector<double> velocity;
  suture::Time stamp;
  bool valid = false;
};

/// A JointVelocityGoal is the goal of CRTK's servo_jv; corresponds to cisst's prmVelocityJointSet.
struct SUTURE_TYPE() JointVelocityGoal {
  SUTURE_FIELD(capacity(8), unit("rad/s")) std::vector<double> goal;
  /// The list may be empty.
  SUTURE_FIELD(capacity(8), unit("rad/s2")) std::vector<double> acceleration;
  /// The list may be empty.
  SUTURE_FIELD(capacity(8), unit("rad/s2")) std::vector<double> deceleration;
  /// The joints shall not pass these positions; the list may be empty.
  SUTURE_FIELD(capacity(8), unit("rad")) std::vector<double> guard;
  /// The mask says which joints count; if it is empty, all do.
  SUTURE_FIELD(capacity(8)) std::vector<bool> mask;
  suture::Time stamp;
};

/// A JointEffortGoal is the goal of CRTK's servo_jf; corresponds to cisst's prmForceTorqueJointSet.
struct SUTURE_TYPE() JointEffortGoal {
  SUTURE_FIELD(capacity(8), unit("N.m")) std::vector<double> effort;
  /// The mask says which joints count; if it is empty, all do.
  SUTURE_FIELD(capacity(8)) std::vector<bool> mask;
  suture::Time stamp;
};

enum class SUTURE_TYPE() JointType : std::uint8_t {
  Undefined,
  Prismatic,
  Revolute,
  Universal,
  BallSocket,
  Inactive,
};

/// Says what the joints are and what they may do, for CRTK's configuration_js. Corresponds to
/// cisst's prmConfigurationJoint.
struct SUTURE_TYPE() JointConfiguration {
  SUTURE_FIELD(capacity(8, 15)) std::vector<std::string> name;
  SUTURE_FIELD(capacity(8)) std::vector<JointType> type;
  SUTURE_FIELD(capacity(8), unit("rad")) std::vector<double> position_min;
  SUTURE_FIELD(capacity(8), unit("rad")) std::vector<double> position_max;
  SUTURE_FIELD(capacity(8), unit("rad/s")) std::vector<double> velocity_min;
  SUTURE_FIELD(capacity(8), unit("rad/s")) std::vector<double> velocity_max;
  SUTURE_FIELD(capacity(8), unit("rad/s2")) std::vector<double> acceleration_min;
  SUTURE_FIELD(capacity(8), unit("rad/s2")) std::vector<double> acceleration_max;
  SUTURE_FIELD(capacity(8), unit("N.m")) std::vector<double> effort_min;
  SUTURE_FIELD(capacity(8), unit("N.m")) std::vector<double> effort_max;
  bool valid = false;
};

/// A ServoJoint has position, velocity and effort in one servo command; corresponds to cisst's
/// prmServoJoint.
struct SUTURE_TYPE() ServoJoint {
  SUTURE_FIELD(capacity(8, 15)) std::vector<std::string> name;
  /// Each joint has these bits: 1 position, 2 velocity, 4 effort.
  SUTURE_FIELD(capacity(8)) std::vector<std::uint16_t> mode;
  SUTURE_FIELD(capacity(8), unit("rad")) std::vector<double> position;
  SUTURE_FIELD(capacity(8), unit("rad/s")) std::vector<double> velocity;
  SUTURE_FIELD(capacity(8), unit("N.m")) std::vector<double> effort;
  /// Says what position control may act on; row-major, joints x joints.
  SUTURE_FIELD(capacity(64)) std::vector<double> position_projection;
  suture::Time stamp;
};

/// Turns actuators into joints and back, joints x actuators, row-major.
/// Corresponds to cisst's prmActuatorJointCoupling.
struct SUTURE_TYPE() ActuatorJointCoupling {
  std::uint32_t joints = 0;
  std::uint32_t actuators = 0;
  SUTURE_FIELD(capacity(64)) std::vector<double> actuator_to_joint_position;
  SUTURE_FIELD(capacity(64)) std::vector<double> joint_to_actuator_position;
  SUTURE_FIELD(capacity(64)) std::vector<double> actuator_to_joint_effort;
  SUTURE_FIELD(capacity(64)) std::vector<double> joint_to_actuator_effort;
};

/// A Jacobian is 6 x joints, column-major: linear rows first, in m/s and rad/s per unit of joint
/// velocity.
struct SUTURE_TYPE() Jacobian {
  std::uint32_t joints = 0;
  SUTURE_FIELD(capacity(48)) std::vector<double> coefficients;
  suture::Time stamp;
  bool valid = false;
};

}  // namespace robots
