#pragma once
// These are the reads of an arm that say how its tip moves and what it presses with.

#include <suture/base/time.h>

#include <Eigen/Core>
#include <optional>

#include "arm/arm.h"
#include "arm_control/arm_controller.h"
#include "arm_control/drive_reading.h"
#include "kinematics/spatial_vector.h"

namespace robots {

/// One thread. Only the constructor allocates. Units are m, rad, s, N and Nm. The arm computes
/// twists and forces along the axes of its base, and these are rotated to those of the reference
/// frame.
template <int N>
class TipReads {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// `model` must outlive this.
  explicit TipReads(const ArmModel<N>& model);

  /// Before the first cycle: names the frames of the data.
  void nameFrames(suture::FrameId tip, suture::FrameId reference, suture::FrameId base);
  /// Names another base frame.
  void nameBase(suture::FrameId base) { spatialCf_.reference_frame = base; }

  /// Takes what the drives measured. `tip` is the pose that the tip has by that, in the frame of
  /// the base, and `base` is the pose of the base in the reference frame.
  void measured(const DriveReading<N>& reading, const PoseStamped& tip,
                const Eigen::Isometry3d& base);
  /// Takes the set-point and how fast it moves. setpoint_cv() has the stamp `now`.
  void asked(const Joints& setpoint, const Joints& rate, const Eigen::Isometry3d& base,
             suture::Time now, bool valid);

  const Twist& measured_cv() const { return measuredCv_; }
  const Twist& setpoint_cv() const { return setpointCv_; }
  const Wrench& body_measured_cf() const { return bodyCf_; }
  const Wrench& spatial_measured_cf() const { return spatialCf_; }
  const CartesianState& measured_cs() const { return measuredCs_; }
  const Jacobian& body_jacobian() const { return bodyJacobian_; }
  const Jacobian& spatial_jacobian() const { return spatialJacobian_; }

 private:
  using SpatialVector = kinematics::SpatialVector;
  using JacobianMatrix = Eigen::Matrix<double, 6, N>;

  /// Returns the wrench that the arm presses with at its tip, along the base's axes, if the drives
  /// measure it.
  std::optional<SpatialVector> pressed(const DriveReading<N>& reading,
                                       const JacobianMatrix& jacobian) const;
  void placeForce(const std::optional<SpatialVector>& force, const PoseStamped& tip);
  void placeState(const PoseStamped& tip, const Eigen::Isometry3d& base);

  const ArmModel<N>& model_;
  Twist measuredCv_, setpointCv_;
  Wrench bodyCf_, spatialCf_;
  CartesianState measuredCs_;
  Jacobian bodyJacobian_, spatialJacobian_;
};

extern template class TipReads<6>;
extern template class TipReads<7>;

}  // namespace robots
