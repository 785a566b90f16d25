#pragma once
// This says how actuators turn joints, because cables lead from one motor to several joints.

#include <Eigen/Core>
#include <Eigen/LU>

namespace robots {

/// Immutable; only the constructors invert, and nothing allocates. This is a linear coupling of N
/// actuators with N joints, the identity by default.
template <int N>
class Coupling {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;

  Coupling() : Coupling(Matrix::Identity()) {}
  /// Joint positions are `actuatorToJoint` times actuator positions. The matrix must be invertible.
  explicit Coupling(const Matrix& actuatorToJoint)
      : toJoints_(actuatorToJoint), toActuators_(actuatorToJoint.inverse()) {}

  /// These two convert positions and velocities.
  Vector joints(const Vector& actuators) const { return toJoints_ * actuators; }
  Vector actuators(const Vector& joints) const { return toActuators_ * joints; }
  /// These two convert efforts, so that actuators and joints have the same power.
  Vector jointEfforts(const Vector& actuators) const {
    return toActuators_.transpose() * actuators;
  }
  Vector actuatorEfforts(const Vector& joints) const { return toJoints_.transpose() * joints; }

  /// Returns how far off the joints are at most, if each actuator is off by as much as `actuators`
  /// says.
  Vector jointBounds(const Vector& actuators) const { return toJoints_.cwiseAbs() * actuators; }
  /// Returns the most effort that the joints get, if each actuator gives at most as much as
  /// `actuators` says.
  Vector jointEffortBounds(const Vector& actuators) const {
    return toActuators_.cwiseAbs().transpose() * actuators;
  }
  const Matrix& actuatorToJoint() const { return toJoints_; }

 private:
  Matrix toJoints_, toActuators_;
};

/// Returns the coupling of a patient side manipulator: yaw, pitch and insertion have an actuator
/// each; the four discs of the large needle driver turn its roll, its wrist pitch and yaw, and its
/// jaw (jhu-dvrk/sawIntuitiveResearchKit, share/tool/LARGE_NEEDLE_DRIVER_400006.json:
/// ActuatorToJointPosition).
inline Coupling<7> psmCoupling() {
  Coupling<7>::Matrix matrix = Coupling<7>::Matrix::Identity();
  // clang-format off
  matrix.bottomRightCorner<4, 4>() <<
      -1.5632,  0,       0,      0,
       0,       1.0186,  0,      0,
       0,      -0.8306,  0.6089, 0.6089,
       0,       0,      -1.2177, 1.2177;
  // clang-format on
  return Coupling<7>(matrix);
}

/// Returns the coupling of a master tool manipulator: the motor of the shoulder turns the elbow
/// too, and both motors turn the platform (jhu-dvrk/sawIntuitiveResearchKit,
/// core/share/cuhk-daVinci/sawRobotIO1394-MTML-41878.xml: ActuatorToJointPosition).
inline Coupling<7> mtmCoupling() {
  constexpr double kPlatform = 0.6697;
  Coupling<7>::Matrix matrix = Coupling<7>::Matrix::Identity();
  matrix(2, 1) = -1;
  matrix(3, 1) = kPlatform;
  matrix(3, 2) = -kPlatform;
  return Coupling<7>(matrix);
}

/// Returns the coupling of an arm with its tool behind it, which has an actuator of its own.
template <int N>
Coupling<N + 1> withTool(const Coupling<N>& arm) {
  typename Coupling<N + 1>::Matrix matrix = Coupling<N + 1>::Matrix::Identity();
  matrix.template topLeftCorner<N, N>() = arm.actuatorToJoint();
  return Coupling<N + 1>(matrix);
}

}  // namespace robots
