#pragma once
// How actuators turn joints: cables lead from one motor to several joints.

#include <Eigen/Core>
#include <Eigen/LU>

namespace robots {

/// A linear coupling of N actuators with N joints, the identity by default. Immutable; only the
/// constructors invert, and nothing allocates.
template <int N>
class Coupling {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;

  Coupling() : Coupling(Matrix::Identity()) {}
  /// Joint positions are `actuatorToJoint` times actuator positions; it can be inverted.
  explicit Coupling(const Matrix& actuatorToJoint)
      : toJoints_(actuatorToJoint), toActuators_(actuatorToJoint.inverse()) {}

  /// These two convert positions, and velocities as well.
  Vector joints(const Vector& actuators) const { return toJoints_ * actuators; }
  Vector actuators(const Vector& joints) const { return toActuators_ * joints; }
  /// These two convert efforts, so that actuators and joints have the same power.
  Vector jointEfforts(const Vector& actuators) const {
    return toActuators_.transpose() * actuators;
  }
  Vector actuatorEfforts(const Vector& joints) const { return toJoints_.transpose() * joints; }

 private:
  Matrix toJoints_, toActuators_;
};

/// The coupling of a patient side manipulator: yaw, pitch and insertion have an actuator each; the
/// four discs of the large needle driver turn its roll, its wrist pitch and yaw, and its jaw
/// (jhu-dvrk/sawIntuitiveResearchKit, share/tool/LARGE_NEEDLE_DRIVER_400006.json:
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

}  // namespace robots
