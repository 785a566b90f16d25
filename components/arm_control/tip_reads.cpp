#include "arm_control/tip_reads.h"

#include "arm_control/tip_force.h"

namespace robots {
namespace {

using kinematics::rotated;
using kinematics::SpatialVector;

void blank(Jacobian& jacobian, int joints) {
  jacobian.joints = static_cast<std::uint32_t>(joints);
  jacobian.coefficients.assign(6 * static_cast<std::size_t>(joints), 0.0);
}

template <class Matrix>
void place(Jacobian& jacobian, const Matrix& matrix, suture::Time stamp, bool valid) {
  Matrix::Map(jacobian.coefficients.data()) = matrix;
  jacobian.stamp = stamp;
  jacobian.valid = valid;
}

void place(Twist& twist, const SpatialVector& value, suture::Time stamp, bool valid) {
  twist.linear = value.head<3>();
  twist.angular = value.tail<3>();
  twist.stamp = stamp;
  twist.valid = valid;
}

void place(Wrench& wrench, const SpatialVector& value, suture::Time stamp, bool valid) {
  wrench.force = value.head<3>();
  wrench.torque = value.tail<3>();
  wrench.stamp = stamp;
  wrench.valid = valid;
}

template <class Data>
void name(Data& data, suture::FrameId moving, suture::FrameId reference) {
  data.moving_frame = moving;
  data.reference_frame = reference;
}

}  // namespace

template <int N>
TipReads<N>::TipReads(const ArmModel<N>& model) : model_(model) {
  blank(bodyJacobian_, N);
  blank(spatialJacobian_, N);
}

template <int N>
void TipReads<N>::nameFrames(suture::FrameId tip, suture::FrameId reference, suture::FrameId base) {
  name(measuredCv_, tip, reference);
  name(setpointCv_, tip, reference);
  name(measuredCs_, tip, reference);
  name(bodyCf_, tip, tip);
  name(spatialCf_, tip, base);
}

template <int N>
void TipReads<N>::measured(const DriveReading<N>& reading, const PoseStamped& tip,
                           const Eigen::Isometry3d& base) {
  const Eigen::Matrix3d tool = tip.pose.linear();
  const JacobianMatrix spatial = model_.chain.jacobian(reading.position);
  JacobianMatrix body;
  body << tool.transpose() * spatial.template topRows<3>(),
      tool.transpose() * spatial.template bottomRows<3>();
  place(spatialJacobian_, spatial, tip.stamp, tip.valid);
  place(bodyJacobian_, body, tip.stamp, tip.valid);
  const SpatialVector velocity = spatial * reading.velocity;
  place(measuredCv_, rotated(base.linear(), velocity), tip.stamp, tip.valid);
  placeForce(tip.valid ? pressed(reading, spatial) : std::nullopt, tip);
  placeState(tip, base);
}

template <int N>
void TipReads<N>::asked(const Joints& setpoint, const Joints& rate, const Eigen::Isometry3d& base,
                        suture::Time now, bool valid) {
  const SpatialVector velocity = model_.chain.jacobian(setpoint) * rate;
  place(setpointCv_, rotated(base.linear(), velocity), now, valid);
}

// Without power the brakes bear what presses on the tip, and the motors measure nothing of it.
template <int N>
std::optional<SpatialVector> TipReads<N>::pressed(const DriveReading<N>& reading,
                                                  const JacobianMatrix& jacobian) const {
  if (!reading.measures_effort || reading.power != DrivePower::On) return std::nullopt;
  Joints effort = reading.effort;
  if (model_.weight) effort -= model_.weight->gravity(model_.weight->at(reading.position));
  return tipForce<N>(jacobian, effort);
}

template <int N>
void TipReads<N>::placeForce(const std::optional<SpatialVector>& force, const PoseStamped& tip) {
  const SpatialVector spatial = force.value_or(SpatialVector::Zero());
  const Eigen::Matrix3d tool = tip.pose.linear();
  place(spatialCf_, spatial, tip.stamp, force.has_value());
  place(bodyCf_, rotated(tool.transpose(), spatial), tip.stamp, force.has_value());
}

template <int N>
void TipReads<N>::placeState(const PoseStamped& tip, const Eigen::Isometry3d& base) {
  measuredCs_.position = base * tip.pose;
  measuredCs_.linear_velocity = measuredCv_.linear;
  measuredCs_.angular_velocity = measuredCv_.angular;
  measuredCs_.force = base.linear() * spatialCf_.force;
  measuredCs_.torque = base.linear() * spatialCf_.torque;
  measuredCs_.position_is_valid = measuredCs_.velocity_is_valid = measuredCv_.valid;
  measuredCs_.force_is_valid = spatialCf_.valid;
  measuredCs_.stamp = tip.stamp;
}

template class TipReads<6>;
template class TipReads<7>;

}  // namespace robots
